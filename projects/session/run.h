// One run of a program as everybody looks at it: a controller that runs now, one far away, or what a recording holds.
// Image, program, history, values, expressions, and whether it may be written. A Session is one, a RecordedRun is one.
// Any thread, unless a function says otherwise.
#pragma once
#include "runtime/controller/controller.h"
#include "runtime/history/history.h"

#include <memory>
#include <string>

namespace plc::session {

using controller::Nanoseconds;

class Versions;

struct Status {
    controller::State state = controller::State::Stopped;
    uint64_t scans = 0; // finished scans
    Nanoseconds time{}; // of the last scan
    double load = 0;    // share of wall time spent in scans, 0..1
    int64_t lastScanNs = 0;
    std::optional<controller::Fault> fault, simulationFault;
    history::Position position = 0; // newest recorded
    uint64_t halts = 0;             // how often the scan came to stand; its frames are at hand
    uint64_t skippedScans = 0;
    Message retainProblem;
};

/// A finished scan, or the state at a breakpoint, with the version of the program it belongs to.
struct Snapshot {
    std::vector<std::byte> image; // empty: nothing yet
    std::shared_ptr<const image::CompiledProgram> program;
    uint64_t scan = 0;
    Nanoseconds time{};
    history::Position position = 0;
    bool isHalted = false;
};

/// What a write goes to: a path, and its place where that is already known for a version of the program. Another
/// version looks the path up again.
struct Target {
    Target(std::string path) : path(std::move(path)) {} // NOLINT: a path is a target
    Target(const char* path) : path(path) {}            // NOLINT
    Target(std::string path, image::Place place, std::shared_ptr<const image::CompiledProgram> program)
        : path(std::move(path)), place(place), program(std::move(program)) {}

    std::string path;
    image::Place place;
    std::shared_ptr<const image::CompiledProgram> program; // that the place belongs to; null: not looked up
};

/// One of several values that belong together.
struct Assignment {
    std::string path;
    types::Value value;
};

/// Written before one scan, or none of them.
struct Together {
    std::vector<Assignment> values;
    std::string origin;
};

class Run {
public:
    virtual ~Run();
    Run(const Run&) = delete;
    Run& operator=(const Run&) = delete;

    // --- looking
    [[nodiscard]] virtual const history::History& history() const = 0;
    /// Of the newest scan; null before anything was built or recorded.
    [[nodiscard]] virtual std::shared_ptr<const image::CompiledProgram> program() const = 0;
    [[nodiscard]] virtual Status status() const = 0;
    /// The newest image with all that belongs to it; `into` keeps its memory from call to call.
    virtual void latest(Snapshot& into) const = 0;
    /// The newest image alone.
    [[nodiscard]] std::vector<std::byte> snapshot(uint64_t* scan = nullptr) const;
    /// As seen from instance path `scope`, for images of the newest program. Cached, errors too.
    [[nodiscard]] Result<expression::Expression> expression(const std::string& text,
                                                            const std::string& scope = {}) const;
    /// The same for images of one of the versions that were run.
    [[nodiscard]] Result<expression::Expression> expression(const std::string& text, const std::string& scope,
                                                            const image::CompiledProgram& version) const;
    /// For series that cross online changes; may outlive the run.
    [[nodiscard]] history::Recompile recompile(const std::string& text, const std::string& scope = {}) const;

    // --- writing. False: what it shows is over, nothing below has an effect.
    [[nodiscard]] virtual bool isLive() const = 0;
    /// Found once, for write and press.
    [[nodiscard]] Result<Target> target(const std::string& path) const;
    /// `origin`: who it comes from, in words ("panel Main, button Start"); the journal keeps it.
    virtual void write(Target target, types::Value value, std::string origin = {});
    /// All of them before one scan, or none: what is refused then is among the refusals.
    virtual void writeTogether(std::vector<Assignment> values, std::string origin = {});
    /// Momentary button: released no earlier than after every cyclic task ran once with the press.
    virtual void press(Target target, types::Value pressed, types::Value released, std::string origin = {});
    virtual void release(Target target);
    virtual void force(std::string path, types::Value value, std::string origin = {});
    virtual void unforce(std::string path);
    virtual void unforceAll();
    [[nodiscard]] virtual std::vector<controller::Forced> forces() const;
    /// Refusals of posted commands (unknown path, wrong type, forced): text per command, oldest first, taken once.
    [[nodiscard]] virtual std::vector<Error> takeRefusals();

protected:
    Run();
    [[nodiscard]] const std::shared_ptr<Versions>& versions() const { return m_versions; }

private:
    std::shared_ptr<Versions> m_versions; // the programs that were run, and the one cache of compiled expressions
};

} // namespace plc::session
