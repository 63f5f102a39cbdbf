// Writes that wait for their scan: writes to one variable keep their order, one per scan, and the release of a
// momentary button waits until every cyclic task has run once with the press. Scan thread.
#pragma once
#include "projects/session/run.h"

#include <deque>

namespace plc::session {

class WriteQueue {
public:
    void write(Target target, types::Value value, std::string origin = {}) {
        m_fresh.push_back({Kind::Write, std::move(target), std::move(value), {}, std::move(origin)});
    }
    void press(Target target, types::Value pressed, types::Value released, std::string origin = {}) {
        m_fresh.push_back({Kind::Press, std::move(target), std::move(pressed), std::move(released), std::move(origin)});
    }
    void release(Target target) { m_fresh.push_back({Kind::Release, std::move(target), {}, {}, {}}); }
    [[nodiscard]] bool isEmpty() const { return m_fresh.empty() && m_lanes.empty(); }
    /// At a scan boundary: carries out what may be. `areScansComing`: else nothing has to wait. Refusals go to
    /// `refusals`.
    void apply(controller::Controller& controller, bool areScansComing, std::vector<Error>& refusals);

private:
    enum class Kind : uint8_t { Write, Press, Release };
    struct Request {
        Kind kind;
        Target target;
        types::Value value, released;
        std::string origin;
    };
    /// Requests to one variable, or to variables that share bytes.
    struct Lane {
        std::vector<image::Place> places;
        std::deque<Request> waiting;
        uint64_t writtenBefore = ~uint64_t(0); // number of the scan that gets, or got, its last write
    };
    struct Held {
        std::string path;
        image::Place place;
        types::Value released;
        std::string origin;
        std::vector<uint64_t> runs; // of the cyclic tasks at the press
    };
    void sortIn(const image::CompiledProgram& program, Request request, std::vector<Error>& refusals);
    void rebind(const image::CompiledProgram& program, std::vector<Error>& refusals);
    /// False: it has to wait.
    [[nodiscard]] bool carryOut(Request& request, controller::Controller& controller, bool areScansComing,
                                std::vector<Error>& refusals);

    std::deque<Request> m_fresh;
    std::vector<Lane> m_lanes;
    std::vector<Held> m_held;
    const image::CompiledProgram* m_program = nullptr; // that the places belong to
};

} // namespace plc::session
