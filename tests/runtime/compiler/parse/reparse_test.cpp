// A text that is read again after an edit gives the tokens, the tree with all its places, and the findings that reading
// the whole text gives, while what is well in front of the edit is not read.
#include "runtime/compiler/parse/reparse.h"
#include "tests/runtime/compiler/parse/outline.h"
#include "tests/support/repeats.h"

#include <gtest/gtest.h>

#include <deque>
#include <random>

namespace plc::parse {
namespace {

using namespace syntax;

/// Every place and comment of a tree, in the order of its nodes.
class Places {
public:
    std::string text;
    std::vector<size_t> numbers; // some hundred thousand

    void file(const SyntaxFile& file) {
        for (const lex::Token& each : file.tokens.tokens)
            number(static_cast<size_t>(each.kind)), number(static_cast<size_t>(each.soft)), number(each.afterNewline),
                number(each.begin), number(each.end);
        for (const lex::Comment& each : file.tokens.comments)
            number(each.begin), number(each.end), number(each.beforeToken);
        number(file.asksForNames);
        list(file.declarations);
    }

private:
    void number(size_t value) { numbers.push_back(value); }
    void range(SourceRange range) { number(range.begin), number(range.end); }
    void name(const Name& name) { text += name.text, text += '@', range(name.range); }
    void pragmas(const std::vector<Pragma>& all) {
        for (const Pragma& each : all) range(each.range), text += each.key, text += each.value;
    }
    void list(const std::vector<Decl*>& all) {
        for (const Decl* each : all) {
            number(static_cast<size_t>(each->kind)), range(each->range);
            if (each->pou) unit(*each->pou);
            if (each->space) list(each->space->declarations);
            if (each->type) name(each->type->name), text += each->type->comment, pragmas(each->type->pragmas);
            if (each->globals && each->globals->section) {
                text += each->globals->name;
                text += each->globals->comment;
                section(*each->globals->section);
            }
            if (each->test) range(each->test->range), block(each->test->body);
        }
        text += "\n";
    }
    void unit(const Pou& pou) {
        name(pou.name), range(pou.range), range(pou.header), pragmas(pou.pragmas);
        text += pou.comment;
        number(pou.hasEnd);
        for (const VarSection* each : pou.sections) section(*each);
        body(pou.body);
        for (const Pou* each : pou.methods) unit(*each);
        for (const Property* each : pou.properties) {
            name(each->name), range(each->range);
            if (each->get) unit(*each->get);
            if (each->set) unit(*each->set);
        }
        for (const ActionDecl* each : pou.actions) name(each->name), range(each->extent), body(each->body);
        text += "\n";
    }
    void section(const VarSection& section) {
        range(section.range), pragmas(section.pragmas);
        for (const VarDecl* each : section.declarations) {
            for (const Name& one : each->names) name(one);
            range(each->range), pragmas(each->pragmas), expr(each->initial);
            text += each->comment;
        }
    }
    void body(const Body& body) {
        number(static_cast<size_t>(body.language)), range(body.range), block(body.statements);
        if (body.chart) text += testing::outline(*body.chart), range(body.chart->range);
    }
    void block(const Block& statements) {
        for (const Stmt* each : statements) {
            range(each->range), expr(each->target), expr(each->value), expr(each->from), expr(each->to);
            if (each->il) name(each->il->op), expr(each->il->operand);
            block(each->body), block(each->elseBody);
            for (const IfBranch& branch : each->branches)
                range(branch.range), expr(branch.condition), block(branch.body);
            for (const CaseArm& arm : each->arms) range(arm.range), block(arm.body);
        }
    }
    void expr(const Expr* expr) {
        if (!expr) return;
        number(static_cast<size_t>(expr->kind)), range(expr->range), range(expr->operatorRange), name(expr->name);
        text += expr->text;
        this->expr(expr->base), this->expr(expr->right);
        for (const Argument& each : expr->arguments) name(each.name), range(each.range), this->expr(each.value);
    }
};

struct Read {
    std::string text;
    std::unique_ptr<SyntaxFile> tree;
    std::vector<diagnostics::Diagnostic> found;

