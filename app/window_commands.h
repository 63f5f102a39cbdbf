// Commands of the menus that need a dialog and several parts of the window: import and export, native programs, the
// explanation of a problem, other controllers. Functions over the main window; GUI thread.
#pragma once

namespace plc::app {

class Attachment;
class MainWindow;

/// The head of the table that has the focus, as a menu.
void chooseColumns(MainWindow& window);
void importProject(MainWindow& window);
void exportProject(MainWindow& window);
void buildNativeProgram(MainWindow& window);
/// That of the row in the list of problems that has the focus, else of the problem at the cursor.
void explainProblem(MainWindow& window);
/// The one of the window's control.
[[nodiscard]] Attachment& attachmentOf(MainWindow& window);

} // namespace plc::app
