// CASE: labels, their overlaps, the values of an enumeration that have no branch.
#include "runtime/compiler/sema/statements/case_statement.h"

#include "runtime/compiler/sema/context.h"
#include "runtime/compiler/sema/statements/statements.h"
#include "runtime/compiler/sema/types/conversions.h"
#include "runtime/compiler/sema/values/expressions.h"

#include "runtime/base/text.h"

#include <map>

namespace plc::sema {
static void refuseSelector(Context& context, const syntax::Stmt& stmt, TypeId type);

namespace {
/// The values that have a branch, joined where they touch. Unsigned ones are kept moved by half the range, so that
/// their order is that of signed numbers.
class TakenValues {
public:
    explicit TakenValues(bool isUnsigned) : m_moved(isUnsigned ? INT64_MIN : 0) {}
    /// False: some of them are taken already.
    bool add(int64_t low, int64_t high) {
        low ^= m_moved;
        high ^= m_moved;
        auto at = m_highs.upper_bound(low);
        if (at != m_highs.begin() && std::prev(at)->second >= low) --at;
        bool isFree = true;
        for (; at != m_highs.end() && at->first <= high; at = m_highs.erase(at)) {
            isFree = false;
            low = std::min(low, at->first);
            high = std::max(high, at->second);
        }
        m_highs.emplace(low, high);
        return isFree;
    }
    [[nodiscard]] bool contains(int64_t value) const {
        const auto next = m_highs.upper_bound(value ^ m_moved);
        return next != m_highs.begin() && std::prev(next)->second >= (value ^ m_moved);
    }

private:
    int64_t m_moved;
    std::map<int64_t, int64_t> m_highs; // by low
};
} // namespace

/// CASE by a text or a REAL: told, with the same written as IF … ELSIF where the places are clear.
///   wrong: CASE s OF 'a': … END_CASE  with s : STRING (P2041)
void refuseSelector(Context& context, const syntax::Stmt& stmt, TypeId type) {
    auto& diagnostic = context.emit(stmt.value->range, findings::CaseSelector(context.nameOf(type)));
    const FileId file = stmt.range.file;
    if (!file.isValid() || stmt.origin || stmt.arms.empty()) return;
    const std::string selector = context.textOf(stmt.value->range);
    const std::string_view whole = context.world.textOf(stmt.range);
    std::vector<diagnostics::TextEdit> edits;
    uint32_t from = stmt.range.begin;
    for (const syntax::CaseArm& arm : stmt.arms) {
        std::string condition;
        uint32_t end = 0;
        for (const syntax::CaseLabel& label : arm.labels) {
            if (!label.low || !label.low->range.file.isValid()) return;
            const std::string low = context.textOf(label.low->range);
            condition +=
                (condition.empty() ? "" : " OR ") +
                (label.high ? selector + " >= " + low + " AND " + selector + " <= " + context.textOf(label.high->range)
                            : selector + " = " + low);
            end = label.high ? label.high->range.end : label.low->range.end;
            if (&arm != &stmt.arms.front() && &label == &arm.labels.front()) from = label.low->range.begin;
        }
        if (arm.labels.empty() || end < from) return;
        while (end - stmt.range.begin < whole.size() && whole[end - stmt.range.begin] != ':') ++end;
        if (end - stmt.range.begin >= whole.size()) return;
        edits.push_back({{file, from, end + 1}, (edits.empty() ? "IF " : "ELSIF ") + condition + " THEN"});
    }
    const size_t last = foldCase(whole).rfind("end_case");
    if (last == std::string::npos) return;
    const uint32_t at = stmt.range.begin + static_cast<uint32_t>(last);
    edits.push_back({{file, at, at + 8}, "END_IF"});
    diagnostic.fixes.push_back({fixes::WriteIfAndElsif(), std::move(edits)});
}

/// CASE (edition 3, 7.3.3.3.3): its labels are constants, each once.
///   ok:    CASE x OF 1..3: … 4: … END_CASE
///   wrong: CASE x OF 1..3: … 2: … END_CASE  (P3010)   CASE x OF y: …  (P2019)   CASE x OF 3..1: …  (P3027)
///   advice: CASE color OF Red: … END_CASE  where Green is left over (P3009)
void caseStatement(Context& context, const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out) {
    if (!stmt.value) return;
    Operand selector = settled(context, expression(context, *stmt.value));
    const bool known = !selector.isUnknown();
    const types::Family family = known ? context.types.family(selector.type()) : types::Family::Other;
    const TypeId type = known ? selector.type() : context.elementary(TypeKind::Unknown);
    const bool isText = known && context.types.isText(type);
    if (known && !types::isInteger(family) && family != types::Family::Bool && family != types::Family::Character)
        refuseSelector(context, stmt, type);
    const bool good = known && !isText &&
                      (types::isInteger(family) || family == types::Family::Bool || family == types::Family::Character);
    const bool isBig = good && context.types.storageKind(type) != TypeKind::Lint &&
                       types::bitsOf(context.types.storageKind(type)) == 64;
    tree::Stmt* made =
        newStmt(context, tree::StmtKind::Case,
                stmt.range.file.isValid()
                    ? SourceRange{stmt.range.file, stmt.range.begin, std::max(stmt.range.begin, stmt.value->range.end)}
                    : stmt.range);
    if (good)
        made->a = convertNode(context, selector, context.elementary(isBig ? TypeKind::Ulint : TypeKind::Lint)).expr;
    made->operandType = context.elementary(isBig ? TypeKind::Ulint : TypeKind::Lint);
    const Flow before = context.flow;
    Flow joined{false, true};
    const auto join = [&] {
        if (context.flow.isReachable) joined.isResultSet = joined.isResultSet && context.flow.isResultSet;
        joined.isReachable = joined.isReachable || context.flow.isReachable;
    };
    TakenValues seen(isBig);
    const auto label = [&](const syntax::Expr* e) -> std::optional<int64_t> {
        if (!e) return std::nullopt;
        Operand value = expression(context, *e, type);
        if (value.isUnknown()) return std::nullopt;
        if (!value.isConstant()) {
            context.emit(e->range, findings::NotConstant());
            return std::nullopt;
        }
        if (good && context.isKind(value.type(), TypeKind::Enum) && !context.isKind(type, TypeKind::Enum))
            value = convertNode(context, value, context.types.storage(value.type()));
        if (good) {
            const types::Value& constantValue = value.expr->value;
            const bool fitsAnyway =
                isNumeric(context, value.type()) && std::holds_alternative<int64_t>(constantValue.data) &&
                (fits(context, constantValue, context.types.storage(type)) || context.isKind(type, TypeKind::Enum));
            if (!fitsAnyway) value = converted(context, value, type);
        }
        if (value.isUnknown() || !std::holds_alternative<int64_t>(value.expr->value.data)) return std::nullopt;
        return value.expr->value.integer();
    };
    for (const syntax::CaseArm& arm : stmt.arms) {
        tree::CaseArm& madeArm = made->arms.emplace_back();
        for (const syntax::CaseLabel& each : arm.labels) {
            const auto low = label(each.low);
            const auto high = each.high ? label(each.high) : low;
            if (!low || !high) continue;
            const auto less = [&](int64_t a, int64_t b) {
                return isBig ? static_cast<uint64_t>(a) < static_cast<uint64_t>(b) : a < b;
            };
            const SourceRange range =
                each.high ? SourceRange{each.low->range.file, each.low->range.begin, each.high->range.end}
                          : each.low->range;
            if (less(*high, *low)) {
                context.emit(range, findings::ArraySizeInvalid(*low, *high));
                continue;
            }
            if (!seen.add(*low, *high)) context.emit(range, findings::DuplicateCase(context.textOf(range)));
            madeArm.ranges.push_back({*low, *high});
        }
        context.flow = before;
        statements(context, arm.body, madeArm.body);
        join();
    }
    bool complete = stmt.hasElse;
    if (stmt.hasElse) {
        context.flow = before;
        statements(context, stmt.elseBody, made->elseBody);
        join();
    } else if (good && context.isKind(type, TypeKind::Enum)) {
        std::vector<std::string> missing;
        size_t count = 0;
        std::vector<std::string> names;
        for (const types::Enumerator& enumerator : context.types[type].enumerators) {
            if (seen.contains(enumerator.value)) continue;
            if (++count <= 3) missing.push_back(enumerator.name);
            names.push_back(enumerator.name);
        }
        if (count > 3) missing.push_back("…");
        if (count && stmt.range.file.isValid() && !stmt.origin) {
            const SourceRange word{stmt.range.file, stmt.range.begin, stmt.range.begin + 4};
            auto& diagnostic = context.emit(word, findings::MissingCase(missing));
            std::string text;
            for (const std::string& name : names) text += context.nameOf(type) + "." + name + ": ;\n";
            const std::string_view whole = context.world.textOf(stmt.range);
            size_t at = whole.size();
            for (size_t i = 0; i + 8 <= whole.size(); ++i) {
                const std::string_view part = whole.substr(i, 8);
                if (std::equal(part.begin(), part.end(), "END_CASE",
                               [](char a, char b) { return (a >= 'a' && a <= 'z' ? a - 32 : a) == b; }))
                    at = i;
            }
            if (at < whole.size()) {
                const auto place = stmt.range.begin + static_cast<uint32_t>(at);
                diagnostic.fixes.push_back({fixes::AddMissingBranches(), {{{stmt.range.file, place, place}, text}}});
                diagnostic.fixes.push_back({fixes::AddElse(), {{{stmt.range.file, place, place}, "ELSE\n    ;\n"}}});
            }
        }
        complete = count == 0 && !context.types[type].enumerators.empty();
    }
    if (!complete) {
        context.flow = before;
        join();
    }
    context.flow = joined;
    if (!before.isReachable) context.flow.isReachable = false;
    if (good) out.push_back(made);
}

} // namespace plc::sema
