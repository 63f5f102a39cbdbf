// One recorded scan walked through statement by statement, forwards and backwards, with the call path and the values as
// they were at that moment. Shaped as the Debug Adapter Protocol asks (stackTrace, scopes, evaluate, next, stepIn,
// stepOut, stepBack, continue, reverseContinue, goto), so that the window and an adapter stand on the same. It moves in
// a Look and touches no controller. Belongs to one thread.
#pragma once
#include "runtime/debug/breakpoint.h"
#include "runtime/inside/look.h"

namespace plc::inside {

class SlowScan {
public:
    explicit SlowScan(std::shared_ptr<const Look> look);

    [[nodiscard]] const Look& look() const { return *m_look; }
    // --- where it stands: before stop `at` of `stops`; behind the last one the scan is over
    [[nodiscard]] size_t at() const { return m_at; }
    [[nodiscard]] size_t stops() const { return m_stops.size(); }
    [[nodiscard]] bool isAtEnd() const { return m_at >= m_stops.size(); }
    /// The statement that runs next; none at the end.
    [[nodiscard]] SourceRange range() const;
    /// What has been reported before this moment: [0, event()).
    [[nodiscard]] EventIndex event() const;
    /// Of the loops around it, outermost first, from 0.
    [[nodiscard]] std::vector<uint64_t> passes() const;

    // --- what is seen there
    struct Frame {
        uint32_t id = 0; // of the activation, for scopes() and evaluate()
        std::string function, instance, task;
        SourceRange range; // of the statement that it stands at
    };
    /// Innermost first; empty at the end.
    [[nodiscard]] std::vector<Frame> stackTrace() const;
    struct Variable {
        std::string name;
        types::Value value;     // no value: not connected
        bool isChanged = false; // by what ran since the stop before
    };
    struct Scope {
        enum class Kind : uint8_t { Locals, Instance };
        Kind kind = Kind::Locals;
        std::string instance; // Instance: its path
        std::vector<Variable> variables;
    };
    [[nodiscard]] std::vector<Scope> scopes(uint32_t frame) const;
    /// An ST expression as seen from a frame, at this moment.
    [[nodiscard]] Result<types::Value> evaluate(const std::string& text, uint32_t frame);
    /// The whole image at this moment, frames included.
    [[nodiscard]] std::span<const std::byte> image() const { return m_image; }
    /// The places that what ran since the stop before has written.
    [[nodiscard]] std::vector<EventIndex> writes() const;

    // --- moving; false: it was at that end already
    bool step(debug::Step how);
    /// In: one statement back, wherever it is; Over: not into calls; Out: to the statement that called.
    bool stepBack(debug::Step how);
    struct LineOf {
        FileId file;
        uint32_t line = 1;
        bool operator==(const LineOf&) const = default;
    };
    void setBreakpoints(std::vector<LineOf> lines) { m_breakpoints = std::move(lines); }
    /// To the next statement on a line with a breakpoint, else to the end.
    bool goOn();
    /// To the one before, else to the scan's first statement.
    bool reverseContinue();
    void goTo(size_t stop);
    /// To the next statement with this text, from the start again when there is none behind.
    bool goToStatement(SourceRange statement);
    bool goToEvent(EventIndex event);
    /// To the next statement on the line, likewise.
    bool goToLine(const LineOf& line);

private:
    void findStops();
    [[nodiscard]] uint32_t activationOf(size_t stop) const;
    /// `outer` is `inner` or called it, by however many calls.
    [[nodiscard]] bool isAround(uint32_t outer, uint32_t inner) const;
    [[nodiscard]] bool ends(debug::Step how, size_t from, size_t to) const;
    [[nodiscard]] bool isBreakpoint(size_t stop) const;
    [[nodiscard]] LineOf lineOf(size_t stop) const;
    [[nodiscard]] std::vector<std::byte> imageAt(size_t stop) const;
    void apply(const Event& event, std::vector<std::byte>& image) const;
    [[nodiscard]] std::vector<Variable> variables(uint32_t frame, bool locals) const;

    std::shared_ptr<const Look> m_look;
    std::vector<EventIndex> m_stops;  // Statement events
    std::vector<EventIndex> m_writes; // Write events
    size_t m_at = 0;
    std::vector<std::byte> m_image, m_before; // now, and at the stop before
    std::vector<LineOf> m_breakpoints;
};

} // namespace plc::inside
