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
        // Ranges that touch become one, so a CASE with thousands of labels in a row stays a short list.
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
    // No fix for statements that a lowering made: their text is elsewhere.
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
        // Up to the colon of the branch, comments between included.
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

namespace {

/// One CASE being checked. Its labels are compared as 64 bits, with or without a sign (`m_isBig`).
class CaseCheck {
public:
    CaseCheck(Context& context, const syntax::Stmt& stmt)
        : m_context(context), m_stmt(stmt), m_selector(settled(context, expression(context, *stmt.value))),
          m_type(m_selector.isUnknown() ? context.elementary(TypeKind::Unknown) : m_selector.type()),
          m_isGood(!m_selector.isUnknown() && canChoose() && !context.types.isText(m_type)),
          // ULINT and LWORD need all 64 bits without a sign; every other selector fits into LINT.
          m_isBig(m_isGood && context.types.storageKind(m_type) != TypeKind::Lint &&
                  types::bitsOf(context.types.storageKind(m_type)) == 64),
          m_seen(m_isBig), m_before(context.flow) {
        if (!m_selector.isUnknown() && !canChoose()) refuseSelector(context, stmt, m_type);
    }

    void run(std::vector<tree::Stmt*>& out) {
        m_made = newStmt(m_context, tree::StmtKind::Case, head());
        m_made->operandType = m_context.elementary(m_isBig ? TypeKind::Ulint : TypeKind::Lint);
        // One width for all selectors: the code generator has one form of switch.
        if (m_isGood) m_made->a = convertNode(m_context, m_selector, m_made->operandType).expr;
        m_before = m_context.flow;
        for (const syntax::CaseArm& each : m_stmt.arms) arm(each);
        if (!isComplete()) { // none of the arms may run
            m_context.flow = m_before;
            join();
        }
        m_context.flow = m_joined;
        // Nothing behind unreachable code becomes reachable by a branch.
        if (!m_before.isReachable) m_context.flow.isReachable = false;
        if (m_isGood) out.push_back(m_made);
    }

private:
    [[nodiscard]] bool canChoose() const {
        const types::Family family = m_context.types.family(m_type);
        return types::isInteger(family) || family == types::Family::Bool || family == types::Family::Character;
    }

    [[nodiscard]] SourceRange head() const {
        const SourceRange whole = m_stmt.range;
        if (!whole.file.isValid()) return whole;
        return {whole.file, whole.begin, std::max(whole.begin, m_stmt.value->range.end)};
    }

    /// What holds after the CASE holds after each of its arms.
    void join() {
        const Flow& flow = m_context.flow;
        if (flow.isReachable) m_joined.isResultSet = m_joined.isResultSet && flow.isResultSet;
        m_joined.isReachable = m_joined.isReachable || flow.isReachable;
    }

    void arm(const syntax::CaseArm& each) {
        tree::CaseArm& made = m_made->arms.emplace_back();
        for (const syntax::CaseLabel& written : each.labels) label(written, made);
        m_context.flow = m_before;
        statements(m_context, each.body, made.body);
        join();
    }

    void label(const syntax::CaseLabel& each, tree::CaseArm& made) {
        const auto low = valueOf(each.low);
        const auto high = each.high ? valueOf(each.high) : low;
        if (!low || !high) return;
        const SourceRange first = each.low->range;
        const SourceRange range = each.high ? SourceRange{first.file, first.begin, each.high->range.end} : first;
        const bool isReversed = m_isBig ? static_cast<uint64_t>(*high) < static_cast<uint64_t>(*low) : *high < *low;
        if (isReversed) {
            m_context.emit(range, findings::ArraySizeInvalid(*low, *high));
            return;
        }
        if (!m_seen.add(*low, *high)) m_context.emit(range, findings::DuplicateCase(m_context.textOf(range)));
        made.ranges.push_back({*low, *high});
    }

    [[nodiscard]] std::optional<int64_t> valueOf(const syntax::Expr* label) {
        if (!label) return std::nullopt;
        Operand value = expression(m_context, *label, m_type);
        if (value.isUnknown()) return std::nullopt;
        if (!value.isConstant()) {
            m_context.emit(label->range, findings::NotConstant());
            return std::nullopt;
        }
        // With a wrong selector labels are still checked for being constant.
        if (m_isGood) value = inSelectorsType(value);
        if (value.isUnknown() || !std::holds_alternative<int64_t>(value.expr->value.data)) return std::nullopt;
        return value.expr->value.integer();
    }

