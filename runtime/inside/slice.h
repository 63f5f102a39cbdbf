// What a value of a scan depends on, followed backwards through the reports of a Look: the statement that wrote it, the
// operands that decided, the conditions that let it run, down to what was there when the scan began. Values.
#pragma once
#include "runtime/inside/look.h"
#include "runtime/inside/statement_map.h"

#include <set>

namespace plc::inside {

/// A variable as the scan found it when it began; or the clock.
struct Leaf {
    image::Place place;
    std::string path;
    types::Value value;
    bool isClock = false;
    bool isInternal = false; // what a library's block remembers
    SourceRange condition;   // the smallest condition around where it was read: `level > 80`
    bool conditionHeld = false;
    std::vector<types::Value> others; // values it was compared with
    bool operator<(const Leaf& other) const {
        return std::tie(isClock, place.offset, place.bit) <
               std::tie(other.isClock, other.place.offset, other.place.bit);
    }
};

/// A step of the way from the value asked about to the leaves.
struct Reason {
    enum class Kind : uint8_t {
        Statement, // wrote `path`
        Guard,     // a condition that let it run
        NotReset,  // a condition that kept another statement from writing
        Blocked,   // a condition that keeps a statement from writing
        Block,     // a block of a library: timer, counter, edge
        Leaf       // leaves[leaf]
    };
    Kind kind = Kind::Leaf;
    SourceRange range;
    std::string function, instance, path; // Statement: what was written; Block: the block's path
    std::string blockType;                // Block: "TON"
    Message note;                         // Block: "has run 3.2 s of 5 s, 1.8 s to go"
    types::Value value;
    uint32_t leaf = kNone;
    bool isInternal = false; // Leaf: what a library's block remembers
    EventIndex event = kNone;
    std::vector<Reason> steps;
};

struct Slice {
    std::vector<Reason> steps;
    std::vector<Leaf> leaves; // in the order met, without repetition
    uint32_t task = kNone;    // that wrote it
    bool isCut = false;       // more than is shown
};

/// Bytes of the place; a bit takes its byte.
[[nodiscard]] uint32_t sizeOf(const types::TypeTable& types, const image::Place& place);

class Slicer {
public:
    Slicer(const Look& look, const StatementMap& map);
    /// Why the bytes hold what they hold after the scan.
    [[nodiscard]] Slice sliceOf(const image::Place& place);
    /// The same of a condition over the image after the scan: several places.
    [[nodiscard]] Slice sliceOf(const std::vector<image::Place>& places);

private:
    using Steps = std::vector<Reason>;
    void read(EventIndex read, Steps& out);
    void placeBefore(EventIndex before, const image::Place& place, Steps& out, SourceRange text);
    void write(EventIndex write, const image::Place& place, Steps& out);
    void library(EventIndex before, uint32_t activation, Steps& out);
    [[nodiscard]] uint32_t blockAround(EventIndex before, const image::Place& place) const;
    void blockedCalls(Steps& out);
    void assigned(EventIndex write, Steps& out);
    void parameter(EventIndex write, Steps& out);
    void output(EventIndex write, Steps& out);
    void expression(const tree::Expr& expr, EventIndex before, uint32_t activation, Steps& out);
    void operands(const tree::Expr& expr, EventIndex at, uint32_t activation, Steps& out);
    void callResult(const tree::Expr& expr, EventIndex at, uint32_t activation, Steps& out);
    void guards(const tree::Stmt& stmt, EventIndex before, uint32_t activation, Steps& out);
    void guard(Reason::Kind kind, const tree::Stmt& around, EventIndex before, uint32_t activation, Steps& out);
    void input(const Activation& activation, const image::Place& place, Steps& out);
    void otherWriters(const image::Place& place, EventIndex after, Steps& out, bool followsCalls = true);
    void leaf(const image::Place& place, EventIndex read, Steps& out, bool isInternal = false);
    void clock(Steps& out);

    [[nodiscard]] EventIndex valueEvent(const tree::Expr& expr, EventIndex before, uint32_t activation) const;
    [[nodiscard]] EventIndex statementAround(EventIndex before, uint32_t activation) const;
    [[nodiscard]] uint32_t libraryActivation(uint32_t activation) const; // the outermost of a library; kNone
    [[nodiscard]] bool boolAt(EventIndex event) const { return m_look.events()[event].bits != 0; }
    [[nodiscard]] std::optional<image::Place> fixedPlace(const tree::Place& place, const Activation& activation) const;
    /// The bytes that a place may lie in, in this run of its function: followed through IN_OUT and references by what
    /// they held in the scan.
    struct Reach {
        image::Place place;
        bool isWhole = false; // the whole of an array, a word or a text: which part of it is not known
        /// Of an array's element that is not known: `place` in the first one, and so on every `stride` bytes within
        /// `span`.
        uint32_t stride = 0, span = 0;
        [[nodiscard]] bool isKnown() const { return !isWhole && stride == 0; }
    };
    [[nodiscard]] bool reaches(const Reach& reach, const image::Place& place) const;
    [[nodiscard]] std::optional<Reach> reachOf(const tree::Place& place, const Activation& run) const;
    [[nodiscard]] std::optional<Reach> argumentOf(const Activation& run, uint32_t local) const;
    [[nodiscard]] std::optional<uint32_t> referredBy(uint32_t offset) const;
    [[nodiscard]] bool isFull();

    const Look& m_look;
    const StatementMap& m_map;
    Slice m_slice;
    std::set<EventIndex> m_seen; // writes that are explained already
    std::set<uint32_t> m_blocks; // and runs of library blocks
    struct Condition {
        SourceRange range;
        bool held = false;
        std::vector<types::Value> against; // what it compares with
    };
    Condition m_condition; // around what is read now
    size_t m_count = 0;
    uint32_t m_depth = 0;
};

/// "IO.S1", "Main.list[3]", "Main.word.5": a place as a person names it.
[[nodiscard]] std::string nameOf(const image::Layout& layout, const image::Place& place);

} // namespace plc::inside
