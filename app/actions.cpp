// The table of actions: shortcuts as CODESYS has them (F5 run, F8 step in, F10 over, F9 breakpoint, F11 build), all editable.
#include "app/editor_tabs.h"
#include "app/main_window.h"
#include "app/problems_view.h"
#include "app/search_view.h"
#include "editor/debug/watch_view.h"
#include "editor/kit/icons.h"

#include <QApplication>

namespace plc::app {

namespace {

using kit::Icon;
constexpr int none = -1;
constexpr int drawn(Icon which) { return static_cast<int>(which); }

template <void (editor::StEditor::*Command)()> void inEditor(MainWindow& window) {
    if (auto* editor = window.tabs().currentEditor()) (editor->*Command)();
}

void say(MainWindow& window, const Result<void>& result) {
    if (!result) window.say(QString::fromStdString(result.error().text()), true);
}

#define TR(text) QT_TRANSLATE_NOOP("plc::app::MainWindow", text)

const std::vector<ActionSpec> kActions = {
    {"file.new", TR("File"), TR("New Project…"), "Ctrl+Shift+N", drawn(Icon::New), [](MainWindow& w) { w.newProject(); }},
    {"file.open", TR("File"), TR("Open Project…"), "Ctrl+O", drawn(Icon::Open), [](MainWindow& w) { w.chooseProject(); }},
    {"file.close", TR("File"), TR("Close Project"), "Ctrl+Shift+W", none, [](MainWindow& w) { w.closeProject(); }},
    {"file.newUnit", TR("File"), TR("New Program, Block, Type…"), "Ctrl+N", drawn(Icon::Pou), [](MainWindow& w) { w.newUnit(); }},
    {"file.save", TR("File"), TR("Save"), "Ctrl+S", drawn(Icon::Save), [](MainWindow& w) { w.saveDocument(); }},
    {"file.newPanel", TR("File"), TR("New Panel…"), "", drawn(Icon::Panel), [](MainWindow& w) { w.newPanel(); }},
    {"file.texts", TR("File"), TR("Panel Texts"), "", drawn(Icon::Texts), [](MainWindow& w) { w.openTexts(); }},
    {"file.alarms", TR("File"), TR("Alarms"), "", drawn(Icon::Alarm), [](MainWindow& w) { w.openAlarms(); }},
    {"file.saveAll", TR("File"), TR("Save All"), "Ctrl+Shift+S", none, [](MainWindow& w) { w.tabs().saveAll(); }},
    {"file.closeTab", TR("File"), TR("Close Document"), "Ctrl+W", none, [](MainWindow& w) { if (w.tabs().count()) w.tabs().closePage(w.tabs().currentIndex()); }},
    {"file.libraries", TR("File"), TR("Libraries…"), "", drawn(Icon::Library), [](MainWindow& w) { w.chooseLibraries(); }},
    {"file.settings", TR("File"), TR("Settings…"), "Ctrl+,", drawn(Icon::Settings), [](MainWindow& w) { w.openSettings(); }},
    {"file.quit", TR("File"), TR("Quit"), "Ctrl+Q", none, [](MainWindow& w) { w.close(); }},

    {"edit.undo", TR("Edit"), TR("Undo"), "Ctrl+Z", drawn(Icon::Undo), [](MainWindow& w) { if (auto* e = w.tabs().currentEditor()) e->undo(); }},
    {"edit.redo", TR("Edit"), TR("Redo"), "Ctrl+Y", drawn(Icon::Redo), [](MainWindow& w) { if (auto* e = w.tabs().currentEditor()) e->redo(); }},
    {"edit.cut", TR("Edit"), TR("Cut"), "Ctrl+X", drawn(Icon::Cut), [](MainWindow& w) { if (auto* e = w.tabs().currentEditor()) e->cut(); }},
    {"edit.copy", TR("Edit"), TR("Copy"), "Ctrl+C", drawn(Icon::Copy), [](MainWindow& w) { if (auto* e = w.tabs().currentEditor()) e->copy(); }},
    {"edit.paste", TR("Edit"), TR("Paste"), "Ctrl+V", drawn(Icon::Paste), [](MainWindow& w) { if (auto* e = w.tabs().currentEditor()) e->paste(); }},
    {"edit.find", TR("Edit"), TR("Find…"), "Ctrl+F", drawn(Icon::Find), [](MainWindow& w) { if (auto* p = w.tabs().currentPage()) p->findBar().open(false); }},
    {"edit.replace", TR("Edit"), TR("Replace…"), "Ctrl+H", drawn(Icon::Replace), [](MainWindow& w) { if (auto* p = w.tabs().currentPage()) p->findBar().open(true); }},
    {"edit.findNext", TR("Edit"), TR("Find Next"), "F3", none, [](MainWindow& w) { if (auto* p = w.tabs().currentPage()) p->findBar().findNext(); }},
    {"edit.findPrevious", TR("Edit"), TR("Find Previous"), "Shift+F3", none, [](MainWindow& w) { if (auto* p = w.tabs().currentPage()) p->findBar().findPrevious(); }},
    {"edit.findAll", TR("Edit"), TR("Find in All Files…"), "Ctrl+Shift+F", none,
     [](MainWindow& w) {
         w.showDock("search");
         auto* e = w.tabs().currentEditor();
         w.search().openSearch(e && e->hasSelectedText() ? e->selectedText() : QString());
     }},
    {"edit.goToLine", TR("Edit"), TR("Go to Line…"), "Ctrl+G", none, [](MainWindow& w) { w.goToLine(); }},
    {"edit.definition", TR("Edit"), TR("Go to Definition"), "F12", drawn(Icon::Forward), [](MainWindow& w) { w.definitionAtCursor(); }},
    {"edit.uses", TR("Edit"), TR("Find All Uses"), "Shift+F12", none, [](MainWindow& w) { w.usesAtCursor(); }},
    {"edit.rename", TR("Edit"), TR("Rename…"), "F2", drawn(Icon::Rename), [](MainWindow& w) { w.renameAtCursor(); }},
    {"edit.complete", TR("Edit"), TR("Complete"), "", none, inEditor<&editor::StEditor::triggerCompletion>},
    {"edit.fix", TR("Edit"), TR("Apply a Fix (Alt+Enter)"), "", drawn(Icon::Lightbulb), inEditor<&editor::StEditor::applyFix>},
    {"edit.format", TR("Edit"), TR("Format"), "Ctrl+Shift+I", drawn(Icon::Format), inEditor<&editor::StEditor::formatText>},
    {"edit.comment", TR("Edit"), TR("Comment In or Out (Ctrl+/)"), "", none, inEditor<&editor::StEditor::toggleComment>},
    {"edit.duplicate", TR("Edit"), TR("Duplicate"), "Ctrl+D", none, inEditor<&editor::StEditor::duplicateLine>},
    {"edit.selectBlock", TR("Edit"), TR("Select the Block Around"), "Ctrl+Shift+Up", none, inEditor<&editor::StEditor::selectBlock>},
    {"edit.matching", TR("Edit"), TR("Go to the Matching Word"), "Ctrl+M", none, inEditor<&editor::StEditor::goToMatchingWord>},
    {"edit.nextProblem", TR("Edit"), TR("Next Problem"), "F4", none, [](MainWindow& w) { w.problems().goToNext(1); }},
    {"edit.previousProblem", TR("Edit"), TR("Previous Problem"), "Shift+F4", none, [](MainWindow& w) { w.problems().goToNext(-1); }},
    {"edit.back", TR("Edit"), TR("Back"), "Alt+Left", drawn(Icon::Back), [](MainWindow& w) { w.tabs().goBack(); }},
    {"edit.forward", TR("Edit"), TR("Forward"), "Alt+Right", drawn(Icon::Forward), [](MainWindow& w) { w.tabs().goForward(); }},

    {"run.build", TR("Run"), TR("Build"), "F11", drawn(Icon::Build), [](MainWindow& w) { w.control().build(); }},
    {"run.start", TR("Run"), TR("Run"), "F5", drawn(Icon::Run), [](MainWindow& w) { w.control().start(); }},
    {"run.pause", TR("Run"), TR("Pause"), "Ctrl+F5", drawn(Icon::Pause), [](MainWindow& w) { w.control().pause(); }},
    {"run.stop", TR("Run"), TR("Stop"), "Shift+F8", drawn(Icon::Stop), [](MainWindow& w) { w.control().stop(); }},
    {"run.scan", TR("Run"), TR("Single Scan"), "Ctrl+F8", drawn(Icon::Step), [](MainWindow& w) { w.control().singleScan(); }},
    {"run.stepIn", TR("Run"), TR("Step In"), "F8", drawn(Icon::StepInto), [](MainWindow& w) { w.control().step(session::StepKind::In); }},
    {"run.stepOver", TR("Run"), TR("Step Over"), "F10", drawn(Icon::StepOver), [](MainWindow& w) { w.control().step(session::StepKind::Over); }},
    {"run.stepOut", TR("Run"), TR("Step Out"), "Shift+F10", drawn(Icon::StepOut), [](MainWindow& w) { w.control().step(session::StepKind::Out); }},
    {"run.toCursor", TR("Run"), TR("Run to Cursor"), "Ctrl+F10", drawn(Icon::RunToCursor),
     [](MainWindow& w) {
         auto* e = w.tabs().currentEditor();
         int line = 0, column = 0;
         if (!e) return;
         e->getCursorPosition(&line, &column);
         w.control().runTo(e->file(), line + 1);
     }},
    {"run.breakpoint", TR("Run"), TR("Toggle Breakpoint"), "F9", drawn(Icon::Breakpoint),
     [](MainWindow& w) {
         auto* e = w.tabs().currentEditor();
         int line = 0, column = 0;
         if (!e) return;
         e->getCursorPosition(&line, &column);
         w.control().toggleBreakpoint(e->file(), line + 1);
     }},
    {"run.resetWarm", TR("Run"), TR("Reset Warm"), "", drawn(Icon::Reset), [](MainWindow& w) { w.control().reset(controller::ResetKind::Warm); }},
    {"run.resetCold", TR("Run"), TR("Reset Cold"), "", drawn(Icon::ResetCold), [](MainWindow& w) { w.control().reset(controller::ResetKind::Cold); }},
    {"run.resetOrigin", TR("Run"), TR("Reset Origin"), "", drawn(Icon::ResetOrigin), [](MainWindow& w) { w.control().reset(controller::ResetKind::Origin); }},
    {"run.change", TR("Run"), TR("Online Change"), "Alt+F8", drawn(Icon::OnlineChange), [](MainWindow& w) { w.control().onlineChange(); }},
    {"run.speed", TR("Run"), TR("Speed…"), "", drawn(Icon::Clock), [](MainWindow& w) { w.setSpeed(); }},
    {"run.history", TR("Run"), TR("Memory for the Recording…"), "", drawn(Icon::Record), [](MainWindow& w) { w.setHistoryBudget(); }},
    {"run.saveRecording", TR("Run"), TR("Save the Recording…"), "", drawn(Icon::Export), [](MainWindow& w) { w.saveRecording(); }},
    {"run.write", TR("Run"), TR("Write Prepared Values"), "Ctrl+F7", drawn(Icon::Write), [](MainWindow& w) { w.watch().writePrepared(); }},
    {"run.force", TR("Run"), TR("Force Prepared Values"), "F7", drawn(Icon::Force), [](MainWindow& w) { w.watch().forcePrepared(); }},
    {"run.releaseAll", TR("Run"), TR("Release All Forces"), "Alt+F7", drawn(Icon::Unforce), [](MainWindow& w) { if (w.control().session()) w.control().session()->unforceAll(); }},
    {"run.tests", TR("Run"), TR("Run the Tests"), "Ctrl+T", drawn(Icon::Test), [](MainWindow& w) { w.runTests(); }},

    {"time.back", TR("Time"), TR("One Scan Back"), "Ctrl+Alt+Left", drawn(Icon::StepBack), [](MainWindow& w) { w.control().stepView(-1); }},
    {"time.forward", TR("Time"), TR("One Scan Forward"), "Ctrl+Alt+Right", drawn(Icon::Step), [](MainWindow& w) { w.control().stepView(1); }},
    {"time.live", TR("Time"), TR("Back to Live"), "Ctrl+Alt+End", drawn(Icon::Live), [](MainWindow& w) { w.control().view(std::nullopt); }},
    {"time.resume", TR("Time"), TR("Resume From Here"), "", drawn(Icon::Resume), [](MainWindow& w) { say(w, w.control().resumeFromView()); }},

    {"view.palette", TR("View"), TR("Command Palette"), "Ctrl+Shift+P", drawn(Icon::Command), [](MainWindow& w) { w.openPalette(); }},
    {"view.split", TR("View"), TR("Split the Editor"), "Ctrl+\\", drawn(Icon::Split), [](MainWindow& w) { if (auto* p = w.tabs().currentPage()) p->toggleSplit(); }},
    {"view.table", TR("View"), TR("Declarations as a Table"), "Ctrl+Shift+D", drawn(Icon::Table), [](MainWindow& w) { if (auto* p = w.tabs().currentPage()) { p->toggleTable(); p->table().setModel(w.workspace().model()); } }},
    {"view.chart", TR("View"), TR("Chart Beside the Text"), "Ctrl+Shift+G", drawn(Icon::Sfc),
     [](MainWindow& w) {
         auto* page = w.tabs().currentPage();
         const auto model = w.workspace().model();
         const auto file = page && model ? model->fileOf(page->file().toStdString()) : std::nullopt;
         if (!file) return;
         if (page->chart() && page->chart()->isVisible()) page->showChart({});
         else page->showChart(QString::fromStdString(model->pouAt(*file, page->active().cursorOffset())).section('.', 0, 0));
     }},
    {"view.values", TR("View"), TR("Online Values in the Text"), "Ctrl+Shift+O", none,
     [](MainWindow& w) {
         auto s = w.settings().editor();
         s.showOnlineValues = !s.showOnlineValues;
         w.settings().setEditor(s);
         w.tabs().applySettings();
     }},
    {"view.zoomIn", TR("View"), TR("Larger"), "Ctrl++", drawn(Icon::ZoomIn), [](MainWindow& w) { if (auto* e = w.tabs().currentEditor()) e->zoomIn(); }},
    {"view.zoomOut", TR("View"), TR("Smaller"), "Ctrl+-", drawn(Icon::ZoomOut), [](MainWindow& w) { if (auto* e = w.tabs().currentEditor()) e->zoomOut(); }},
    {"view.light", TR("View"), TR("Light Theme"), "", none, [](MainWindow& w) { w.changeTheme(kit::ThemeChoice::Light); }},
    {"view.dark", TR("View"), TR("Dark Theme"), "", none, [](MainWindow& w) { w.changeTheme(kit::ThemeChoice::Dark); }},
    {"view.system", TR("View"), TR("Theme of the System"), "", none, [](MainWindow& w) { w.changeTheme(kit::ThemeChoice::System); }},
    {"view.reset", TR("View"), TR("Reset the Layout"), "", none, [](MainWindow& w) { w.resetLayout(); }},

    {"help.tour", TR("Help"), TR("Tour"), "", drawn(Icon::Help), [](MainWindow& w) { w.startTour(); }},
    {"help.about", TR("Help"), TR("About Stepwise"), "", drawn(Icon::Information), [](MainWindow& w) { w.about(); }},
};

} // namespace

const std::vector<ActionSpec>& actionTable() { return kActions; }

} // namespace plc::app
