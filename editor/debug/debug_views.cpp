#include "editor/debug/debug_views.h"

#include "editor/debug/fault_scan.h"
#include "editor/kit/icons.h"
#include "editor/kit/message_text.h"
#include "editor/kit/post.h"
#include "editor/kit/texts.h"
#include "editor/kit/theme.h"
#include "editor/plot/model/plot_scale.h"
#include "editor/trace/curves/trace_plot.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QMenu>
#include <QPainter>
#include <QScrollBar>
#include <QSplitter>
#include <QTime>
#include <QToolBar>
#include <QVBoxLayout>

#include <algorithm>

namespace plc::editor {

namespace {

QTreeWidget* makeTree(QWidget* parent, const QStringList& headers, const QString& name) {
    auto* tree = new QTreeWidget(parent);
    tree->setHeaderLabels(headers);
    tree->setRootIsDecorated(false);
    tree->setAlternatingRowColors(true);
    tree->setUniformRowHeights(true);
    tree->setAccessibleName(name);
    tree->header()->setStretchLastSection(true);
    return tree;
}

QToolBar* makeBar(QWidget* parent) {
    auto* bar = new QToolBar(parent);
    bar->setIconSize({16, 16});
    return bar;
}

void stack(QWidget* parent, std::initializer_list<QWidget*> parts) {
    auto* layout = new QVBoxLayout(parent);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    for (QWidget* part : parts) layout->addWidget(part);
}

QString nanosecondsText(double ns) {
    const QLocale locale; // the decimal sign of the studio's language
    if (ns < 1e3) return QString("%1 ns").arg(locale.toString(ns, 'f', 0));
    if (ns < 1e6) return QString("%1 µs").arg(locale.toString(ns / 1e3, 'f', 1));
    return QString("%1 ms").arg(locale.toString(ns / 1e6, 'f', 2));
}

} // namespace

// ------------------------------------------------------------------ forces

ForceView::ForceView(RunControl& control, QWidget* parent) : QWidget(parent), m_control(control) {
    QToolBar* bar = makeBar(this);
    m_tree = makeTree(this, {tr("Variable"), tr("Forced value")}, tr("Forced variables"));
    m_tree->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_tree->setColumnWidth(0, 240);
    connect(bar->addAction(kit::icon(kit::Icon::Unforce), tr("Release selected")), &QAction::triggered, this, [this] {
        for (QTreeWidgetItem* item : m_tree->selectedItems()) m_control.unforce(item->text(0));
    });
    connect(bar->addAction(kit::icon(kit::Icon::Clear), tr("Release all")), &QAction::triggered, this, [this] {
        if (m_control.session()) m_control.session()->unforceAll();
    });
    stack(this, {bar, m_tree});
    connect(&control, &RunControl::refreshed, this, &ForceView::refresh);
}

void ForceView::refresh() {
    if (!isVisible()) return;
    const auto forces = m_control.session() ? m_control.session()->forces() : std::vector<controller::Forced>();
    while (m_tree->topLevelItemCount() > static_cast<int>(forces.size()))
        delete m_tree->topLevelItem(m_tree->topLevelItemCount() - 1);
    for (size_t i = 0; i < forces.size(); ++i) {
        QTreeWidgetItem* item = static_cast<int>(i) < m_tree->topLevelItemCount()
                                    ? m_tree->topLevelItem(static_cast<int>(i))
                                    : new QTreeWidgetItem(m_tree);
        item->setText(0, kit::fromView(forces[i].path));
        item->setText(1, kit::fromView(types::toText(*m_control.session()->program()->layout.types, forces[i].value)));
        item->setIcon(0, kit::icon(kit::Icon::Force));
    }
}

// ------------------------------------------------------------------ call path

namespace {

constexpr int kPartsShown = 500;

/// A value with its parts below it; rows that are there keep their unfolding.
void fillValue(QTreeWidgetItem* item, const types::TypeTable& types, const QString& name, const types::Value& value) {
    const QString shown = kit::fromView(types::toText(types, value)).left(300);
    if (item->text(0) != name) item->setText(0, name);
    if (item->text(1) != shown) item->setText(1, shown);
    const auto* parts = std::get_if<std::vector<types::Value>>(&value.data);
    const types::Type* type = parts ? &types[value.type] : nullptr;
    int row = 0;
    const auto part = [&](const QString& label, const types::Value& each) {
        fillValue(row < item->childCount() ? item->child(row) : new QTreeWidgetItem(item), types, label, each);
        ++row;
    };
    if (parts && type->kind == types::TypeKind::Array) {
        std::vector<int64_t> index;
        for (const types::Dimension& d : type->dimensions) index.push_back(d.low);
        for (size_t i = 0; i < parts->size() && row < kPartsShown; ++i) {
            QStringList at;
            for (const int64_t each : index) at << QString::number(each);
            part("[" + at.join(", ") + "]", (*parts)[i]);
            size_t d = index.size();
            while (d > 0 && ++index[d - 1] > type->dimensions[d - 1].high)
                index[d - 1] = type->dimensions[d - 1].low, --d;
        }
    } else if (parts) {
        for (size_t i = 0; i < parts->size() && i < type->fields.size() && row < kPartsShown; ++i)
            if (!type->fields[i].isPrivate) part(kit::fromView(type->fields[i].name), (*parts)[i]);
    }
    while (item->childCount() > row) delete item->child(row);
}

} // namespace

CallPathView::CallPathView(RunControl& control, QWidget* parent) : QWidget(parent), m_control(control) {
    m_frames = makeTree(this, {tr("Unit"), tr("Instance"), tr("Line")}, tr("Call stack"));
    m_values = makeTree(this, {tr("Variable"), tr("Value")}, tr("Values of the frame"));
    m_values->setRootIsDecorated(true);
    auto* splitter = new QSplitter(this);
    splitter->addWidget(m_frames);
    splitter->addWidget(m_values);
    for (int column : {0, 1})
        m_frames->header()->setSectionResizeMode(column, QHeaderView::ResizeToContents); // the line in sight
    m_none = new QLabel(tr("This scan has run to its end: it has no call stack."), this);
    m_none->setObjectName(QStringLiteral("noCallStack"));
    m_none->setWordWrap(true);
    m_none->setMargin(6);
    m_none->hide();
    stack(this, {m_none, splitter});
    connect(&control, &RunControl::halted, this, &CallPathView::refresh);
    connect(&control, &RunControl::viewedChanged, this, &CallPathView::refresh); // all views show one moment
    connect(&control, &RunControl::sessionChanged, this, &CallPathView::refresh);
    connect(&control, &RunControl::statusChanged, this, [this] {
        const controller::State now = m_control.status().state;
        if (std::exchange(m_shownState, now) != now && now != controller::State::Halted) refresh();
    });
    connect(&control, &RunControl::refreshed, this, [this] { // written meanwhile
        if (isVisible() && m_control.status().state == controller::State::Halted) showValues();
    });
    connect(m_frames, &QTreeWidget::currentItemChanged, this, &CallPathView::showValues);
    const auto go = [this](QTreeWidgetItem* item) {
        if (!item->text(1).isEmpty()) emit instanceChosen(item->text(0).section('.', 0, 0), item->text(1));
        if (const auto place = m_control.placeInText(m_ranges[static_cast<size_t>(frameOf(item))]))
            emit placeRequested(place->file, place->offset);
    };
    connect(m_frames, &QTreeWidget::itemActivated, this, go);
    connect(m_frames, &QTreeWidget::itemClicked, this, go);
}

int CallPathView::frameOf(QTreeWidgetItem* item) const { return m_frames->indexOfTopLevelItem(item); }

void CallPathView::showValues() {
    QTreeWidgetItem* current = m_frames->currentItem();
    const auto variables = current && m_control.session()
                               ? m_control.faultScan().variables(static_cast<size_t>(frameOf(current)))
                               : std::vector<std::pair<std::string, types::Value>>();
    while (m_values->topLevelItemCount() > static_cast<int>(variables.size()))
        delete m_values->topLevelItem(m_values->topLevelItemCount() - 1);
    if (variables.empty()) return;
    const auto program = m_control.session()->program();
    for (size_t i = 0; i < variables.size(); ++i)
        fillValue(static_cast<int>(i) < m_values->topLevelItemCount() ? m_values->topLevelItem(static_cast<int>(i))
                                                                      : new QTreeWidgetItem(m_values),
                  *program->layout.types, kit::fromView(variables[i].first), variables[i].second);
}

bool CallPathView::showsItsMoment() const {
    if (m_control.showsRecorded()) return false;
    if (m_control.viewed()) return m_control.faultScan().isShown();
    const std::optional<history::Position> fault = m_control.faultScan().position();
    return !fault || *fault + 1 == m_control.shownHistory()->statistics().end; // else the plant has gone on
}

void CallPathView::refresh() {
    m_frames->clear();
    m_ranges.clear();
    m_none->setVisible(m_control.hasValues() && !showsItsMoment());
    if (!m_control.session() || m_control.isEnding() || !showsItsMoment()) return showValues();
    const auto add = [&](const std::string& function, const std::string& instance, SourceRange range) {
        auto* item = new QTreeWidgetItem(m_frames, {kit::fromView(function), kit::fromView(instance)});
        m_ranges.push_back(range);
        if (const auto place = m_control.placeInText(range))
            item->setText(2, QString("%1:%2").arg(place->file).arg(place->line));
    };
    if (m_control.status().state == controller::State::Halted)
        for (const session::FaultFrame& frame : m_control.session()->haltFrames())
            add(frame.function, frame.instance, frame.range);
    else if (m_control.status().fault)
        for (const controller::FaultFrame& frame : m_control.status().fault->calls)
            add(frame.function, frame.instance, frame.range);
    if (m_frames->topLevelItemCount()) m_frames->setCurrentItem(m_frames->topLevelItem(0));
    showValues();
}

// ------------------------------------------------------------------ breakpoints

BreakpointView::BreakpointView(RunControl& control, QWidget* parent) : QWidget(parent), m_control(control) {
    QToolBar* bar = makeBar(this);
    m_tree = makeTree(this, {tr("Place"), tr("Condition"), tr("Hit count"), tr("Instance")}, tr("Breakpoints"));
    m_tree->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_tree->setColumnWidth(0, 140);
    m_tree->setColumnWidth(1, 110);
    m_tree->header()->setSectionResizeMode(2, QHeaderView::ResizeToContents); // in sight in every language
    connect(bar->addAction(kit::icon(kit::Icon::Delete), tr("Remove selected")), &QAction::triggered, this, [this] {
        auto list = m_control.breakpoints();
        for (QTreeWidgetItem* item : m_tree->selectedItems())
            std::erase_if(list, [&](const EditorBreakpoint& b) {
                return b.file == item->data(0, Qt::UserRole).toString() &&
                       b.line == item->data(1, Qt::UserRole).toInt();
            });
        m_control.setBreakpoints(list);
    });
    connect(bar->addAction(kit::icon(kit::Icon::Clear), tr("Remove all")), &QAction::triggered, this,
            [this] { m_control.setBreakpoints({}); });
    stack(this, {bar, m_tree});
    connect(&control, &RunControl::breakpointsChanged, this, &BreakpointView::reload);
    connect(m_tree, &QTreeWidget::itemChanged, this, &BreakpointView::takeEdits);
    connect(m_tree, &QTreeWidget::itemActivated, this, [this](QTreeWidgetItem* item, int column) {
        if (column == 0)
            emit lineRequested(item->data(0, Qt::UserRole).toString(), item->data(1, Qt::UserRole).toInt());
    });
}

void BreakpointView::reload() {
    const QSignalBlocker blocker(m_tree);
    m_tree->clear();
    for (const EditorBreakpoint& each : m_control.breakpoints()) {
        auto* item =
            new QTreeWidgetItem(m_tree, {QString("%1:%2").arg(each.file).arg(each.line), each.condition,
                                         each.hitCount ? QString::number(each.hitCount) : QString(), each.instance});
        item->setFlags(item->flags() | Qt::ItemIsEditable | Qt::ItemIsUserCheckable);
        if (!each.hasCode) {
            item->setForeground(0, kit::colors().muted);
            item->setToolTip(
                0, tr("The running program has no code at or below this line; choose a line with a statement"));
        }
        item->setCheckState(0, each.isEnabled ? Qt::Checked : Qt::Unchecked);
        item->setData(0, Qt::UserRole, each.file);
        item->setData(1, Qt::UserRole, each.line);
    }
}

void BreakpointView::takeEdits(QTreeWidgetItem* item) {
    auto list = m_control.breakpoints();
    for (EditorBreakpoint& each : list)
        if (each.file == item->data(0, Qt::UserRole).toString() && each.line == item->data(1, Qt::UserRole).toInt()) {
            each.condition = item->text(1).trimmed();
            each.hitCount = item->text(2).toInt();
            each.instance = item->text(3).trimmed();
            each.isEnabled = item->checkState(0) == Qt::Checked;
        }
    kit::post(this, [this, list] { m_control.setBreakpoints(list); });
}

// ------------------------------------------------------------------ tasks

/// Execution times of the selected task, powers of two from 1 µs.
class TaskMonitor::Histogram : public QWidget {
public:
    explicit Histogram(QWidget* parent) : QWidget(parent) {
        setMinimumHeight(110);
        setAccessibleName(TaskMonitor::tr("Histogram of execution times"));
    }
    void show(const std::vector<uint32_t>& bins) {
        if (m_bins == bins) return;
        m_bins = bins;
        update();
    }

protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        const kit::ThemeColors& c = kit::colors();
        painter.fillRect(rect(), c.base);
        size_t last = m_bins.size();
        while (last > 8 && m_bins[last - 1] == 0) --last;
        const uint32_t highest = m_bins.empty() ? 0 : *std::max_element(m_bins.begin(), m_bins.end());
        if (highest == 0) {
            painter.setPen(c.muted);
            painter.drawText(rect(), Qt::AlignCenter,
                             TaskMonitor::tr("Execution times appear here while the controller runs"));
            return;
        }
        const int base = height() - 20, left = 8, width = this->width() - 16;
        const double column = static_cast<double>(width) / static_cast<double>(last);
        QFont small = font();
        small.setPointSizeF(small.pointSizeF() * 0.85);
        painter.setFont(small);
        for (size_t i = 0; i < last; ++i) {
            const double share = std::log1p(m_bins[i]) / std::log1p(highest);
            const QRectF bar(left + column * static_cast<double>(i) + 1.5, base - share * (base - 8), column - 3,
                             share * (base - 8));
            painter.setPen(Qt::NoPen);
            painter.setBrush(c.accent);
            painter.drawRoundedRect(bar, 2, 2);
            painter.setPen(c.muted);
            const QString label = nanosecondsText(1e3 * std::pow(2.0, static_cast<double>(i)));
            if (column > painter.fontMetrics().horizontalAdvance(label) + 4 || i % 4 == 0)
                painter.drawText(QRectF(left + column * static_cast<double>(i) - 20, base + 2, column + 40, 16),
                                 Qt::AlignCenter, label);
        }
    }

private:
    std::vector<uint32_t> m_bins;
};

