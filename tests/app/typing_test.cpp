// Typing as one means it: a new document has the keyboard.
#include "editor/debug/watch_view.h"
#include "hmi/designer/panel_designer.h"
#include "tests/app/studio_fixture.h"

#include <QAction>
#include <QDialog>
#include <QLineEdit>
#include <QTimer>

namespace plc::app {
namespace {

class TypingTest : public StudioTest {
protected:
    /// Types the name into the dialog that opens next and accepts it.
    static void answerWithName(const QString& name) {
        QTimer::singleShot(100, qApp, [name] {
            auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
            ASSERT_NE(dialog, nullptr);
            dialog->findChild<QLineEdit*>()->setText(name);
            dialog->accept();
        });
    }
};

TEST_F(TypingTest, ANewDocumentHasTheKeyboard) {
    window->watch().tree().setFocus();
    answerWithName("Mixer");
    window->action("file.newUnit")->trigger();
    ASSERT_NE(window->tabs().currentEditor(), nullptr);
    EXPECT_TRUE(editor().hasFocus() || editor().viewport()->hasFocus());
    window->watch().tree().setFocus();
    answerWithName("desk");
    window->action("file.newPanel")->trigger();
    auto* designer = qobject_cast<hmi::PanelDesigner*>(window->tabs().currentWidget());
    ASSERT_NE(designer, nullptr);
    EXPECT_TRUE(designer->canvas().hasFocus());
}

} // namespace
} // namespace plc::app
