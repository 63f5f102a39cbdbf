#include "app/start/studio_tour.h"

#include <QCoreApplication>

namespace plc::app {

namespace {
/// It speaks as part of the window.
struct TourWords {
    Q_DECLARE_TR_FUNCTIONS(plc::app::MainWindow)
};
} // namespace

std::vector<TourStop> studioTour(const TouredStudio& studio) {
    const auto dockWidget = [&](const char* name) { return [studio, name] { return studio.dock(name); }; };
    const auto show = [&](const char* name) { return [studio, name] { studio.showDock(name); }; };
    return {
        {TourWords::tr("Welcome"),
         TourWords::tr(
             "%1 Nothing can break: the plant is only a simulation. Press Next to look around for a minute, or F5 to "
             "run it straight away.")
             .arg(studio.summary.isEmpty() ? TourWords::tr("This is the project %1.").arg(studio.project)
                                           : studio.summary),
         {},
         {}},
        {TourWords::tr("What to press"),
         TourWords::tr(
             "The page next to the program is the project's README: what it shows, what to press, what to watch."),
         dockWidget("guide"), show("guide")},
        {TourWords::tr("The project"),
         TourWords::tr("Programs, blocks, tasks, panels, traces and tests, made from the text files in the folder."),
         dockWidget("project"), show("project")},
        {TourWords::tr("The program"),
         TourWords::tr(
             "Structured Text with semantic highlighting. Errors are underlined as you type; Alt+Enter offers quick "
             "fixes; Ctrl+Space completes."),
         [studio]() -> QWidget* { return studio.documents; },
         {}},
        {TourWords::tr("Run"),
         TourWords::tr("F5 compiles to native code and runs it. Values then appear next to each line."),
         [studio] { return studio.toolBar("mainToolBar"); }, studio.run},
        {TourWords::tr("Watch"),
         TourWords::tr("Any expression, at any moment. Prepare a value and write or force it with one click."),
         dockWidget("watch"),
         [studio] {
             studio.showDock("watch");
             studio.fillWatch();
         }},
        {TourWords::tr("The trace"),
         TourWords::tr(
             "Nothing has to be selected in advance: every scan is recorded, and any expression can be charted "
             "afterwards."),
         dockWidget("trace"), show("trace")},
        {TourWords::tr("The panel"),
         !studio.hasPanel
             ? TourWords::tr(
                   "What the operator sees. This project has no panel yet; new ones are drawn with the mouse.")
             : TourWords::tr(
                   "What the operator sees, in the languages of the machine. It works here as it will on the machine."),
         dockWidget("panel"), show("panel")},
        {TourWords::tr("Time runs backwards, too"),
         TourWords::tr(
             "Drag the time slider, or press Alt+PgUp: code, charts and panel show the past. “Resume from Here” "
             "continues from there."),
         [studio] { return studio.toolBar("timeToolBar"); },
         {}},
        {TourWords::tr("That’s it"),
         TourWords::tr("Ctrl+Shift+P finds every command. The start page has more machines to play with."),
         {},
         {}},
    };
}

} // namespace plc::app
