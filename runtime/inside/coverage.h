// Statements, branches and MC/DC of the conditions that scans ran through, gathered from Looks. One thread; one
// program.
//
// MC/DC: each condition of a decision has been seen to decide alone: two evaluations in which it differs, the others
// are equal or were not evaluated (short circuit), and the decision came out otherwise.
#pragma once
#include "runtime/inside/look.h"

#include <map>
#include <set>

namespace plc::inside {

struct StatementCoverage {
    SourceRange range;
    uint64_t count = 0;
};
/// IF: then and else; CASE: its arms and ELSE; loops: entered at all.
struct BranchCoverage {
    SourceRange statement;
    std::string name; // "then", "else", "arm 2"
    uint64_t count = 0;
};
struct ConditionCoverage {
    SourceRange range;
    bool wasTrue = false, wasFalse = false, decidedAlone = false;
    /// For one that never decided alone: what the others would have to be, "level > 80 = TRUE, stop = FALSE".
    std::string missing;
};
struct DecisionCoverage {
    SourceRange range;
    std::vector<ConditionCoverage> conditions;
};
struct FunctionCoverage {
    std::string name, file;
    std::vector<StatementCoverage> statements; // by place
    std::vector<BranchCoverage> branches;
    std::vector<DecisionCoverage> decisions;
    [[nodiscard]] size_t statementsRun() const;
    [[nodiscard]] size_t branchesTaken() const;
    [[nodiscard]] size_t conditionsMet() const;
    [[nodiscard]] size_t conditionCount() const;
};

/// What a line of the text is known to have done.
struct LineCoverage {
    enum class State : uint8_t { None, Run, Partly, NotRun };
    uint64_t count = 0;
    bool isStatement = false;
    size_t branches = 0, taken = 0;
    std::vector<Message> missing; // branches never taken, combinations never seen
    [[nodiscard]] State state() const;
};
/// By line from 1, of the function's file.
[[nodiscard]] std::map<uint32_t, LineCoverage> linesOf(const image::CompiledProgram& program,
                                                       const FunctionCoverage& f);

class Coverage {
public:
    explicit Coverage(std::shared_ptr<const image::CompiledProgram> program);
    /// A scan of the same sources, to its end; other programs are left out. Of one that fails, what had run counts.
    Result<void> add(Insight& insight, Position at);
    /// Every scan of a recording that can be run again; how many could not.
    size_t addAll(const history::History& history, Progress* progress = nullptr);
    /// The project's own functions, by name; without those of tests.
    [[nodiscard]] std::vector<FunctionCoverage> functions() const;

private:
    struct Decision {
        const tree::Expr* root = nullptr;
        std::vector<const tree::Expr*> conditions;
        /// Per evaluation: 0 FALSE, 1 TRUE, 2 not evaluated; the result behind them.
        std::set<std::vector<uint8_t>> seen;
    };
    void gather(const std::vector<tree::Stmt*>& body, uint32_t function);
    void gatherDecision(const tree::Stmt& stmt, const tree::Expr* expr, uint32_t function);
    void count(const Look& look, const Event& event, uint32_t function);
    void finishDecision(Decision& decision, const std::map<const tree::Expr*, uint8_t>& values, bool result);
    [[nodiscard]] DecisionCoverage coverageOf(const Decision& decision) const;
    [[nodiscard]] bool isCounted(uint32_t function) const;

    std::shared_ptr<const image::CompiledProgram> m_program;
    std::shared_ptr<WatchedCode> m_code = std::make_shared<WatchedCode>();
    const tree::Program* m_tree;
    struct Unit {
        std::map<uint32_t, StatementCoverage> statements; // by start of the text
        std::map<std::pair<uint32_t, int64_t>, BranchCoverage> branches;
        std::vector<uint32_t> decisions;
    };
    std::map<uint32_t, Unit> m_units; // by function
    std::vector<Decision> m_decisions;
    std::vector<std::map<const tree::Expr*, uint8_t>> m_values;    // of conditions, by depth of the bodies that run
    std::unordered_map<const tree::Expr*, uint32_t> m_decisionOf;  // root → decision
    std::unordered_map<const tree::Expr*, uint32_t> m_conditionOf; // condition → decision
};

/// Cobertura's XML, as CI servers read it; paths as the sources have them.
[[nodiscard]] std::string coberturaXml(const image::CompiledProgram& program, const std::vector<FunctionCoverage>& all);
/// One page without scripts: each file with its lines coloured and what is missing named.
[[nodiscard]] std::string coverageHtml(const image::CompiledProgram& program, const std::vector<FunctionCoverage>& all);

} // namespace plc::inside
