#include "projects/analysis/instruction_lists.h"

#include "runtime/base/text.h"
#include "runtime/compiler/lower/print.h"
#include "runtime/compiler/parse/parser.h"

#include <algorithm>
#include <functional>

namespace plc::analysis {

namespace {

using syntax::Block;
using syntax::BodyLanguage;
using Visit = std::function<void(const Block&)>;

/// Every list of a body: its own (before or after lowering), and those of transitions and actions in its chart.
void listsOf(const syntax::Body& body, const Visit& visit) {
    if (body.language == BodyLanguage::Il) visit(body.instructions.empty() ? body.statements : body.instructions);
    if (!body.chart) return;
    for (const syntax::TransitionDecl* transition : body.chart->transitions) visit(transition->ilCondition);
    for (const syntax::ActionDecl* action : body.chart->actions) listsOf(action->body, visit);
}

void listsOf(const syntax::Pou& pou, const Visit& visit) {
    listsOf(pou.body, visit);
    for (const syntax::ActionDecl* action : pou.actions) {
        const auto* chart = pou.body.chart; // lowering adds a chart's actions to the unit's
        if (!chart || std::find(chart->actions.begin(), chart->actions.end(), action) == chart->actions.end())
            listsOf(action->body, visit);
    }
    for (const syntax::Pou* method : pou.methods) listsOf(*method, visit);
    for (const syntax::Property* property : pou.properties)
        for (const syntax::Pou* accessor : {property->get, property->set})
            if (accessor) listsOf(*accessor, visit);
}

void listsOf(const std::vector<syntax::Decl*>& declarations, const Visit& visit) {
    for (const syntax::Decl* decl : declarations) {
        if (decl->pou) listsOf(*decl->pou, visit);
        if (decl->space) listsOf(decl->space->declarations, visit);
    }
}

void eachInstruction(const Block& list, const std::function<void(const syntax::Stmt&)>& visit) {
    for (const syntax::Stmt* stmt : list) {
        if (!stmt->il) continue;
        visit(*stmt);
        eachInstruction(stmt->il->body, visit);
        for (const syntax::Argument& argument : stmt->il->arguments)
            if (argument.instructions) eachInstruction(*argument.instructions, visit);
    }
}

constexpr std::string_view kInputs[] = {"S1", "R1", "CLK", "CU", "CD", "PV", "IN", "PT", "LOAD"};

} // namespace

std::vector<AccumulatorPlace> accumulatorPlaces(const syntax::SyntaxFile& file) {
    std::vector<AccumulatorPlace> out;
    listsOf(file.declarations, [&](const Block& list) {
        eachInstruction(list, [&](const syntax::Stmt& stmt) {
            if (!stmt.il->result || !stmt.il->op.isValid()) return;
            // Of "AND( … )" the result is there when the parenthesis closes.
            const uint32_t at = stmt.il->opensParenthesis && stmt.range.end > stmt.range.begin
                                    ? stmt.range.end - 1
                                    : stmt.il->op.range.begin;
            out.push_back({at, lower::print(*stmt.il->result)});
        });
    });
    std::stable_sort(out.begin(), out.end(),
                     [](const AccumulatorPlace& a, const AccumulatorPlace& b) { return a.at < b.at; });
    return out;
}

std::vector<uint32_t> operatorPlaces(const syntax::SyntaxFile& file) {
    std::vector<uint32_t> out;
    listsOf(file.declarations, [&](const Block& list) {
        eachInstruction(list, [&](const syntax::Stmt& stmt) {
            const syntax::IlInstruction& il = *stmt.il;
            const std::string word = std::string(il.op.text) + (il.conditional ? "C" : "") + (il.negate ? "N" : "");
            if (il.op.isValid() && isListOperator(word)) out.push_back(il.op.range.begin);
        });
    });
    std::sort(out.begin(), out.end());
    return out;
}

const std::vector<ListOperator>& listOperators() {
    static const std::vector<ListOperator> all = {
        {"LD", "the operand becomes the current result"},
        {"LDN", "the negated operand becomes the current result"},
        {"ST", "stores the current result"},
        {"STN", "stores the negated current result"},
        {"S", "sets the operand when the current result is TRUE"},
        {"R", "resets the operand when the current result is TRUE"},
        {"AND", "and"},
        {"ANDN", "and, with the operand negated"},
        {"AND(", "and, with what follows up to )"},
        {"ANDN(", "and, with what follows up to ) negated"},
        {"OR", "or"},
        {"ORN", "or, with the operand negated"},
        {"OR(", "or, with what follows up to )"},
        {"ORN(", "or, with what follows up to ) negated"},
        {"XOR", "exclusive or"},
        {"XORN", "exclusive or, with the operand negated"},
        {"XOR(", "exclusive or, with what follows up to )"},
        {"XORN(", "exclusive or, with what follows up to ) negated"},
        {"NOT", "negates the current result"},
        {"ADD", "adds"},
        {"ADD(", "adds what follows up to )"},
        {"SUB", "subtracts"},
        {"SUB(", "subtracts what follows up to )"},
        {"MUL", "multiplies"},
        {"MUL(", "multiplies with what follows up to )"},
        {"DIV", "divides"},
        {"DIV(", "divides by what follows up to )"},
        {"MOD", "remainder of the division"},
        {"MOD(", "remainder of the division by what follows up to )"},
        {"GT", "greater than"},
        {"GT(", "greater than what follows up to )"},
        {"GE", "greater or equal"},
        {"GE(", "greater than or equal to what follows up to )"},
        {"EQ", "equal"},
        {"EQ(", "equal to what follows up to )"},
        {"NE", "not equal"},
        {"NE(", "not equal to what follows up to )"},
        {"LE", "less or equal"},
        {"LE(", "less than or equal to what follows up to )"},
        {"LT", "less than"},
        {"LT(", "less than what follows up to )"},
        {"JMP", "goes on at a label"},
        {"JMPC", "goes on at a label when the current result is TRUE"},
        {"JMPCN", "goes on at a label when the current result is FALSE"},
        {"CAL", "calls an instance"},
        {"CALC", "calls an instance when the current result is TRUE"},
        {"CALCN", "calls an instance when the current result is FALSE"},
        {"RET", "ends the unit"},
        {"RETC", "ends the unit when the current result is TRUE"},
        {"RETCN", "ends the unit when the current result is FALSE"},
        {"S1", "input of an SR instance"},
        {"R1", "input of an RS instance"},
        {"CLK", "input of an R_TRIG or F_TRIG instance"},
        {"CU", "input of a CTU or CTUD instance"},
        {"CD", "input of a CTD or CTUD instance"},
        {"PV", "input of a counter instance"},
        {"IN", "input of a TP, TON or TOF instance"},
        {"PT", "input of a TP, TON or TOF instance"},
    };
    return all;
}

bool isListOperator(std::string_view word) {
    const auto& all = listOperators();
    return std::any_of(all.begin(), all.end(),
                       [&](const ListOperator& op) { return equalsIgnoringCase(op.name, word); });
}

std::optional<ListContext> listContextAt(std::string_view text, uint32_t wordBegin) {
    diagnostics::Sink sink;
    const auto file = parse::parseFile(FileId(size_t(0)), text, sink);
    const Block* found = nullptr;
    uint32_t nearest = 0;
    listsOf(file->declarations,
            [&](const Block& list) { // the list that began last before the place and is still open there
                if (list.empty() || list.front()->range.begin > wordBegin || list.front()->range.begin < nearest)
                    return;
                const std::string between =
                    foldCase(text.substr(list.back()->range.end,
                                         wordBegin > list.back()->range.end ? wordBegin - list.back()->range.end : 0));
                if (between.find("end_") != std::string::npos) return;
                nearest = list.front()->range.begin;
                found = &list;
            });
    if (!found) return std::nullopt;
    ListContext context;
    eachInstruction(*found, [&](const syntax::Stmt& stmt) {
        if (stmt.il->label.isValid()) context.labels.emplace_back(stmt.il->label.text);
    });
    // the line's words up to the place, without a label
    uint32_t begin = wordBegin;
    while (begin > 0 && text[begin - 1] != '\n') --begin;
    std::string_view line = text.substr(begin, wordBegin - begin);
    if (const size_t colon = line.find(':'); colon != std::string_view::npos &&
                                             (colon + 1 >= line.size() || line[colon + 1] != '=') &&
                                             line.find('(') > colon)
        line.remove_prefix(colon + 1);
    const size_t from = line.find_first_not_of(" \t");
    if (from == std::string_view::npos) return context;
    line.remove_prefix(from);
    const std::string word = foldCase(line.substr(0, line.find_first_of(" \t(")));
    const bool bracket = line.find('(') != std::string_view::npos;
    context.place = ListPlace::Operand;
    if (word.starts_with("jmp"))
        context.place = ListPlace::Label;
    else if (word.starts_with("cal") && !bracket)
        context.place = ListPlace::Instance;
    else if (!bracket && std::any_of(std::begin(kInputs), std::end(kInputs),
                                     [&](std::string_view input) { return equalsIgnoringCase(input, word); }))
        context.place = ListPlace::Instance;
    return context;
}

} // namespace plc::analysis
