// What a back end knows about a whole program before it makes code: sites of statements, frame layouts, the call graph,
// who can fault, which locals must lie in memory. Made once per program and tier, shared by the threads that emit parts
// of it; knows no LLVM.
#pragma once
#include "runtime/compiler/facts/frames.h"
#include "runtime/compiler/facts/sites.h"
#include "runtime/compiler/facts/tier.h"
#include "runtime/compiler/facts/walk.h"
#include "runtime/compiler/facts/work.h"
#include "runtime/compiler/facts/writes.h"

namespace plc::facts {

struct FunctionFacts {
    FrameLayout frame;             // of this tier
    std::vector<bool> mayBeNull;   // IN_OUT locals that a caller leaves out
    std::vector<uint32_t> callees; // indices, without repetition
    bool canFault = false;
    bool charges = false;     // touches the budget of work, itself or through callees
    bool hasLoop = false;     // itself
    bool hasSlots = false;    // follows IN_OUT slots of its instance
    bool hasTry = false;      // itself
    bool inCycle = false;     // of calls
    bool isUnbounded = false; // reaches a cycle: frames are checked as they come
    WriteSummary writes;
    bool isReachable = false; // from a task, the initializer or a dispatch table
};

/// One implementation a dispatched call can reach.
struct Target {
    uint32_t blockNumber = 0;
    types::TypeId block;
    uint32_t function = 0; // 0: abstract
};

class ProgramFacts {
public:
    ProgramFacts(const tree::Program& program, Tier tier);
    [[nodiscard]] const FunctionFacts& operator[](uint32_t function) const { return m_functions[function]; }
    /// The program, when its locals fit into the image; else why not. Calls in cycles check for themselves.
    [[nodiscard]] Result<void> fits() const;
    [[nodiscard]] const SiteTable& sites() const { return m_sites; }
    [[nodiscard]] const WorkTable& work() const { return m_work; }
    /// Every block whose instances may stand behind a call of `method` (by its owner's type).
    [[nodiscard]] const std::vector<Target>& targetsOf(uint32_t method) const;
    [[nodiscard]] types::TypeId blockType(uint32_t blockNumber) const;
    [[nodiscard]] uint32_t blockCount() const { return static_cast<uint32_t>(m_blocks.size()); }

private:
    void collect(uint32_t function);
    [[nodiscard]] std::vector<Target> findTargets(uint32_t method) const;
    void findCycles();
    void measureWork();
    void recordLongPaths();
    void spread();
    void spreadWrites();

    const tree::Program& m_program;
    Tier m_tier;
    SiteTable m_sites;
    WorkTable m_work;
    std::vector<uint32_t> m_order;       // each function after those it calls, as far as there are no cycles
    std::vector<types::TypeId> m_blocks; // by block number
    std::vector<FunctionFacts> m_functions;
    std::unordered_map<uint32_t, std::vector<Target>> m_targets; // of every method that has a slot
};

} // namespace plc::facts
