// A session whose controller runs elsewhere, in `stepwise serve`: it has the same program, is fed with the scans and
// the state of that controller and records them, so that whoever shows a session shows that controller; what is asked
// of it becomes an order that the outlet carries there. A Mirror belongs to the owner of the session; one thread feeds
// it.
#pragma once
#include "projects/session/session.h"

namespace plc::session {

enum class OrderKind : uint8_t {
    Start,
    Pause,
    SingleScan,
    Stop,
    Reset,
    Write, // one value
    WriteTogether,
    Press, // values: pressed, released
    Release,
    Force,
    Unforce,
    UnforceAll,
    ResetStatistics,
    ChangeProgram,
    SetBreakpoints,
    Resume,
    Step,
    RunTo
};

/// What was asked of the controller; only what its kind needs is filled in.
struct Order {
    OrderKind kind{};
    std::vector<Assignment> values{};
    std::string path{};
    std::string origin{};
    controller::ResetKind reset{};
    Step step{};
    FileId file{};
    uint32_t line = 0;
    std::vector<Breakpoint> breakpoints{};
    std::shared_ptr<const driver::Built> built{};
    std::function<void(const controller::OnlineChangeReport&)> done{};
};

/// Carries orders to the controller. Called from any thread; must not block.
class Outlet {
public:
    virtual ~Outlet() = default;
    virtual void post(Order order) = 0;
    /// A controller that others use is not put back in time: why not.
    [[nodiscard]] virtual Error whyNotBack() const = 0;
};

class Mirror {
public:
    [[nodiscard]] static std::unique_ptr<Session> open(driver::Built built, Settings settings,
                                                       std::shared_ptr<Outlet> outlet);
    explicit Mirror(Session& session) : m(session) {}

    /// A scan that the controller made, in the program that the mirror has; recorded and shown. `outside`: what acted
    /// on it there, if anything did.
    void scanned(std::span<const std::byte> image, uint64_t scan, Nanoseconds time,
                 const image::Outside* outside = nullptr);
    /// The image where the controller stands between scans, or inside one with its frames.
    void stands(std::span<const std::byte> image, bool isHalted) { show(image, isHalted); }
    struct Figures {
        Status status; // position and fault texts as they are there
        std::vector<controller::Forced> forces;
        std::vector<controller::TaskStatistics> tasks;
        std::vector<FaultFrame> frames;
        Message haltProblem;
    };
    void told(Figures figures);
    void happened(controller::Event event);
    void refused(Error why);
    /// Another program runs there from now on.
    void programChanged(driver::Built built);

private:
    void show(std::span<const std::byte> image, bool isHalted);
    Session& m;
};

} // namespace plc::session