    [[nodiscard]] Places places() const {
        Places out;
        out.file(*tree);
        SourceSet sources;
        sources.add("a.st", text);
        for (const diagnostics::Diagnostic& each : found)
            out.text += diagnostics::renderText(sources, each, false) + "\n";
        return out;
    }
};

Read readWhole(std::string text) {
    Read out{std::move(text), nullptr, {}};
    diagnostics::Sink sink;
    const Definitions known;
    out.tree = parseFile(FileId(size_t(0)), out.text, sink, &known);
    out.found = sink.take();
    return out;
}

/// Units of all kinds, the first of them plain so that there is something to share.
std::string longText() {
    std::string text = "TYPE Kind : (Slow, Fast); END_TYPE\nVAR_GLOBAL\n  gTotal : DINT; // of all\nEND_VAR\n";
    for (int i = 0; i < 220; ++i) {
        const std::string n = std::to_string(i);
        text += "(* station " + n + " *)\n{attribute 'hide'}\nFUNCTION_BLOCK Station" + n +
                "\nVAR_INPUT\n  level : INT := " + n + "; (* in mm *)\nEND_VAR\nVAR k : ARRAY[1..3] OF INT; END_VAR\n";
        if (i % 7 == 3) text += "METHOD Reset : BOOL\n  k[1] := 0; Reset := TRUE;\nEND_METHOD\n";
        text += "IF level > 2000 THEN\n  k[1] := k[2] + 3 * level; // full\nELSE\n  gTotal := gTotal + 1;\nEND_IF;\n";
        text += "END_FUNCTION_BLOCK\n\n";
        if (i % 40 == 10) text += "METHOD PUBLIC Behind : INT\n  Behind := 2;\nEND_METHOD\n";
        if (i % 50 == 20) text += "NAMESPACE N" + n + "\nFUNCTION F : INT\n  F := 1;\nEND_FUNCTION\nEND_NAMESPACE\n";
    }
    return text + "PROGRAM Main\nVAR s : Station1; END_VAR\ns(level := 5);\nEND_PROGRAM\n";
}

/// What typing and pasting leave, the things that reach far among them.
const std::vector<std::string>& pieces() {
    static const std::vector<std::string> all = {" ",
                                                 "x",
                                                 ";",
                                                 "(*",
                                                 "*)",
                                                 "'",
                                                 "\"q\"",
                                                 "END_FUNCTION_BLOCK\n",
                                                 "END_IF",
                                                 "{",
                                                 "}",
                                                 "\n",
                                                 "// c\n",
                                                 "\xC3\xA4",
                                                 "\xFF",
                                                 "VAR a : INT; END_VAR\n",
                                                 "0",
                                                 " := 1;",
                                                 "IF ",
                                                 "gvl",
                                                 "REGION r\n",
                                                 "END_REGION\n",
                                                 "{gvl G}\n",
                                                 "LD x\nST y\n",
                                                 "{IF defined (Q)}\n",
                                                 "{END_IF}\n",
                                                 "{define Q}\n",
                                                 "FUNCTION_BLOCK Q\nEND_FUNCTION_BLOCK\n",
                                                 "METHOD M : INT\nEND_METHOD\n",
                                                 "VAR_GLOBAL g : INT; END_VAR\n",
                                                 "INITIAL_STEP S:\nEND_STEP\n",
                                                 "TEST 'a'\nEND_TEST\n",
                                                 "END_PROGRAM\n",
                                                 "#",
                                                 "%IX0.0",
                                                 "==",
                                                 "\xE2\x80\x9C"};
    return all;
}

TEST(Reparse, RandomEditsReadAsTheWholeTextDoes) {
    std::mt19937 random(20261123);
    const std::string clean = longText();
    std::deque<Read> alive; // each owns what those behind it share
    alive.push_back(readWhole(clean));
    size_t shared = 0;
    for (int step = 0; step < repeats(1000); ++step) {
        SCOPED_TRACE("step " + std::to_string(step) + " of seed 20261123");
        const Read& before = alive.back();
        std::string text = step % 4 == 3 ? clean : before.text;
        // in the second half, where typing pays
        const size_t at = text.size() / 2 + random() % (text.size() / 2 + 1);
        if (random() % 3 == 0)
            text.erase(at, random() % 12);
        else
            text.insert(at, pieces()[random() % pieces().size()]);

        diagnostics::Sink sink;
        const Definitions known;
        Read now{std::move(text), nullptr, {}};
        auto again = reparseFile({*before.tree, before.text, before.found}, now.text, sink, &known);
        const Read whole = readWhole(now.text);
        if (!again || step % 50 == 0) {
            alive.clear(); // it shares nothing
            alive.push_back(readWhole(now.text));
            continue;
        }
        ++shared;
        ASSERT_GT(again->shared, 0u);
        EXPECT_EQ(again->tree->declarations[0], before.tree->declarations[0]) << "the same node";
        now.tree = std::move(again->tree);
        now.found = sink.take();
        const Places read = now.places(), meant = whole.places();
        ASSERT_EQ(testing::outline(*now.tree), testing::outline(*whole.tree));
        ASSERT_EQ(read.text, meant.text);
        ASSERT_EQ(read.numbers, meant.numbers);
        alive.push_back(std::move(now));
    }
    EXPECT_GT(shared, repeats(400U));
}

TEST(Reparse, OneUnitInFrontOfTheEditIsReadAgain) {
    const Read before = readWhole(longText());
    const size_t at = before.text.find("Station200");
    std::string text = before.text;
    text.insert(text.find("2000", at), "1");
    diagnostics::Sink sink;
    const auto again = reparseFile({*before.tree, before.text, before.found}, text, sink, nullptr);
    ASSERT_TRUE(again);
    const auto& all = before.tree->declarations;
    ASSERT_LT(again->shared + 1, all.size());
    EXPECT_EQ(all[again->shared]->pou->name.text, "Station199");
    EXPECT_NE(again->tree->declarations[again->shared], all[again->shared]);
}

/// What is behind decides about what is in front: the text is read in whole.
TEST(Reparse, WhatReachesFurtherIsReadInWhole) {
    const std::string plain = longText();
    for (const char* front :
         {"{gvl G}\nVAR_GLOBAL h : INT; END_VAR\n", "FUNCTION F : INT\nVAR \"a b\" : INT; END_VAR\nEND_FUNCTION\n",
          "FUNCTION F : INT\nREGION := 1;\nEND_FUNCTION\n", "FUNCTION_BLOCK L\nLD a\nST b\nEND_FUNCTION_BLOCK\n",
          "FUNCTION F : INT\nF := ;\nEND_FUNCTION\n", "FUNCTION F : INT\nF := 1 ? 2;\nEND_FUNCTION\n",
          "{IF defined (Q)}\n{END_IF}\n", "{text it's\nlong}\n", "/* a /* b */\n"}) {
        const Read before = readWhole(front + plain);
        std::string text = before.text;
        text.insert(text.rfind("level"), " ");
        diagnostics::Sink sink;
        EXPECT_FALSE(reparseFile({*before.tree, before.text, before.found}, text, sink, nullptr)) << front;
    }
}

} // namespace
} // namespace plc::parse
