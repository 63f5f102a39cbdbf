// What every list of variables shows: pickers, the command line, the debug adapter and servers all read this tree.
#include "runtime/compiler/driver/driver.h"
#include "runtime/image/variable_tree.h"

#include <gtest/gtest.h>

namespace plc {
namespace {

using image::VariableKind;
using image::VariableNode;
using image::VariableTree;

const char* const kSource = R"(
{attribute 'qualified_only'}
VAR_GLOBAL
    speed : REAL; // of the belt [m/s]
END_VAR
VAR_GLOBAL CONSTANT
    Most : INT := 7;
END_VAR
TYPE Pair : STRUCT a : INT; b : ARRAY[1..2, 0..1] OF BOOL; END_STRUCT END_TYPE
FUNCTION_BLOCK Motor
VAR_INPUT go : BOOL; END_VAR
VAR_OUTPUT n : DINT; END_VAR
VAR_IN_OUT shared : Pair; END_VAR
VAR {attribute 'hide'} inner : INT; END_VAR
n := n + inner + shared.a + BOOL_TO_INT(go);
END_FUNCTION_BLOCK
PROGRAM Main
VAR
    m : Motor;
    p : Pair;
    long : ARRAY[0..4999] OF INT;
    out AT %QX0.3 : BOOL;
END_VAR
VAR CONSTANT k : INT := 3; END_VAR
VAR_EXTERNAL speed : REAL; END_VAR
m(go := TRUE, shared := p);
END_PROGRAM
)";

struct Tree : testing::Test {
    driver::Built built = [] {
        driver::BuildInput input;
        input.files.push_back({"main.st", kSource});
        return driver::build(input);
    }();
    void SetUp() override {
        ASSERT_TRUE(built.program) << [&] {
            std::string out;
            for (const auto& one : built.checked.analysis->diagnostics)
                out += diagnostics::renderText(*built.checked.sources, one, false) + "\n";
            return out;
        }();
    }
    VariableTree tree() const { return VariableTree(built.program->layout); }
    static std::string paths(const std::vector<VariableNode>& nodes) {
        std::string out;
        for (const VariableNode& node : nodes) out += (out.empty() ? "" : " ") + node.path;
        return out;
    }
    VariableNode child(std::string_view of, std::string_view name) const {
        for (const VariableNode& node : tree().children(of))
            if (node.name == name) return node;
        ADD_FAILURE() << name << " is not in " << of;
        return {};
    }
};

TEST_F(Tree, ProgramsComeFirstAndMembersInOrderOfDeclaration) {
    const std::vector<VariableNode> roots = tree().roots();
    ASSERT_FALSE(roots.empty());
    EXPECT_EQ(roots.front().path, "Main");
    EXPECT_EQ(roots.front().kind, VariableKind::Program);
    const std::string members = paths(tree().children("main")); // as every name: without case
    EXPECT_TRUE(members.starts_with("main.m main.p main.long")) << members;
    EXPECT_EQ(members.find("speed"), std::string::npos) << "an external variable is listed where it is declared";
}

TEST_F(Tree, MembersThatAreHiddenAreNotListedAndAnInOutLeadsNowhere) {
    EXPECT_EQ(paths(tree().children("Main.m")), "Main.m.go Main.m.n Main.m.shared");
    EXPECT_EQ(child("Main.m", "go").kind, VariableKind::Input);
    EXPECT_EQ(child("Main.m", "n").kind, VariableKind::Output);
    EXPECT_TRUE(child("Main.m", "shared").isInOut);
    EXPECT_FALSE(child("Main.m", "shared").hasMembers);
    EXPECT_EQ(paths(tree().children("Main.m.shared")), "");
}

TEST_F(Tree, ElementsAreCountedThroughAllDimensionsAndALongArrayIsCut) {
    EXPECT_EQ(paths(tree().children("Main.p.b")), "Main.p.b[1,0] Main.p.b[1,1] Main.p.b[2,0] Main.p.b[2,1]");
    const std::vector<VariableNode> all = tree().children("Main.long");
    ASSERT_EQ(all.size(), VariableTree::kMostElements);
    EXPECT_EQ(all.back().path, "Main.long[999]");
}

TEST_F(Tree, GlobalsHaveTheirCommentAndConstantsAreMarked) {
    std::vector<VariableNode> declared = tree().declared();
    const auto named = [&](std::string_view end) {
        return std::find_if(declared.begin(), declared.end(),
                            [&](const VariableNode& node) { return node.path.ends_with(end); });
    };
    ASSERT_NE(named("speed"), declared.end());
    EXPECT_NE(named("speed")->comment.find("[m/s]"), std::string::npos);
    ASSERT_NE(named("Most"), declared.end());
    EXPECT_TRUE(named("Most")->isConstant);
    EXPECT_TRUE(child("Main", "k").isConstant);
    EXPECT_FALSE(child("Main", "p").isConstant);
}

TEST_F(Tree, EveryPathThatIsListedIsFound) {
    int leaves = 0;
    tree().visit(
        tree().roots(),
        [&](const VariableNode& node, int) {
            if (!node.isGroup() && !node.isInOut) {
                EXPECT_TRUE(built.program->layout.find(node.path)) << node.path;
            }
            leaves += !node.hasMembers;
            return VariableTree::Next::Into;
        },
        true);
    EXPECT_GT(leaves, 1000);
}

TEST_F(Tree, AWalkStopsGoesOverAndStaysOutOfArraysAsItIsAsked) {
    std::string seen;
    const auto walk = [&](bool intoArrays, auto visitor) {
        seen.clear();
        return tree().visit({child("Main", "p")}, visitor, intoArrays);
    };
    const auto all = [&](const VariableNode& node, int depth) {
        seen += std::string(static_cast<size_t>(depth), '>') + node.name + " ";
        return VariableTree::Next::Into;
    };
    EXPECT_TRUE(walk(false, all));
    EXPECT_EQ(seen, "p >a >b ");
    EXPECT_TRUE(walk(true, all));
    EXPECT_EQ(seen, "p >a >b >>[1,0] >>[1,1] >>[2,0] >>[2,1] ");
    EXPECT_FALSE(walk(true, [&](const VariableNode& node, int) {
        seen += node.name;
        return node.name == "a" ? VariableTree::Next::Stop : VariableTree::Next::Into;
    }));
    EXPECT_EQ(seen, "pa");
    EXPECT_TRUE(walk(true, [&](const VariableNode& node, int) {
        seen += node.name;
        return VariableTree::Next::Over;
    }));
    EXPECT_EQ(seen, "p");
}

TEST_F(Tree, WhatIsNotThereHasNothingBelowIt) {
    EXPECT_TRUE(tree().children("Main.nothing").empty());
    EXPECT_TRUE(tree().children("Main.p.a").empty());
    EXPECT_TRUE(tree().children("Main.p.b[9,9]").empty());
    EXPECT_TRUE(tree().children("][").empty());
}

} // namespace
} // namespace plc
