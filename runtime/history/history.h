// Records the image of every scan as changes of 64-byte blocks (D2), under a memory budget, and answers from it.
// Written by the scan thread (as ScanObserver's work, through `append`), read by any thread: readers see all scans
// finished before they asked.
#pragma once
#include "runtime/base/progress.h"
#include "runtime/base/signal.h"
#include "runtime/expression/expression.h"
#include "runtime/history/journal.h"
#include "runtime/image/program.h"

#include <chrono>
#include <functional>
#include <memory>
#include <vector>

namespace plc::history {

using Nanoseconds = std::chrono::nanoseconds;

/// Position in the recording: counts appended scans over all branches; never reused. The PLC's own scan number and time
/// can repeat after going back, the position does not.
using Position = uint64_t;

struct ScanStamp {
    Position position = 0;
    uint64_t scan = 0;
    Nanoseconds time{};
};

/// After going back, recording continues on a new branch: [first, …) follows `parent` (the scan it was resumed from).
inline constexpr Position kNoParent = ~Position(0); // of a branch that starts again (reset to the origin)
struct Branch {
    Position first = 0;
    Position parent = 0;
};
/// Positions [begin, end).
struct PositionRange {
    Position begin = 0, end = 0;
    bool operator==(const PositionRange&) const = default;
};
/// The positions that lead to the scan before `end`, oldest first: what was recorded and then gone back from is left
/// out. `branches` as History::branches() gives them.
[[nodiscard]] std::vector<PositionRange> chainTo(const std::vector<Branch>& branches, Position end);

struct Mark { // event on the time axis
    Position position = 0;
    Nanoseconds time{};
    int kind = 0; // controller::EventKind
    Message text;
};

/// A bucket of a series over scans. `count` 0 = gap (evicted, or the path did not exist).
struct Bucket : SignalBucket {
    Position begin = 0; // its first scan
};
struct Sample {
    ScanStamp at;
    double value = 0;
    bool hasValue = false;
    int64_t integer = 0; // 64-bit integers, times and dates without rounding (LWORD, ULINT: their bits)
};

struct Statistics {
    uint64_t scans = 0;          // recorded and still there
    Position first = 0, end = 0; // oldest still there; one past the newest
    size_t bytes = 0, budget = 0, segments = 0;
};

/// Makes the expression for another program version (a series crosses an online change by path and type); invalid =
/// gap.
using Recompile = std::function<expression::Expression(const image::CompiledProgram&)>;

/// What a recorded scan began from: enough to make it again (D13).
struct ScanInput {
    std::shared_ptr<const image::CompiledProgram> program;
    std::vector<std::byte> image; // as long as the program's, without frames
    image::ScanStart start;
    /// Not all of `start` is said: pending events and first-scan flags follow from the image.
    bool startIsPartial = true;
    std::vector<image::OutsideNote> notes;
    ScanStamp stamp; // of the scan itself
    int64_t calendarStartNs = 0;
    bool hasJournal = false; // recordings of earlier versions have none
};

class History {
public:
    explicit History(size_t budgetBytes = size_t(256) << 20);
    ~History();

    // --- the scan thread
    void beginProgram(std::shared_ptr<const image::CompiledProgram> program); // a new segment under this version
    void beginBranch(Position parent);                                        // after going back
    /// `dirtyPages`: one byte for each image::kDirtyPage bytes that may have changed since the scan before; empty =
    /// look everywhere.
    void append(std::span<const std::byte> image, uint64_t scan, Nanoseconds time,
                std::span<const uint8_t> dirtyPages = {});
    void mark(int kind, Message text, Nanoseconds time);
    /// What acted since the last scan on the one to come; before its append.
    void outsideActed(const image::Outside& outside);
    void actedWhileHalted(std::span<const image::OutsideNote> notes);

    // --- any thread
    /// What the program was built from; saved with a recording. Told before beginProgram().
    void describeProgram(std::shared_ptr<const image::CompiledProgram> program,
                         std::vector<std::pair<std::string, std::string>> sources, std::vector<std::string> libraries,
                         std::vector<std::pair<std::string, std::string>> libraryTexts = {});
    void setBudget(size_t bytes);
    /// Versions of the program that recorded scans were made by, oldest first.
    [[nodiscard]] std::vector<std::shared_ptr<const image::CompiledProgram>> programs() const;
    [[nodiscard]] Statistics statistics() const;
    [[nodiscard]] std::vector<Branch> branches() const;
    [[nodiscard]] std::vector<Mark> marks() const;
    /// The whole image after that scan (data part, frame area zero); empty when evicted. `program` receives its
    /// version.
    [[nodiscard]] std::vector<std::byte> seek(Position position,
                                              std::shared_ptr<const image::CompiledProgram>* program = nullptr) const;
    [[nodiscard]] std::optional<ScanStamp> stamp(Position position) const;
    /// What the scan began from; an error says why that is not known any more.
    [[nodiscard]] Result<ScanInput> inputOf(Position position) const;
    /// The journals in [from, to), oldest first, without those that only repeat what is in force; false to stop.
    void forEachJournal(Position from, Position to,
                        const std::function<bool(Position, const JournalEntry&)>& visit) const;
    /// The last position at or before that PLC time on the newest branch (what was recorded between a branch's parent
    /// and its first scan does not belong to it).
    [[nodiscard]] std::optional<Position> positionAt(Nanoseconds time) const;
    /// Position of PLC scan number on the newest branch.
    [[nodiscard]] std::optional<Position> positionOfScan(uint64_t scan) const;
    /// Buckets over [from, to); a bucket of one scan is exact. Uses the place's block log when the expression is one
    /// variable.
    [[nodiscard]] std::vector<Bucket> series(const expression::Expression& expression, const Recompile& recompile,
                                             Position from, Position to, size_t buckets) const;
    [[nodiscard]] std::vector<Sample> samples(const expression::Expression& expression, const Recompile& recompile,
                                              Position from, Position to) const;
    enum class Direction { Forward, Backward };
    /// Next position (strictly after/before `from`) at which the expression becomes true (was not true at the scan
    /// before it).
    [[nodiscard]] std::optional<Position> find(const expression::Expression& expression, const Recompile& recompile,
                                               Position from, Direction direction) const;
    /// Next position at which the value differs from the scan before.
    [[nodiscard]] std::optional<Position> findChange(const expression::Expression& expression,
                                                     const Recompile& recompile, Position from,
                                                     Direction direction) const;

    /// A recording on disk: sources and libraries to rebuild the program, then the segments. Atomic write; cancelled,
    /// the file is as it was.
    Result<void> save(const std::string& path, Progress* progress = nullptr) const;
    /// Only the pieces of the recording that have scans in the range, each in whole. The answer: where the last of them
    /// begins, which may still grow.
    Result<Position> saveRange(const std::string& path, PositionRange range, Progress* progress = nullptr) const;
    /// `rebuild` compiles the sources the file holds (the history does not know the compiler).
    /// `libraryTexts` are empty in recordings of earlier versions: then those of this studio serve.
    struct Sources {
        std::vector<std::pair<std::string, std::string>> files; // path, text
        std::vector<std::string> libraries;
        std::vector<std::pair<std::string, std::string>> libraryTexts; // "toolbox/valves.st", text
    };
    using Rebuild = std::function<std::shared_ptr<const image::CompiledProgram>(const Sources& sources)>;
    [[nodiscard]] static Result<std::unique_ptr<History>> load(const std::string& path, const Rebuild& rebuild,
                                                               Progress* progress = nullptr);

private:
    struct State;
    std::unique_ptr<State> m;
};

} // namespace plc::history
