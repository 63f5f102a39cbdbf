// SFC graphs in: divergences, convergences and jumps become FROM and TO, actions and conditions of every form are kept.
#include "fixture.h"

namespace plc::exchange {
namespace {

std::string in(std::initializer_list<const char*> ids) {
    std::string out;
    for (const char* id : ids)
        out += "<connectionPointIn><connection refLocalId=\"" + std::string(id) +
               "\" formalParameter=\"sfc\"/></connectionPointIn>";
    return out;
}
std::string step(const std::string& id, const std::string& name, std::initializer_list<const char*> from,
                 const std::string& more = {}) {
    return "<step localId=\"" + id + "\" name=\"" + name + "\" " + more + "><position x=\"10\" y=\"20\"/>" + in(from) +
           "<connectionPointOut formalParameter=\"\"/></step>";
}
std::string transition(const std::string& id, const std::string& condition, std::initializer_list<const char*> from) {
    return "<transition localId=\"" + id + "\"><position x=\"0\" y=\"0\"/>" + in(from) +
           "<condition><inline name=\"\"><ST><xhtml>" + condition + "</xhtml></ST></inline></condition></transition>";
}
std::string node(const std::string& tag, const std::string& id, std::initializer_list<const char*> from) {
    return "<" + tag + " localId=\"" + id + "\"><position x=\"0\" y=\"0\"/>" + in(from) +
           "<connectionPointOut formalParameter=\"\"/></" + tag + ">";
}
std::string jump(const std::string& id, const std::string& target, std::initializer_list<const char*> from) {
    return "<jumpStep localId=\"" + id + "\" targetName=\"" + target + "\"><position x=\"0\" y=\"0\"/>" + in(from) +
           "</jumpStep>";
}

class ChartImport : public ExchangeTest {
protected:
    std::string chart(const std::string& elements, const std::string& interface, const std::string& more = {}) {
        imported = import(document(pou("Main", "program", interface, "<SFC>" + elements + "</SFC>", more)));
        EXPECT_EQ(errorsOf(imported), "");
        const std::string text = fileOf(imported, "src/Main.st");
        const size_t begin = text.find("INITIAL_STEP");
        return text.substr(begin, text.rfind("END_PROGRAM") - begin);
    }
    Imported imported;
};

TEST_F(ChartImport, StepsAndTransitionsInARowWithAJumpBack) {
    EXPECT_EQ(chart(step("1", "Init", {}, "initialStep=\"true\"") + transition("2", "a", {"1"}) +
                        step("3", "Run", {"2"}) + transition("4", "NOT a", {"3"}) + jump("5", "Init", {"4"}),
                    bools({"a"})),
              "INITIAL_STEP Init:\nEND_STEP\nTRANSITION FROM Init TO Run := a; END_TRANSITION\nSTEP "
              "Run:\nEND_STEP\nTRANSITION FROM Run TO Init := NOT a; END_TRANSITION\n");
    EXPECT_EQ(imported.side["units"]["Main"]["positions"]["Run"].dump(), "[10,20]");
}

std::string macro(const std::string& id, const std::string& name, std::initializer_list<const char*> from,
                  const std::string& elements) {
    return "<macroStep localId=\"" + id + "\" name=\"" + name + "\"><position x=\"0\" y=\"0\"/>" + in(from) +
           "<connectionPointOut formalParameter=\"\"/><body><SFC>" + elements + "</SFC></body></macroStep>";
}

TEST_F(ChartImport, AMacroStepBecomesTheStepsItHolds) {
    // "Run" is the name of a step outside, too; the jump at the end leads to the macro step
    const std::string inner =
        step("1", "Begin", {}, "initialStep=\"true\"") + transition("2", "b", {"1"}) + step("3", "Run", {"2"});
    EXPECT_EQ(chart(step("1", "Init", {}, "initialStep=\"true\"") + transition("2", "a", {"1"}) +
                        macro("3", "M", {"2"}, inner) + transition("4", "NOT a", {"3"}) + step("5", "Run", {"4"}) +
                        transition("6", "a AND b", {"5"}) + jump("7", "M", {"6"}),
                    bools({"a", "b"})),
              "INITIAL_STEP Init:\nEND_STEP\nTRANSITION FROM Init TO Begin := a; END_TRANSITION\nSTEP "
              "Begin:\nEND_STEP\nTRANSITION FROM Begin TO M_Run := b; END_TRANSITION\nSTEP M_Run:\nEND_STEP\n"
              "TRANSITION FROM M_Run TO Run := NOT a; END_TRANSITION\nSTEP Run:\nEND_STEP\nTRANSITION FROM Run TO "
              "Begin := a AND b; END_TRANSITION\n");
    ASSERT_EQ(imported.report.notes.size(), 1u) << imported.report.toText();
    EXPECT_EQ(imported.report.notes[0].kind, NoteKind::MacroStepExpanded);
}

TEST_F(ChartImport, MacroStepsHoldMacroStepsAndActionsAndMayBeEmpty) {
    const std::string block = "<actionBlock localId=\"4\"><position x=\"0\" y=\"0\"/>" + in({"1"}) +
                              "<action localId=\"5\" qualifier=\"N\"><reference name=\"q\"/></action></actionBlock>";
    const std::string deep = step("1", "Deep", {}) + block;
    const std::string inner = step("1", "Begin", {}) + transition("2", "a", {"1"}) + macro("3", "Inner", {"2"}, deep);
    EXPECT_EQ(chart(step("1", "Init", {}, "initialStep=\"true\"") + transition("2", "a", {"1"}) +
                        macro("3", "Outer", {"2"}, inner) + transition("4", "NOT a", {"3"}) + jump("5", "Init", {"4"}),
                    bools({"a", "q"})),
              "INITIAL_STEP Init:\nEND_STEP\nTRANSITION FROM Init TO Begin := a; END_TRANSITION\nSTEP "
              "Begin:\nEND_STEP\nTRANSITION FROM Begin TO Deep := a; END_TRANSITION\nSTEP Deep:\n    q(N);\nEND_STEP\n"
              "TRANSITION FROM Deep TO Init := NOT a; END_TRANSITION\n");
    imported = import(document(pou("Main", "program", bools({"a"}),
                                   "<SFC>" + step("1", "Init", {}, "initialStep=\"true\"") +
                                       transition("2", "a", {"1"}) + macro("3", "Empty", {"2"}, "") + "</SFC>")));
    EXPECT_GE(imported.report.losses(), 1u);
    EXPECT_NE(imported.report.toText().find("The element macroStep Empty was not read"), std::string::npos)
        << imported.report.toText();
}

TEST_F(ChartImport, AlternativesDivergeAndConverge) {
    EXPECT_EQ(chart(step("1", "Init", {}, "initialStep=\"true\"") + node("selectionDivergence", "2", {"1"}) +
                        transition("3", "a", {"2"}) + step("4", "L", {"3"}) + transition("5", "b", {"2"}) +
                        step("6", "R", {"5"}) + transition("7", "NOT a", {"4"}) + transition("8", "NOT b", {"6"}) +
                        node("selectionConvergence", "9", {"7", "8"}) + step("10", "End", {"9"}) +
                        transition("11", "TRUE", {"10"}) + jump("12", "Init", {"11"}),
                    bools({"a", "b"})),
              "INITIAL_STEP Init:\nEND_STEP\nTRANSITION FROM Init TO L := a; END_TRANSITION\nSTEP "
              "L:\nEND_STEP\nTRANSITION FROM Init TO R := b; END_TRANSITION\nSTEP R:\nEND_STEP\n"
              "TRANSITION FROM L TO End := NOT a; END_TRANSITION\nTRANSITION FROM R TO End := NOT b; "
              "END_TRANSITION\nSTEP End:\nEND_STEP\nTRANSITION FROM End TO Init := TRUE; END_TRANSITION\n");
}

TEST_F(ChartImport, ParallelBranchesOpenAndJoin) {
    EXPECT_EQ(chart(step("1", "Init", {}, "initialStep=\"true\"") + transition("2", "a", {"1"}) +
                        node("simultaneousDivergence", "3", {"2"}) + step("4", "L", {"3"}) + step("5", "R", {"3"}) +
                        node("simultaneousConvergence", "6", {"4", "5"}) + transition("7", "b", {"6"}) +
                        jump("8", "Init", {"7"}),
                    bools({"a", "b"})),
              "INITIAL_STEP Init:\nEND_STEP\nTRANSITION FROM Init TO (L, R) := a; END_TRANSITION\nSTEP "
              "L:\nEND_STEP\nSTEP R:\nEND_STEP\nTRANSITION FROM (L, R) TO Init := b; END_TRANSITION\n");
}

TEST_F(ChartImport, ActionsKeepQualifierTimeAndInlineText) {
    const std::string actions =
        "<actionBlock localId=\"20\"><position x=\"0\" y=\"0\"/>" + in({"1"}) +
        "<action localId=\"21\" qualifier=\"N\"><relPosition x=\"0\" y=\"0\"/><reference name=\"a\"/></action>"
        "<action localId=\"22\" qualifier=\"L\" duration=\"T#2s\"><relPosition x=\"0\" y=\"0\"/><reference "
        "name=\"Work\"/></action>"
        "<action localId=\"23\" qualifier=\"P\"><relPosition x=\"0\" y=\"0\"/><inline><ST><xhtml>b := NOT "
        "b;</xhtml></ST></inline></action></actionBlock>";
    EXPECT_EQ(chart(step("1", "Init", {}, "initialStep=\"true\"") + actions + transition("2", "FALSE", {"1"}) +
                        jump("3", "Init", {"2"}),
                    bools({"a", "b"}),
                    "<actions><action name=\"Work\"><body>" + st("b := TRUE;") + "</body></action></actions>"),
              "INITIAL_STEP Init:\n    a(N);\n    Work(L, T#2s);\n    Init_Action1(P);\nEND_STEP\nTRANSITION FROM Init "
              "TO Init := FALSE; END_TRANSITION\n\nACTION Work:\nb := TRUE;\nEND_ACTION\n\n"
              "ACTION Init_Action1:\nb := NOT b;\nEND_ACTION\n");
}

TEST_F(ChartImport, ConditionsAsReferencesVariablesAndContacts) {
    const auto with = [](const std::string& id, const std::string& condition, const char* from) {
        return "<transition localId=\"" + id + "\"><position x=\"0\" y=\"0\"/>" + in({from}) + "<condition>" +
               condition + "</condition></transition>";
    };
    const std::string named = "<transitions><transition name=\"Ready\"><body>" + st("Ready := a AND b;") +
                              "</body></transition></transitions>";
    EXPECT_EQ(chart(step("1", "S1", {}, "initialStep=\"true\"") + with("2", "<reference name=\"Ready\"/>", "1") +
                        step("3", "S2", {"2"}) +
                        "<inVariable localId=\"4\"><position x=\"0\" y=\"0\"/><connectionPointOut/><expression>a OR "
                        "b</expression></inVariable>" +
                        with("5", "<connectionPointIn><connection refLocalId=\"4\"/></connectionPointIn>", "3") +
                        step("6", "S3", {"5"}) +
                        "<leftPowerRail localId=\"7\"><position x=\"0\" y=\"0\"/></leftPowerRail><contact "
                        "localId=\"8\"><position x=\"0\" y=\"0\"/>" +
                        in({"7"}) +
                        "<variable>a</variable></contact>"
                        "<contact localId=\"9\" negated=\"true\"><position x=\"0\" y=\"0\"/>" +
                        in({"8"}) + "<variable>b</variable></contact>" +
                        with("10", "<connectionPointIn><connection refLocalId=\"9\"/></connectionPointIn>", "6") +
                        jump("11", "S1", {"10"}),
                    bools({"a", "b"}), named),
              "INITIAL_STEP S1:\nEND_STEP\nTRANSITION FROM S1 TO S2 := a AND b; END_TRANSITION\nSTEP "
              "S2:\nEND_STEP\nTRANSITION FROM S2 TO S3 := a OR b; END_TRANSITION\nSTEP S3:\nEND_STEP\n"
              "TRANSITION FROM S3 TO S1 := a AND NOT b; END_TRANSITION\n");
}

TEST_F(ChartImport, BlocksThatConditionsAreDrawnWithAreCalledInEveryScan) {
    const auto input = [](const char* pin, const char* from) {
        return "<variable formalParameter=\"" + std::string(pin) + "\"><connectionPointIn><connection refLocalId=\"" +
               from + "\"/></connectionPointIn></variable>";
    };
    const std::string timer =
        "<inVariable localId=\"7\"><position x=\"0\" "
        "y=\"0\"/><connectionPointOut/><expression>a</expression></inVariable>"
        "<inVariable localId=\"8\"><position x=\"0\" y=\"0\"/><connectionPointOut/><expression>T#30ms</expression>"
        "</inVariable><block localId=\"9\" typeName=\"TON\" instanceName=\"t\"><position x=\"0\" y=\"0\"/>"
        "<inputVariables>" +
        input("IN", "7") + input("PT", "8") +
        "</inputVariables><inOutVariables/><outputVariables><variable formalParameter=\"Q\"><connectionPointOut/>"
        "</variable></outputVariables></block>";
    const std::string drawn = "<transition localId=\"2\"><position x=\"0\" y=\"0\"/>" + in({"1"}) +
                              "<condition><connectionPointIn><connection refLocalId=\"9\" formalParameter=\"Q\"/>"
                              "</connectionPointIn></condition></transition>";
    EXPECT_EQ(
        chart(step("1", "Init", {}, "initialStep=\"true\"") + drawn + step("3", "Run", {"2"}) +
                  transition("4", "NOT a", {"3"}) + jump("5", "Init", {"4"}) + timer,
              "<localVars><variable name=\"a\"><type><BOOL/></type></variable><variable name=\"CallBlocks\"><type>"
              "<BOOL/></type></variable><variable name=\"t\"><type><derived name=\"TON\"/></type></variable>"
              "</localVars>"),
        "INITIAL_STEP Init:\n    CallBlocks_(S);\nEND_STEP\nTRANSITION FROM Init TO Run := t.Q; END_TRANSITION\n"
        "STEP Run:\nEND_STEP\nTRANSITION FROM Run TO Init := NOT a; END_TRANSITION\n\n"
        "ACTION CallBlocks_:\nt(IN := a, PT := T#30ms);\nEND_ACTION\n");
    EXPECT_EQ(imported.report.losses(), 0u) << imported.report.toText();
    EXPECT_NE(imported.report.toText().find("the action CallBlocks_"), std::string::npos);
}

TEST_F(ChartImport, StepActionsOfCodesysBecomeAssociations) {
    const std::string data =
        "<addData><data name=\"http://www.3s-software.com/plcopenxml/sfc/element\" "
        "handleUnknown=\"implementation\"><attributes xmlns=\"\"><attribute guid=\"1\">Init</attribute>"
        "<attribute guid=\"2\">Init_entry</attribute><attribute guid=\"3\">Init_active</attribute><attribute "
        "guid=\"4\">Init_exit</attribute></attributes></data></addData>";
    std::string actions = "<actions>";
    for (const char* name : {"Init_entry", "Init_active", "Init_exit"})
        actions += "<action name=\"" + std::string(name) + "\"><body>" + st("a := TRUE;") + "</body></action>";
    const std::string text = chart("<step localId=\"1\" name=\"Init\" initialStep=\"true\"><position x=\"0\" "
                                   "y=\"0\"/><connectionPointOut formalParameter=\"sfc\"/>" +
                                       data + "</step>" + transition("2", "FALSE", {"1"}) + jump("3", "Init", {"2"}),
                                   bools({"a"}), actions + "</actions>");
    EXPECT_TRUE(text.starts_with(
        "INITIAL_STEP Init:\n    Init_entry(P1);\n    Init_active(N);\n    Init_exit(P0);\nEND_STEP\n"))
        << text;
}

TEST_F(ChartImport, WhatLeadsNowhereHasALine) {
    imported = import(document(pou("Main", "program", bools({"a"}),
                                   "<SFC>" + step("1", "Init", {}, "initialStep=\"true\"") +
                                       transition("2", "a", {"1"}) + jump("3", "Gone", {"2"}) + "</SFC>")));
    EXPECT_EQ(imported.report.losses(), 2u) << imported.report.toText();
}

} // namespace
} // namespace plc::exchange
