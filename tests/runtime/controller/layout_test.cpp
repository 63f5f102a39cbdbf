#include "tests/runtime/hand_made_program.h"

#include <gtest/gtest.h>

namespace plc::image {
namespace {

using plc::testing::HandMade;
using types::Dimension;
using types::TypeKind;
using types::TypeTable;

class LayoutTest : public ::testing::Test {
protected:
    LayoutTest() {
        types::Field alias = HandMade::field("RESET", TypeKind::Bool);
        alias.aliases = {"R"};
        const types::TypeId point =
            made.structure("Point", {HandMade::field("x", TypeKind::Int), HandMade::field("y", TypeKind::Lreal)});
        const types::TypeId grid = made.types().array({Dimension{1, 3}, Dimension{0, 1}}, point);
        const types::TypeId motor =
            made.structure("Motor",
                           {HandMade::field("speed", TypeKind::Real), alias, HandMade::field("points", grid),
                            HandMade::field("name", made.types().string(10))},
                           TypeKind::Block);
        made.add("Main", motor, Area::Program);
        made.add("Speed", TypeKind::Word).list = "GVL";
        made.add("Speed", TypeKind::Int).list = "Other";
        made.add("only", TypeKind::Dint).list = "GVL";
        made.locate("lamp", TypeKind::Bool, "%QX0.1", 80, 1, Area::Output);
        program = made.finish();
    }
    std::string failure(std::string_view path) {
        const Result<Place> place = program->layout.find(path);
        return place ? std::string() : place.error().message.english();
    }
    HandMade made;
    std::shared_ptr<CompiledProgram> program;
};

TEST_F(LayoutTest, FindsVariablesByPathWithoutCase) {
    const Layout& layout = program->layout;
    const uint32_t main = layout.roots[0].offset;
    const uint32_t points = (*layout.types)[layout.roots[0].type].findField("points")->offset;
    struct Row {
        const char* path;
        uint32_t offset;
        TypeKind kind;
        int bit;
    };
    const Row rows[] = {
        {"Main.speed", main, TypeKind::Real, -1},
        {"main.SPEED", main, TypeKind::Real, -1},
        {"Motor.speed", main, TypeKind::Real, -1}, // the program type has one instance
        {"Main.reset", main + 4, TypeKind::Bool, -1},
        {"Main.r", main + 4, TypeKind::Bool, -1},
        {"Main.points[2, 1].x", main + points + 3 * 16, TypeKind::Int, -1},
        {"Main.points[1,0].y", main + points + 8, TypeKind::Lreal, -1},
        {"GVL.Speed", layout.roots[1].offset, TypeKind::Word, -1},
        {"Other.speed", layout.roots[2].offset, TypeKind::Int, -1},
        {"only", layout.roots[3].offset, TypeKind::Dint, -1},
        {"GVL.Speed.11", layout.roots[1].offset + 1, TypeKind::Bool, 3},
        {"GVL.Speed.%X2", layout.roots[1].offset, TypeKind::Bool, 2},
        {"only.%W1", layout.roots[3].offset + 2, TypeKind::Word, -1},
        {"lamp", 80, TypeKind::Bool, 1},
        {"%QX0.1", 80, TypeKind::Bool, 1},
        {"%Q0.1", 80, TypeKind::Bool, 1},
        {"%iw3", 67, TypeKind::Word, -1},
        {"%MD4", 100, TypeKind::Dword, -1},
        {"Main.name[2]", main + points + 6 * 16 + 2, TypeKind::Char, -1},
    };
    for (const Row& row : rows) {
        const Result<Place> place = layout.find(row.path);
        ASSERT_TRUE(place) << row.path << ": " << place.error().message.english();
        EXPECT_EQ(place->offset, row.offset) << row.path;
        EXPECT_EQ(layout.types->kind(place->type), row.kind) << row.path;
        EXPECT_EQ(place->bit, row.bit) << row.path;
    }
}

TEST_F(LayoutTest, SaysWhatIsWrongWithAPath) {
    EXPECT_EQ(failure("Main.sped"), "'Motor' has no variable 'sped'; did you mean 'speed'?");
    EXPECT_EQ(failure("Maiin.speed"), "there is no variable 'Maiin'; did you mean 'Main'?");
    EXPECT_EQ(failure("GVL.Sped"), "'GVL' has no variable 'Sped'; did you mean 'Speed'?");
    EXPECT_EQ(failure("Speed"), "'Speed' is ambiguous; write one of GVL.Speed, Other.Speed");
    EXPECT_EQ(failure("Main.points[4,0].x"),
              "index 4 is outside 1..3; use an index in this range or enlarge the array");
    EXPECT_EQ(failure("GVL.Speed.16"), "bit 16 is outside 0..15; use a bit in this range");
    EXPECT_EQ(failure("%QX20.0"), "the program does not use the address '%QX20.0'; declare a variable AT this address");
    EXPECT_NE(failure("Main."), "");
    EXPECT_NE(failure("Main.points[1"), "");
    EXPECT_NE(failure(""), "");
    EXPECT_NE(failure("%Z1"), "");
}

TEST_F(LayoutTest, PathAtGoesBackToEveryLeaf) {
    const Layout& layout = program->layout;
    size_t leaves = 0;
    for (const Root& root : layout.roots) {
        layout.forEachLeaf(Layout::pathOf(root), {root.type, root.offset, root.bit},
                           [&](const std::string& path, const Place& place) {
                               const Result<Place> again = layout.find(path);
                               EXPECT_TRUE(again && *again == place) << path;
                               if (place.bit < 0) {
                                   EXPECT_EQ(layout.pathAt(place.offset), path);
                               }
                               ++leaves;
                               return true;
                           });
    }
    EXPECT_EQ(leaves, 3u + 12u + 4u);
    const types::TypeId point =
        (*layout.types)[(*layout.types)[layout.roots[0].type].findField("points")->type].element;
    const Result<Place> element = layout.find("Main.points[3,1]");
    ASSERT_TRUE(element);
    EXPECT_EQ(layout.pathAt(element->offset, point), "Main.points[3,1]");
    EXPECT_EQ(layout.pathAt(element->offset), "Main.points[3,1].x");
}

} // namespace
} // namespace plc::image
