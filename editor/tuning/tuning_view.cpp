#include "editor/tuning/tuning_view.h"

#include "editor/kit/icons.h"
#include "editor/kit/message_text.h"
#include "editor/kit/post.h"
#include "editor/kit/texts.h"
#include "editor/plot/figure_view.h"
#include "editor/plot/model/plot_scale.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QEvent>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSlider>
#include <QSplitter>
#include <QTabWidget>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace plc::editor {

namespace {

/// Scrolls up and down only: as wide as what is in it, which grows when lists are filled.
class UprightScroll : public QScrollArea {
public:
    void fitWidth() { setMinimumWidth(widget()->minimumSizeHint().width() + verticalScrollBar()->sizeHint().width()); }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        const bool isTaken = QScrollArea::eventFilter(watched, event);
        if (watched == widget() && event->type() == QEvent::LayoutRequest) fitWidth();
        return isTaken;
    }
};

QString translated(std::string_view word) { return QCoreApplication::translate("Tuning", std::string(word).c_str()); }

QTreeWidget* makeTree(const QStringList& headers, const QString& name) {
    auto* tree = new QTreeWidget;
    tree->setHeaderLabels(headers);
    tree->setRootIsDecorated(false);
    tree->setAlternatingRowColors(true);
    tree->setUniformRowHeights(true);
    tree->setAccessibleName(name);
    return tree;
}

} // namespace

TuningView::TuningView(RunControl& control, QWidget* parent) : QWidget(parent), m_control(control) {
    auto* split = new QSplitter(Qt::Horizontal, this);
    split->addWidget(makeSettings());
    split->addWidget(makeCharts());
    split->setStretchFactor(0, 2);
    split->setStretchFactor(1, 3);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 4, 4, 4);
    layout->addWidget(makeHead());
    layout->addWidget(m_state); // a line of its own: between the buttons it has no room on a small screen
    layout->addWidget(split, 1);
    constexpr int kRest = 120;
    m_trialTimer.setSingleShot(true);
    m_trialTimer.setInterval(kRest);
    connect(&m_trialTimer, &QTimer::timeout, this, &TuningView::tryOut);
    connect(&control, &RunControl::sessionChanged, this, &TuningView::listLoops);
    connect(&control, &RunControl::sessionAboutToEnd, this, [this] {
        m_before.clear();
        m_edited.reset();
        m_trialTimer.stop();
        refreshButtons();
    });
    connect(&control, &RunControl::statusChanged, this, &TuningView::refreshButtons);
    connect(&control, &RunControl::viewedChanged, this, [this] {
        const session::Run* run = m_control.run(); // a recording was opened or closed
        if (m_listed != (run ? run->program() : nullptr)) listLoops();
    });
    listLoops();
}

TuningView::~TuningView() {
    if (m_worker.joinable()) m_worker.join();
}

QWidget* TuningView::makeHead() {
    auto* head = new QWidget(this);
    auto* row = new QHBoxLayout(head);
    row->setContentsMargins(0, 0, 0, 0);
    m_loop = new QComboBox(head);
    m_loop->setObjectName("tuningLoop");
    m_loop->setAccessibleName(tr("Control loop"));
    m_loop->setMinimumWidth(160);
    m_find = new QPushButton(kit::icon(kit::Icon::Trigger), tr("Find Steps"), head);
    m_find->setObjectName("tuningFind");
    m_find->setToolTip(
        tr("Searches the recording for steps of the set point and of the output and fits a model of the process."));
    m_report = new QPushButton(kit::icon(kit::Icon::Export), tr("Report…"), head);
    m_report->setObjectName("tuningReport");
    m_report->setToolTip(tr("Saves a report on the loop with model and settings as HTML or PDF."));
    m_state = new QLabel(head);
    m_state->setObjectName("tuningState");
    m_state->setWordWrap(true);
    m_write = new QPushButton(kit::icon(kit::Icon::Write), tr("Write Parameters"), head);
    m_write->setObjectName("tuningWrite");
    m_write->setToolTip(tr("Writes all parameters in one scan."));
    m_back = new QPushButton(kit::icon(kit::Icon::Undo), tr("Take Back"), head);
    m_back->setObjectName("tuningBack");
    m_back->setToolTip(tr("Writes the parameters that were in force before."));
    row->addWidget(new QLabel(tr("Loop:"), head));
    for (QWidget* part : {static_cast<QWidget*>(m_loop), static_cast<QWidget*>(m_find)}) row->addWidget(part);
    row->addStretch(1);
    for (QWidget* part : {m_report, m_write, m_back}) row->addWidget(part);
    connect(m_find, &QPushButton::clicked, this, &TuningView::findSteps);
    connect(m_report, &QPushButton::clicked, this, &TuningView::saveReport);
    connect(m_write, &QPushButton::clicked, this, &TuningView::writeParameters);
    connect(m_back, &QPushButton::clicked, this, &TuningView::takeBack);
    return head;
}

