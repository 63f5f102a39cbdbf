// One recorded scan from inside (D13): every statement, branch, read, write and value, in the order in which it
// happened, with the instance it happened in. This is the one interface for whoever asks what a scan computed: exact
// values in the text, power flow, stepping backwards, "who set this?", "why?", coverage, findings.
//
//     inside::Insight insight(session.history());
//     auto look = insight.look(position);                      // Result<shared_ptr<const Look>>; cached
//     for (const Seen& seen : (*look)->valuesOf(range, "Main.pump"))  // range: of an expression in the text
//         show(seen.value, seen.passes);
//     (*look)->isExecuted(statementRange, "Main.pump");
//
// A Look is immutable: any thread may read it. Insight belongs to one thread; it never touches the running controller.
#pragma once
#include "runtime/compiler/tree/tree.h"
#include "runtime/image/watch.h"
#include "runtime/inside/plain_list.h"
#include "runtime/inside/rerun.h"

#include <mutex>
#include <unordered_map>

namespace plc::inside {

using EventIndex = uint32_t;
inline constexpr uint32_t kNone = ~uint32_t(0);

/// One report of the watched code.
struct Event {
    image::WatchKind kind{};
    int16_t bit = -1;        // Read, Write
    uint32_t activation = 0; // index in activations()
    uint32_t passes = kNone; // of the loops that ran, newest: see passesAt()
    const void* node = nullptr;
    uint64_t bits =
        0; // Value: the bits; Read, Write: the first 8 bytes there; Arm: number; Text, Bytes: index of a copy
    uint32_t offset = 0; // Read, Write: place in the image
    uint32_t size = 0;
    uint32_t copy = kNone; // Write of more than 8 bytes: index of a copy

    [[nodiscard]] const tree::Stmt* stmt() const { return static_cast<const tree::Stmt*>(node); }
    [[nodiscard]] const tree::Expr* expr() const { return static_cast<const tree::Expr*>(node); }
    [[nodiscard]] const tree::Place* place() const { return static_cast<const tree::Place*>(node); }
    [[nodiscard]] const tree::Call* call() const { return static_cast<const tree::Call*>(node); }
};

/// One run of a function's body.
struct Activation {
    uint32_t function = 0; // of CompiledProgram::functions
    uint32_t instance = 0, frame = 0;
    uint32_t parent = kNone;           // activation that called it
    EventIndex call = kNone;           // its Call event, in the parent
    EventIndex begin = 0, end = kNone; // Begin and End; kNone: a fault left it
    uint32_t task = kNone;             // of CompiledProgram::tasks
};

/// A value of an expression as it was at its place.
struct Seen {
    types::Value value;
    EventIndex event = 0;
    uint32_t activation = 0;
    std::vector<uint64_t> passes; // of the loops around it, outermost first, from 0
};

/// Loops keep the passes asked for: of a loop that begins where this text does, `count` passes from `first` on. Other
/// loops keep all.
struct PassWindow {
    SourceRange loop;
    uint64_t first = 0, count = 1;
};
class Look;
struct LookOptions {
    size_t eventLimit = size_t(2) << 20; // 48 bytes each; what is more is left out and said
    std::vector<PassWindow> windows;
    std::vector<uint32_t> functions; // watched at least; none: all
    /// Called with each event of the scan in turn, however many there are; the look keeps none of them. Their
    /// `activation` is the depth of the call (0: of a task); `passes` and copies of texts are left out.
    std::function<void(const Look&, const Event&, uint32_t function)> each;
};

class Look {
public:
    // --- what was looked at
    [[nodiscard]] Position position() const { return m_position; }
    [[nodiscard]] const image::CompiledProgram& program() const { return *m_rerun.input.program; }
    [[nodiscard]] const tree::Program& tree() const { return *m_tree; }
    [[nodiscard]] const history::ScanInput& input() const { return m_rerun.input; }
    /// The scan came out as recorded; else differences() says where not, doubt() why.
    [[nodiscard]] bool isExact() const { return m_rerun.isExact(); }
    [[nodiscard]] const std::vector<Difference>& differences() const { return m_rerun.differences; }
    /// Also when not all of it was kept, so that what came last is not known; empty: there is none.
    [[nodiscard]] Message doubt() const;
    [[nodiscard]] const std::optional<controller::Fault>& fault() const { return m_rerun.fault; }
    /// The image after the scan.
    [[nodiscard]] std::span<const std::byte> image() const { return m_rerun.image; }
    /// The scan did more than eventLimit keeps: what came last is not known.
    [[nodiscard]] bool isCut() const { return m_isCut; }
    /// Reports that did not fit, or lie outside the windows of their loops.
    [[nodiscard]] uint64_t leftOut() const { return m_leftOut; }

