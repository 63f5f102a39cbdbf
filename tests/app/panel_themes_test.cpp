// The project's themes in the window: from the menu and the tree to colours of open panels, and from a finding to the
// theme that it is about.
#include "app/documents/design_pages.h"
#include "app/panels/live_views.h"
#include "app/panels/panel_files.h"
#include "app/panels/text_page.h"
#include "app/project/project_tree.h"
#include "hmi/designer/canvas/design_canvas.h"
#include "hmi/designer/editors/theme_dialog.h"
#include "tests/app/studio_fixture.h"
#include "tests/support/answer.h"

#include <QAction>
#include <QComboBox>
#include <QTreeWidget>
#include <Qsci/qsciscintilla.h>

namespace plc::app {
namespace {

const QByteArray kPanel = R"({"theme": "fog", "elements": [
  {"kind": "text", "id": "a", "rect": [40, 40, 120, 40], "text": "Level"}]})";

class PanelThemesTest : public StudioTest {
protected:
    void SetUp() override {
        write("hmi/overview.panel.json", kPanel);
        StudioTest::SetUp();
    }
    /// Opens the dialog by `open`, and calls `look` with it; false: none came.
    static bool inDialog(const std::function<void()>& open, const std::function<void(hmi::ThemeDialog&)>& look) {
        bool wasThere = false;
        inNext<hmi::ThemeDialog>(qApp, [&](hmi::ThemeDialog& dialog) {
            wasThere = true;
            look(dialog);
            if (dialog.isVisible()) dialog.done(QDialog::Rejected);
        });
        open();
        return wasThere;
    }
};

TEST_F(PanelThemesTest, AThemeThatIsMadeIsShownAtOnceAndIsNotTakenForAnothers) {
    window->designs().openPanel("overview");
    EXPECT_TRUE(inDialog([&] { window->action("file.themes")->trigger(); },
                         [](hmi::ThemeDialog& dialog) {
                             EXPECT_EQ(dialog.add("fog"), QString());
                             emit dialog.grid().committed("background", QColor("#102030"));
                             dialog.accept();
                         }));
    EXPECT_TRUE(QFile::exists(folder.path() + "/hmi/themes/fog.json"));
    const QColor wanted("#102030");
    auto* canvas = window->tabs().currentWidget()->findChild<hmi::DesignCanvas*>();
    ASSERT_NE(canvas, nullptr);
    EXPECT_EQ(canvas->scene().theme().color("background"), wanted);
    ASSERT_NE(window->live().player(), nullptr);
    EXPECT_EQ(window->live().player()->scene().theme().color("background"), wanted);
    // A file of ours is none that another program wrote, and one that another program writes later is seen.
    window->panelFiles().look();
    write("hmi/themes/fog.json", R"({"colors": {"background": "#203040"}})");
    EXPECT_TRUE(waitFor([&] { return canvas->scene().theme().color("background") == QColor("#203040"); }));
}

TEST_F(PanelThemesTest, TheTreeAndTheDesignerOpenTheDialog) {
    write("hmi/themes/dusk.json", "{}");
    write("hmi/themes/fog.json", "{}");
    ASSERT_TRUE(waitFor([&] { return window->live().panels().themes.own().size() == 2; }));
    window->designs().openPanel("overview");
    QTreeWidgetItem* themes = nullptr;
    QTreeWidget& tree = window->projectTree().tree();
    for (int i = 0; i < tree.topLevelItemCount(); ++i)
        if (tree.topLevelItem(i)->text(0) == "Panel Themes") themes = tree.topLevelItem(i);
    ASSERT_NE(themes, nullptr);
    EXPECT_TRUE(inDialog([&] { emit tree.itemActivated(themes, 0); }, [](hmi::ThemeDialog&) {}));
    auto* edit = window->tabs().currentWidget()->findChild<QAction*>("themes");
    ASSERT_NE(edit, nullptr);
    EXPECT_TRUE(inDialog([&] { edit->trigger(); },
                         [](hmi::ThemeDialog& dialog) {
                             EXPECT_EQ(dialog.preview().scene().panel().text("theme"), "fog")
                                 << "with the panel that is drawn";
                         }));
}

TEST_F(PanelThemesTest, AFindingLeadsToItsThemeOrToTheTextThatCannotBeRead) {
    write("hmi/themes/fog.json", R"({"colors": {"text": "#C8C8C8"}})");
    write("hmi/themes/mist.json", "{\"base\": \"dark\",\n \"colors\": {\"backgrond\": \"#304050\"}}");
    ASSERT_TRUE(waitFor([&] { return window->live().panels().themes.has("fog"); }));
    EXPECT_TRUE(inDialog([&] { window->designs().openPlace("hmi/themes/fog.json", {}); },
                         [](hmi::ThemeDialog& dialog) {
                             EXPECT_EQ(dialog.choice().currentText(), "fog");
                             EXPECT_NE(dialog.weaknesses(), QString());
                         }));
    window->designs().openPlace("hmi/people.json", {});
    EXPECT_EQ(window->tabs().currentWidget()->property("pageKey"), "people");
    window->designs().openPlace("hmi/themes/mist.json", {});
    auto* page = qobject_cast<TextPage*>(window->tabs().currentWidget());
    ASSERT_NE(page, nullptr);
    auto* text = page->findChild<QsciScintilla*>();
    ASSERT_NE(text, nullptr);
    text->setText(text->text().replace("backgrond", "background"));
    window->designs().save();
    EXPECT_TRUE(waitFor([&] { return window->live().panels().themes.has("mist"); }));
    EXPECT_EQ(window->tabs().currentWidget(), page) << "no dialog gets in the way";
}

} // namespace
} // namespace plc::app
