#include "editor/trace/trace_view.h"

#include "editor/kit/edit_history.h"
#include "editor/kit/icons.h"
#include "editor/kit/message_text.h"
#include "editor/kit/theme.h"
#include "editor/plot/painting/plot_table.h"
#include "editor/plot/plot_export.h"
#include "editor/trace/channel_panel.h"
#include "editor/trace/figure_pane.h"
#include "editor/trace/recording/run_recording.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QSplitter>
#include <QTableWidget>
#include <QToolBar>
#include <QVBoxLayout>

namespace plc::trace {

namespace {
constexpr auto Frame = std::chrono::milliseconds(33);
constexpr auto ReadBudget = std::chrono::milliseconds(8);
} // namespace

TraceView::TraceView(QWidget* parent)
    : QWidget(parent), m_store(std::make_shared<history::ColumnStore>()), m_others(m_store) {
    setAccessibleName(tr("Trace"));
    m_plot = new plot::PlotView(this);
    m_channels = new ChannelPanel(this);
    m_figure = new FigurePane(this);
    m_table = new QTableWidget(this);
    m_table->setAccessibleName(tr("Measurements"));
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->verticalHeader()->hide();
    m_table->setShowGrid(false);
    m_table->setAlternatingRowColors(true);
    m_table->hide();
    m_state = new QLabel(this);
    m_memory = new QLabel(this);
    auto* bar = new QToolBar(this);
    makeActions(bar);

    auto* right = new QSplitter(Qt::Vertical, this);
    m_charts = new QSplitter(Qt::Vertical, right);
    m_charts->addWidget(m_plot);
    m_charts->addWidget(m_figure);
    m_charts->setStretchFactor(0, 1);
    m_charts->setStretchFactor(1, 1);
    right->addWidget(m_charts);
    right->addWidget(m_table);
    right->setStretchFactor(0, 8);
    right->setStretchFactor(1, 1);
    auto* splitter = new QSplitter(Qt::Horizontal, this);
    splitter->addWidget(m_channels);
    splitter->addWidget(right);
    splitter->setStretchFactor(0, 0);
    splitter->setStretchFactor(1, 1);
    splitter->setSizes({260, 900});
    m_sides = splitter;
    auto* status = new QHBoxLayout;
    status->setContentsMargins(8, 2, 8, 3);
    status->addWidget(m_state);
    status->addStretch();
    status->addWidget(m_memory);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(bar);
    layout->addWidget(splitter, 1);
    layout->addLayout(status);

    m_channels->setCompletionSource(
        [this](const QString& text, int cursor) { return m_variables.complete(text, cursor); });
    m_channels->setCheck([this](const QString& text) {
        if (!m_recording) return QString();
        const auto type = channelTypeOf(*m_recording, text.trimmed().toStdString());
        return type ? QString() : kit::messageText(type.error().message);
    });
    m_channels->setPicker([this](const QString& current) { return kit::pickVariable(m_variables, current, this); });
    connect(m_channels, &ChannelPanel::changeRequested, this,
            [this](const QString& text, const std::function<void(TraceSetup&)>& f) { change(text, f); });
    connect(m_figure, &FigurePane::changeRequested, this,
            [this](const QString& text, const std::function<void(TraceSetup&)>& f) { change(text, f); });
    connect(m_figure, &FigurePane::failed, this, &TraceView::failed);
    connect(m_channels, &ChannelPanel::channelWanted, this, &TraceView::addChannel);
    connect(m_channels, &ChannelPanel::channelSelected, this, [this](int channel) {
        m_plot->edit([channel](plot::PlotModel& model) {
            model.selected = channel >= 0 ? QString::number(channel) : QString();
        });
    });
    connect(m_plot, &plot::PlotView::variablesDropped, this, [this](const QStringList& paths, int chart) {
        for (const QString& path : paths) addChannel(path, chart);
    });
    connect(m_plot, &plot::PlotView::curveToggled, this, [this](const QString& id, bool visible) {
        const int channel = id.toInt();
        change(visible ? tr("Show channel") : tr("Hide channel"),
               [channel, visible](TraceSetup& s) { s.channels[static_cast<size_t>(channel)].isVisible = visible; });
    });
    connect(m_plot, &plot::PlotView::curveSelected, this, [this](const QString& id) {
        if (!id.isEmpty()) m_channels->selectChannel(id.toInt());
    });
    connect(m_plot, &plot::PlotView::followingChanged, m_follow, &QAction::setChecked);
    connect(m_plot, &plot::PlotView::toolChanged, this,
            [this](plot::PlotTool tool) { toolAction(tool)->setChecked(true); });
    connect(m_plot, &plot::PlotView::cursorsChanged, this, [this] {
        m_cursors->setChecked(m_plot->hasCursors());
        showTable();
        m_channels->showValues(m_plot->model());
    });
    connect(m_plot, &plot::PlotView::menuRequested, this, &TraceView::plotMenu);
    connect(m_plot, &plot::PlotView::timeActivated, this, [this](qint64 time) {
        if (!m_recording) return;
        if (const auto position = m_recording->positionAt(time)) emit positionActivated(*position);
    });
    connect(&m_undo, &QUndoStack::indexChanged, this, &TraceView::setupChanged);
    connect(&kit::Theme::current(), &kit::Theme::changed, this, &TraceView::rebuildModel);
    m_timer.setInterval(Frame);
    connect(&m_timer, &QTimer::timeout, this, &TraceView::tick);
    m_plot->edit([](plot::PlotModel& model) { model.to = 10'000'000'000; });
    m_plot->setFollowing(true);
    m_follow->setChecked(true);
    setupTaken();
}

TraceView::~TraceView() {
    m_undo.disconnect(this);
    m_plot->disconnect(this);
}

/// In a narrow window the plot keeps the larger part.
void TraceView::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    const QList<int> sizes = m_sides->sizes();
    constexpr int LeastPlot = 360, LeastChannels = 120, UsualChannels = 260;
    if (sizes.value(0) > 0 && sizes.value(1) < LeastPlot && sizes.value(0) > sizes.value(1) / 2) {
        const int channels = std::clamp(width() - LeastPlot, LeastChannels, UsualChannels);
        m_sides->setSizes({channels, std::max(width() - channels, 1)});
    }
    // one above the other needs height, which a dock below the editor does not have
    constexpr int LeastHeight = 480;
    m_charts->setOrientation(height() < LeastHeight && width() > LeastHeight * 3 / 2 ? Qt::Horizontal : Qt::Vertical);
}

void TraceView::setFolder(const QString& folder) {
    if (folder == m_folder) return;
    m_folder = folder;
    m_plot->edit([](plot::PlotModel& model) { // another project begins at its own time
        model.to -= model.from;
        model.from = 0;
    });
    m_plot->setFollowing(true);
}

void TraceView::setSetup(TraceSetup setup) {
    m_setup = std::move(setup);
    m_undo.clear();
    m_plot->edit([this](plot::PlotModel& model) {
        model.to = model.from + std::max<int64_t>(m_setup.span, 1000);
        model.cursorA = m_setup.cursorA;
        model.cursorB = m_setup.cursorB;
        for (plot::PlotChart& chart : model.charts)
            for (plot::PlotAxis& axis : chart.axes) axis.zoom.reset();
    });
    m_cursors->setChecked(m_plot->hasCursors());
    setupTaken();
    emit setupChanged();
}

Result<void> TraceView::openSetup(const QString& path) {
    auto setup = loadSetup(path.toStdString());
    if (!setup) return setup.error();
    m_path = path;
    setSetup(std::move(*setup));
    return {};
}

Result<void> TraceView::storeSetup(const QString& path) {
    m_setup.span = m_plot->model().to - m_plot->model().from;
    m_setup.cursorA = m_plot->model().cursorA;
    m_setup.cursorB = m_plot->model().cursorB;
    auto result = saveSetup(m_setup, path.toStdString());
    if (!result) return result;
    m_path = path;
    m_undo.setClean();
    emit setupChanged();
    return {};
}

TraceSetup TraceView::applyEdit(const TraceSetup& next) {
    TraceSetup before = std::exchange(m_setup, next);
    setupTaken();
    return before;
}

void TraceView::change(const QString& text, const std::function<void(TraceSetup&)>& change, int mergeId) {
    TraceSetup next = m_setup;
    change(next);
    if (next == m_setup) return;
    m_undo.push(new kit::EditCommand<TraceSetup>(
        text, std::move(next), [this](const TraceSetup& edit) { return applyEdit(edit); }, mergeId));
}

void TraceView::addChannel(const QString& expression, int chart) {
    change(tr("Add channel"), [&](TraceSetup& s) {
        ChannelSetup channel;
        channel.expression = expression.trimmed().toStdString();
        channel.chart = std::clamp(chart, 0, static_cast<int>(s.charts.size()) - 1);
        channel.unit = m_variables.unitOf(expression.trimmed()).toStdString();
        s.channels.push_back(std::move(channel));
    });
}

void TraceView::renameExpressions(const std::function<QString(const QString& expression)>& renamed) {
    change(tr("Rename"), [&](TraceSetup& setup) {
        forEachExpression(setup, [&](std::string& expression) {
            expression = renamed(QString::fromStdString(expression)).toStdString();
        });
    });
}

void TraceView::followOthers() {
    m_others.follow(m_setup,
                    [this](const std::string& file) { return readFile(inProject(QString::fromStdString(file))); });
    m_others.pump(ReadBudget);
}

void TraceView::setupTaken() {
    followCompareWith();
    followOthers();
    if (m_feed) {
        m_feed->setSettings({m_setup.every, m_setup.condition});
        m_feed->setExpressions(expressionsOf(m_setup), m_setup.trigger.expression);
        m_feed->pump(ReadBudget);
    }
    if (m_olderFeed) {
        m_olderFeed->setExpressions(expressionsOf(m_setup));
        m_olderFeed->pump(ReadBudget);
    }
    m_trigger.setSetup(m_setup.trigger);
    m_triggerRead = INT64_MIN;
    m_shots = 0;
    if (const auto source = m_feed && !m_opened ? m_feed->triggerSource()
                                                : nullptr) // only what is yet to come fires it; of a file, all that was
        if (const auto range = source->timeRange()) m_triggerRead = range->second;
    m_tableShown->setChecked(m_setup.hasTable);
    rebuildModel();
}

void TraceView::rebuildModel() {
    m_plot->edit([this](plot::PlotModel& model) {
        applySetup(model, m_setup, m_feed.get(), &m_others);
        model.beneathName.clear();
        if (m_olderFeed) applyBeneath(model, m_setup, *m_olderFeed);
    });
    m_channels->showSetup(m_setup, m_plot->model());
    drawFigure();
    showTable();
    showStatus();
}

void TraceView::tick() {
    if (!m_recording) return;
    m_feed->pump(ReadBudget);
    if (m_olderFeed) m_olderFeed->pump(ReadBudget);
    if (!m_others.isEmpty()) m_others.pump(ReadBudget);
    if (const size_t marks = m_recording->marks().size(); marks != m_marks) {
        m_marks = marks;
        m_plot->edit([this](plot::PlotModel& model) { applyMarks(model, *m_recording, m_feed->chain()); });
    }
    runTrigger();
    m_plot->refresh();
    if (++m_ticks % 4 != 0) return; // figures are read by people
    m_channels->showValues(m_plot->model());
    followFigure();
    showStatus();
}

void TraceView::runTrigger() {
    if (m_trigger.state() == TriggerState::Off || m_trigger.state() == TriggerState::Done) return;
    const auto source = m_feed->triggerSource();
    if (!source) return;
    const auto range = source->timeRange();
    if (!range) return;
    if (range->second < m_triggerRead) m_triggerRead = range->second; // went back
    source->visit(m_triggerRead == INT64_MIN ? INT64_MIN : m_triggerRead + 1, INT64_MAX,
                  [&](std::span<const SignalSample> block) {
                      for (const SignalSample& s : block)
                          m_trigger.feed(s.time, std::isnan(s.value) ? std::nullopt : std::optional(s.value != 0));
                  });
    m_triggerRead = range->second;
    if (m_trigger.shots() == m_shots) return;
    m_shots = m_trigger.shots();
    showShot(*m_trigger.completeAt());
}

void TraceView::showShot(int64_t time) {
    m_plot->setFollowing(false);
    m_plot->edit([time](plot::PlotModel& model) {
        model.trigger = time;
        model.origin = time;
    });
    m_plot->setRange(time - m_setup.trigger.before,
                     std::max(time + m_setup.trigger.after, time - m_setup.trigger.before + 1000));
    m_arm->setChecked(m_trigger.state() == TriggerState::Armed);
    showTable();
    showStatus();
}

void TraceView::armTrigger() {
    if (m_setup.trigger.mode == TriggerMode::Off && !m_setup.trigger.expression.empty())
        change(tr("Arm trigger"), [](TraceSetup& s) { s.trigger.mode = TriggerMode::Single; });
    else
        m_trigger.arm();
    if (m_opened) m_triggerRead = INT64_MIN; // nothing more comes: the first in the file
    m_arm->setChecked(m_trigger.state() == TriggerState::Armed);
    if (m_setup.trigger.expression.empty()) {
        m_channels->list()->setCurrentItem(nullptr); // the trace's own properties hold the trigger
        emit failed(tr("The trigger has no expression yet: enter one in the properties of the trace."));
    }
    m_plot->edit([](plot::PlotModel& model) {
        model.trigger.reset();
        model.origin = 0;
    });
    if (!m_opened) m_plot->setFollowing(true);
    showStatus();
}

bool TraceView::findTrigger(history::History::Direction direction) {
    const TriggerSetup& t = m_setup.trigger;
    if (!m_recording || t.expression.empty()) return false;
    const plot::PlotModel& model = m_plot->model();
    const auto from = m_recording->positionAt(model.trigger.value_or(model.from + (model.to - model.from) / 2));
    if (!from) return false;
    std::optional<Position> found;
    auto look = [&](const std::string& expression) {
        const auto position = m_recording->find(expression, *from, direction);
        if (position && (!found || (direction == history::History::Direction::Forward) == (*position < *found)))
            found = position;
    };
    if (t.edge != TriggerEdge::Falling) look(t.expression);
    if (t.edge == TriggerEdge::Falling || t.edge == TriggerEdge::Both) look("NOT (" + t.expression + ")");
    const auto stamp = found ? m_recording->stamp(*found) : std::nullopt;
    if (!stamp) return false;
    showShot(stamp->time.count());
    return true;
}

void TraceView::showPosition(std::optional<Position> position) {
    const auto stamp = position && m_recording ? m_recording->stamp(*position) : std::nullopt;
    const bool comesBack = !position && m_plot->model().present && !m_opened;
    m_plot->edit([&](plot::PlotModel& model) {
        model.present.reset();
        if (stamp) model.present = stamp->time.count();
    });
    if (stamp) showTime(stamp->time.count());
    if (comesBack) m_plot->setFollowing(true);
    m_channels->showValues(m_plot->model());
}

void TraceView::showTime(int64_t time) {
    const plot::PlotModel& model = m_plot->model();
    if (time >= model.from && time <= model.to) return;
    const int64_t span = model.to - model.from;
    m_plot->setFollowing(false);
    m_plot->setRange(time - span / 2, time - span / 2 + span);
}

void TraceView::setColumnBudget(size_t bytes) {
    m_store->setBudget(bytes);
    showStatus();
}

void TraceView::showTable() {
    const bool shown = m_setup.hasTable && m_plot->hasCursors();
    m_table->setVisible(shown);
    if (!shown) return;
    const plot::MeasureTable table = plot::measureTable(m_plot->model(), true);
    m_table->setColumnCount(static_cast<int>(table.headers.size()));
    m_table->setHorizontalHeaderLabels(table.headers);
    m_table->setRowCount(static_cast<int>(table.rows.size()));
    for (int r = 0; r < m_table->rowCount(); ++r)
        for (int c = 0; c < m_table->columnCount(); ++c) {
            const plot::MeasureTable::Row& row = table.rows[static_cast<size_t>(r)];
            auto* item = new QTableWidgetItem(row.cells[c]);
            if (c == 0)
                item->setForeground(row.color);
            else
                item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
            m_table->setItem(r, c, item);
        }
    m_table->resizeColumnsToContents();
    m_table->resizeRowsToContents();
    int height = m_table->horizontalHeader()->sizeHint().height() + 4;
    for (int r = 0; r < std::min(6, m_table->rowCount()); ++r) height += m_table->rowHeight(r);
    m_table->setMinimumHeight(std::min(height, std::max(90, this->height() / 3))); // the charts come first
    m_table->setMaximumHeight(std::max(height, 300));
    m_table->setToolTip(table.headline);
}

QString TraceView::statusText() const {
    QString trigger;
    switch (m_trigger.state()) {
    case TriggerState::Off:
        trigger = m_setup.trigger.expression.empty() ? QString() : tr("Trigger off");
        break;
    case TriggerState::Armed:
        trigger = tr("Trigger armed");
        break;
    case TriggerState::Collecting:
        trigger = tr("Triggered, collecting");
        break;
    case TriggerState::Done:
        trigger = tr("Triggered");
        break;
    }
    if (m_shots > 0 && m_setup.trigger.mode == TriggerMode::Repeated)
        trigger += QLatin1Char(' ') + tr("(%n shot(s))", nullptr, static_cast<int>(m_shots));
    if (const plot::PlotModel& model = m_plot->model(); model.cursorA && model.cursorB) {
        const QString cursors = plot::measureTable(model).headline;
        return trigger.isEmpty() ? cursors : trigger + QStringLiteral("     ") + cursors;
    }
    return trigger;
}

void TraceView::showStatus() {
    m_state->setText(statusText());
    if (!m_recording) {
        m_memory->setText(tr("Not running"));
        return;
    }
    const history::Statistics s = m_recording->statistics();
    auto megabytes = [](size_t bytes) { return QLocale().toString(static_cast<double>(bytes) / 1048576.0, 'f', 1); };
    const QString file = m_opened ? m_openedName + QStringLiteral("  ·  ") : QString();
    m_memory->setText(file + tr("%L1 scans kept  ·  history %2 of %3 MB  ·  channels %4 of %5 MB")
                                 .arg(s.scans)
                                 .arg(megabytes(s.bytes), megabytes(s.budget), megabytes(m_store->bytes()),
                                      megabytes(m_store->budget())));
}

void TraceView::askWhy(kit::AskWhy question, int channel) {
    if (channel < 0 || static_cast<size_t>(channel) >= m_setup.channels.size()) return;
    std::optional<Position> at;
    if (const auto cursor = m_plot->model().cursorA ? m_plot->model().cursorA : m_plot->model().cursorB;
        cursor && m_recording)
        at = m_recording->positionAt(*cursor);
    emit whyRequested(question, QString::fromStdString(m_setup.channels[static_cast<size_t>(channel)].expression), at);
}

void TraceView::plotMenu(const QPoint& global, int chart, const QString& curve) {
    QMenu menu(this);
    if (!curve.isEmpty()) {
        const int channel = curve.toInt();
        menu.addAction(kit::icon(kit::Icon::Configuration), tr("Properties"), this,
                       [this, channel] { m_channels->selectChannel(channel); });
        menu.addAction(kit::icon(kit::Icon::Delete), tr("Remove Channel"), this, [this, channel] {
            change(tr("Remove Channel"), [channel](TraceSetup& s) { s.channels.erase(s.channels.begin() + channel); });
        });
        kit::addWhyActions(menu, [this, channel](kit::AskWhy question) { askWhy(question, channel); });
        menu.addSeparator();
    }
    menu.addAction(kit::icon(kit::Icon::Add), tr("Add Channel…"), this, [this, chart] {
        if (const auto path = kit::pickVariable(m_variables, {}, this)) addChannel(*path, chart);
    });
    menu.addAction(kit::icon(kit::Icon::Fit), tr("Fit"), m_plot, &plot::PlotView::fit);
    menu.addAction(kit::icon(kit::Icon::Cursor), tr("Cursors"), this,
                   [this] { m_plot->setCursorsShown(!m_plot->hasCursors()); });
    addNoteActions(menu, global);
    addFigureActions(*menu.addMenu(kit::icon(kit::Icon::Trace), tr("Show Beside")));
    menu.addAction(kit::icon(kit::Icon::Copy), tr("Copy as Picture"), this, [this] {
        plot::copyPicture(m_plot->model(), {m_plot->size(), 2});
    });
    menu.exec(global);
}

void TraceView::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    m_timer.start();
}

void TraceView::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    m_timer.stop();
}

} // namespace plc::trace
