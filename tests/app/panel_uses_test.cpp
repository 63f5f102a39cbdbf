// Uses of a name beyond the program's text: panels and alarms are counted, searched and shown before a rename.
#include "app/panels/live_views.h"
#include "app/project/rename_dialog.h"
#include "app/project/search_view.h"
#include "editor/debug/watch_view.h"
#include "editor/trace/trace_view.h"
#include "hmi/designer/panel_designer.h"
#include "tests/app/studio_fixture.h"
#include "tests/support/answer.h"

#include <QAction>
#include <QLabel>
#include <QLineEdit>
#include <QTreeWidget>

namespace plc::app {
namespace {

QStringList placesOf(RenameDialog& dialog) {
    QStringList out;
    for (int i = 0; i < dialog.places().topLevelItemCount(); ++i) out << dialog.places().topLevelItem(i)->text(0);
    return out;
}

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

class MemberRenameTest : public StudioTest {
protected:
    void SetUp() override {
        write("src/pump.st", "FUNCTION_BLOCK Pump\nVAR_OUTPUT flow : REAL; END_VAR\nflow := 1.0;\nEND_FUNCTION_BLOCK\n"
                             "VAR_GLOBAL gPump : Pump; END_VAR\n");
        write("hmi/overview.panel.json",
              R"({"elements": [{"id": "flow", "kind": "number", "rect": [40, 40, 120, 40], "value": "gPump.flow"}]})");
        write("hmi/pump.panel.json", R"({"size": [200, 100], "parameters": [{"name": "pump", "type": "Pump"}],
              "elements": [{"id": "flow", "kind": "number", "rect": [0, 0, 120, 40], "value": "$pump.flow * 2.0"}]})");
        StudioTest::SetUp();
    }
    std::string read(const char* file) {
        QFile in(window->workspace().folder() + "/" + file);
        return in.open(QIODevice::ReadOnly) ? in.readAll().toStdString() : std::string();
    }
};

TEST_F(MemberRenameTest, PanelsAndFaceplatesFollowAVariableOfABlock) {
    window->tabs().openFile("src/pump.st");
    analysed();
    editor().goTo(static_cast<uint32_t>(editor().utf8().find("flow :")));
    QStringList shown;
    inNext<RenameDialog>(window.get(), [&](RenameDialog& dialog) {
        shown = placesOf(dialog);
        dialog.findChild<QLineEdit*>()->setText("output");
        dialog.accept();
    });
    window->action("edit.rename")->trigger();
    EXPECT_TRUE(shown.contains("hmi/overview.panel.json: flow")) << shown.join(" | ").toStdString();
    EXPECT_TRUE(shown.contains("hmi/pump.panel.json: flow"));
    EXPECT_NE(read("hmi/overview.panel.json").find("gPump.output"), std::string::npos);
    EXPECT_NE(read("hmi/pump.panel.json").find("$pump.output * 2.0"), std::string::npos);
    QTest::keyClick(&editor(), Qt::Key_Z, Qt::ControlModifier);
    EXPECT_NE(editor().utf8().find("flow :"), std::string::npos);
    EXPECT_NE(read("hmi/overview.panel.json").find("gPump.flow"), std::string::npos);
    EXPECT_NE(read("hmi/pump.panel.json").find("$pump.flow * 2.0"), std::string::npos);
}

TEST_F(MemberRenameTest, WatchListsAndTheTraceFollowAndTheRunningProgramIsMentioned) {
    window->watch().setExpressions({"gPump.flow", "Main.counter"});
    window->watch().addList("pumps");
    window->watch().setExpressions({"gPump.flow * 3.0"});
    window->live().traceView().addChannel("gPump.flow");
    window->action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().value("Main.counter").text.toInt() > 3; }));
    window->tabs().openFile("src/pump.st");
    analysed();
    editor().goTo(static_cast<uint32_t>(editor().utf8().find("flow :")));
    QString complaint;
    bool isMentioned = false;
    inNext<RenameDialog>(window.get(), [&](RenameDialog& dialog) {
        for (QLabel* each : dialog.findChildren<QLabel*>())
            isMentioned |= each->isVisible() && each->text().contains("initial value");
        auto* line = dialog.findChild<QLineEdit*>();
        line->selectAll();
        QTest::keyClicks(line, "END_IF");
        QTest::keyClick(line, Qt::Key_Return);
        complaint = dialog.isVisible() ? dialog.complaint() : QString();
        QTest::keyClicks(line, "delivery"); // over what is selected
        QTest::keyClick(line, Qt::Key_Return);
        if (dialog.isVisible()) dialog.reject();
    });
    window->action("edit.rename")->trigger();
    EXPECT_TRUE(isMentioned) << "its value is lost";
    EXPECT_TRUE(complaint.contains("END_IF")) << complaint.toStdString();
    EXPECT_NE(editor().utf8().find("delivery :"), std::string::npos) << editor().utf8();
    EXPECT_EQ(window->watch().expressions(), QStringList{"gPump.delivery * 3.0"});
    EXPECT_EQ(window->live().traceView().setup().channels.front().expression, "gPump.delivery");
    window->watch().showList("Watch");
    EXPECT_EQ(window->watch().expressions(), (QStringList{"gPump.delivery", "Main.counter"}));
    QTest::keyClick(&editor(), Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(window->watch().expressions(), (QStringList{"gPump.flow", "Main.counter"}));
    EXPECT_EQ(window->live().traceView().setup().channels.front().expression, "gPump.flow");
}

TEST_F(PanelUsesTest, FindInAllFilesCoversPanels) {
    window->search().openSearch("Main.limit");
    window->search().search();
    EXPECT_EQ(rows(0).filter("hmi/overview.panel.json").size(), 2);
}

TEST_F(PanelUsesTest, ARenameShowsWhatItChangesFirst) {
    QStringList shown;
    inNext<RenameDialog>(window.get(), [&](RenameDialog& dialog) {
        shown = placesOf(dialog);
        dialog.reject();
    });
    window->action("edit.rename")->trigger();
    EXPECT_TRUE(shown.contains("src/main.st:4")) << shown.join(" | ").toStdString();
    EXPECT_TRUE(shown.contains("hmi/overview.panel.json: entry"));
    EXPECT_NE(editor().utf8().find("limit :"), std::string::npos) << "nothing has changed yet";
}

} // namespace
} // namespace plc::app