TaskMonitor::TaskMonitor(RunControl& control, QWidget* parent) : QWidget(parent), m_control(control) {
    QToolBar* bar = makeBar(this);
    m_tree = makeTree(this,
                      {tr("Task"), tr("Runs"), tr("Last"), tr("Min"), tr("Mean"), tr("Max"), tr("Jitter"),
                       tr("Overruns"), tr("Load")},
                      tr("Tasks"));
    m_histogram = new Histogram(this);
    connect(bar->addAction(kit::icon(kit::Icon::Clear), tr("Reset the statistics")), &QAction::triggered, this, [this] {
        if (m_control.session()) m_control.session()->resetTaskStatistics();
    });
    for (int column = 1; column < 9; ++column) m_tree->setColumnWidth(column, 76);
    m_tree->setColumnWidth(0, 110);
    stack(this, {bar, m_tree, m_histogram});
    connect(&control, &RunControl::refreshed, this, &TaskMonitor::refresh);
}

void TaskMonitor::refresh() {
    if (!isVisible()) return;
    const auto tasks =
        m_control.session() ? m_control.session()->taskStatistics() : std::vector<controller::TaskStatistics>();
    while (m_tree->topLevelItemCount() > static_cast<int>(tasks.size()))
        delete m_tree->topLevelItem(m_tree->topLevelItemCount() - 1);
    for (size_t i = 0; i < tasks.size(); ++i) {
        const controller::TaskStatistics& task = tasks[i];
        QTreeWidgetItem* item = static_cast<int>(i) < m_tree->topLevelItemCount()
                                    ? m_tree->topLevelItem(static_cast<int>(i))
                                    : new QTreeWidgetItem(m_tree);
        double interval = 0;
        for (const image::Task& each : m_control.session()->program()->tasks)
            if (each.name == task.name) interval = static_cast<double>(each.interval.count());
        const QStringList columns{kit::fromView(task.name),
                                  QString::number(task.count),
                                  nanosecondsText(static_cast<double>(task.lastNs)),
                                  nanosecondsText(static_cast<double>(task.minNs)),
                                  nanosecondsText(task.meanNs),
                                  nanosecondsText(static_cast<double>(task.maxNs)),
                                  nanosecondsText(static_cast<double>(task.jitterNs)),
                                  QString::number(task.overruns),
                                  interval > 0
                                      ? QString("%1 %").arg(QLocale().toString(100 * task.meanNs / interval, 'f', 2))
                                      : QString("–")};
        for (int column = 0; column < columns.size(); ++column) {
            item->setText(column, columns[column]);
            if (column) item->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
        }
        item->setForeground(7, task.overruns ? kit::colors().warning : kit::colors().text);
    }
    const int row = std::max(0, m_tree->indexOfTopLevelItem(m_tree->currentItem()));
    m_histogram->show(row < static_cast<int>(tasks.size()) ? tasks[static_cast<size_t>(row)].histogram
                                                           : std::vector<uint32_t>());
}

