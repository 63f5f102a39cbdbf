// Uses of a name beyond the program's text: panels and alarms are counted, searched and shown before a rename.
#include "app/panels/live_views.h"
#include "app/project/rename_dialog.h"
#include "app/project/search_view.h"
#include "hmi/designer/panel_designer.h"
#include "tests/app/studio_fixture.h"

#include <QAction>
#include <QLabel>
#include <QLineEdit>
#include <QTimer>
#include <QTreeWidget>

namespace plc::app {
namespace {

class PanelUsesTest : public StudioTest {
protected:
    void SetUp() override {
        write("hmi/overview.panel.json",
              R"({"elements": [{"id": "count", "kind": "number", "rect": [40, 40, 120, 40], "value": "Main.limit"},
                  {"id": "entry", "kind": "numberEntry", "rect": [40, 140, 120, 40], "target": "Main.limit"}]})");
        StudioTest::SetUp();
        editor().goTo(static_cast<uint32_t>(editor().utf8().find("limit :")));
    }
    QStringList rows(int column) {
        QStringList out;
        for (int i = 0; i < window->search().results().topLevelItemCount(); ++i)
            out << window->search().results().topLevelItem(i)->text(column);
        return out;
    }
};

TEST_F(PanelUsesTest, UsesInPanelsAreCountedAndLeadThere) {
    window->action("edit.uses")->trigger();
    EXPECT_TRUE(rows(0).contains("hmi/overview.panel.json: count")) << rows(0).join(" | ").toStdString();
    EXPECT_TRUE(rows(0).contains("hmi/overview.panel.json: entry"));
    const int at = static_cast<int>(rows(0).indexOf("hmi/overview.panel.json: entry"));
    EXPECT_EQ(rows(1)[at], "write");
    emit window->search().results().itemActivated(window->search().results().topLevelItem(at), 0);
    auto* designer = qobject_cast<hmi::PanelDesigner*>(window->tabs().currentWidget());
    ASSERT_NE(designer, nullptr);
    EXPECT_EQ(designer->selection().ids(), hmi::ElementIds{"entry"});
}

TEST_F(PanelUsesTest, ABindingIsCompletedWithTheProjectsVariablesBeforeFunctions) {
    const auto offered = [&](std::string_view typed) {
        QStringList out;
        for (const auto& item :
             window->workspace().model()->completePath(typed, static_cast<uint32_t>(typed.size())).items)
            out << QString::fromStdString(item.text);
        return out;
    };
    const QStringList all = offered("M");
    ASSERT_FALSE(all.isEmpty());
    EXPECT_EQ(all.first(), "Main");
    EXPECT_TRUE(all.contains("MAX")) << all.join(' ').toStdString();
    EXPECT_EQ(offered("Main.li").first(), "limit");
}

TEST_F(PanelUsesTest, FindInAllFilesCoversPanels) {
    window->search().openSearch("Main.limit");
    window->search().search();
    EXPECT_EQ(rows(0).filter("hmi/overview.panel.json").size(), 2);
}

TEST_F(PanelUsesTest, ARenameShowsWhatItChangesFirst) {
    QStringList shown;
    QTimer::singleShot(150, qApp, [&] {
        auto* dialog = qobject_cast<RenameDialog*>(QApplication::activeModalWidget());
        ASSERT_NE(dialog, nullptr);
        for (int i = 0; i < dialog->places().topLevelItemCount(); ++i)
            shown << dialog->places().topLevelItem(i)->text(0);
        dialog->reject();
    });
    window->action("edit.rename")->trigger();
    EXPECT_TRUE(shown.contains("src/main.st:4")) << shown.join(" | ").toStdString();
    EXPECT_TRUE(shown.contains("hmi/overview.panel.json: entry"));
    EXPECT_NE(editor().utf8().find("limit :"), std::string::npos) << "nothing has changed yet";
}

} // namespace
} // namespace plc::app
