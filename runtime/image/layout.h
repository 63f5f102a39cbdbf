// THE CONTRACT between compiler and controller, part 1: what lies where in the process image (D1).
// A Layout maps paths such as `Main.pid.q_rOput` or `GVL.Speed[3].5` to places. Owned by the CompiledProgram;
// immutable, any thread may read.
//
//   0         ImageHeader
//   …         input area %I, output area %Q, memory area %M: flat addresses, then the places of hierarchical ones
//   …         globals, program instances                       ← declared variables, all recorded
//   dataEnd   frame area: locals of functions and VAR_TEMP whose address can be taken; not recorded, not retained
#pragma once
#include "runtime/base/result.h"
#include "runtime/image/address.h"
#include "runtime/types/value.h"

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace plc::image {

/// At offset 0 of every image. Programs read the clock here; the controller writes it before each scan.
struct ImageHeader {
    int64_t timeNs = 0;        // PLC clock: nanoseconds since the first scan
    int64_t calendarNs = 0;    // calendar at this scan: nanoseconds since 1970-01-01
    uint64_t scan = 0;         // number of this scan, from 0
    uint64_t taskPeriodNs = 0; // period of the task that runs now (0: freewheeling or event)
    uint32_t firstScan = 1;    // 1 in the first scan after a start or reset
    uint32_t reserved[7] = {};
};
static_assert(sizeof(ImageHeader) == 64);

/// A place in the image. `bit` ≥ 0: one bit of the byte at offset.
struct Place {
    types::TypeId type;
    uint32_t offset = 0;
    int16_t bit = -1;
    bool operator==(const Place&) const = default;
};

/// A variable at the top of the path tree: a global, a program instance, or a located variable.
struct Root {
    std::string name;  // "Speed", "Main"
    std::string list;  // global list: "GVL"; empty for programs and unnamed lists
    std::string space; // namespace, for library globals
    types::TypeId type;
    uint32_t offset = 0;
    int16_t bit = -1;
    Area area = Area::Global;
    bool retain = false;
    bool persistent = false;
    bool constant = false;
    bool isSimulation = false; // program instance with {attribute 'simulation'}
    bool isHidden = false;     // compiler-made
    std::string programType;   // of a program instance: its PROGRAM's name
    std::string address;       // "%QX0.1" of a located variable
    SourceRange declaration;
    std::string comment;
};

struct AreaRange {
    uint32_t begin = 0;
    uint32_t size = 0;
};

/// %IW3.1, %QX1.2.3: a place of its own behind the flat addresses of its area. What its numbers mean is for the devices
/// of the project: they find it here by its name.
struct HierarchicalAddress {
    std::string name; // image::hierarchicalName
    Place place;
    Area area = Area::Input;
    uint32_t size = 0; // bytes; more than the type's when a variable of another type is located there
};

class Layout {
public:
    std::shared_ptr<types::TypeTable> types;
    std::vector<Root> roots; // in order of declaration
    AreaRange inputs, outputs, memory;
    Addressing addressing = Addressing::Bytes;
    std::vector<HierarchicalAddress> hierarchical; // by name
    uint32_t dataEnd = 0;                          // end of declared variables: what history, retain and pointers see
    uint32_t frameBegin = 0;                       // 64-byte aligned
    uint32_t imageSize = 0;

    /// Resolves a path without case: `Main.x`, `GVL.a[2,3].b`, `x.5` (bit), `%QX0.1`, program type names where there is
    /// one instance, pin aliases. Errors name the unknown part and a near match.
    [[nodiscard]] Result<Place> find(std::string_view path) const;
    /// The longest path whose place covers `offset` (for pointers, online change and fault messages); "" when none.
    [[nodiscard]] std::string pathAt(uint32_t offset, types::TypeId wanted = {}) const;
    /// Visits every scalar (and text) under `place` with its path; arrays element by element. The visitor returns false
    /// to stop.
    void forEachLeaf(const std::string& path, Place place,
                     const std::function<bool(const std::string&, const Place&)>& visit) const;
    /// The path of a root: "Main", "GVL.Speed", "Ns.GVL.Speed"; its address when it has no name.
    [[nodiscard]] static std::string pathOf(const Root& root);
    /// "%IX0.0", "%QW4", "%MD48", "%IW3.1" → place (BOOL, BYTE, WORD, DWORD, LWORD).
    [[nodiscard]] Result<Place> address(std::string_view text) const;
    /// The bytes of an area that flat addresses count; hierarchical ones follow.
    [[nodiscard]] uint32_t flatSize(Area area) const;
};

} // namespace plc::image