// ------------------------------------------------------------------ log

namespace {
constexpr int kProblemRole = Qt::UserRole;
constexpr int kMostEvents = 5000;
} // namespace

EventLog::EventLog(RunControl& control, QWidget* parent) : QWidget(parent), m_control(control) {
    QToolBar* bar = makeBar(this);
    m_tree = makeTree(this, {tr("Time"), tr("PLC time"), tr("Scan"), tr("Event")}, tr("Events"));
    m_tree->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_tree->setColumnWidth(0, 80);
    m_tree->setColumnWidth(1, 110);
    m_tree->setColumnWidth(2, 80);
    connect(bar->addAction(kit::icon(kit::Icon::Clear), tr("Clear")), &QAction::triggered, m_tree, &QTreeWidget::clear);
    QAction* copyRows = bar->addAction(kit::icon(kit::Icon::Copy), tr("Copy the selected rows, or all rows"));
    connect(copyRows, &QAction::triggered, this, &EventLog::copy);
    auto* copyKey = new QAction(kit::icon(kit::Icon::Copy), tr("Copy"), m_tree);
    copyKey->setShortcut(QKeySequence::Copy);
    copyKey->setShortcutContext(Qt::WidgetShortcut);
    connect(copyKey, &QAction::triggered, this, &EventLog::copy);
    m_tree->addAction(copyKey);
    m_tree->setContextMenuPolicy(Qt::ActionsContextMenu);
    m_problemsOnly = bar->addAction(kit::icon(kit::Icon::Warning), tr("Only faults and rejections"));
    m_problemsOnly->setCheckable(true);
    connect(m_problemsOnly, &QAction::toggled, this, &EventLog::filterAll);
    m_filter = new QLineEdit(bar);
    m_filter->setPlaceholderText(tr("Filter"));
    m_filter->setAccessibleName(tr("Filter of the events"));
    m_filter->setClearButtonEnabled(true);
    m_filter->setMaximumWidth(260);
    connect(m_filter, &QLineEdit::textChanged, this, &EventLog::filterAll);
    bar->addWidget(m_filter);
    stack(this, {bar, m_tree});
    connect(&control, &RunControl::refreshed, this, &EventLog::refresh);
    connect(&control, &RunControl::sessionChanged, this, [this] { m_seen = 0; });
    connect(&control, &RunControl::messageAdded, this, &EventLog::addMessage);
    connect(m_tree->verticalScrollBar(), &QScrollBar::rangeChanged, this, [this](int, int last) {
        if (m_follows) m_tree->verticalScrollBar()->setValue(last); // also when the window gets another size
    });
    connect(m_tree->verticalScrollBar(), &QScrollBar::actionTriggered, this, [this] { // by the user only
        const QScrollBar& bar = *m_tree->verticalScrollBar();
        m_follows = bar.sliderPosition() >= bar.maximum();
    });
    connect(m_tree, &QTreeWidget::itemActivated, this, [this](QTreeWidgetItem* item) {
        const QString place = item->data(3, Qt::UserRole).toString();
        if (!place.isEmpty()) emit lineRequested(place.section(':', 0, -2), place.section(':', -1).toInt());
    });
}

