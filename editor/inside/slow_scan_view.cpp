#include "editor/inside/slow_scan_view.h"

#include "editor/kit/icons.h"
#include "editor/kit/message_text.h"
#include "editor/kit/texts.h"
#include "editor/kit/theme.h"
#include "editor/plot/model/plot_scale.h"
#include "runtime/debug/sites.h"
#include "runtime/inside/texts.h"

#include <QAction>
#include <QHeaderView>
#include <QLabel>
#include <QSplitter>
#include <QToolBar>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace plc::editor {

using debug::Step;

namespace {

QTreeWidget* makeTree(const QStringList& columns, const char* name, QWidget* parent) {
    auto* tree = new QTreeWidget(parent);
    tree->setAccessibleName(columns.front());
    tree->setObjectName(name);
    tree->setHeaderLabels(columns);
    tree->setUniformRowHeights(true);
    tree->header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    return tree;
}

} // namespace

SlowScanView::SlowScanView(InsideDesk& desk, RunControl& control, QWidget* parent)
    : QWidget(parent), m_desk(desk), m_control(control) {
    using kit::Icon;
    auto* bar = new QToolBar(this);
    bar->setIconSize({16, 16});
    const auto add = [&](Icon icon, const QString& label, const char* name, auto&& run) {
        QAction* action = bar->addAction(kit::icon(icon), label, this, run);
        action->setObjectName(name);
        m_moves << action;
    };
    add(Icon::Back, tr("Back to the previous breakpoint or to the first statement of the scan"), "slowReverse",
        [this] { reverseContinue(); });
    add(Icon::PreviousChange, tr("Back out of the call"), "slowBackOut", [this] { stepBack(Step::Out); });
    add(Icon::Undo, tr("Back over calls"), "slowBackOver", [this] { stepBack(Step::Over); });
    add(Icon::StepBack, tr("One statement back"), "slowBack", [this] { stepBack(Step::In); });
    bar->addSeparator();
    add(Icon::StepInto, tr("Step in"), "slowIn", [this] { step(Step::In); });
    add(Icon::StepOver, tr("Step over"), "slowOver", [this] { step(Step::Over); });
    add(Icon::StepOut, tr("Step out"), "slowOut", [this] { step(Step::Out); });
    add(Icon::Forward, tr("Forward to the next breakpoint or to the end of the scan"), "slowOn", [this] { goOn(); });
    bar->addSeparator();
    add(Icon::Close, tr("End the walk"), "slowClose", [this] { close(); });
    m_state = new QLabel(this);
    m_state->setWordWrap(true);
    m_state->setAccessibleName(tr("Current position of the walk"));
    m_frames = makeTree({tr("Call"), tr("Instance"), tr("Line")}, "slowFrames", this);
    m_frames->setRootIsDecorated(false);
    m_frames->setAccessibleName(tr("Call path"));
    m_values = makeTree({tr("Name"), tr("Value")}, "slowValues", this);
    m_values->setAccessibleName(tr("Values at this moment"));
    connect(m_frames, &QTreeWidget::currentItemChanged, this, &SlowScanView::showValues);
    const auto goTo = [this](QTreeWidgetItem* item) {
        const auto frames = m_scan ? m_scan->stackTrace() : std::vector<inside::SlowScan::Frame>();
        const auto index = static_cast<size_t>(m_frames->indexOfTopLevelItem(item));
        if (index >= frames.size()) return;
        if (const auto place = m_control.placeInText(frames[index].range, m_look->program()))
            emit placeRequested(place->file, place->offset, 0);
    };
    connect(m_frames, &QTreeWidget::itemClicked, this, goTo);
    connect(m_frames, &QTreeWidget::itemActivated, this, goTo);
    auto* parts = new QSplitter(Qt::Horizontal, this);
    parts->addWidget(m_frames);
    parts->addWidget(m_values);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 0, 4, 0);
    layout->setSpacing(2);
    layout->addWidget(bar);
    layout->addWidget(m_state);
    layout->addWidget(parts, 1);
    setMinimumSize(260, 120);
    connect(&control, &RunControl::sessionAboutToEnd, this, &SlowScanView::close);
    connect(&control, &RunControl::recordedMustClose, this, &SlowScanView::close);
    connect(&control, &RunControl::viewedChanged, this, &SlowScanView::follow);
    connect(&control, &RunControl::breakpointsChanged, this, &SlowScanView::takeBreakpoints);
    show();
}

/// The time slider has gone to another scan: that one is walked through; back to live ends the walk.
void SlowScanView::follow() {
    if (!m_asked) return;
    const auto viewed = m_control.viewed();
    if (!viewed) return close();
    if (*viewed != *m_asked) open(viewed);
}

