// The Debug Adapter Protocol over a Debuggee: launch and attach, breakpoints, stepping forward and back, variables. It
// knows no pipe: messages come in as texts and go out through `send`. One thread; work() is called again and again
// while the program moves.
#pragma once
#include "projects/debug_adapter/debuggee.h"
#include "projects/debug_adapter/variables.h"

#include <map>

namespace plc::dap {

class Adapter {
public:
    using Send = std::function<void(const Json& message)>;
    explicit Adapter(Send send) : m_send(std::move(send)) {}
    ~Adapter();

    void receive(const Result<std::string>& message);
    /// The program moves: work() is wanted.
    [[nodiscard]] bool hasWork() const { return m_debuggee && m_debuggee->isMoving(); }
    void work();
    [[nodiscard]] bool isOver() const { return m_isOver; }

private:
    /// The body of a response.
    using Body = Result<Json>;
    using Method = Body (Adapter::*)(const Json& arguments);
    [[nodiscard]] static Method methodOf(std::string_view name);
    [[nodiscard]] Body answer(const std::string& command, const Json& arguments);
    void respond(const Json& request, const Body& body);
    void event(std::string_view name, Json body);

    // --- life
    Body initialize(const Json& arguments);
    Body launch(const Json& arguments);
    Body attach(const Json& arguments);
    Body configurationDone(const Json& arguments);
    Body restart(const Json& arguments);
    Body disconnect(const Json& arguments);
    [[nodiscard]] Result<void> load(const Json& arguments);

    // --- breakpoints
    struct Wanted {
        uint32_t line = 1;
        std::string condition, hits;
        int64_t id = 0;
    };
    Body setBreakpoints(const Json& arguments);
    Body setExceptionBreakpoints(const Json& arguments);
    [[nodiscard]] Json place(const std::string& path, const Wanted& wanted, std::vector<debug::Breakpoint>& out) const;
    void applyBreakpoints();

    // --- moving
    Body goOn(const Json& arguments);
    Body next(const Json& arguments);
    Body stepIn(const Json& arguments);
    Body stepOut(const Json& arguments);
    Body pause(const Json& arguments);
    Body stepBack(const Json& arguments);
    Body reverseContinue(const Json& arguments);
    void stopped(const Stop& stop);
    void forget();

    // --- looking
    Body threads(const Json& arguments);
    Body stackTrace(const Json& arguments);
    Body scopes(const Json& arguments);
    Body variables(const Json& arguments);
    Body evaluate(const Json& arguments);
    Body setVariable(const Json& arguments);
    Body setExpression(const Json& arguments);
    Body exceptionInfo(const Json& arguments);
    Body source(const Json& arguments);
    [[nodiscard]] Json sourceOf(FileId file) const;
    [[nodiscard]] FileId fileOf(const std::string& path) const;
    [[nodiscard]] const std::vector<Frame>& frames();
    [[nodiscard]] std::optional<Frame> frameAt(const Json& arguments, std::string_view key);
    [[nodiscard]] std::vector<Variables::Line> linesOf(const Frame& frame, bool areLocals);
    [[nodiscard]] std::vector<Variables::Line> globals();
    [[nodiscard]] const types::TypeTable& types() const { return *m_debuggee->program().layout.types; }
    [[nodiscard]] Body written(const std::string& path, const std::string& text);

    Send m_send;
    int64_t m_sequence = 0;
    std::unique_ptr<Debuggee> m_debuggee;
    Json m_launched; // the arguments, for restart
    bool m_isAttached = false, m_isConfigured = false, m_stopsOnFaults = true, m_isOver = false;
    int64_t m_firstLine = 1, m_firstColumn = 1;          // 0 where the client counts from 0
    std::map<std::string, std::vector<Wanted>> m_wanted; // by path
    int64_t m_lastId = 0;
    Variables m_variables;
    std::optional<std::vector<Frame>> m_frames; // of the moment
    Stop m_stop;
};

} // namespace plc::dap
