// Writes that wait for their scan: writes to one variable keep their order, one per scan, and the release of a momentary button waits until
// every cyclic task has run once with the press. Scan thread.
#pragma once
#include "runtime/controller/controller.h"

#include <deque>

namespace plc::session {

class WriteQueue {
public:
    void write(std::string path, types::Value value) { m_waiting.push_back({Kind::Write, std::move(path), std::move(value), {}}); }
    void press(std::string path, types::Value pressed, types::Value released) { m_waiting.push_back({Kind::Press, std::move(path), std::move(pressed), std::move(released)}); }
    void release(std::string path) { m_waiting.push_back({Kind::Release, std::move(path), {}, {}}); }
    [[nodiscard]] bool isEmpty() const { return m_waiting.empty(); }
    /// At a scan boundary: carries out what may be. `areScansComing`: else nothing has to wait. Refusals go to `refusals`.
    void apply(controller::Controller& controller, bool areScansComing, std::vector<std::string>& refusals);

private:
    enum class Kind : uint8_t { Write, Press, Release };
    struct Waiting {
        Kind kind;
        std::string path;
        types::Value value, released;
    };
    struct Held {
        image::Place place;
        types::Value released;
        std::vector<uint64_t> runs; // of the cyclic tasks at the press
    };
    enum class Outcome : uint8_t { Done, Wait };
    [[nodiscard]] Outcome carryOut(Waiting& request, const image::Place& place, controller::Controller& controller, bool areScansComing, std::vector<std::string>& refusals);

    std::deque<Waiting> m_waiting;
    std::vector<Held> m_held;
    std::vector<image::Place> m_touched; // written before the coming scan, which has this number
    uint64_t m_touchedScan = ~uint64_t(0);
};

} // namespace plc::session