void SlowScanView::open(std::optional<history::Position> at, std::optional<Step> back) {
    const history::History* history = m_control.shownHistory();
    if (!history || history->statistics().scans == 0) {
        m_state->setText(tr("There is no recorded scan yet: run the program first."));
        return;
    }
    if (!at) at = m_control.viewed().value_or(history->statistics().end - 1);
    m_asked = at;
    const unsigned number = ++m_number;
    m_state->setText(tr("Running the scan again…"));
    m_control.view(at); // panel, chart and watch stay at this scan
    (void)m_desk.ask("slow scan", [this, at, back, number](InsideDesk::Bench& bench) {
        auto look = bench.insight.look(*at);
        return [this, back, number, look] {
            if (number != m_number) return;
            if (!look) {
                m_state->setText(kit::messageText(look.error()));
                return;
            }
            m_look = *look;
            m_scan = std::make_unique<inside::SlowScan>(m_look);
            if (back) { // it has run: of a fault, the statement that failed comes first
                m_scan->goOn();
                m_scan->stepBack(*back);
            }
            takeBreakpoints();
            show();
            emit moved();
        };
    });
}

void SlowScanView::close() {
    ++m_number;
    m_asked.reset();
    if (!m_scan) return show();
    m_scan.reset();
    m_look.reset();
    show();
    emit moved();
}

void SlowScanView::takeBreakpoints() {
    if (!m_scan) return;
    std::vector<inside::SlowScan::LineOf> lines;
    for (const EditorBreakpoint& each : m_control.breakpoints())
        if (const FileId file = debug::fileOfPath(m_look->program(), each.file.toStdString());
            each.isEnabled && file.isValid())
            lines.push_back({file, static_cast<uint32_t>(each.line)});
    m_scan->setBreakpoints(std::move(lines));
}

void SlowScanView::step(Step how) {
    if (!m_scan) return open();
    if (m_scan->step(how)) show(), emit moved();
}

void SlowScanView::stepBack(Step how) {
    if (!m_scan) return open({}, how);
    if (m_scan->stepBack(how)) show(), emit moved();
}

void SlowScanView::goOn() {
    if (m_scan && m_scan->goOn()) show(), emit moved();
}

void SlowScanView::reverseContinue() {
    if (m_scan && m_scan->reverseContinue()) show(), emit moved();
}

void SlowScanView::goToLine(const QString& file, int line) {
    if (!m_scan) return;
    const FileId id = debug::fileOfPath(m_look->program(), file.toStdString());
    if (id.isValid() && m_scan->goToLine({id, static_cast<uint32_t>(line)})) show(), emit moved();
}

void SlowScanView::show() {
    for (QAction* move : m_moves) move->setEnabled(isOpen());
    const QSignalBlocker blocker(m_frames);
    m_frames->clear();
    m_values->clear();
    if (!m_scan) {
        m_state->setText(tr("Walks through a recorded scan statement by statement, forwards and backwards (Time, Walk "
                            "Through the Scan)."));
        return;
    }
    const auto& stamp = m_look->input().stamp;
    QString where = m_scan->stops() == 0 ? kit::messageText(inside::texts::NothingRan())
                    : m_scan->isAtEnd()
                        ? tr("The end of scan %1 at %2").arg(stamp.scan).arg(plot::momentText(stamp.time.count()))
                        : tr("Scan %1 at %2: before statement %3 of %4")
                              .arg(stamp.scan)
                              .arg(plot::momentText(stamp.time.count()))
                              .arg(m_scan->at() + 1)
                              .arg(m_scan->stops());
    QStringList passes;
    for (const uint64_t pass : m_scan->passes()) passes << QString::number(pass + 1);
    if (!passes.isEmpty()) where += tr(" · pass %1", "of loops, outermost first").arg(passes.join(u'.'));
    if (const Message doubt = m_look->doubt(); !doubt.isEmpty())
        where += QChar(u'\n') + kit::messageText(inside::texts::Note(doubt));
    m_state->setText(where);
    for (const inside::SlowScan::Frame& frame : m_scan->stackTrace()) {
        auto* item = new QTreeWidgetItem(m_frames, {kit::fromView(frame.function), kit::fromView(frame.instance)});
        if (const auto place = m_control.placeInText(frame.range, m_look->program()))
            item->setText(2, QString("%1:%2").arg(place->file).arg(place->line));
        item->setData(0, Qt::UserRole, frame.id);
    }
    if (m_frames->topLevelItemCount()) m_frames->setCurrentItem(m_frames->topLevelItem(0));
    showValues();
}

void SlowScanView::showValues() {
    m_values->clear();
    const QTreeWidgetItem* frame = m_frames->currentItem();
    if (!m_scan || !frame) return;
    const types::TypeTable& types = *m_look->program().layout.types;
    for (const inside::SlowScan::Scope& scope : m_scan->scopes(frame->data(0, Qt::UserRole).toUInt())) {
        const bool isLocals = scope.kind == inside::SlowScan::Scope::Kind::Locals;
        auto* group = new QTreeWidgetItem(m_values, {isLocals ? tr("Locals") : kit::fromView(scope.instance)});
        for (const inside::SlowScan::Variable& variable : scope.variables) {
            if (!variable.value.hasValue()) continue;
            auto* item = new QTreeWidgetItem(
                group, {kit::fromView(variable.name), kit::fromView(types::toText(types, variable.value))});
            if (!variable.isChanged) continue;
            QFont bold = item->font(1);
            bold.setBold(true);
            for (int column : {0, 1}) {
                item->setFont(column, bold);
                item->setForeground(column, kit::colors().accent);
            }
        }
        group->setExpanded(true);
    }
}

} // namespace plc::editor
