// A contact taken from one place and put into another: its removal, then its insertion into the text that leaves, told
// as edits of the text as it is.
#include "runtime/base/messages.h"
#include "runtime/compiler/ladder/edits.h"
#include "runtime/compiler/ladder/projector.h"
#include "runtime/compiler/parse/parser.h"

#include <algorithm>

namespace plc::ladder {

namespace {

uint32_t sizeOf(const std::string& text) { return static_cast<uint32_t>(text.size()); }

/// Where a place of the text is once the edits were made; what they removed is where they were.
uint32_t placeAfter(const Edits& edits, uint32_t at) {
    int64_t shift = 0;
    for (const TextEdit& edit : edits) {
        if (edit.range.begin >= at) break;
        const uint32_t gone = std::min(at, edit.range.end) - edit.range.begin;
        shift += (edit.range.end <= at ? int64_t(edit.text.size()) : 0) - int64_t(gone);
    }
    return static_cast<uint32_t>(int64_t(at) + shift);
}

/// The one replacement that makes `after` of `before`.
Edits difference(std::string_view before, std::string_view after, FileId file) {
    size_t begin = 0, tail = 0;
    const size_t shorter = std::min(before.size(), after.size());
    while (begin < shorter && before[begin] == after[begin]) ++begin;
    while (tail < shorter - begin && before[before.size() - 1 - tail] == after[after.size() - 1 - tail]) ++tail;
    if (begin == before.size() && begin == after.size()) return {};
    return {{{file, static_cast<uint32_t>(begin), static_cast<uint32_t>(before.size() - tail)},
             std::string(after.substr(begin, after.size() - tail - begin))}};
}

/// `second` is of the text that `first` makes; none when one reaches into what the other wrote.
std::optional<Edits> together(const Edits& first, const Edits& second) {
    Edits all = first;
    for (const TextEdit& edit : second) {
        int64_t shift = 0; // of the text that `first` made against the text before
        bool touches = false;
        for (const TextEdit& made : first) {
            const auto begin = static_cast<uint32_t>(int64_t(made.range.begin) + shift);
            const uint32_t end = begin + sizeOf(made.text);
            if (edit.range.end < begin) break;
            touches |= edit.range.begin <= end;
            if (edit.range.begin > end) shift += int64_t(made.text.size()) - int64_t(made.range.length());
        }
        if (touches) return std::nullopt;
        all.push_back({{edit.range.file, static_cast<uint32_t>(int64_t(edit.range.begin) - shift),
                        static_cast<uint32_t>(int64_t(edit.range.end) - shift)},
                       edit.text});
    }
    return all;
}

} // namespace

/// Beside the same expressions as the picture shows it: once it is taken away, other statements may share that contact.
Result<Edits> LadderEditor::moveContact(NodeId node, NodeId beside, Place place) const {
    const RungId rung = rungOf(beside);
    if (!rung.isValid() || !m_diagram[beside].expr) return Error{errors::SelectContactOrWire(), {}};
    std::vector<SourceRange> places;
    for (const syntax::Expr* expr : sameIn(m_diagram[rung], beside)) places.push_back(expr->range);
    return moveWith(node, [&](const LadderEditor& left, const Edits& removed, const std::string& text) {
        std::vector<SourceRange> now = places;
        for (SourceRange& each : now)
            each = {each.file, placeAfter(removed, each.begin), placeAfter(removed, each.end)};
        return left.insertAt(now, place, text);
    });
}

Result<Edits> LadderEditor::moveContact(NodeId node, RungId rung) const {
    const NodeId power = m_diagram[rung].power;
    const bool isSeries = power.isValid() && m_diagram[power].kind == NodeKind::Series;
    const NodeId last = isSeries ? m_diagram[power].children.back() : power;
    if (last == node) return Edits();
    if (last.isValid() && m_diagram[last].expr && m_diagram[last].kind != NodeKind::Box)
        return moveContact(node, last, Place::After);
    return moveWith(node, [&](const LadderEditor& left, const Edits& removed, const std::string& text) {
        const RungId target = left.m_diagram.rungAt(placeAfter(removed, m_diagram[rung].range.begin));
        if (!target.isValid()) return Result<Edits>(Error{errors::SelectContactOrWire(), {}});
        return left.appendContact(target, text);
    });
}

Result<Edits> LadderEditor::moveWith(NodeId node, const Insert& insert) const {
    if (!m_diagram[node].expr) return Error{errors::SelectContactOrWire(), {}};
    const std::string operand = slice(innerRange(*m_diagram[node].expr, m_text));
    const Result<Edits> removed = remove(node);
    if (!removed) return removed.error();
    const std::string text = applyEdits(std::string(m_text), *removed);
    diagnostics::Sink sink;
    const auto file = parse::parseFile(m_unit.range.file, text, sink);
    Unit unit = findUnit(*file, m_unit.name);
    if (!unit.body) return Error{errors::EditInTextOnly(), {}};
    unit.pou = m_unit.pou; // the declarations are the same
    unit.owner = m_unit.owner;
    const Diagram diagram = project(text, *file, unit, m_types, m_diagram.form);
    const LadderEditor left(text, *file, unit, diagram, m_types);
    const Result<Edits> inserted = insert(left, *removed, operand);
    if (!inserted) return inserted.error();
    const std::string result = applyEdits(text, *inserted);
    if (const auto both = together(*removed, *inserted))
        if (auto edits = finish(*both); edits && applyEdits(std::string(m_text), *edits) == result) return edits;
    return difference(m_text, result, m_unit.range.file);
}

} // namespace plc::ladder
