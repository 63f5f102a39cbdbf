// The table of actions: shortcuts as CODESYS has them (F5 run, F8 step in, F10 over, F9 breakpoint, F11 build), all
// editable.
#include "app/documents/design_pages.h"
#include "app/documents/file_commands.h"
#include "app/documents/unit_commands.h"
#include "app/frame/keyboard_commands.h"
#include "app/frame/perspectives.h"
#include "app/frame/side_bars.h"
#include "app/main_window.h"
#include "app/online/attachment.h"
#include "app/online/devices_view.h"
#include "app/online/inside_views.h"
#include "app/pages/editor_tabs.h"
#include "app/pages/focus_command.h"
#include "app/project/problems_view.h"
#include "app/project/search_view.h"
#include "app/window_commands.h"
#include "editor/debug/watch_view.h"
#include "editor/kit/icons.h"
#include "editor/kit/message_text.h"
#include "editor/text/st_keys.h"

#include <QApplication>

namespace plc::app {

namespace {

using kit::Icon;
constexpr int none = -1;
constexpr int drawn(Icon which) { return static_cast<int>(which); }

template <void (editor::StEditor::*Command)()> void inEditor(MainWindow& window) {
    if (auto* editor = window.tabs().currentEditor()) (editor->*Command)();
}

constexpr char kUndo[] = "undo", kRedo[] = "redo", kCut[] = "cut", kCopy[] = "copy", kPaste[] = "paste",
               kZoomIn[] = "zoom-in", kZoomOut[] = "zoom-out";
template <const char* Command> void inFocus(MainWindow& window) {
    runInFocus(window.tabs(), QString::fromLatin1(Command));
}

void say(MainWindow& window, const Result<void>& result) {
    if (!result) window.say(kit::messageText(result.error()), true);
}

const std::vector<ActionSpec> kActions = {
    {"file.new", QT_TRANSLATE_NOOP("plc::app::MainWindow", "File"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "New Project…"), "Ctrl+Shift+N", drawn(Icon::New), [](MainWindow& w) { w.newProject(); }},
    {"file.open", QT_TRANSLATE_NOOP("plc::app::MainWindow", "File"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Open Project…"), "Ctrl+O", drawn(Icon::Open), [](MainWindow& w) { w.chooseProject(); }},
    {"file.close", QT_TRANSLATE_NOOP("plc::app::MainWindow", "File"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Close Project"), "Ctrl+Shift+W", none, [](MainWindow& w) { w.closeProject(); }},
    {"file.newUnit", QT_TRANSLATE_NOOP("plc::app::MainWindow", "File"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "New Program, Block, Type…"), "Ctrl+N", drawn(Icon::Pou), [](MainWindow& w) { w.units().newUnit(); }},
    {"file.newPanel", QT_TRANSLATE_NOOP("plc::app::MainWindow", "File"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "New Panel…"), "", drawn(Icon::Panel), [](MainWindow& w) { w.designs().newPanel(); }},
    {"file.newTrace", QT_TRANSLATE_NOOP("plc::app::MainWindow", "File"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "New Trace…"), "", drawn(Icon::Trace), [](MainWindow& w) { w.projectFiles().newTrace(); }},
    {"file.texts", QT_TRANSLATE_NOOP("plc::app::MainWindow", "File"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Panel Texts"), "", drawn(Icon::Texts), [](MainWindow& w) { w.designs().openTexts(); }},
    {"file.alarms", QT_TRANSLATE_NOOP("plc::app::MainWindow", "File"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Alarms"), "", drawn(Icon::Alarm), [](MainWindow& w) { w.designs().openAlarms(); }},
    {"file.recipes", QT_TRANSLATE_NOOP("plc::app::MainWindow", "File"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Recipes"), "", drawn(Icon::Table), [](MainWindow& w) { w.designs().openRecipes(); }},
    {"file.people", QT_TRANSLATE_NOOP("plc::app::MainWindow", "File"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Users and Rights"), "", drawn(Icon::User), [](MainWindow& w) { w.designs().openPeople(); }},
    {"file.themes", QT_TRANSLATE_NOOP("plc::app::MainWindow", "File"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Panel Themes…"), "", drawn(Icon::Theme), [](MainWindow& w) { w.designs().editThemes(); }},
    {"file.save", QT_TRANSLATE_NOOP("plc::app::MainWindow", "File"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Save"), "Ctrl+S", drawn(Icon::Save), [](MainWindow& w) { w.designs().save(); }},
    {"file.saveAll", QT_TRANSLATE_NOOP("plc::app::MainWindow", "File"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Save All"), "Ctrl+Shift+S", none, [](MainWindow& w) { w.designs().saveAll(); }},
    {"file.closeTab", QT_TRANSLATE_NOOP("plc::app::MainWindow", "File"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Close Document"), "Ctrl+W", none, [](MainWindow& w) { if (w.tabs().count()) w.tabs().closePage(w.tabs().currentIndex()); }},
    {"file.closeOthers", QT_TRANSLATE_NOOP("plc::app::MainWindow", "File"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Close Other Documents"), "", none, [](MainWindow& w) { w.tabs().closeOthers(w.tabs().currentIndex()); }},
    {"file.libraries", QT_TRANSLATE_NOOP("plc::app::MainWindow", "File"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Libraries…"), "", drawn(Icon::Library), [](MainWindow& w) { w.chooseLibraries(); }},
    {"file.projectSettings", QT_TRANSLATE_NOOP("plc::app::MainWindow", "File"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Project Settings…"), "", none, [](MainWindow& w) { w.openProjectSettings(); }},
    {"file.import", QT_TRANSLATE_NOOP("plc::app::MainWindow", "File"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Import…"), "", none, [](MainWindow& w) { importProject(w); }},
    {"file.export", QT_TRANSLATE_NOOP("plc::app::MainWindow", "File"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Export…"), "", none, [](MainWindow& w) { exportProject(w); }},
    {"file.settings", QT_TRANSLATE_NOOP("plc::app::MainWindow", "File"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Settings…"), "Ctrl+,", drawn(Icon::Settings), [](MainWindow& w) { w.openSettings(); }},
    {"file.quit", QT_TRANSLATE_NOOP("plc::app::MainWindow", "File"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Quit"), "Ctrl+Q", none, [](MainWindow& w) { w.close(); }},

    {"edit.undo", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Edit"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Undo"), "Ctrl+Z", drawn(Icon::Undo), inFocus<kUndo>},
    {"edit.redo", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Edit"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Redo"), "Ctrl+Y", drawn(Icon::Redo), inFocus<kRedo>},
    {"edit.cut", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Edit"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Cut"), "Ctrl+X", drawn(Icon::Cut), inFocus<kCut>},
    {"edit.copy", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Edit"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Copy"), "Ctrl+C", drawn(Icon::Copy), inFocus<kCopy>},
    {"edit.paste", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Edit"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Paste"), "Ctrl+V", drawn(Icon::Paste), inFocus<kPaste>},
    {"edit.find", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Edit"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Find…"), "Ctrl+F", drawn(Icon::Find), [](MainWindow& w) { if (auto* p = w.tabs().currentPage()) p->findBar().open(false); }},
    {"edit.replace", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Edit"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Replace…"), "Ctrl+H", drawn(Icon::Replace), [](MainWindow& w) { if (auto* p = w.tabs().currentPage()) p->findBar().open(true); }},
    {"edit.findNext", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Edit"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Find Next"), "F3", none, [](MainWindow& w) { if (auto* p = w.tabs().currentPage()) p->findBar().findNext(); }},
    {"edit.findPrevious", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Edit"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Find Previous"), "Shift+F3", none, [](MainWindow& w) { if (auto* p = w.tabs().currentPage()) p->findBar().findPrevious(); }},
    {"edit.findAll", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Edit"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Find in All Files…"), "Ctrl+Shift+F", none,
     [](MainWindow& w) {
         w.showDock("search");
         auto* e = w.tabs().currentEditor();
         w.search().openSearch(e && e->hasSelectedText() ? e->selectedText() : QString());
     }},
    {"edit.goToLine", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Edit"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Go to Line…"), "Ctrl+G", none, [](MainWindow& w) { w.units().goToLine(); }},
    {"edit.definition", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Edit"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Go to Definition"), "F12", drawn(Icon::Forward), [](MainWindow& w) { w.units().definitionAtCursor(); }},
    {"edit.uses", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Edit"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Find References"), "Shift+F12", none, [](MainWindow& w) { w.units().usesAtCursor(); }},
    {"edit.rename", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Edit"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Rename…"), "F2", drawn(Icon::Rename), [](MainWindow& w) { if (!editFocusedCell()) w.units().renameAtCursor(); }},
    {"edit.complete", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Edit"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Complete"), "", none, inEditor<&editor::StEditor::triggerCompletion>},
    {"edit.fix", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Edit"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Quick Fix (Alt+Enter)"), "", drawn(Icon::Lightbulb), inEditor<&editor::StEditor::applyFix>},
    {"edit.format", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Edit"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Format"), "Ctrl+Shift+I", drawn(Icon::Format), inEditor<&editor::StEditor::formatText>},
    {"edit.comment", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Edit"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Toggle Comment (Ctrl+/)"), "", none, inEditor<&editor::StEditor::toggleComment>},
    {"edit.duplicate", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Edit"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Duplicate"), "Ctrl+D", none, inEditor<&editor::StEditor::duplicateLine>},
    {"edit.selectBlock", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Edit"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Select Enclosing Block"), "Ctrl+Shift+Up", none, inEditor<&editor::StEditor::selectBlock>},
    {"edit.nextOccurrence", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Edit"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Add Next Occurrence to Selection"), "Alt+J", none, inEditor<&editor::StEditor::selectNextOccurrence>},
    {"edit.matching", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Edit"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Go to Matching Keyword"), "Ctrl+M", none, inEditor<&editor::StEditor::goToMatchingWord>},
    {"edit.fold", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Edit"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Fold or Unfold the Block"), "Ctrl+Alt+F", none, [](MainWindow& w) { if (auto* e = w.tabs().currentEditor()) editor::toggleFold(*e); }},
    {"edit.foldAll", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Edit"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Fold or Unfold All"), "", none, [](MainWindow& w) { if (auto* e = w.tabs().currentEditor()) e->foldAll(); }},
    {"edit.nextProblem", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Edit"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Next Problem"), "F4", none, [](MainWindow& w) { w.problems().goToNext(1); }},
    {"edit.previousProblem", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Edit"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Previous Problem"), "Shift+F4", none, [](MainWindow& w) { w.problems().goToNext(-1); }},
    {"edit.bookmark", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Edit"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Bookmark"), "Ctrl+F2", drawn(Icon::Marker),
     [](MainWindow& w) { if (auto* e = w.tabs().currentEditor()) e->toggleBookmark(static_cast<int>(e->SendScintilla(QsciScintillaBase::SCI_LINEFROMPOSITION, static_cast<unsigned long>(e->cursorOffset())))); }},
    {"edit.nextBookmark", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Edit"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Next Bookmark"), "Ctrl+Shift+F2", none, [](MainWindow& w) { w.tabs().goToBookmark(1); }},
    {"edit.previousBookmark", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Edit"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Previous Bookmark"), "", none, [](MainWindow& w) { w.tabs().goToBookmark(-1); }},
    {"edit.asSt", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Edit"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Show as ST…"), "Ctrl+Alt+S", none, [](MainWindow& w) { w.units().showConverted(analysis::TextLanguage::St); }},
    {"edit.asIl", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Edit"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Show as an Instruction List…"), "Ctrl+Alt+I", none, [](MainWindow& w) { w.units().showConverted(analysis::TextLanguage::Il); }},
    {"edit.back", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Edit"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Back"), "Alt+Left", drawn(Icon::Back), [](MainWindow& w) { w.tabs().goBack(); }},
    {"edit.forward", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Edit"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Forward"), "Alt+Right", drawn(Icon::Forward), [](MainWindow& w) { w.tabs().goForward(); }},

    {"run.build", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Run"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Build"), "F11", drawn(Icon::Build), [](MainWindow& w) { w.control().build(); }},
    {"run.start", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Run"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Run"), "F5", drawn(Icon::Run), [](MainWindow& w) { w.control().start(); }},
    {"run.pause", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Run"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Pause"), "Ctrl+F5", drawn(Icon::Pause), [](MainWindow& w) { w.control().pause(); }},
    {"run.stop", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Run"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Stop"), "Shift+F8", drawn(Icon::Stop), [](MainWindow& w) { w.control().stop(); }},
    {"run.scan", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Run"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Single Scan"), "Ctrl+F8", drawn(Icon::Step), [](MainWindow& w) { w.control().singleScan(); }},
    {"run.stepIn", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Run"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Step Into"), "F8", drawn(Icon::StepInto), [](MainWindow& w) { w.step(session::Step::In); }},
    {"run.stepOver", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Run"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Step Over"), "F10", drawn(Icon::StepOver), [](MainWindow& w) { w.step(session::Step::Over); }},
    {"run.stepOut", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Run"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Step Out"), "Shift+F10", drawn(Icon::StepOut), [](MainWindow& w) { w.step(session::Step::Out); }},
    {"run.toCursor", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Run"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Run to Cursor"), "Ctrl+F10", drawn(Icon::RunToCursor),
     [](MainWindow& w) {
         auto* e = w.tabs().currentEditor();
         int line = 0, column = 0;
         if (!e) return;
         e->getCursorPosition(&line, &column);
         w.control().runTo(e->file(), line + 1);
     }},
    {"run.breakpoint", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Run"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Toggle Breakpoint"), "F9", drawn(Icon::Breakpoint),
     [](MainWindow& w) {
         auto* e = w.tabs().currentEditor();
         int line = 0, column = 0;
         if (!e) return;
         e->getCursorPosition(&line, &column);
         w.control().toggleBreakpoint(e->file(), line + 1);
     }},
    {"run.resetWarm", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Run"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Reset Warm"), "", drawn(Icon::Reset), [](MainWindow& w) { w.control().reset(controller::ResetKind::Warm); }},
    {"run.resetCold", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Run"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Reset Cold"), "", drawn(Icon::ResetCold), [](MainWindow& w) { w.control().reset(controller::ResetKind::Cold); }},
    {"run.resetOrigin", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Run"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Reset Origin"), "", drawn(Icon::ResetOrigin), [](MainWindow& w) { w.control().reset(controller::ResetKind::Origin); }},
    {"run.change", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Run"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Online Change"), "Alt+F8", drawn(Icon::OnlineChange), [](MainWindow& w) { w.control().onlineChange(); }},
    {"run.speed", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Run"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Speed…"), "", drawn(Icon::Clock), [](MainWindow& w) { w.setSpeed(); }},
    {"run.history", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Run"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Memory for the Recording…"), "", drawn(Icon::Record), [](MainWindow& w) { w.setHistoryBudget(); }},
    {"run.saveRecording", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Run"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Save the Recording…"), "", drawn(Icon::Export), [](MainWindow& w) { w.saveRecording(); }},
    {"run.openRecording", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Run"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Open a Recording…"), "", drawn(Icon::Record), [](MainWindow& w) { w.openRecording(); }},
    {"run.write", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Run"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Write Prepared Values"), "Ctrl+F7", drawn(Icon::Write), [](MainWindow& w) { w.watch().writePrepared(); }},
    {"run.force", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Run"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Force Prepared Values"), "F7", drawn(Icon::Force), [](MainWindow& w) { w.watch().forcePrepared(); }},
    {"run.releaseAll", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Run"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Release All Forces"), "Alt+F7", drawn(Icon::Unforce), [](MainWindow& w) { if (w.control().session()) w.control().session()->unforceAll(); }},
    {"run.devices", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Run"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Connect or Disconnect the Devices"), "", drawn(Icon::Link), [](MainWindow& w) { DevicesView::of(w).toggleConnection(); }},
    {"run.attach", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Run"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Attach to a Controller…"), "", drawn(Icon::Link), [](MainWindow& w) { attachmentOf(w).ask(); }},
    {"run.detach", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Run"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Detach from the Controller"), "", none, [](MainWindow& w) { attachmentOf(w).detach(); }},
    {"run.native", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Run"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Build a Native Program…"), "", drawn(Icon::Export), [](MainWindow& w) { buildNativeProgram(w); }},
    {"run.tests", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Run"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Run the Tests"), "Ctrl+T", drawn(Icon::Test), [](MainWindow& w) { w.runTests(); }},

    {"time.back", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Time"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "One Scan Back"), "Alt+PgUp", drawn(Icon::StepBack), [](MainWindow& w) { w.control().stepView(-1); }},
    {"time.forward", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Time"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "One Scan Forward"), "Alt+PgDown", drawn(Icon::Step), [](MainWindow& w) { w.control().stepView(1); }},
    {"time.live", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Time"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Back to Live"), "Ctrl+Alt+End", drawn(Icon::Live), [](MainWindow& w) { w.backToLive(); }},
    {"time.resume", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Time"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Resume from Here"), "", drawn(Icon::Resume), [](MainWindow& w) { say(w, w.control().resumeFromView()); }},

    {"time.walk", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Time"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Walk Through the Scan"), "Ctrl+Alt+G", drawn(Icon::Clock), [](MainWindow& w) { w.inside().walk(); }},
    {"time.backIn", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Time"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Step Back In"), "Ctrl+Shift+F8", drawn(Icon::StepBack), [](MainWindow& w) { w.stepBack(session::Step::In); }},
    {"time.backOver", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Time"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Step Back Over"), "Ctrl+Shift+F10", none, [](MainWindow& w) { w.stepBack(session::Step::Over); }},
    {"time.backOut", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Time"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Step Back Out"), "Ctrl+Alt+Shift+F10", none, [](MainWindow& w) { w.stepBack(session::Step::Out); }},
    {"time.passBack", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Time"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Previous Pass of the Loop"), "Ctrl+Alt+PgUp", none, [](MainWindow& w) { if (auto* e = w.tabs().currentEditor()) editor::changePass(*e, -1); }},
    {"time.passForward", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Time"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Next Pass of the Loop"), "Ctrl+Alt+PgDown", none, [](MainWindow& w) { if (auto* e = w.tabs().currentEditor()) editor::changePass(*e, 1); }},
    {"time.why", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Time"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Why?"), "Ctrl+Alt+W", drawn(Icon::Question), [](MainWindow& w) { w.inside().askAboutFocus(kit::AskWhy::Why); }},
    {"time.whyNot", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Time"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Why Not?"), "Ctrl+Alt+N", drawn(Icon::Lightbulb), [](MainWindow& w) { w.inside().askAboutFocus(kit::AskWhy::WhyNot); }},
    {"time.who", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Time"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Who Set This?"), "Ctrl+Alt+Q", drawn(Icon::Write), [](MainWindow& w) { w.inside().askAboutFocus(kit::AskWhy::Who); }},

    {"time.whatIf", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Time"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "What If…"), "Ctrl+Alt+H", drawn(Icon::Split), [](MainWindow& w) { w.whatIf(); }},
    {"time.coverage", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Time"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Coverage of the Recording"), "", drawn(Icon::Layers), [](MainWindow& w) { w.inside().coverRecording(); }},
    {"time.noCoverage", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Time"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Hide the Coverage"), "", none, [](MainWindow& w) { w.inside().hideCoverage(); }},

    {"view.palette", QT_TRANSLATE_NOOP("plc::app::MainWindow", "View"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Command Palette"), "Ctrl+Shift+P", drawn(Icon::Command), [](MainWindow& w) { w.openPalette(); }},
    {"view.split", QT_TRANSLATE_NOOP("plc::app::MainWindow", "View"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Split the Editor"), "Ctrl+Shift+E", drawn(Icon::Split), [](MainWindow& w) { if (auto* p = w.tabs().currentPage()) p->toggleSplit(); }},
    {"view.beside", QT_TRANSLATE_NOOP("plc::app::MainWindow", "View"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Open Another File Beside…"), "", drawn(Icon::Split), [](MainWindow& w) { w.openBeside(); }},
    {"view.table", QT_TRANSLATE_NOOP("plc::app::MainWindow", "View"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Declarations as a Table"), "Ctrl+Shift+D", drawn(Icon::Table), [](MainWindow& w) { if (auto* p = w.tabs().currentPage()) { p->toggleTable(); p->table().setModel(w.workspace().model()); } }},
    {"view.chart", QT_TRANSLATE_NOOP("plc::app::MainWindow", "View"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Diagram Beside the Text"), "Ctrl+Shift+G", drawn(Icon::Sfc),
     [](MainWindow& w) {
         auto* page = w.tabs().currentPage();
         const auto model = w.workspace().model();
         if (page && model && model->fileOf(page->file().toStdString())) page->toggleGraph();
     }},
    {"view.values", QT_TRANSLATE_NOOP("plc::app::MainWindow", "View"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Online Values in the Text"), "Ctrl+Shift+O", none,
     [](MainWindow& w) {
         auto s = w.settings().editor();
         s.showOnlineValues = !s.showOnlineValues;
         w.settings().setEditor(s);
         w.tabs().applySettings();
     }},
    {"view.zoomIn", QT_TRANSLATE_NOOP("plc::app::MainWindow", "View"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Larger"), "Ctrl++", drawn(Icon::ZoomIn), inFocus<kZoomIn>},
    {"view.zoomOut", QT_TRANSLATE_NOOP("plc::app::MainWindow", "View"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Smaller"), "Ctrl+-", drawn(Icon::ZoomOut), inFocus<kZoomOut>},
    {"view.contextMenu", QT_TRANSLATE_NOOP("plc::app::MainWindow", "View"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Context Menu"), "Alt+Shift+F10", none, [](MainWindow&) { showContextMenu(); }},
    {"view.columns", QT_TRANSLATE_NOOP("plc::app::MainWindow", "View"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Columns…"), "", none, [](MainWindow& w) { chooseColumns(w); }},
    {"view.light", QT_TRANSLATE_NOOP("plc::app::MainWindow", "View"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Light Theme"), "", none, [](MainWindow& w) { w.changeTheme(kit::ThemeChoice::Light); }},
    {"view.dark", QT_TRANSLATE_NOOP("plc::app::MainWindow", "View"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Dark Theme"), "", none, [](MainWindow& w) { w.changeTheme(kit::ThemeChoice::Dark); }},
    {"view.contrast", QT_TRANSLATE_NOOP("plc::app::MainWindow", "View"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "High-Contrast Theme"), "", none, [](MainWindow& w) { w.changeTheme(kit::ThemeChoice::Contrast); }},
    {"view.system", QT_TRANSLATE_NOOP("plc::app::MainWindow", "View"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "System Theme"), "", none, [](MainWindow& w) { w.changeTheme(kit::ThemeChoice::System); }},
    {"view.editing", QT_TRANSLATE_NOOP("plc::app::MainWindow", "View"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Arrange for Editing"), "Ctrl+Alt+1", none, [](MainWindow& w) { if (w.workspace().isOpen()) w.perspectives().show(Perspective::Editing); }},
    {"view.debugging", QT_TRANSLATE_NOOP("plc::app::MainWindow", "View"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Arrange for Debugging"), "Ctrl+Alt+2", none, [](MainWindow& w) { if (w.workspace().isOpen()) w.perspectives().show(Perspective::Debugging); }},
    {"view.panelDesign", QT_TRANSLATE_NOOP("plc::app::MainWindow", "View"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Arrange for Drawing Panels"), "Ctrl+Alt+3", none, [](MainWindow& w) { if (w.workspace().isOpen()) w.perspectives().show(Perspective::PanelDesign); }},
    {"view.maximise", QT_TRANSLATE_NOOP("plc::app::MainWindow", "View"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Maximise the Editor"), "Ctrl+Alt+M", none, [](MainWindow& w) { if (w.workspace().isOpen()) w.perspectives().toggleMaximised(); }},
    {"view.hideDock", QT_TRANSLATE_NOOP("plc::app::MainWindow", "View"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Hide Dock Automatically"), "Ctrl+Alt+P", none, [](MainWindow& w) { w.sideBars().toggleFocused(); }},
    {"view.moveDock", QT_TRANSLATE_NOOP("plc::app::MainWindow", "View"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Move Dock to the Next Side"), "Ctrl+Alt+Shift+D", none, [](MainWindow& w) { moveFocusedDock(w, w.sideBars()); }},
    {"view.floatDock", QT_TRANSLATE_NOOP("plc::app::MainWindow", "View"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Float or Dock Again"), "", none, [](MainWindow& w) { floatFocusedDock(w.sideBars()); }},
    {"view.nextPane", QT_TRANSLATE_NOOP("plc::app::MainWindow", "View"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Next Pane"), "Ctrl+F6", none, [](MainWindow& w) { focusNextPane(w, w.sideBars(), 1); }},
    {"view.previousPane", QT_TRANSLATE_NOOP("plc::app::MainWindow", "View"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Previous Pane"), "Ctrl+Shift+F6", none, [](MainWindow& w) { focusNextPane(w, w.sideBars(), -1); }},
    {"view.wider", QT_TRANSLATE_NOOP("plc::app::MainWindow", "View"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Wider Pane"), "Ctrl+Alt+X", none, [](MainWindow&) { PaneKeys::change(PaneKeys::Change::Wider); }},
    {"view.narrower", QT_TRANSLATE_NOOP("plc::app::MainWindow", "View"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Narrower Pane"), "Ctrl+Alt+Shift+X", none, [](MainWindow&) { PaneKeys::change(PaneKeys::Change::Narrower); }},
    {"view.taller", QT_TRANSLATE_NOOP("plc::app::MainWindow", "View"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Taller Pane"), "Ctrl+Alt+Y", none, [](MainWindow&) { PaneKeys::change(PaneKeys::Change::Taller); }},
    {"view.shorter", QT_TRANSLATE_NOOP("plc::app::MainWindow", "View"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Shorter Pane"), "Ctrl+Alt+Shift+Y", none, [](MainWindow&) { PaneKeys::change(PaneKeys::Change::Shorter); }},
    {"view.tabLeft", QT_TRANSLATE_NOOP("plc::app::MainWindow", "View"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Move Document Left"), "Ctrl+Shift+PgUp", none, [](MainWindow& w) { w.tabs().moveCurrent(-1); }},
    {"view.tabRight", QT_TRANSLATE_NOOP("plc::app::MainWindow", "View"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Move Document Right"), "Ctrl+Shift+PgDown", none, [](MainWindow& w) { w.tabs().moveCurrent(1); }},
    {"view.reset", QT_TRANSLATE_NOOP("plc::app::MainWindow", "View"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Reset the Layout"), "", none, [](MainWindow& w) { w.resetLayout(); }},

    {"help.explain", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Help"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Explain the Problem"), "F1", drawn(Icon::Question), [](MainWindow& w) { explainProblem(w); }},
    {"help.information", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Help"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Show Tooltip at the Cursor"), "Ctrl+I", none, [](MainWindow& w) { if (auto* e = w.tabs().currentEditor()) editor::showInformation(*e); }},
    {"help.tour", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Help"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "Tour"), "", drawn(Icon::Help), [](MainWindow& w) { w.startTour(); }},
    {"help.about", QT_TRANSLATE_NOOP("plc::app::MainWindow", "Help"), QT_TRANSLATE_NOOP("plc::app::MainWindow", "About Stepwise"), "", drawn(Icon::Information), [](MainWindow& w) { w.about(); }},
};

} // namespace

const std::vector<ActionSpec>& actionTable() { return kActions; }

QMap<QString, QKeySequence> defaultShortcuts() {
    QMap<QString, QKeySequence> out;
    for (const ActionSpec& spec : kActions)
        out[QLatin1String(spec.id)] = {QString::fromLatin1(spec.shortcut), QKeySequence::PortableText};
    return out;
}

} // namespace plc::app
