#include "app/window_commands.h"
#include "app/documents/design_pages.h"

#include "app/exchange/exchange_dialogs.h"
#include "app/frame/keyboard_commands.h"
#include "app/main_window.h"
#include "app/online/attachment.h"
#include "app/online/native_program.h"
#include "app/pages/editor_tabs.h"
#include "app/project/explanation_dialog.h"
#include "app/project/problems_view.h"
#include "editor/kit/message_text.h"
#include "editor/kit/texts.h"
#include "projects/storage/project_file.h"

#include <QApplication>
#include <QMenu>

namespace plc::app {

void chooseColumns(MainWindow& window) {
    QMenu* columns = makeColumnMenu();
    if (!columns)
        return window.say(MainWindow::tr("There are no columns here; go to a table or a list with columns first"),
                          true);
    columns->setAttribute(Qt::WA_DeleteOnClose);
    const QWidget* table = QApplication::focusWidget();
    columns->popup(table->mapToGlobal(QPoint(8, 8)));
}

void importProject(MainWindow& window) {
    ImportDialog dialog(window.settings().projectsFolder(), &window);
    if (dialog.exec() == QDialog::Accepted) window.openProject(dialog.folder());
}

void exportProject(MainWindow& window) {
    if (!window.workspace().isOpen()) return;
    if (auto saved = window.workspace().saveAll(); !saved) return window.say(kit::messageText(saved.error()), true);
    const auto project = projects::openProject({window.workspace().folder().toStdString()});
    if (!project) return window.say(kit::messageText(project.error()), true);
    ExportDialog dialog(*project, &window);
    if (dialog.exec() == QDialog::Accepted) window.say(MainWindow::tr("The project was exported"));
}

void buildNativeProgram(MainWindow& window) {
    if (!window.workspace().isOpen()) return;
    const QString done =
        buildNativeProgram(&window, window.workspace().folder(), [&window] { window.designs().saveAll(); });
    if (!done.isEmpty()) window.say(done);
}

namespace {

/// Of the problem whose text the cursor is in, or else of the first one in its line; "" where there is none.
QString problemAtCursor(MainWindow& window) {
    const editor::StEditor* editor = window.tabs().currentEditor();
    const auto model = window.workspace().model();
    const auto file = editor && model ? model->fileOf(editor->file().toStdString()) : std::nullopt;
    if (!file) return {};
    const SourceText& source = model->sources()[*file];
    const uint32_t at = editor->cursorOffset();
    const auto line = source.lineColumn(at).line;
    std::string_view inLine;
    for (const diagnostics::Diagnostic& each : model->diagnostics()) {
        if (each.range.file != *file) continue;
        if (each.range.begin <= at && at <= each.range.end) return kit::fromView(diagnostics::codeOf(each.kind));
        if (inLine.empty() && source.lineColumn(each.range.begin).line == line) inLine = diagnostics::codeOf(each.kind);
    }
    return kit::fromView(inLine);
}

} // namespace

void explainProblem(MainWindow& window) {
    const QString code =
        window.problems().list().hasFocus() ? window.problems().currentCode() : problemAtCursor(window);
    auto* dialog = window.findChild<ExplanationDialog*>();
    if (!dialog) dialog = new ExplanationDialog(&window);
    if (!dialog->show(code))
        window.say(code.isEmpty()
                       ? ExplanationDialog::tr("Put the cursor on a problem, or choose one in the list, and "
                                               "press F1 again")
                       : ExplanationDialog::tr("There is no page for %1; choose a code from the list").arg(code));
}

Attachment& attachmentOf(MainWindow& window) {
    return Attachment::of(window.control(), window.workspace(),
                          {&window, [&window](const QString& text, bool isError) { window.say(text, isError); },
                           [&window](const QString& folder) { return window.openProject(folder); }});
}

} // namespace plc::app
