// Coils: their kind, one more, one less.
#include "runtime/base/chars.h"
#include "runtime/base/messages.h"
#include "runtime/base/text.h"
#include "runtime/compiler/ladder/edits.h"
#include "runtime/compiler/ladder/projector.h"

#include <algorithm>

namespace plc::ladder {

using syntax::Expr;
using syntax::ExprKind;
using syntax::Stmt;
using syntax::StmtKind;

namespace {

/// Whether `name` is one of the words of `text`.
bool namesIn(const std::string& text, const std::string& name) {
    const std::string folded = foldCase(text), wanted = foldCase(name);
    for (size_t at = folded.find(wanted); at != std::string::npos && !wanted.empty();
         at = folded.find(wanted, at + 1)) {
        const size_t end = at + wanted.size();
        if ((at == 0 || !isNameByte(folded[at - 1])) && (end == folded.size() || !isNameByte(folded[end]))) return true;
    }
    return false;
}

} // namespace

/// IF e THEN y := TRUE; END_IF
Result<Edits> LadderEditor::setConditionalCoil(const Rung& rung, const Node& node, CoilKind kind) const {
    if (kind == CoilKind::Set || kind == CoilKind::Reset)
        return finish({{node.stmt->value->range, kind == CoilKind::Set ? "TRUE" : "FALSE"}});
    for (const Stmt* stmt : rung.statements) {
        if (stmt->kind != StmtKind::If || stmt->branches[0].body.front() != node.stmt) continue;
        if (stmt->branches[0].body.size() > 1) break;
        const std::string condition = slice(stmt->branches[0].condition->range);
        return finish({{stmt->range, slice(node.stmt->target->range) + " := " +
                                         (kind == CoilKind::Negated ? "NOT (" + condition + ")" : condition) + ";"}});
    }
    return Error{errors::OutputsShareIf(), {}};
}

Result<Edits> LadderEditor::setCoil(NodeId id, CoilKind kind) const {
    const Node& node = m_diagram[id];
    if (node.kind != NodeKind::Coil) return Error{errors::SelectCoil(), {}};
    if (node.coil == kind) return Edits{};
    if (node.isConditional) return setConditionalCoil(m_diagram[rungOf(id)], node, kind);
    const Stmt& stmt = *node.stmt;
    if (stmt.value->kind == ExprKind::AssignChain) return Error{errors::SeveralAssigned(), {}};
    Edits edits;
    const Expr& value = *stmt.value;
    if (node.coil == CoilKind::Negated) { // NOT (e) becomes e
        const SourceRange inner = innerRange(*value.base, m_text);
        edits.push_back({{inner.file, value.range.begin, inner.begin}, {}});
        edits.push_back({{inner.file, inner.end, value.range.end}, {}});
    } else if (kind == CoilKind::Negated && value.parenthesised) {
        edits.push_back({{value.range.file, value.range.begin, value.range.begin}, "NOT "});
    } else if (kind == CoilKind::Negated) {
        edits.push_back({{value.range.file, value.range.begin, value.range.begin}, "NOT ("});
        edits.push_back({{value.range.file, value.range.end, value.range.end}, ")"});
    }
    const std::string_view wanted = kind == CoilKind::Set ? "S=" : kind == CoilKind::Reset ? "R=" : ":=";
    // the operator, wherever comments stand between target and value
    for (const lex::Token& token : m_file.tokens.tokens) {
        if (token.begin < stmt.target->range.end) continue;
        if (token.begin >= value.range.begin) break;
        if (token.kind != stmt.op) continue;
        if (m_text.substr(token.begin, token.end - token.begin) != wanted)
            edits.push_back({{stmt.range.file, token.begin, token.end}, std::string(wanted)});
    }
    return finish(std::move(edits));
}

std::string LadderEditor::powerText(RungId id) const {
    const Rung& rung = m_diagram[id];
    const Stmt* first = firstWithPower(rung);
    if (!first) return "TRUE";
    std::vector<const Expr*> parts;
    andParts(*powerOf(*first), parts);
    size_t shared = parts.size();
    if (rung.branches.size() > 1 && rung.power.isValid()) {
        const Node& power = m_diagram[rung.power];
        shared = power.kind == NodeKind::Series ? std::min(shared, power.children.size()) : 1;
        if (power.kind == NodeKind::Series && power.expr == powerOf(*first)) shared = parts.size();
    }
    if (shared == parts.size()) return unparenthesised(slice(powerOf(*first)->range));
    std::string out;
    for (size_t i = 0; i < shared; ++i) out += (i ? " AND " : "") + slice(parts[i]->range);
    return out;
}

/// Whether an output changes a variable that `power` names.
bool LadderEditor::writesItsPower(const Rung& rung, const std::string& power) const {
    const auto root = [](const std::string& place) { return place.substr(0, place.find_first_of(".[^ ")); };
    for (const Branch& branch : rung.branches) {
        const Node& node = m_diagram[branch.output];
        if (node.kind == NodeKind::Coil && namesIn(power, root(node.label))) return true;
        for (const OutputPin& pin : node.outputs)
            if (namesIn(power, root(pin.target))) return true;
    }
    return false;
}

Result<Edits> LadderEditor::addCoil(RungId id, std::string_view target) const {
    const auto operand = parsed(target);
    if (!operand) return operand.error();
    if (!operand->isPlace) return Error{errors::CoilWritesVariable(), {}};
    const Rung& rung = m_diagram[id];
    if (rung.kind != RungKind::Logic || rung.statements.empty()) return Error{errors::SelectRungWithContacts(), {}};
    std::string power = powerText(id);
    // What the rung writes may be what its contacts read: then the new coil follows the first one.
    if (writesItsPower(rung, power)) {
        const Branch& first = rung.branches.front();
        const Node& output = m_diagram[first.output];
        if (first.tail.isValid() || output.kind != NodeKind::Coil || output.coil != CoilKind::Normal)
            return Error{errors::RungReadsWhatItWrites(), {}};
        for (size_t i = 1; i < rung.branches.size(); ++i) // it has to have the power still
            if (equalsIgnoringCase(m_diagram[rung.branches[i].output].label, output.label))
                return Error{errors::RungReadsWhatItWrites(), {}};
        power = output.label;
    }
    const Stmt& last = *rung.statements.back();
    return finish(
        {{{last.range.file, last.range.end, last.range.end},
          lineEnd() + indentOf(rung.statements.front()->range.begin) + operand->text + " := " + power + ";"}});
}

Result<Edits> LadderEditor::removeOutput(NodeId id) const {
    const RungId rungId = rungOf(id);
    const Rung& rung = m_diagram[rungId];
    if (rung.branches.size() == 1) return removeRung(rungId);
    const Node& node = m_diagram[id];
    if (!node.stmt) return Error{errors::DeleteOutputInText(), {}};
    if (node.stmt->value && node.stmt->value->kind == ExprKind::AssignChain)
        return Error{errors::SeveralAssigned(), {}};
    // the only output of an IF takes the IF with it
    for (const Stmt* stmt : rung.statements)
        if (stmt->kind == StmtKind::If && stmt->branches[0].body.size() == 1 &&
            stmt->branches[0].body.front() == node.stmt)
            return finish({{statementLines(stmt->range), {}}});
    return finish({{statementLines(node.stmt->range), {}}});
}

} // namespace plc::ladder