    /// A number that fits is taken as it is: CASE of an enumeration may name its values by number.
    [[nodiscard]] Operand inSelectorsType(Operand value) {
        const bool choosesEnum = m_context.isKind(m_type, TypeKind::Enum);
        if (m_context.isKind(value.type(), TypeKind::Enum) && !choosesEnum)
            value = convertNode(m_context, value, m_context.types.storage(value.type()));
        const types::Value& constant = value.expr->value;
        const bool fitsAnyway = isNumeric(m_context, value.type()) && std::holds_alternative<int64_t>(constant.data) &&
                                (fits(m_context, constant, m_context.types.storage(m_type)) || choosesEnum);
        return fitsAnyway ? value : converted(m_context, value, m_type);
    }

    /// Whether one of the arms runs, whatever the value.
    [[nodiscard]] bool isComplete() {
        if (m_stmt.hasElse) {
            m_context.flow = m_before;
            statements(m_context, m_stmt.elseBody, m_made->elseBody);
            join();
            return true;
        }
        if (!m_isGood || !m_context.isKind(m_type, TypeKind::Enum)) return false;
        std::vector<std::string> missing;
        for (const types::Enumerator& enumerator : m_context.types[m_type].enumerators)
            if (!m_seen.contains(enumerator.value)) missing.push_back(enumerator.name);
        // Only of enumerations: of numbers nobody names all.
        if (!missing.empty() && m_stmt.range.file.isValid() && !m_stmt.origin) reportMissing(missing);
        return missing.empty() && !m_context.types[m_type].enumerators.empty();
    }

    void reportMissing(const std::vector<std::string>& missing) {
        constexpr size_t kMostShown = 3;
        std::vector<std::string> shown(
            missing.begin(), missing.begin() + static_cast<std::ptrdiff_t>(std::min(kMostShown, missing.size())));
        if (missing.size() > kMostShown) shown.push_back("…");
        const FileId file = m_stmt.range.file;
        auto& diagnostic =
            m_context.emit({file, m_stmt.range.begin, m_stmt.range.begin + 4}, findings::MissingCase(shown));
        const std::string_view whole = m_context.world.textOf(m_stmt.range);
        const size_t end = lastEnd(whole);
        if (end >= whole.size()) return;
        std::string branches;
        for (const std::string& name : missing) branches += m_context.nameOf(m_type) + "." + name + ": ;\n";
        const auto place = m_stmt.range.begin + static_cast<uint32_t>(end);
        diagnostic.fixes.push_back({fixes::AddMissingBranches(), {{{file, place, place}, branches}}});
        diagnostic.fixes.push_back({fixes::AddElse(), {{{file, place, place}, "ELSE\n    ;\n"}}});
    }

    /// The last END_CASE; the size of the text where there is none.
    [[nodiscard]] static size_t lastEnd(std::string_view whole) {
        constexpr std::string_view kEnd = "END_CASE";
        for (size_t i = whole.size() < kEnd.size() ? 0 : whole.size() - kEnd.size() + 1; i-- > 0;)
            if (equalsIgnoringCase(whole.substr(i, kEnd.size()), kEnd)) return i;
        return whole.size();
    }

    Context& m_context;
    const syntax::Stmt& m_stmt;
    Operand m_selector;
    TypeId m_type;
    bool m_isGood; // the selector can choose
    bool m_isBig;
    TakenValues m_seen;
    Flow m_before, m_joined{false, true};
    tree::Stmt* m_made = nullptr;
};

} // namespace

/// CASE (edition 3, 7.3.3.3.3): its labels are constants, each once.
///   ok:    CASE x OF 1..3: … 4: … END_CASE
///   wrong: CASE x OF 1..3: … 2: … END_CASE  (P3010)   CASE x OF y: …  (P2019)   CASE x OF 3..1: …  (P3027)
///   advice: CASE color OF Red: … END_CASE  where Green is left over (P3009)
void caseStatement(Context& context, const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out) {
    if (stmt.value) CaseCheck(context, stmt).run(out);
}

} // namespace plc::sema