QWidget* TuningView::makeSettings() {
    auto* page = new QWidget;
    auto* grid = new QGridLayout(page);
    grid->setContentsMargins(0, 0, 0, 0);
    m_steps = makeTree({tr("Use"), tr("At"), tr("Moved"), tr("From"), tr("To"), tr("Verdict")}, tr("Steps found"));
    m_steps->setObjectName("tuningSteps");
    m_model = new QComboBox;
    m_model->setObjectName("tuningModel");
    m_model->setAccessibleName(tr("Model"));
    m_model->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_formula = new QLabel;
    m_formula->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_formula->setWordWrap(true);
    m_rule = new QComboBox;
    m_rule->setObjectName("tuningRule");
    m_rule->setAccessibleName(tr("Rule"));
    for (const tuning::Rule rule : tuning::allRules()) m_rule->addItem(translated(title(rule)), static_cast<int>(rule));
    m_kind = new QComboBox;
    m_kind->setObjectName("tuningKind");
    m_kind->setAccessibleName(tr("Kind of controller"));
    const auto slider = [&](const char* name, const QString& what) {
        auto* made = new QSlider(Qt::Horizontal);
        made->setObjectName(name);
        made->setAccessibleName(what);
        made->setRange(0, 100);
        made->setValue(50);
        made->setPageStep(10);
        return made;
    };
    m_brisk = slider("tuningBrisk", tr("Calm to brisk"));
    m_tracking = slider("tuningTracking", tr("Disturbance to set point"));
    m_figures = makeTree({QString(), tr("Now"), tr("Proposed")}, tr("Before and after"));
    m_figures->setObjectName("tuningFigures");
    m_words = new QLabel;
    m_words->setObjectName("tuningWords");
    m_words->setWordWrap(true);
    m_constants = new QLabel;
    m_constants->setObjectName("tuningConstants");
    m_constants->setWordWrap(true);
    m_constants->hide();
    const auto ends = [](const QString& left, QSlider* middle, const QString& right) {
        auto* row = new QHBoxLayout;
        row->addWidget(new QLabel(left));
        row->addWidget(middle, 1);
        row->addWidget(new QLabel(right));
        return row;
    };
    grid->addWidget(m_steps, 0, 0, 1, 4);
    grid->addWidget(new QLabel(tr("Model:")), 1, 0);
    grid->addWidget(m_model, 1, 1, 1, 3);
    grid->addWidget(m_formula, 2, 0, 1, 4);
    grid->addWidget(new QLabel(tr("Rule:")), 3, 0);
    grid->addWidget(m_rule, 3, 1);
    grid->addWidget(new QLabel(tr("Controller:")), 3, 2);
    grid->addWidget(m_kind, 3, 3);
    grid->addLayout(ends(tr("Calm"), m_brisk, tr("Brisk")), 4, 0, 1, 4);
    grid->addLayout(ends(tr("Disturbance"), m_tracking, tr("Set point")), 5, 0, 1, 4);
    grid->addWidget(m_figures, 6, 0, 1, 4);
    grid->addWidget(m_words, 7, 0, 1, 4);
    grid->addWidget(m_constants, 8, 0, 1, 4);
    grid->setRowStretch(0, 2);
    grid->setRowStretch(6, 3);
    connect(m_steps, &QTreeWidget::itemChanged, this, &TuningView::fitChosenSteps);
    connect(m_steps, &QTreeWidget::currentItemChanged, this, [this] {
        if (!m_isFilling && m_finding) m_trialTimer.start();
    });
    for (QComboBox* box : {m_model, m_rule, m_kind})
        connect(box, &QComboBox::currentIndexChanged, this, &TuningView::propose);
    for (QSlider* each : {m_brisk, m_tracking}) connect(each, &QSlider::valueChanged, this, &TuningView::propose);
    // a low dock shows some rows of each list and scrolls to the rest
    m_steps->setMinimumHeight(110);
    m_figures->setMinimumHeight(170);
    auto* scrolled = new UprightScroll;
    scrolled->setWidget(page);
    scrolled->setWidgetResizable(true);
    scrolled->setFrameShape(QFrame::NoFrame);
    scrolled->setFocusPolicy(Qt::NoFocus); // its fields have the keyboard and scroll it
    scrolled->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scrolled->fitWidth();
    return scrolled;
}

