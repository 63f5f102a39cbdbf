// What codegen knows about a whole program before it emits: sites of statements, frame layouts, the call graph, who can
// fault, which locals must lie in memory. Made once per module; one thread.
#pragma once
#include "runtime/compiler/codegen/codegen.h"
#include "runtime/compiler/codegen/walk.h"

#include <unordered_map>

namespace plc::codegen {

/// Where the locals of a function lie in its frame. Text and aggregate result first, then text and aggregate parameters
/// in order (so that every implementation of a method agrees about them), then the rest.
struct FrameLayout {
    std::vector<uint32_t> offsets; // by local; kNoFrame = in a register
    uint32_t size = 0;
};
inline constexpr uint32_t kNoFrame = 0xffffffffu;
[[nodiscard]] FrameLayout layFrameOut(const types::TypeTable& types, const tree::Function& function,
                                      const std::vector<bool>& inMemory);
[[nodiscard]] uint32_t slotSize(const types::TypeTable& types, const tree::Local& local);

/// Statement → site, in the order of DebugMap::sites. Statements of one text share a site; it is asked for a stop once,
/// where the outermost (or first) of them begins. A Block that stands for a written statement (a block call) is such a
/// statement.
class SiteTable {
public:
    explicit SiteTable(const tree::Program& program);
    struct Place {
        uint32_t site = 0;  // 0 = none
        bool stops = false; // asks whether to stop
    };
    [[nodiscard]] Place at(const tree::Stmt& stmt) const;
    [[nodiscard]] uint32_t siteOf(const tree::Stmt& stmt) const { return at(stmt).site; }
    std::vector<image::Site> sites; // 0 unused

private:
    std::unordered_map<const tree::Stmt*, Place> m_places;
};

/// What a function may write besides its own locals, callees included; IN_OUT parameters count where they are bound.
struct WriteSummary {
    struct Extent {
        uint32_t begin = 0, end = 0;
    };
    bool anything = false; // through pointers, slots, dispatched calls
    bool instance = false; // of THIS
    std::vector<Extent> absolutes;
    void addAbsolute(Extent extent);
};

/// The bytes a place may touch, from its root's begin: all of an indexed array. False when they are not fixed to THIS
/// or the image.
bool extentOf(const types::TypeTable& types, const tree::Place& place, WriteSummary::Extent& extent);

struct FunctionFacts {
    FrameLayout frame;             // of this tier
    std::vector<bool> mayBeNull;   // IN_OUT locals that a caller leaves out
    std::vector<uint32_t> callees; // indices, without repetition
    bool canFault = false;
    bool charges = false;     // touches the loop budget, itself or through callees
    bool hasLoop = false;     // itself
    bool hasSlots = false;    // follows IN_OUT slots of its instance
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
    [[nodiscard]] const SiteTable& sites() const { return m_sites; }
    /// Every block whose instances may stand behind a call of `method` (by its owner's type).
    [[nodiscard]] const std::vector<Target>& targetsOf(uint32_t method) const;
    [[nodiscard]] types::TypeId blockType(uint32_t blockNumber) const;
    [[nodiscard]] uint32_t blockCount() const { return static_cast<uint32_t>(m_blocks.size()); }

private:
    void collect(uint32_t function);
    [[nodiscard]] std::vector<Target> findTargets(uint32_t method) const;
    void findCycles();
    void spread();
    void spreadWrites();

    const tree::Program& m_program;
    Tier m_tier;
    SiteTable m_sites;
    std::vector<types::TypeId> m_blocks; // by block number
    std::vector<FunctionFacts> m_functions;
    std::unordered_map<uint32_t, std::vector<Target>> m_targets; // of every method that has a slot
};

} // namespace plc::codegen
