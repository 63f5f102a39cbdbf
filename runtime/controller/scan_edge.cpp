// Where devices touch the image: between two scans, on the scan thread. What they write is noted for the journal with
// its origin, and a forced place keeps its value.
#include "runtime/controller/scan_edge.h"

#include "runtime/controller/controller_state.h"

namespace plc::controller {

using image::OutsideKind;

namespace {

/// More changes than this in one scan are noted as one of many places: the journal keeps their bytes all the same.
constexpr uint32_t kNotesOfAScan = 64;

} // namespace

class Controller::State_::Edge final : public EdgeWriter {
public:
    explicit Edge(State_& state) : m_state(state) {}
    void put(const image::Place& place, std::span<const std::byte> bytes, const std::string& origin) override;
    void fault(Message why) override {
        // The first of several stops the controller; while it is stopped anyway nothing is to be said.
        if (problem.isEmpty() && plcRuns()) problem = std::move(why);
    }
    [[nodiscard]] bool plcRuns() const override { return m_state.plcRuns(); }

    Message problem;

private:
    [[nodiscard]] bool isHeld(const image::Place& place) const {
        return !m_state.forces.isEmpty() && m_state.forces.overlapping(*m_state.layout().types, place) != nullptr;
    }
    State_& m_state;
    uint32_t m_noted = 0;
};

void Controller::State_::Edge::put(const image::Place& place, std::span<const std::byte> bytes,
                                   const std::string& origin) {
    std::byte* at = m_state.image.get() + place.offset;
    if (place.bit >= 0) {
        const auto mask = std::byte(1u << static_cast<unsigned>(place.bit));
        const std::byte wanted = bytes[0] != std::byte{} ? *at | mask : *at & ~mask;
        // Unchanged is no write: otherwise every poll would fill the journal.
        if (wanted == *at || isHeld(place)) return;
        *at = wanted;
    } else {
        if (std::memcmp(at, bytes.data(), bytes.size()) == 0 || isHeld(place)) return;
        std::memcpy(at, bytes.data(), bytes.size());
    }
    markWritten(m_state.dirtyPages, place.offset, place.bit >= 0 ? 1 : static_cast<uint32_t>(bytes.size()));
    // The last note that is made is for all further ones.
    if (++m_noted > kNotesOfAScan) return;
    m_state.origin = origin;
    if (m_noted < kNotesOfAScan)
        m_state.touch(OutsideKind::Write, place);
    else
        m_state.touch(OutsideKind::Write);
    m_state.origin.clear();
}

bool Controller::State_::letDevicesIn() {
    Edge writer(*this);
    exit.edge->beforeScan(writer);
    if (writer.problem.isEmpty()) return true;
    enterFaultFromOutside(std::move(writer.problem));
    return false;
}

/// No scan is made with inputs that the program must not run with.
void Controller::State_::enterFaultFromOutside(Message why) {
    Fault f;
    f.message = std::move(why);
    // The last scan that was made: the fault is seen before the next one begins.
    f.scan = scan > 0 ? scan - 1 : 0;
    f.time = Nanoseconds(header().timeNs);
    Message text = f.message;
    touch(OutsideKind::Fault, "devices");
    fault = std::move(f);
    state = State::Fault;
    makeOutputsSafe();
    report(EventKind::Fault, std::move(text));
}

void setScanEdge(Controller& controller, ScanEdge* edge) {
    static_cast<FaultExit*>(controller.context().owner)->edge = edge;
}

} // namespace plc::controller