/// File and line of a fault or a halt; of older ones nobody knows it any more.
QString EventLog::placeOf(const controller::Event& event) const {
    using controller::EventKind;
    std::optional<RunControl::TextPlace> place;
    if (event.kind == EventKind::Fault) {
        const session::Status status = m_control.session()->status(); // the window's own may be older than the event
        const auto& fault = status.fault ? status.fault : status.simulationFault;
        if (fault) place = m_control.placeInText(fault->range);
    } else if (event.kind == EventKind::Breakpoint) {
        const auto frames = m_control.session()->haltFrames();
        if (!frames.empty()) place = m_control.placeInText(frames.front().range);
    }
    return place ? QString("%1:%2").arg(place->file).arg(place->line) : QString();
}

void EventLog::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    if (m_follows) m_tree->scrollToBottom(); // rows that came while it was hidden were not laid out
}

void EventLog::add(const QStringList& columns, int icon, bool isProblem) {
    auto* item = new QTreeWidgetItem(m_tree, columns);
    item->setIcon(3, kit::icon(static_cast<kit::Icon>(icon)));
    item->setData(0, kProblemRole, isProblem);
    filter(item);
    if (m_tree->topLevelItemCount() > kMostEvents) delete m_tree->topLevelItem(0);
    if (m_follows) m_tree->scrollToBottom();
}

