#include "editor/tuning/tuning_view.h"

#include "editor/kit/icons.h"
#include "editor/kit/message_text.h"
#include "editor/kit/post.h"
#include "editor/plot/figure_view.h"
#include "editor/plot/plot_sample.h"
#include "editor/plot/plot_scale.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QSplitter>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace plc::editor {

namespace {

QString text(const std::string& s) { return QString::fromStdString(s); }

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

QString seconds(double value) {
    return value > 0 ? QString("%1 s").arg(plot::valueText(value, 4)) : QStringLiteral("–");
}

waveform::Curve curveOf(const tuning::Trajectory& trajectory, const QString& name, int colour) {
    waveform::Curve out{name.toStdString(), {}, trajectory.output, colour, waveform::CurveStyle::Line};
    for (size_t i = 0; i < out.y.size(); ++i) out.x.push_back(static_cast<double>(i) * trajectory.cycle);
    return out;
}

/// A trial looks at no more of the recording than this.
constexpr uint64_t kMostTried = 20'000;

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
    layout->addWidget(split, 1);
    constexpr int kRest = 120;
    m_trialTimer.setSingleShot(true);
    m_trialTimer.setInterval(kRest);
    connect(&m_trialTimer, &QTimer::timeout, this, &TuningView::tryOut);
    connect(&control, &RunControl::sessionChanged, this, &TuningView::listLoops);
    connect(&control, &RunControl::sessionAboutToEnd, this, [this] {
        m_before.clear();
        m_trialTimer.stop();
        refreshButtons();
    });
    connect(&control, &RunControl::statusChanged, this, &TuningView::refreshButtons);
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
        tr("Looks for steps of the set point and of the output in the recording and makes a model of the process."));
    m_state = new QLabel(head);
    m_state->setObjectName("tuningState");
    m_write = new QPushButton(kit::icon(kit::Icon::Write), tr("Write Parameters"), head);
    m_write->setObjectName("tuningWrite");
    m_write->setToolTip(tr("Writes all parameters in one scan."));
    m_back = new QPushButton(kit::icon(kit::Icon::Undo), tr("Take Back"), head);
    m_back->setObjectName("tuningBack");
    m_back->setToolTip(tr("Writes the parameters that were in force before."));
    row->addWidget(new QLabel(tr("Loop:"), head));
    for (QWidget* part : {static_cast<QWidget*>(m_loop), static_cast<QWidget*>(m_find)}) row->addWidget(part);
    row->addWidget(m_state, 1);
    for (QWidget* part : {m_write, m_back}) row->addWidget(part);
    connect(m_find, &QPushButton::clicked, this, &TuningView::findSteps);
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
    grid->setRowStretch(0, 2);
    grid->setRowStretch(6, 3);
    connect(m_steps, &QTreeWidget::itemChanged, this, &TuningView::fitChosenSteps);
    for (QComboBox* box : {m_model, m_rule, m_kind})
        connect(box, &QComboBox::currentIndexChanged, this, &TuningView::propose);
    for (QSlider* each : {m_brisk, m_tracking}) connect(each, &QSlider::valueChanged, this, &TuningView::propose);
    return page;
}

QWidget* TuningView::makeCharts() {
    auto* page = new QWidget;
    auto* grid = new QGridLayout(page);
    grid->setContentsMargins(0, 0, 0, 0);
    const auto figure = [](const QString& what) {
        auto* made = new plot::FigureView;
        made->setAccessibleName(what);
        return made;
    };
    m_data = figure(tr("Recording and model"));
    m_setPoint = figure(tr("Response to the set point"));
    m_load = figure(tr("Response to a disturbance"));
    m_trial = figure(tr("Trial with the block itself"));
    m_data->setObjectName("tuningData");
    m_trial->setObjectName("tuningTrial");
    m_setPoint->setObjectName("tuningSetPoint");
    m_load->setObjectName("tuningLoad");
    grid->addWidget(m_data, 0, 0);
    grid->addWidget(m_trial, 0, 1);
    grid->addWidget(m_setPoint, 1, 0);
    grid->addWidget(m_load, 1, 1);
    return page;
}

// ------------------------------------------------------------------ loops and steps

