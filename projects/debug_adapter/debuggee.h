// What is being debugged: a session whose scan stands at a breakpoint, or a moment of its recording (or of a recording
// from a file), one after the other without a seam: a step back leaves the live scan, and steps forward lead into it
// again. Owned by the adapter; its thread. The scan thread is the session's own.
#pragma once
#include "projects/session/session.h"
#include "runtime/inside/slow_scan.h"

#include <chrono>
#include <memory>
#include <optional>

namespace plc::dap {

struct LaunchSettings {
    std::string program; // project folder or ST file
    std::vector<std::string> libraries;
    session::RunMode mode{session::Pace::Real, 1.0};
    bool stopsAtEntry = false;
};

struct Stop {
    enum class Why : uint8_t { Entry, Breakpoint, Step, Pause, Fault, Begin };
    Why why = Why::Step;
    Message text; // of a fault; of a condition that cannot be evaluated
};

/// A call that is live at the moment that is shown.
struct Frame {
    uint32_t id = 0;
    std::string function, instance;
    SourceRange range; // of the statement that is about to run
    std::optional<size_t> task;
};

class Debuggee {
public:
    [[nodiscard]] static Result<std::unique_ptr<Debuggee>> launch(const LaunchSettings& settings);
    /// A recording, at its last scan; `folder`: of the project it was made from, where that is here.
    [[nodiscard]] static Result<std::unique_ptr<Debuggee>> open(const std::string& recording,
                                                                const std::string& folder = {});
    ~Debuggee();

    [[nodiscard]] const image::CompiledProgram& program() const;
    [[nodiscard]] bool isLive() const { return m_session != nullptr; }
    [[nodiscard]] bool isPast() const { return m_scan != nullptr; }
    /// The folder that paths of sources begin at; empty: they are absolute.
    [[nodiscard]] const std::string& folder() const { return m_folder; }
    void setBreakpoints(std::vector<debug::Breakpoint> breakpoints);

    // --- moving; poll() reports where it came to stand
    void begin(bool stopsAtEntry);
    void goOn();
    void step(debug::Step how);
    void stepBack();
    void reverseContinue();
    void pause();
    [[nodiscard]] bool isMoving() const { return m_motion != Motion::None; }
    /// Works for some milliseconds on a way through the recording; says when it stands.
    [[nodiscard]] std::optional<Stop> poll();

    // --- while it stands
    [[nodiscard]] std::vector<Frame> frames();
    struct Variable {
        std::string name;
        types::Value value; // no value: not connected or not readable
        bool isLocal = false, isChanged = false;
    };
    [[nodiscard]] std::vector<Variable> variables(const Frame& frame);
    [[nodiscard]] Result<types::Value> evaluate(const std::string& text, const std::optional<Frame>& frame);
    /// Writes before the next statement; waits until it is done.
    [[nodiscard]] Result<types::Value> write(const std::string& path, const std::string& text);
    [[nodiscard]] std::optional<controller::Fault> fault() const;
    /// Scan and PLC time of the moment, for people.
    [[nodiscard]] std::optional<history::ScanStamp> stamp() const;

private:
    enum class Motion : uint8_t { None, Live, Forward, Back };
    Debuggee() = default;
    [[nodiscard]] const history::History& history() const;
    [[nodiscard]] const session::Snapshot& snapshot();
    void live(Stop::Why why);
    [[nodiscard]] std::optional<Stop> pollLive();

    // --- the recording
    [[nodiscard]] Result<void> enterPast();
    [[nodiscard]] bool standAt(const controller::FaultFrame& frame, std::span<const std::byte> image);
    [[nodiscard]] Result<void> show(history::Position position);
    [[nodiscard]] std::optional<history::Position> before(history::Position position) const;
    [[nodiscard]] std::optional<history::Position> behind(history::Position position) const;
    /// To the next scan with a statement in that direction; false: there is none.
    bool turnTo(std::optional<history::Position> position, bool isBack);
    [[nodiscard]] bool isAtBreakpoint();
    void takeLines();
    [[nodiscard]] std::optional<Stop> pollForward();
    [[nodiscard]] std::optional<Stop> pollBack();
    [[nodiscard]] std::optional<Stop> stand(Stop::Why why, Message text = {});
    void leavePast(Stop::Why why);
    [[nodiscard]] std::optional<size_t> taskNamed(std::string_view name) const;
    [[nodiscard]] std::optional<size_t> taskOf(const controller::FaultFrame& entry) const;

    std::string m_folder;
    session::RunMode m_mode;
    std::unique_ptr<session::Session> m_session;
    std::unique_ptr<history::History> m_recording;
    std::unique_ptr<inside::Insight> m_insight;
    std::vector<debug::Breakpoint> m_breakpoints;
    Motion m_motion = Motion::None;
    Stop::Why m_why = Stop::Why::Entry; // of the stop to come, live
    bool m_isPauseAsked = false;
    std::optional<Stop> m_stop; // found already, to be reported
    uint64_t m_haltsSeen = 0;
    std::optional<session::Snapshot> m_snapshot; // of the halt
    std::unique_ptr<inside::SlowScan> m_scan;    // of the moment in the recording
};

} // namespace plc::dap
