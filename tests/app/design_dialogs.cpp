// The dialogs that are opened from the documents of the design and of the diagrams, for those who look at all windows.
#include "tests/app/all_windows.h"
#include "tests/support/settle.h"

#include "app/documents/design_pages.h"
#include "app/pages/editor_tabs.h"
#include "app/pages/st_page.h"
#include "app/start/start_page.h"
#include "editor/graph/ladder/ladder_view.h"
#include "editor/kit/inputs/color_popup.h"
#include "hmi/designer/editors/password_dialog.h"
#include "hmi/designer/editors/recipe_editor.h"
#include "hmi/designer/editors/text_editor.h"
#include "hmi/designer/panel_designer.h"

#include <QAction>
#include <QDir>
#include <QFile>
#include <QGraphicsView>
#include <QMenu>
#include <QTableWidget>

namespace plc::app {

namespace {

/// The command of a page, in its bar or in a menu of it.
QAction* actionCalled(QWidget& page, const char* context, const char* english) {
    const QString text = QCoreApplication::translate(context, english);
    for (QAction* action : page.findChildren<QAction*>())
        if (QString(action->text()).remove('&').startsWith(text)) return action;
    ADD_FAILURE() << english << " is no command of the page";
    return nullptr;
}

} // namespace

void lookAtDesignDialogs(MainWindow& window, const Look& look) {
    window.designs().openTexts();
    auto* texts = qobject_cast<hmi::TextEditor*>(window.tabs().currentWidget());
    ASSERT_NE(texts, nullptr);
    const auto ofTexts = [&](const char* english) {
        if (QAction* action = actionCalled(*texts, "plc::hmi::TextEditor", english)) action->trigger();
    };
    lookAtDialog(look, "add a key", [&] { ofTexts("Add a key"); });
    lookAtDialog(look, "add a language", [&] { ofTexts("Add a language"); });
    lookAtDialog(look, "export XLIFF", [&] { ofTexts("Export XLIFF"); });
    lookAtDialog(look, "password", [&] {
        hmi::PasswordDialog dialog("anna", &window);
        dialog.exec();
    });
    QDir().mkpath(window.workspace().folder() + "/hmi/themes");
    QFile theme(window.workspace().folder() + "/hmi/themes/workshop.json"); // letters that can hardly be read
    ASSERT_TRUE(theme.open(QIODevice::WriteOnly));
    theme.write(R"({"colors": {"text": "#C8C8C8"}})");
    theme.close();
    window.designs().openPanel("all");
    window.live().design()->themesReplaced();
    lookAtDialog(look, "themes", [&] { window.designs().editThemes(); });
    auto* designer = qobject_cast<hmi::PanelDesigner*>(window.tabs().currentWidget());
    ASSERT_NE(designer, nullptr);
    designer->selection().set({designer->document().panel().elements().front().id()});
    settle();
    lookAtDialog(look, "records", [&] { emit designer->sheet().grid().actionRequested("when"); });
    StPage* page = window.tabs().openFile("src/rungs.st");
    editor::LadderView* ladder = page->showLadder("Rungs");
    ASSERT_NE(ladder, nullptr);
    lookAtDialog(look, "keys of the ladder", [&] { QTest::keyClick(ladder->findChild<QGraphicsView*>(), Qt::Key_F1); });
    lookAtDialog(look, "beside", [&] { window.openBeside(); });
    kit::ColorPopup colours(QColor("#2878C8"), true, &window);
    colours.setAttribute(Qt::WA_DeleteOnClose, false);
    colours.openBelow(QRect(window.mapToGlobal(QPoint(200, 200)), QSize(80, 20)));
    look(colours, "colours");
    colours.close();
}

} // namespace plc::app
