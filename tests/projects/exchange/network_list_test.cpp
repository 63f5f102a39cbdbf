// LD and FBD of TwinCAT: the archive of networks becomes a diagram of PLCopen and its text.
#include "fixture.h"

#include "projects/exchange/plcopen/plcopen_export.h"
#include "projects/storage/project_file.h"

namespace plc::exchange {
namespace {

std::string value(const std::string& name, const std::string& text) { return "<v n=\"" + name + "\">" + text + "</v>"; }
std::string text(const std::string& name, const std::string& text) { return value(name, "\"" + text + "\""); }
std::string flags(int bits) {
    return "<o n=\"Flags\" t=\"Flags\">" + value("Flags", std::to_string(bits)) + value("Fixed", "false") + "</o>";
}
std::string operandMembers(const std::string& name, int bits) {
    return text("Operand", name) + text("Type", "BOOL") + flags(bits) + value("LValue", "false");
}
/// A contact or variable: bits 1 negated, 16 rising, 32 falling.
std::string operand(const std::string& name, int bits = 0) {
    return "<o t=\"BoxTreeOperand\"><o n=\"Operand\" t=\"Operand\">" + operandMembers(name, bits) + "</o></o>";
}
/// `member` makes it the member of that name of the object around it.
std::string as(const std::string& member, std::string object) { return object.insert(2, " n=\"" + member + "\""); }
std::string names(const std::string& list, const std::vector<std::string>& all) {
    std::string out = "<o n=\"" + list + "\" t=\"ParamList\"><l2 n=\"Names\" cet=\"String\">";
    for (const std::string& each : all) out += "<v>" + each + "</v>";
    return out + "</l2></o>";
}
/// Targets: name and bits (1 negated, 2 set, 4 jump, 8 return); "" writes none.
std::string targets(const std::vector<std::pair<std::string, int>>& all) {
    std::string out = "<o n=\"OutputItems\" t=\"OutputItemList\"><l2 n=\"OutputItems\" cet=\"Operand\">";
    for (const auto& [name, bits] : all)
        out += name.empty() ? std::string("<n />") : "<o>" + operandMembers(name, bits) + "</o>";
    return out + "</l2></o>";
}
std::string box(const std::string& type, const std::string& instance, const std::vector<std::string>& inputs,
                const std::vector<std::string>& inputNames = {}, const std::vector<std::string>& outputNames = {},
                const std::vector<std::pair<std::string, int>>& outputs = {}) {
    std::string out = "<o t=\"BoxTreeBox\">" + text("BoxType", type) + "<o n=\"Instance\" t=\"Operand\">" +
                      (instance.empty() ? "<n n=\"Operand\" />" : text("Operand", instance)) + "</o>" +
                      targets(outputs) + names("InputParam", inputNames) + names("OutputParam", outputNames) +
                      "<n n=\"InputFlags\" /><l2 n=\"InputItems\">";
    for (const std::string& each : inputs) out += each;
    return out + "</l2></o>";
}
std::string assign(const std::string& from, const std::vector<std::pair<std::string, int>>& to) {
    return "<o t=\"BoxTreeAssign\">" + targets(to) + flags(0) + (from.empty() ? "" : as("RValue", from)) + "</o>";
}
std::string network(const std::string& items, const std::string& more = {}) {
    return "<o>" + more + "<l2 n=\"NetworkItems\">" + items + "</l2></o>";
}

class NetworkLists : public ExchangeTest {
protected:
    Imported importNetworks(const std::string& variables, const std::string& networks, const char* mode = "Ld",
                            const std::string& more = {}) {
        auto imported = importFrom(
            write("MAIN.TcPOU",
                  "<?xml version=\"1.0\" encoding=\"utf-8\"?><TcPlcObject Version=\"1.1.0.1\"><POU Name=\"MAIN\">"
                  "<Declaration><![CDATA[PROGRAM MAIN\nVAR\n" +
                      variables +
                      "END_VAR\n]]></Declaration><Implementation><NWL><XmlArchive><Data><o xml:space=\"preserve\" "
                      "t=\"NWLImplementationObject\">" +
                      text("DefaultViewMode", mode) + "<l2 n=\"NetworkList\" cet=\"Network\">" + networks +
                      "</l2></o></Data></XmlArchive></NWL></Implementation>" + more + "</POU></TcPlcObject>"));
        EXPECT_TRUE(imported) << imported.error().english();
        return imported ? std::move(*imported) : Imported();
    }
    static std::string bodyOf(const Imported& imported) {
        const std::string all = fileOf(imported, "src/MAIN.st");
        const size_t begin = all.rfind("END_VAR\n") + 8;
        return all.substr(begin, all.rfind("END_PROGRAM") - begin);
    }
};

TEST_F(NetworkLists, ContactsInSeriesAndParallelWithCoils) {
    const Imported imported = importNetworks(
        "a, b, c, y, z, s, r : BOOL;\n",
        network(assign(box("AND", "", {operand("a"), box("OR", "", {operand("b", 1), operand("c")})}), {{"y", 0}})) +
            network(assign(box("OR", "", {operand("a"), operand("b")}), {{"z", 1}})) +
            network(assign(operand("a"), {{"s", 2}, {"r", 3}}), text("Title", "latch")));
    EXPECT_EQ(bodyOf(imported), "y := a AND (NOT b OR c);\nz := NOT (a OR b);\n// latch\ns S= a;\nr R= a;\n");
    EXPECT_EQ(imported.report.losses(), 0u);
    EXPECT_EQ(imported.report.bodies.at("LD"), 1);
    EXPECT_NE(fileOf(imported, "src/MAIN.st").find("{attribute 'view' := 'ladder'}"), std::string::npos);
    EXPECT_EQ(errorsOf(imported), "");
}

TEST_F(NetworkLists, AResultForSeveralCoilsIsComputedOnce) {
    const Imported imported = importNetworks(
        "a, b, y, z : BOOL;\n", network(assign(box("AND", "", {operand("a"), operand("b")}), {{"y", 0}, {"z", 1}})));
    const std::string body = bodyOf(imported);
    EXPECT_NE(body.find(" := a AND b;\ny := result_"), std::string::npos) << body;
    EXPECT_NE(body.find("z := NOT result_"), std::string::npos) << body;
    EXPECT_EQ(errorsOf(imported), "");
}

TEST_F(NetworkLists, BlocksAreCalledAndTheirOutputsRead) {
    const Imported imported = importNetworks("t : TON; start, y : BOOL; et : TIME; n : INT; edge : BOOL;\n",
                                             network(assign(box("TON", "t", {operand("start", 16), operand("T#2s")},
                                                                {"IN", "PT"}, {"Q", "ET"}, {{"", 0}, {"et", 0}}),
                                                            {{"y", 0}})) +
                                                 network(box("ADD", "", {operand("y"), operand("n"), operand("1")},
                                                             {"EN", "", ""}, {"ENO", ""}, {{"", 0}, {"n", 0}})),
                                             "Fbd");
    const std::string body = bodyOf(imported);
    EXPECT_NE(body.find("edge_"), std::string::npos);
    EXPECT_NE(body.find("t(IN := edge_"), std::string::npos);
    EXPECT_NE(body.find("y := t.Q;"), std::string::npos);
    EXPECT_NE(body.find("et := t.ET;"), std::string::npos);
    EXPECT_NE(body.find("IF y THEN\n    n := n + 1;\nEND_IF;"), std::string::npos) << body;
    EXPECT_NE(fileOf(imported, "src/MAIN.st").find("{attribute 'view' := 'fbd'}"), std::string::npos);
    EXPECT_EQ(errorsOf(imported), "");
}

TEST_F(NetworkLists, WiresThatBranchJumpsAndLabels) {
    const std::string wire = "<o t=\"BoxTreeDemux\">" + value("VarId", "7");
    const Imported imported =
        importNetworks("a, b, y, z : BOOL;\n",
                       network(wire + as("Input", box("AND", "", {operand("a"), operand("b")})) + "</o>" +
                               assign(wire + "</o>", {{"y", 0}}) +
                               assign(box("AND", "", {wire + "</o>", operand("z", 1)}), {{"z", 0}})) +
                           network(assign(operand("a"), {{"finish", 4}})) + network(assign("", {{"RETURN", 8}})) +
                           network(assign(operand("b"), {{"y", 0}}), text("Label", "finish")));
    const std::string body = bodyOf(imported);
    EXPECT_NE(body.find(" := a AND b;\ny := result_"), std::string::npos) << body;
    EXPECT_NE(body.find(" AND NOT z;\nIF a THEN\n    JMP finish;\nEND_IF;\nRETURN;\nfinish:\ny := b;\n"),
              std::string::npos)
        << body;
    EXPECT_EQ(errorsOf(imported), "");
}

TEST_F(NetworkLists, ParallelBranchesBesideABlock) {
    const std::string parallel = "<o t=\"BoxTreeParallel\">" + as("Input", operand("a")) + text("Mode", "Or") +
                                 "<l2 n=\"Trees\">" + operand("b") + operand("c", 1) + "</l2></o>";
    const Imported imported = importNetworks("a, b, c, y : BOOL;\n", network(assign(parallel, {{"y", 0}})));
    EXPECT_EQ(bodyOf(imported), "y := a AND (b OR NOT c);\n");
}

TEST_F(NetworkLists, WhatIsCommentedOutOrUnknownHasALineInTheReport) {
    const Imported imported =
        importNetworks("a, y : BOOL;\n",
                       network(assign(operand("a"), {{"y", 0}}), text("Title", "old") + value("OutCommented", "true")) +
                           network("<o t=\"BoxTreeNovel\"></o>"));
    EXPECT_EQ(bodyOf(imported).find("y :="), std::string::npos);
    const std::string report = imported.report.toText();
    EXPECT_NE(report.find("'old' is commented out"), std::string::npos) << report;
    EXPECT_NE(report.find("BoxTreeNovel"), std::string::npos) << report;
    EXPECT_EQ(imported.report.losses(), 1u);
}

TEST_F(NetworkLists, ActionsDeclareTheirVariablesInTheUnit) {
    const Imported imported = importNetworks(
        "a, y : BOOL;\n", network(assign(operand("a"), {{"y", 0}})), "Ld",
        "<Action Name=\"Blink\"><Implementation><NWL><XmlArchive><Data><o t=\"NWLImplementationObject\">" +
            text("DefaultViewMode", "Ld") + "<l2 n=\"NetworkList\" cet=\"Network\">" +
            network(assign(operand("a", 32), {{"y", 0}})) +
            "</l2></o></Data></XmlArchive></NWL></Implementation></Action>");
    const std::string all = fileOf(imported, "src/MAIN.st");
    EXPECT_NE(all.find(" : F_TRIG;\nEND_VAR"), std::string::npos) << all;
    EXPECT_NE(all.find("ACTION Blink:\nBlink_edge_"), std::string::npos) << all;
    EXPECT_EQ(errorsOf(imported), "");
}

TEST_F(NetworkLists, GoOutAsADiagram) {
    const Imported imported = importNetworks(
        "a, b, y : BOOL;\n", network(assign(box("AND", "", {operand("a"), operand("b", 1)}), {{"y", 0}})));
    ASSERT_TRUE(writeImported(imported, path("out")));
    const auto project = projects::openProject({path("out")});
    ASSERT_TRUE(project) << project.error().english();
    const auto exported = exportPlcopen(*project, {});
    ASSERT_TRUE(exported) << exported.error().english();
    EXPECT_NE(exported->text.find("<LD>"), std::string::npos);
    EXPECT_NE(exported->text.find("typeName=\"AND\""), std::string::npos);
    const Imported again = import(exported->text);
    EXPECT_EQ(bodyOf(again), bodyOf(imported));
}

} // namespace
} // namespace plc::exchange
