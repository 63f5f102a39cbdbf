// Breakpoints, stepping and halting. Belongs to the scan thread with the Controller it watches; the thread's owner says
// through `onHalt` how commands are served while it stands.
#pragma once
#include "runtime/controller/controller.h"
#include "runtime/debug/breakpoint.h"
#include "runtime/debug/sites.h"

namespace plc::debug {

/// Why and where the scan stands.
struct Halt {
    uint32_t site = 0;
    std::optional<size_t> breakpoint;           // index into the list; none: a step or run to cursor
    Message problem;                            // a condition that cannot be evaluated, in words
    std::vector<controller::FaultFrame> frames; // innermost first
};

/// How the scan goes on.
enum class Going : uint8_t { On, Abandon };

class Debugger {
public:
    /// Makes a condition, seen from the instance path.
    using Compile = std::function<Result<expression::Expression>(const std::string& text, const std::string& instance)>;
    /// Serves commands until the scan shall go on; may call step(), runTo() and setBreakpoints() meanwhile.
    using OnHalt = std::function<Going(const Halt& halt)>;

    Debugger(controller::Controller& controller, Compile compile, OnHalt onHalt);
    ~Debugger();

    void setBreakpoints(std::vector<Breakpoint> breakpoints);
    /// After an online change or going back: places are found again.
    void programChanged();
    [[nodiscard]] bool isHalted() const { return m_isHalted; }

    // How the scan goes on after a halt (or, while running, at the next statement).
    void resume();
    void step(Step step);
    void runTo(FileId file, uint32_t line);

private:
    enum class Mode : uint8_t { Free, In, Over, Out, ToLine };
    struct Active {
        size_t index = 0; // in m_breakpoints
        uint32_t hits = 0;
        std::optional<uint32_t> instance; // its offset
        std::vector<uint32_t> sites;
        std::vector<std::pair<uint32_t, expression::Expression>> conditions; // by instance offset
    };

    void atSite(uint32_t site, uint32_t instance);
    void halt(Halt halt);
    [[nodiscard]] bool stepEnds(uint32_t site) const;
    [[nodiscard]] std::optional<Halt> breakpointHit(uint32_t site, uint32_t instance);
    [[nodiscard]] bool conditionHolds(Active& active, uint32_t site, uint32_t instance, Message& problem);
    void markSites();

    controller::Controller& m_controller;
    Compile m_compile;
    OnHalt m_onHalt;
    std::vector<Breakpoint> m_breakpoints;
    std::vector<Active> m_active;
    bool m_isHalted = false;

    Mode m_mode = Mode::Free;
    std::vector<uint32_t> m_target; // ToLine
    uint32_t m_fromDepth = 0;       // where the step began
    uint64_t m_fromScan = 0;
    image::CallRecord m_fromEntry;
};

} // namespace plc::debug
