// THE CONTRACT, part 4: what enters a scan from outside (D13). The controller says it before the scan, the history
// keeps it with the scan: image n-1, what is said here and the clock give image n, bit for bit. Plain data; made on the
// scan thread, only for scans that something from outside acted on.
#pragma once
#include "runtime/image/layout.h"

#include <cstdint>
#include <string>
#include <vector>

namespace plc::image {

enum class OutsideKind : uint8_t {
    Write,
    Force,
    Release,
    ReleaseAll,
    Started,
    Stopped, // outputs went to their safe state
    Paused,
    Fault, // outputs went to their safe state
    Reset,
    OnlineChange,
    Resumed, // from a recorded scan
    Retain,  // retained values came back
    Function // a statement of a test ran
};

/// One thing that acted from outside. Its bytes are in the patch of the scan; only what acted while the scan stood at a
/// breakpoint carries its own.
struct OutsideNote {
    OutsideKind kind{};
    uint32_t offset = 0, size = 0; // what was written or forced; size 0: many places
    int16_t bit = -1;
    std::string text;   // of a release: the path; of a reset: its kind
    std::string origin; // "panel Main, button Start"; empty: not said
    uint32_t site = 0;  // not 0: the scan stood before this statement
    uint32_t instance = 0;
    std::vector<std::byte> bytes;
    bool operator==(const OutsideNote&) const = default;
};

/// Bytes that are held, applied twice in each scan.
struct ForcedBytes {
    uint32_t offset = 0, size = 0;
    int16_t bit = -1;
    std::string path;
    std::vector<std::byte> bytes;
    bool operator==(const ForcedBytes&) const = default;
};

/// What a scan depends on beside the image and the program.
struct ScanStart {
    bool plcRuns = false;
    bool isFirst = true, isSimulationFirst = true;
    bool hasSimulationFault = false;
    int64_t timeBefore = -1;                        // of the last scan; -1: none
    uint64_t pendingEvents = 0, triggersBefore = 0; // event tasks, a bit each
    std::vector<ForcedBytes> forces;
    bool operator==(const ScanStart&) const = default;
};

/// Something acted since the scan before; said when the next scan begins.
struct Outside {
    std::span<const std::byte> image;      // the scan starts from it
    std::span<const uint8_t> touchedPages; // a byte for each kDirtyPage; empty: it may differ anywhere
    const ScanStart& start;
    std::span<const OutsideNote> notes;
};

} // namespace plc::image