void TuningView::listLoops() {
    const QString before = m_loop->currentText();
    m_loop->clear();
    if (const session::Session* session = m_control.session(); session && session->program())
        for (const loops::Loop& loop : loops::loopsOf(*session->program())) m_loop->addItem(text(loop.name));
    if (const int index = m_loop->findText(before); index >= 0) m_loop->setCurrentIndex(index);
    if (!m_isSearching)
        m_state->setText(!m_control.session()   ? tr("Start the controller; its recording is what is looked at.")
                         : m_loop->count() == 0 ? tr("The program has no controller block.")
                                                : QString());
    refreshButtons();
}

std::optional<loops::Loop> TuningView::chosenLoop() const {
    const session::Session* session = m_control.session();
    if (!session || !session->program() || m_loop->currentText().isEmpty()) return std::nullopt;
    const auto found = loops::findLoop(*session->program(), m_loop->currentText().toStdString());
    return found ? std::optional(*found) : std::nullopt;
}

void TuningView::runAside(std::function<Result<std::shared_ptr<Finding>>()> work) {
    if (m_worker.joinable()) m_worker.join();
    m_isSearching = true;
    m_state->setText(tr("Searching…"));
    refreshButtons();
    m_worker = std::thread([this, work = std::move(work), hold = m_control.hold()]() mutable {
        auto found = work();
        hold.reset();
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
    const session::Session* session = m_control.session();
    if (!loop || m_isSearching) return;
    const history::History& history = session->history();
    runAside([loop = *loop, program = session->program(), image = session->snapshot(),
              &history]() -> Result<std::shared_ptr<Finding>> {
        auto finding = std::make_shared<Finding>();
        finding->loop = loop;
        finding->program = program;
        auto series = loops::seriesOf(history, loops::signalsOf(loop));
        if (!series) return series.error();
        finding->series = std::move(*series);
        auto study = tuning::study(finding->series);
        if (!study) return study.error();
        finding->study = std::move(*study);
        finding->settings = loops::settingsOf(loop, *program, image);
        const history::Statistics all = history.statistics();
        const size_t last = finding->study.used.back();
        const tuning::FoundStep& step = finding->study.steps[last];
        finding->to = std::min<history::Position>(all.end, all.end - finding->series.size() + step.end);
        const history::Position begin = all.end - finding->series.size() + step.begin;
        finding->from = std::max({begin, finding->to > kMostTried ? finding->to - kMostTried : 0, all.first});
        return finding;
    });
}

void TuningView::show(std::shared_ptr<Finding> finding) {
    m_finding = std::move(finding);
    const tuning::Study& study = m_finding->study;
    m_state->setText(
        tr("%n step(s) found, %1 used.", nullptr, static_cast<int>(study.steps.size())).arg(study.used.size()));
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
    propose();
}

void TuningView::showSteps() {
    const tuning::Study& study = m_finding->study;
    m_steps->clear();
    for (size_t i = 0; i < study.steps.size(); ++i) {
        const tuning::FoundStep& step = study.steps[i];
        const bool isUsed = std::find(study.used.begin(), study.used.end(), i) != study.used.end();
        auto* item = new QTreeWidgetItem(m_steps);
        item->setText(1, plot::momentText(std::llround(m_finding->series.time[step.step] * 1e9)));
        item->setText(2, step.moved == tuning::Moved::SetPoint ? tr("set point") : tr("output"));
        item->setText(3, plot::valueText(step.from, 5));
        item->setText(4, plot::valueText(step.to, 5));
        item->setText(5, kit::messageText(step.reason));
        item->setToolTip(5, item->text(5));
        item->setCheckState(0, isUsed ? Qt::Checked : Qt::Unchecked);
    }
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
        auto study = tuning::study(changed->series, changed->study.steps, chosen);
        if (!study) return study.error();
        changed->study = std::move(*study);
        return changed;
    });
}

// ------------------------------------------------------------------ settings

tuning::Wish TuningView::wish() const {
    return {static_cast<tuning::ControllerKind>(m_kind->currentData().toInt()), m_brisk->value() / 100.0,
            m_tracking->value() / 100.0, tuning::samplingDelay(m_finding->settings.cycle)};
}

tuning::ProcessModel TuningView::model() const {
    const auto& models = m_finding->study.models;
    return models[std::min(static_cast<size_t>(std::max(m_model->currentIndex(), 0)), models.size() - 1)].model;
}

