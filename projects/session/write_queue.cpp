#include "projects/session/write_queue.h"

#include <algorithm>

namespace plc::session {

namespace {

bool overlap(const types::TypeTable& types, const image::Place& a, const image::Place& b) {
    const uint32_t sizeA = a.bit >= 0 ? 1 : types[a.type].size;
    const uint32_t sizeB = b.bit >= 0 ? 1 : types[b.type].size;
    if (a.offset + sizeA <= b.offset || b.offset + sizeB <= a.offset) return false;
    return a.bit < 0 || b.bit < 0 || a.bit == b.bit;
}

bool allRanSince(const std::vector<uint64_t>& before, const std::vector<uint64_t>& now) {
    if (before.size() != now.size()) return true; // other tasks since an online change
    for (size_t i = 0; i < now.size(); ++i)
        if (now[i] <= before[i]) return false;
    return true;
}

} // namespace

void WriteQueue::apply(controller::Controller& controller, bool areScansComing, std::vector<std::string>& refusals) {
    if (m_waiting.empty()) return;
    if (controller.nextScan() != m_touchedScan) m_touched.clear();
    m_touchedScan = controller.nextScan();
    const types::TypeTable& types = *controller.program().layout.types;
    std::deque<Waiting> later;
    while (!m_waiting.empty()) {
        Waiting request = std::move(m_waiting.front());
        m_waiting.pop_front();
        const Result<image::Place> place = controller.program().layout.find(request.path);
        if (!place) {
            refusals.push_back(request.path + ": " + place.error().message);
            continue;
        }
        const bool isTaken = areScansComing && std::any_of(m_touched.begin(), m_touched.end(), [&](const image::Place& p) { return overlap(types, p, *place); });
        // What waits holds up whatever is written to the same variable after it.
        m_touched.push_back(*place);
        if (isTaken || carryOut(request, *place, controller, areScansComing, refusals) == Outcome::Wait) later.push_back(std::move(request));
    }
    m_waiting = std::move(later);
}

WriteQueue::Outcome WriteQueue::carryOut(Waiting& request, const image::Place& place, controller::Controller& controller, bool areScansComing, std::vector<std::string>& refusals) {
    const auto held = std::find_if(m_held.begin(), m_held.end(), [&](const Held& h) { return h.place == place; });
    types::Value value = request.value;
    if (request.kind == Kind::Release) {
        if (held == m_held.end()) return Outcome::Done; // the press was refused
        if (areScansComing && !allRanSince(held->runs, controller.cyclicRuns())) return Outcome::Wait;
        value = held->released;
    }
    if (held != m_held.end()) m_held.erase(held);
    const Result<void> done = controller.write(request.path, value);
    if (!done) refusals.push_back(done.error().text());
    else if (request.kind == Kind::Press) m_held.push_back({place, request.released, controller.cyclicRuns()});
    return Outcome::Done;
}

} // namespace plc::session