void EventLog::filter(QTreeWidgetItem* item) {
    const QString wanted = m_filter->text().trimmed();
    bool isShown = wanted.isEmpty();
    for (int column = 0; column < m_tree->columnCount() && !isShown; ++column)
        isShown = item->text(column).contains(wanted, Qt::CaseInsensitive);
    item->setHidden(!isShown || (m_problemsOnly->isChecked() && !item->data(0, kProblemRole).toBool()));
}

void EventLog::filterAll() {
    for (int row = 0; row < m_tree->topLevelItemCount(); ++row) filter(m_tree->topLevelItem(row));
}

QString EventLog::shownText() const {
    const bool all = m_tree->selectedItems().isEmpty();
    QString out;
    for (int row = 0; row < m_tree->topLevelItemCount(); ++row) {
        const QTreeWidgetItem* item = m_tree->topLevelItem(row);
        if (item->isHidden() || !(all || item->isSelected())) continue;
        QStringList columns;
        for (int column = 0; column < m_tree->columnCount(); ++column) columns << item->text(column);
        out += columns.join('\t') + '\n';
    }
    return out;
}

void EventLog::copy() { QApplication::clipboard()->setText(shownText()); }

void EventLog::addMessage(const QString& message, bool isError) {
    add({QTime::currentTime().toString("HH:mm:ss"), {}, {}, message},
        static_cast<int>(isError ? kit::Icon::Error : kit::Icon::Information), isError);
}

