// The scan that stands at a breakpoint, from inside: what it computed until there. It is not recorded yet, so it is
// made from the scan before it, and what acted from outside since then is found by holding it against the image as it
// stands. One thread, the Insight's.
#pragma once
#include "runtime/controller/fault.h"
#include "runtime/inside/look.h"

namespace plc::inside {

struct Standing {
    std::shared_ptr<const image::CompiledProgram> program;
    std::vector<std::byte> image; // as it stands
    controller::FaultFrame at;    // the innermost
};

struct StandingLook {
    std::shared_ptr<const Look> look; // of the whole scan, as it would go on
    EventIndex end = kNone;           // before which event it stands
};

/// None: the image as it stands did not come out, so nothing is said; so it is in the one scan that begins with a write
/// to a variable that the program itself writes before it stands.
[[nodiscard]] std::optional<StandingLook> lookAtStanding(Insight& insight, const Standing& standing);

} // namespace plc::inside