    // --- what happened
    [[nodiscard]] std::span<const Event> events() const { return m_events; }
    [[nodiscard]] std::span<const Activation> activations() const { return m_activations; }
    [[nodiscard]] types::Value valueOf(const Event& event) const; // Value, Text, Bytes, Read, Write
    /// What a Write of more than 8 bytes has written, its first 4096 bytes; else empty.
    [[nodiscard]] std::span<const std::byte> bytesOf(const Event& event) const;
    /// "Main.pump": the instance an activation ran on; the caller's for functions.
    [[nodiscard]] std::string instanceOf(uint32_t activation) const;
    /// Passes of the loops around an event, outermost first.
    [[nodiscard]] std::vector<uint64_t> passesAt(EventIndex event) const;

    // --- by place in the text. `instance`: a path; empty: any
    /// By index in activations(): whether it counts for the instance.
    [[nodiscard]] std::vector<bool> activationsIn(const std::string& instance) const;
    /// Each value that an expression with exactly this text had, in order.
    [[nodiscard]] std::vector<Seen> valuesOf(SourceRange range, const std::string& instance = {}) const;
    /// How often a statement with this text began.
    [[nodiscard]] uint64_t timesExecuted(SourceRange statement, const std::string& instance = {}) const;
    [[nodiscard]] bool isExecuted(SourceRange statement, const std::string& instance = {}) const {
        return timesExecuted(statement, instance) > 0;
    }
    /// The Write events that touched these bytes, in order.
    [[nodiscard]] std::vector<EventIndex> writesTo(uint32_t offset, uint32_t size, int bit = -1) const;
    /// The last of them before `before`; kNone: what it read was there when the scan began.
    [[nodiscard]] EventIndex lastWriteBefore(EventIndex before, uint32_t offset, uint32_t size, int bit = -1) const;

private:
    friend class Insight;
    friend class Recorder;
    struct Index;
    [[nodiscard]] const Index& index() const;

    Position m_position = 0;
    Rerun m_rerun;
    const tree::Program* m_tree = nullptr;
    std::shared_ptr<const image::Code> m_code;
    PlainList<Event> m_events;
    PlainList<Activation> m_activations;
    std::vector<std::vector<std::byte>> m_copies;
    struct PassOf {
        const tree::Stmt* loop;
        uint64_t pass;
        uint32_t around;    // the next outer one; kNone: none
        SourceRange extent; // of the loop with its body
    };
    PlainList<PassOf> m_passes;
    uint64_t m_leftOut = 0;
    bool m_isCut = false;
    mutable std::once_flag m_indexed;
    mutable std::shared_ptr<const Index> m_index;
};

/// The code that reports what it does, of the programs that were looked into last; compiling it is most of the time of
/// a first look. Whoever looks into several recordings of one program shares it. Any thread.
class WatchedCode {
public:
    /// functions: those that report; none: all.
    [[nodiscard]] Result<std::shared_ptr<const image::Code>>
    of(const std::shared_ptr<const image::CompiledProgram>& program, const std::vector<uint32_t>& functions);

private:
    struct Known {
        std::shared_ptr<const image::CompiledProgram> program;
        std::vector<uint32_t> functions;
        std::shared_ptr<const image::Code> code;
    };
    std::mutex m_mutex;
    std::vector<Known> m_known; // the newest last
};

/// Looks into recorded scans.
class Insight {
public:
    explicit Insight(const history::History& history,
                     std::shared_ptr<WatchedCode> code = std::make_shared<WatchedCode>())
        : m_history(history), m_rerunner(history), m_code(std::move(code)) {}
    [[nodiscard]] Result<std::shared_ptr<const Look>> look(Position position, const LookOptions& options = {});
    /// The scan as it would have gone from another beginning (what if, why not); not compared, not cached.
    [[nodiscard]] Result<std::shared_ptr<const Look>> lookFrom(history::ScanInput input,
                                                               const LookOptions& options = {});
    [[nodiscard]] const history::History& history() const { return m_history; }
    [[nodiscard]] Rerunner& rerunner() { return m_rerunner; }
    /// True of it: whoever asked no longer wants to know; long questions end soon, with whatever they have, and a look
    /// fails with Cancelled. Asked on the thread of the question; null: nobody will say so.
    void setCancel(std::function<bool()> isCancelled) { m_rerunner.setCancel(std::move(isCancelled)); }
    [[nodiscard]] bool isCancelled() const { return m_rerunner.isCancelled(); }

private:
    const history::History& m_history;
    Rerunner m_rerunner;
    std::shared_ptr<WatchedCode> m_code;
    std::vector<std::shared_ptr<const Look>> m_looks; // the newest last
};

} // namespace plc::inside