QWidget* TuningView::makeCharts() {
    auto* page = new QWidget;
    auto* grid = new QGridLayout(page);
    grid->setContentsMargins(0, 4, 0, 0);
    const auto figure = [](const QString& what) {
        auto* made = new plot::FigureView;
        made->setAccessibleName(what);
        return made;
    };
    m_data = figure(tr("Recording and model"));
    m_setPoint = figure(tr("Response to the set point"));
    m_load = figure(tr("Response to a disturbance"));
    m_bode = figure(tr("Bode plot"));
    m_bode->setObjectName("tuningBode");
    m_trial = figure(tr("Simulation with the actual block"));
    m_data->setObjectName("tuningData");
    m_trial->setObjectName("tuningTrial");
    m_setPoint->setObjectName("tuningSetPoint");
    m_load->setObjectName("tuningLoad");
    grid->addWidget(m_trial, 0, 0, 1, 2);
    grid->addWidget(m_setPoint, 1, 0);
    grid->addWidget(m_load, 1, 1);
    auto* tabs = new QTabWidget;
    tabs->setObjectName("tuningCharts");
    tabs->setAccessibleName(tr("Charts of the loop"));
    tabs->setDocumentMode(true);
    tabs->addTab(m_data, tr("Model"));
    tabs->addTab(page, tr("Responses"));
    tabs->addTab(m_bode, tr("Bode Plot"));
    tabs->addTab(makeHealth(), tr("Health"));
    return tabs;
}

// ------------------------------------------------------------------ loops and steps

void TuningView::listLoops() {
    const QString before = m_loop->currentText();
    m_loop->clear();
    const session::Run* run = m_control.run();
    m_listed = run ? run->program() : nullptr;
    if (m_listed)
        for (const loops::Loop& loop : loops::loopsOf(*m_listed)) m_loop->addItem(kit::fromView(loop.name));
    if (const int index = m_loop->findText(before); index >= 0) m_loop->setCurrentIndex(index);
    if (!m_isSearching)
        m_state->setText(!run                   ? tr("Start the controller or open a recording to search it for steps.")
                         : m_loop->count() == 0 ? tr("The program has no controller block; call one, for example PID.")
                                                : QString());
    refreshButtons();
}

std::optional<loops::Loop> TuningView::chosenLoop() const {
    const session::Run* run = m_control.run();
    if (!run || !run->program() || m_loop->currentText().isEmpty()) return std::nullopt;
    const auto found = loops::findLoop(*run->program(), m_loop->currentText().toStdString());
    return found ? std::optional(*found) : std::nullopt;
}

void TuningView::runAside(std::function<Result<std::shared_ptr<Finding>>()> work) {
    if (m_worker.joinable()) m_worker.join();
    m_isSearching = true;
    m_state->setText(tr("Searching…"));
    refreshButtons();
    m_worker =
        std::thread([this, work = std::move(work), hold = m_control.hold(), recorded = m_control.recorded()]() mutable {
            auto found = work();
            hold.reset();
            recorded.reset();
            kit::post(this, [this, found = std::move(found)]() mutable {
                m_isSearching = false;
                if (found)
                    show(std::move(*found));
                else
                    m_state->setText(kit::messageText(found.error()));
                refreshButtons();
            });
        });
}

void TuningView::findSteps() {
    const auto loop = chosenLoop();
    const session::Run* run = m_control.run();
    if (!loop || m_isSearching) return;
    const history::History& history = run->history();
    const bool isLive = m_control.session() && run == m_control.session();
    auto finding = std::make_shared<Finding>();
    finding->loop = *loop;
    finding->program = run->program();
    finding->input = isLive ? m_control.session()->built().input : nullptr;
    runAside([finding = std::move(finding), image = run->snapshot(), &history] {
        return searched(finding, history, image);
    });
}

Result<std::shared_ptr<TuningView::Finding>> TuningView::searched(std::shared_ptr<Finding> finding,
                                                                  const history::History& history,
                                                                  std::span<const std::byte> image) {
    auto recorded = loops::seriesOf(history, loops::signalsOf(finding->loop));
    if (!recorded) return recorded.error();
    finding->recorded = std::move(*recorded);
    tuning::LoopSeries& series = finding->recorded.series;
    finding->settings = loops::settingsOf(finding->loop, *finding->program, image);
    series.low = finding->settings.low;
    series.high = finding->settings.high;
    auto study = tuning::study(series);
    if (study) {
        finding->study = std::move(*study);
    } else { // what was found and why none of it is usable; how the loop is doing can be said all the same
        finding->study.steps = tuning::findSteps(series);
        finding->problem = study.error();
    }
    look(*finding);
    return finding;
}