void TuningView::propose() {
    if (m_isFilling || !m_finding || m_kind->count() == 0) return;
    const tuning::ProcessModel process = model();
    tuning::LoopConditions conditions{m_finding->settings.cycle, tuning::noiseOf(m_finding->series.output), 0};
    const auto rule = static_cast<tuning::Rule>(m_rule->currentData().toInt());
    const auto gains = tuning::tune(process, rule, wish());
    conditions.duration = tuning::trialDuration(process, gains.value_or(m_finding->settings.gains));
    m_now = tuning::assess(process, m_finding->settings.gains, conditions);
    m_proposal.reset();
    m_parameters.clear();
    if (gains) {
        m_parameters = tuning::parametersOf(*m_finding->loop.form, *gains, m_finding->settings.cycle);
        m_proposal = tuning::assess(process, *gains, conditions);
    }
    m_formula->setText(text(formula(process)));
    QStringList words;
    if (!m_proposal) words << tr("The rule has no answer for this process.");
    if (m_proposal)
        words << kit::messageText(robustnessWords(*m_proposal)) << kit::messageText(overshootWords(*m_proposal));
    if (const Message caution = cautionOf(rule); !caution.isEmpty()) words << kit::messageText(caution);
    m_words->setText(words.join(' '));
    showTable();
    showCharts();
    m_trialTimer.start();
    refreshButtons();
}

void TuningView::showTable() {
    m_figures->clear();
    const auto row = [&](const QString& what, const auto& value) {
        new QTreeWidgetItem(m_figures,
                            {what, m_now ? value(*m_now) : QString(), m_proposal ? value(*m_proposal) : QString()});
    };
    using tuning::Assessment;
    const auto number = [](double value) { return std::isfinite(value) ? plot::valueText(value, 4) : tr("any"); };
    row(tr("Gain"), [&](const Assessment& a) { return number(a.gains.gain); });
    row(tr("Integral time"), [&](const Assessment& a) { return seconds(a.gains.integralTime); });
    row(tr("Derivative time"), [&](const Assessment& a) { return seconds(a.gains.derivativeTime); });
    row(tr("Sensitivity Ms"),
        [&](const Assessment& a) { return a.figures.isStable ? number(a.figures.sensitivity) : tr("unstable"); });
    row(tr("Gain margin"), [&](const Assessment& a) { return number(a.figures.gainMargin); });
    row(tr("Phase margin"),
        [&](const Assessment& a) { return tr("%1°").arg(number(std::round(a.figures.phaseMargin))); });
    row(tr("Overshoot"), [&](const Assessment& a) {
        return a.figures.isStable ? tr("%1 %").arg(number(std::round(a.setPoint.overshoot))) : QStringLiteral("–");
    });
    row(tr("Settling time"), [&](const Assessment& a) {
        return a.figures.isStable ? seconds(a.setPoint.settlingTime) : QStringLiteral("–");
    });
    row(tr("Error after a load step"),
        [&](const Assessment& a) { return a.figures.isStable ? number(a.load.integratedError) : QStringLiteral("–"); });
    row(tr("Control effort"),
        [&](const Assessment& a) { return a.figures.isStable ? number(a.setPoint.effort) : QStringLiteral("–"); });
    row(tr("Noise in the output"), [&](const Assessment& a) { return number(a.noise); });
    for (size_t i = 0; i < m_parameters.size(); ++i) {
        const QString before =
            i < m_finding->settings.values.size() ? plot::valueText(m_finding->settings.values[i], 6) : QString();
        new QTreeWidgetItem(m_figures, {text(m_parameters[i].member), before, text(m_parameters[i].text)});
    }
    m_figures->resizeColumnToContents(0);
}

void TuningView::showCharts() {
    const tuning::Study& study = m_finding->study;
    const auto index = std::min(static_cast<size_t>(std::max(m_model->currentIndex(), 0)), study.models.size() - 1);
    waveform::Chart data{tr("Recorded and modelled").toStdString(), tr("time [s]").toStdString(), {}, {}, false};
    waveform::Chart residual{tr("What the model leaves").toStdString(), tr("time [s]").toStdString(), {}, {}, false};
    for (size_t i = 0; i < study.used.size(); ++i) {
        const auto times = timesOf(m_finding->series, study.steps[study.used[i]], study.excerpts[i]);
        const auto name = [&](const QString& what) { return i == 0 ? what.toStdString() : std::string(); };
        data.curves.push_back({name(tr("recorded")), times, study.excerpts[i].output, 2, waveform::CurveStyle::Dots});
        data.curves.push_back(
            {name(tr("model")), times, study.models[index].simulated[i], 0, waveform::CurveStyle::Line});
        waveform::Curve left{name(tr("recorded less model")), times, {}, 1, waveform::CurveStyle::Line};
        for (size_t s = 0; s < std::min(study.excerpts[i].output.size(), study.models[index].simulated[i].size()); ++s)
            left.y.push_back(study.excerpts[i].output[s] - study.models[index].simulated[i][s]);
        residual.curves.push_back(std::move(left));
    }
    m_data->setFigure({{std::move(data), std::move(residual)}, {}});
    const auto response = [&](const QString& title, tuning::Trajectory tuning::Assessment::*which) {
        waveform::Chart chart{title.toStdString(), tr("time [s]").toStdString(), {}, {}, false};
        if (m_now && m_now->figures.isStable) chart.curves.push_back(curveOf((*m_now).*which, tr("now"), 3));
        if (m_proposal && m_proposal->figures.isStable)
            chart.curves.push_back(curveOf((*m_proposal).*which, tr("proposed"), 0));
        return chart;
    };
    m_setPoint->setChart(response(tr("Step of the set point"), &tuning::Assessment::setPointTrajectory));
    m_load->setChart(response(tr("Step of the load"), &tuning::Assessment::loadTrajectory));
}