EventLog::Kept EventLog::release() {
    Kept kept;
    kept.seen = m_seen;
    while (m_tree->topLevelItemCount() > 0) kept.rows.push_back(m_tree->takeTopLevelItem(0));
    return kept;
}

void EventLog::restore(Kept kept) {
    m_seen = kept.seen;
    for (QTreeWidgetItem* row : kept.rows) m_tree->addTopLevelItem(row);
    m_tree->scrollToBottom();
}

void EventLog::refresh() {
    if (!m_control.session()) return;
    const auto events = m_control.session()->eventsSince(m_seen);
    m_seen += events.size();
    for (const controller::Event& event : events) {
        using controller::EventKind;
        const kit::Icon icon = event.kind == EventKind::Fault                                       ? kit::Icon::Error
                               : event.kind == EventKind::Force || event.kind == EventKind::Release ? kit::Icon::Force
                               : event.kind == EventKind::OnlineChange ? kit::Icon::OnlineChange
                               : event.kind == EventKind::Breakpoint   ? kit::Icon::Breakpoint
                               : event.kind == EventKind::SkippedScans ? kit::Icon::Warning
                                                                       : kit::Icon::Information;
        const QString place = &event == &events.back() || event.kind == EventKind::Fault ? placeOf(event) : QString();
        QString shown = trace::markText(static_cast<int>(event.kind), event.text);
        if (event.kind == EventKind::Breakpoint && !place.isEmpty() && !m_control.hasBreakpoint(place))
            shown = tr("Step: %1").arg(kit::messageText(event.text)); // nothing but a step can have ended there
        if (!place.isEmpty()) shown = tr("%1 at %2", "event at file:line").arg(shown, place);
        add({QTime::currentTime().toString("HH:mm:ss"), plot::momentText(event.time.count()),
             QString::number(event.scan), shown},
            static_cast<int>(icon), event.kind == EventKind::Fault || event.kind == EventKind::SkippedScans);
        m_tree->topLevelItem(m_tree->topLevelItemCount() - 1)->setData(3, Qt::UserRole, place);
    }
}

} // namespace plc::editor