void TuningView::look(Finding& finding) {
    std::optional<tuning::LoopFigures> now;
    if (!finding.study.models.empty())
        now = tuning::analyse(finding.study.models.front().model, finding.settings.gains,
                              tuning::samplingDelay(finding.settings.cycle));
    finding.health = tuning::healthOf(finding.recorded.series, tuning::limitsOf(finding.recorded.series, now));
}

void TuningView::show(std::shared_ptr<Finding> finding) {
    m_finding = std::move(finding);
    const tuning::Study& study = m_finding->study;
    m_state->setText(
        m_finding->problem
            ? kit::messageText(*m_finding->problem)
            : tr("%n step(s) found, %1 used.", nullptr, static_cast<int>(study.steps.size())).arg(study.used.size()));
    m_isFilling = true;
    showSteps();
    m_model->clear();
    for (size_t i = 0; i < std::min<size_t>(study.models.size(), 6); ++i)
        m_model->addItem(
            tr("%1, explains %2 %")
                .arg(translated(title(study.models[i].structure)), plot::valueText(study.models[i].fit, 4)));
    m_kind->clear();
    const char* const names[] = {"P", "PI", "PID"};
    for (const tuning::ControllerKind kind : m_finding->loop.form->kinds())
        m_kind->addItem(names[static_cast<size_t>(kind)], static_cast<int>(kind));
    m_kind->setCurrentIndex(std::min(1, m_kind->count() - 1));
    m_isFilling = false;
    if (study.models.empty())
        clearProposal();
    else
        propose();
    showHealth();
}

/// There is no model: nothing of an earlier one stays.
void TuningView::clearProposal() {
    m_now.reset();
    m_proposal.reset();
    m_parameters.clear();
    m_trialTimer.stop();
    for (QLabel* text : {m_formula, m_words, m_constants}) text->clear();
    m_figures->clear();
    for (plot::FigureView* view : {m_data, m_setPoint, m_load, m_trial, m_bode}) view->setFigure({});
    refreshButtons();
}

void TuningView::showSteps() {
    const tuning::Study& study = m_finding->study;
    m_steps->clear();
    for (size_t i = 0; i < study.steps.size(); ++i) {
        const tuning::FoundStep& step = study.steps[i];
        const bool isUsed = std::find(study.used.begin(), study.used.end(), i) != study.used.end();
        auto* item = new QTreeWidgetItem(m_steps);
        item->setText(1, plot::momentText(std::llround(m_finding->recorded.series.time[step.step] * 1e9)));
        item->setText(2, step.moved == tuning::Moved::SetPoint ? tr("set point")
                         : step.moved == tuning::Moved::Input  ? tr("output")
                                                               : tr("disturbance"));
        item->setText(3, plot::valueText(step.from, 5));
        item->setText(4, plot::valueText(step.to, 5));
        item->setText(5, kit::messageText(step.reason));
        item->setToolTip(5, item->text(5));
        if (step.canModel()) item->setCheckState(0, isUsed ? Qt::Checked : Qt::Unchecked);
    }
    if (!study.used.empty()) m_steps->setCurrentItem(m_steps->topLevelItem(static_cast<int>(study.used.back())));
    for (int column = 0; column < 5; ++column) m_steps->resizeColumnToContents(column);
}

void TuningView::fitChosenSteps() {
    if (m_isFilling || m_isSearching || !m_finding) return;
    std::vector<size_t> chosen;
    for (int i = 0; i < m_steps->topLevelItemCount(); ++i)
        if (m_steps->topLevelItem(i)->checkState(0) == Qt::Checked) chosen.push_back(static_cast<size_t>(i));
    if (chosen.empty()) return m_state->setText(tr("Choose at least one step."));
    runAside([finding = m_finding, chosen]() -> Result<std::shared_ptr<Finding>> {
        auto changed = std::make_shared<Finding>(*finding);
        auto study = tuning::study(changed->recorded.series, changed->study.steps, chosen);
        if (!study) return study.error();
        changed->study = std::move(*study);
        changed->problem.reset();
        look(*changed);
        return changed;
    });
}

} // namespace plc::editor