std::vector<loops::ParameterWrite> TuningView::writes() const {
    return m_finding ? loops::writesOf(m_finding->loop, m_finding->program, m_parameters)
                     : std::vector<loops::ParameterWrite>();
}

/// The block itself, over the last step that was used.
void TuningView::tryOut() {
    if (!m_finding) return;
    waveform::Chart chart{
        tr("The last step with these settings").toStdString(), tr("time [s]").toStdString(), {}, {}, false};
    const session::Session* session = m_control.session();
    if (session && session->program() == m_finding->program && m_proposal) {
        auto plan = loops::planFor(m_finding->loop, session->history(), m_finding->from, m_finding->to);
        if (plan) plan->writes = writes();
        const auto run =
            plan ? loops::tryOut(session->history(), *plan, model()) : Result<loops::TrialRun>(plan.error());
        if (run) {
            chart.curves.push_back(
                {tr("recorded").toStdString(), run->before.time, run->before.output, 2, waveform::CurveStyle::Line});
            chart.curves.push_back(
                {tr("proposed").toStdString(), run->series.time, run->series.output, 0, waveform::CurveStyle::Line});
        } else {
            chart.title = kit::messageText(run.error()).toStdString();
        }
    }
    m_trial->setChart(std::move(chart));
}

// ------------------------------------------------------------------ writing

void TuningView::refreshButtons() {
    const bool isOnline = m_control.session() && !m_control.showsRecorded();
    m_find->setEnabled(!m_isSearching && isOnline && m_loop->count() > 0);
    m_write->setEnabled(!m_isSearching && isOnline && m_proposal && !writes().empty());
    m_back->setEnabled(isOnline && !m_before.empty());
}

namespace {
/// As ST writes it, for the log.
QString described(const std::vector<loops::ParameterWrite>& writes) {
    QStringList out;
    for (const loops::ParameterWrite& write : writes)
        out << QString("%1 := %2")
                   .arg(text(write.path), text(plot::exactText(write.value, plot::PlotValueKind::Single)));
    return out.join(QStringLiteral(", "));
}
} // namespace

void TuningView::writeParameters() {
    session::Session* session = m_control.session();
    if (!session || !m_proposal) return;
    const std::vector<loops::ParameterWrite> wanted = writes();
    std::vector<session::Assignment> values;
    std::vector<loops::ParameterWrite> before;
    const auto image = session->snapshot();
    for (const loops::ParameterWrite& write : wanted) {
        const auto value = loops::valueFor(*session->program(), write.path, write.value);
        if (!value) return emit message(kit::messageText(value.error()), true);
        values.push_back({write.path, *value});
        before.push_back({write.path, loops::numberAt(*session->program(), image, write.path).value_or(0)});
    }
    session->writeTogether(std::move(values), tr("Tuning").toStdString());
    m_before = std::move(before);
    emit message(tr("Written: %1").arg(described(wanted)), false);
    refreshButtons();
}

void TuningView::takeBack() {
    session::Session* session = m_control.session();
    if (!session || m_before.empty()) return;
    std::vector<session::Assignment> values;
    for (const loops::ParameterWrite& write : m_before)
        if (const auto value = loops::valueFor(*session->program(), write.path, write.value))
            values.push_back({write.path, *value});
    session->writeTogether(std::move(values), tr("Tuning").toStdString());
    emit message(tr("Taken back: %1").arg(described(m_before)), false);
    m_before.clear();
    refreshButtons();
}

} // namespace plc::editor
