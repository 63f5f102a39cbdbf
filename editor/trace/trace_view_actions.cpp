// The tool bar of TraceView: its actions and menus, export and print.
#include "editor/kit/bar_menu.h"
#include "editor/kit/edit_history.h"
#include "editor/kit/icons.h"
#include "editor/kit/long_task.h"
#include "editor/kit/message_text.h"
#include "editor/kit/own_keys.h"
#include "editor/kit/paper.h"
#include "editor/plot/plot_export.h"
#include "editor/trace/channel_panel.h"
#include "editor/trace/figure_pane.h"
#include "editor/trace/recording/run_recording.h"
#include "editor/trace/trace_view.h"

#include <QAction>
#include <QActionGroup>
#include <QFileDialog>
#include <QMenu>
#include <QPainter>
#include <QPrintDialog>
#include <QPrinter>
#include <QToolBar>

namespace plc::trace {

namespace {

template <typename Run>
QAction* addTool(QToolBar& bar, TraceView& view, kit::Icon icon, const QString& text, const QString& tip, Run&& run) {
    QAction* action = bar.addAction(kit::icon(icon), text);
    action->setToolTip(tip);
    QObject::connect(action, &QAction::triggered, &view, run);
    return action;
}

QAction* checkable(QAction* action) {
    action->setCheckable(true);
    return action;
}

} // namespace

void TraceView::makeActions(QToolBar* bar) {
    bar->setIconSize(QSize(18, 18));
    addViewActions(bar);
    bar->addSeparator();
    addToolActions(bar);
    bar->addSeparator();
    addTriggerActions(bar);
    bar->addSeparator();
    addChartActions(bar);
    auto* spacer = new QWidget(bar);
    spacer->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    bar->addWidget(spacer);
    QMenu* figures =
        kit::addBarMenu(*bar, kit::icon(kit::Icon::Trace), tr("XY plot, spectrum, frequency response, runs"));
    connect(figures, &QMenu::aboutToShow, this, [this, figures] {
        figures->clear();
        addFigureActions(*figures);
    });
    fillFileMenu(kit::addBarMenu(*bar, kit::icon(kit::Icon::Save), tr("Trace configuration")));
    fillExportMenu(kit::addBarMenu(*bar, kit::icon(kit::Icon::Export), tr("Export")));
    addAction(kit::makeUndoAction(m_undo, this));
    addAction(kit::makeRedoAction(m_undo, this));
    for (QAction* action : actions()) action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    new kit::OwnKeys(this);
}

void TraceView::addViewActions(QToolBar* bar) {
    const auto add = [&](kit::Icon icon, const QString& text, const QString& tip, auto&& run) {
        return addTool(*bar, *this, icon, text, tip, run);
    };
    m_follow = checkable(add(kit::Icon::Follow, tr("Follow"), tr("Follow the newest scan (End)"),
                             [this] { m_plot->setFollowing(m_follow->isChecked()); }));
    add(kit::Icon::Fit, tr("Fit"), tr("Show everything recorded (Home)"), [this] {
        m_plot->setFollowing(false);
        m_plot->fit();
    });
    add(kit::Icon::ZoomY, tr("Fit values"), tr("Let the value axes fit again"), [this] { m_plot->fitValues(); });
    add(kit::Icon::Back, tr("Zoom back"), tr("Back to the view before (Backspace)"), [this] { m_plot->zoomBack(); });
}

void TraceView::addToolActions(QToolBar* bar) {
    const auto add = [&](kit::Icon icon, const QString& text, const QString& tip, auto&& run) {
        return addTool(*bar, *this, icon, text, tip, run);
    };
    auto* tools = new QActionGroup(this);
    m_zoomTool =
        checkable(add(kit::Icon::ZoomBox, tr("Zoom"), tr("Drag a box to zoom: flat for time, upright for values"),
                      [this] { m_plot->setTool(plot::PlotTool::ZoomBox); }));
    m_panTool = checkable(add(kit::Icon::Pan, tr("Pan"), tr("Drag to pan (middle button always does)"),
                              [this] { m_plot->setTool(plot::PlotTool::Pan); }));
    m_rulerTool = checkable(add(kit::Icon::Variable, tr("Measure between points"),
                                tr("Drag from one point to another: time, value, slope and frequency between them (M)"),
                                [this] { m_plot->setTool(plot::PlotTool::Ruler); }));
    for (QAction* tool : {m_zoomTool, m_panTool, m_rulerTool}) tools->addAction(tool);
    m_zoomTool->setChecked(true);
    m_cursors =
        checkable(add(kit::Icon::Cursor, tr("Cursors"), tr("Two cursors (Ctrl+click sets A, Shift+click sets B)"),
                      [this] { m_plot->setCursorsShown(m_cursors->isChecked()); }));
    m_tableShown = checkable(
        add(kit::Icon::Statistics, tr("Measure"), tr("Table of values and statistics between the cursors"), [this] {
            const bool shown = m_tableShown->isChecked();
            if (shown && !m_plot->hasCursors()) m_plot->setCursorsShown(true);
            change(tr("Measuring table"), [shown](TraceSetup& s) { s.hasTable = shown; });
        }));
}

void TraceView::addTriggerActions(QToolBar* bar) {
    const auto add = [&](kit::Icon icon, const QString& text, const QString& tip, auto&& run) {
        return addTool(*bar, *this, icon, text, tip, run);
    };
    m_arm = checkable(add(kit::Icon::Trigger, tr("Trigger"), tr("Arm the trigger set in the properties of the trace"),
                          [this] { m_arm->isChecked() ? armTrigger() : m_trigger.disarm(); }));
    add(kit::Icon::ChevronLeft, tr("Previous trigger"), tr("Where the trigger would have fired before"),
        [this] { findTrigger(history::History::Direction::Backward); });
    add(kit::Icon::ChevronRight, tr("Next trigger"), tr("Where the trigger would have fired next"),
        [this] { findTrigger(history::History::Direction::Forward); });
}

void TraceView::addChartActions(QToolBar* bar) {
    const auto add = [&](kit::Icon icon, const QString& text, const QString& tip, auto&& run) {
        return addTool(*bar, *this, icon, text, tip, run);
    };
    add(kit::Icon::Add, tr("Add chart"), tr("Another chart over the same time"),
        [this] { change(tr("Add chart"), [](TraceSetup& s) { s.charts.emplace_back(); }); });
    add(kit::Icon::Layers, tr("Compare"), tr("Load an older recording beneath the present one"), [this] {
        if (m_beneath) {
            report(compareWith({}));
            return;
        }
        const QString path =
            QFileDialog::getOpenFileName(this, tr("Recording to draw beneath"), inProject({}),
                                         tr("Recordings and tables (*.rec *.csv *.tsv *.txt *.trace);;All files (*)"));
        if (!path.isEmpty()) report(compareWith(path));
    });
}

/// Configurations and recordings.
void TraceView::fillFileMenu(QMenu* files) {
    files->addAction(kit::icon(kit::Icon::Open), tr("Open Configuration…"), this, [this] {
        const QString path = QFileDialog::getOpenFileName(this, tr("Open trace configuration"), m_folder,
                                                          tr("Trace configurations (*.trace.json)"));
        if (!path.isEmpty()) report(openSetup(path));
    });
    auto saveAs = [this] {
        QString path =
            QFileDialog::getSaveFileName(this, tr("Save trace configuration"), m_path.isEmpty() ? m_folder : m_path,
                                         tr("Trace configurations (*.trace.json)"));
        if (path.isEmpty()) return;
        if (!path.endsWith(QLatin1String(".trace.json"))) path += QStringLiteral(".trace.json");
        report(storeSetup(path));
    };
    files->addAction(kit::icon(kit::Icon::Save), tr("Save Configuration"), this,
                     [this, saveAs] { m_path.isEmpty() ? saveAs() : report(storeSetup(m_path)); });
    files->addAction(tr("Save Configuration As…"), this, saveAs);
    files->addSeparator();
    files->addAction(tr("Open Recording…"), this, [this] {
        const QString path =
            QFileDialog::getOpenFileName(this, tr("Open recording"), inProject({}),
                                         tr("Recordings and tables (*.rec *.csv *.tsv *.txt *.trace);;All files (*)"));
        if (!path.isEmpty()) report(openRecording(path));
    });
    files->addAction(tr("Add Channel of Another File…"), this, &TraceView::askChannelsFrom);
    QAction* close = files->addAction(tr("Back to the Running PLC"), this, &TraceView::closeRecording);
    QAction* save = files->addAction(tr("Save Recording…"), this, [this] {
        QString path =
            QFileDialog::getSaveFileName(this, tr("Save recording"), inProject({}), tr("Recordings (*.rec)"));
        if (path.isEmpty() || !m_recording) return;
        if (!path.endsWith(QLatin1String(".rec"))) path += QStringLiteral(".rec");
        report(saveRecording(path));
    });
    connect(files, &QMenu::aboutToShow, this, [this, close, save] {
        close->setEnabled(showsFile());
        save->setEnabled(m_recording != nullptr);
    });
}

void TraceView::fillExportMenu(QMenu* exports) {
    exports->addAction(kit::icon(kit::Icon::Copy), tr("Copy as Picture"), this, [this] {
        plot::copyPicture(m_plot->model(), {m_plot->size(), 2});
    });
    for (const char* suffix : {"png", "svg", "pdf", "csv"})
        exports->addAction(suffix == QLatin1String("csv")
                               ? tr("Save Samples in View as CSV…")
                               : tr("Save as %1…").arg(QString(QLatin1String(suffix)).toUpper()),
                           this, [this, suffix] { exportTo(QLatin1String(suffix)); });
    exports->addAction(kit::icon(kit::Icon::Print), tr("Print…"), this, [this] {
        QPrinter printer;
        printer.setResolution(96); // fonts are in points: at a finer one they would grow twice
        printer.setPageOrientation(QPageLayout::Landscape);
        QPrintDialog dialog(&printer, this);
        if (dialog.exec() != QDialog::Accepted) return;
        const kit::PaperColors paper;
        QPainter painter(&printer);
        plot::printPlot(m_plot->model(), painter, QRectF(QPointF(), printer.pageLayout().paintRectPixels(96).size()));
    });
}

QAction* TraceView::toolAction(plot::PlotTool tool) const {
    switch (tool) {
    case plot::PlotTool::ZoomBox:
        return m_zoomTool;
    case plot::PlotTool::Pan:
        return m_panTool;
    case plot::PlotTool::Ruler:
        return m_rulerTool;
    }
    return m_zoomTool;
}

void TraceView::report(const Result<void>& result) {
    if (!result) emit failed(kit::messageText(result.error()));
}

void TraceView::exportTo(const QString& suffix) {
    QString path = QFileDialog::getSaveFileName(this, tr("Save as %1").arg(suffix.toUpper()), m_folder,
                                                QStringLiteral("*.%1").arg(suffix));
    if (path.isEmpty()) return;
    if (!path.endsWith(QLatin1Char('.') + suffix)) path += QLatin1Char('.') + suffix;
    if (suffix == QLatin1String("csv"))
        exportSamples(path);
    else
        report(plot::exportPicture(m_plot->model(), path, {m_plot->size(), 2}));
}

void TraceView::exportSamples(const QString& path) {
    const plot::PlotModel model = m_plot->model(); // its own: the view goes on meanwhile
    kit::LongTask task(tr("Saving the samples…"), this);
    report(plot::exportCsv(model, model.from, model.to, path, [&](double share) { return task.reached(share); }));
}

} // namespace plc::trace
