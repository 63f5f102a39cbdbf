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

void WriteQueue::sortIn(const image::CompiledProgram& program, Request request, std::vector<Error>& refusals) {
    const image::Layout& layout = program.layout;
    if (request.target.program.get() != &program) { // not looked up yet, or for another version
        const Result<image::Place> found = layout.find(request.target.path);
        if (!found) {
            refusals.push_back({found.error().message, request.target.path});
            return;
        }
        request.target.place = *found;
    }
    const image::Place place = request.target.place;
    const auto sharesBytes = [&](const image::Place& other) { return overlap(*layout.types, other, place); };
    auto lane = std::find_if(m_lanes.begin(), m_lanes.end(),
                             [&](const Lane& l) { return std::any_of(l.places.begin(), l.places.end(), sharesBytes); });
    if (lane == m_lanes.end()) lane = m_lanes.insert(m_lanes.end(), Lane{});
    if (std::find(lane->places.begin(), lane->places.end(), place) == lane->places.end()) lane->places.push_back(place);
    lane->waiting.push_back(std::move(request));
}

/// The program was exchanged: the paths are looked up again.
void WriteQueue::rebind(const image::CompiledProgram& program, std::vector<Error>& refusals) {
    m_program = &program;
    std::vector<Lane> lanes = std::exchange(m_lanes, {});
    for (Held& held : m_held) {
        const Result<image::Place> place = program.layout.find(held.path);
        held.place = place ? *place : image::Place{};
    }
    for (Lane& lane : lanes)
        for (Request& request : lane.waiting) sortIn(program, std::move(request), refusals);
}

void WriteQueue::apply(controller::Controller& controller, bool areScansComing, std::vector<Error>& refusals) {
    if (isEmpty()) return;
    if (&controller.program() != m_program) rebind(controller.program(), refusals);
    for (; !m_fresh.empty(); m_fresh.pop_front()) sortIn(controller.program(), std::move(m_fresh.front()), refusals);
    const uint64_t next = controller.nextScan();
    for (Lane& lane : m_lanes) {
        while (!lane.waiting.empty() && (!areScansComing || lane.writtenBefore != next)) {
            if (!carryOut(lane.waiting.front(), controller, areScansComing, refusals)) break;
            lane.waiting.pop_front();
            lane.writtenBefore = next;
        }
    }
    std::erase_if(m_lanes, [&](const Lane& lane) {
        return lane.waiting.empty() && (!areScansComing || lane.writtenBefore != next);
    });
}

bool WriteQueue::carryOut(Request& request, controller::Controller& controller, bool areScansComing,
                          std::vector<Error>& refusals) {
    const auto held =
        std::find_if(m_held.begin(), m_held.end(), [&](const Held& h) { return h.place == request.target.place; });
    types::Value value = request.value;
    if (request.kind == Kind::Release) {
        if (held == m_held.end()) return true; // the press was refused
        if (areScansComing && !allRanSince(held->runs, controller.cyclicRuns())) return false;
        value = held->released;
        request.origin = held->origin;
    }
    if (held != m_held.end()) m_held.erase(held);
    controller.actFor(request.origin);
    const Result<void> done = controller.write(request.target.path, request.target.place, value);
    controller.actFor({});
    if (!done)
        refusals.push_back(done.error());
    else if (request.kind == Kind::Press)
        m_held.push_back(
            {request.target.path, request.target.place, request.released, request.origin, controller.cyclicRuns()});
    return true;
}

} // namespace plc::session
