// What is being typed in a property grid belongs to the thing that it was typed for, also when another one is shown
// without the keyboard having left the field: as when the window is not the one in front.
#include "design_studio.h"
#include "hmi/designer/editors/alarm_editor.h"
#include "hmi/designer/sheet/records_dialog.h"

namespace plc::hmi {
namespace {

/// Opens the field and types over what it holds, without Enter.
void type(kit::PropertyGrid& grid, const char* id, const char* text) {
    grid.editProperty(QString::fromLatin1(id));
    kit::ExpressionEdit* line = nullptr;
    for (auto* each : grid.findChildren<kit::ExpressionEdit*>()) // one that is closed goes a moment later
        if (!each->isHidden()) line = each;
    ASSERT_TRUE(line);
    line->selectAll();
    QTest::keyClicks(line, text);
}

constexpr const char* kElements = R"({"id": "a", "kind": "text", "rect": [10, 10, 80, 40], "text": "first"},
    {"id": "b", "kind": "text", "rect": [10, 60, 80, 40], "text": "second"},
    {"id": "c", "kind": "button", "rect": [10, 110, 80, 40], "text": "third"})";

TEST(TypedValue, StaysWithTheElementWhenAnotherIsSelected) {
    for (const char* next : {"b", "c", ""}) { // with the same rows, with others, and the panel itself
        Studio studio(kElements);
        studio.designer->selection().set({QStringLiteral("a")});
        type(studio.designer->sheet().grid(), "visible", "Main.running");
        if (::testing::Test::HasFatalFailure()) return;
        const auto wordsOf = [&](const char* id) {
            return *id ? writeCompact(studio.panel().find(QString::fromLatin1(id))->fields()) : studio.panel().write();
        };
        const std::string before = *next ? wordsOf(next) : std::string();
        studio.designer->selection().set(*next ? ElementIds{QString::fromLatin1(next)} : ElementIds());
        EXPECT_EQ(studio.panel().find(QStringLiteral("a"))->text("visible"), "Main.running") << next;
        EXPECT_TRUE(!*next || wordsOf(next) == before) << next;
        settle(); // an editor that was left behind is put away now
        EXPECT_EQ(studio.designer->document().undoStack().count(), 1) << next;
    }
}

TEST(TypedValue, OfAnElementThatIsDeletedIsNobodys) {
    Studio studio(kElements);
    studio.designer->selection().set({QStringLiteral("a")});
    type(studio.designer->sheet().grid(), "visible", "Main.running");
    studio.designer->document().perform("Delete", removeElements(studio.panel(), {QStringLiteral("a")}));
    studio.designer->selection().set({QStringLiteral("b")});
    EXPECT_EQ(studio.panel().elements().size(), 2U);
    EXPECT_EQ(studio.panel().find(QStringLiteral("b"))->text("visible"), "");
}

TEST(TypedValue, StaysWithTheAlarmWhenAnotherOrAClassIsChosen) {
    for (const char* next : {"flash", "fault"}) {
        Studio studio;
        studio.project.alarms = *AlarmFile::parse(
            R"({"classes": [{"name": "fault", "title": "@over"}], "alarms": [
                {"id": "over", "condition": "Main.overload", "text": "@over"},
                {"id": "flash", "condition": "Main.flash", "text": "@flash"}]})",
            {});
        AlarmEditor editor(*studio.context);
        editor.show();
        editor.select(QStringLiteral("over"));
        type(editor.grid(), "condition", "Main.running");
        if (::testing::Test::HasFatalFailure()) return;
        editor.select(QString::fromLatin1(next));
        const std::vector<AlarmDefinition> alarms = studio.project.alarms.definitions();
        EXPECT_EQ(alarms[0].condition, "Main.running") << next;
        EXPECT_EQ(alarms[1].condition, "Main.flash") << next;
        editor.undoStack().undo();
        EXPECT_EQ(studio.project.alarms.definitions()[0].condition, "Main.overload");
    }
}

TEST(TypedValue, StaysWithItsRecord) {
    Studio studio;
    const PropertyDescriptor* states = descriptorOf(ElementKind::MultiState).property("states");
    RecordsDialog dialog(*states, Json::parse(R"([{"value": "1"}, {"value": "2"}])"), *studio.context, {}, nullptr);
    dialog.show();
    dialog.selectRow(0);
    type(dialog.grid(), "value", "7");
    dialog.selectRow(1);
    EXPECT_EQ(writeCompact(dialog.value()), R"([{"value": "7"}, {"value": "2"}])");
    type(dialog.grid(), "value", "8");
    dialog.moveRow(-1);
    EXPECT_EQ(writeCompact(dialog.value()), R"([{"value": "8"}, {"value": "7"}])");
}

} // namespace
} // namespace plc::hmi
