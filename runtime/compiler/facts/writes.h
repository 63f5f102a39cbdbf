// What functions may write besides their own locals: loops keep in registers what their calls leave alone. Made once
// per program; immutable afterwards.
#pragma once
#include "runtime/compiler/tree/tree.h"

namespace plc::facts {

/// What a function may write besides its own locals, callees included; IN_OUT parameters count where they are bound.
struct WriteSummary {
    struct Extent {
        uint32_t begin = 0, end = 0;
    };
    bool anything = false; // through pointers, slots, dispatched calls
    bool instance = false; // of THIS
    std::vector<Extent> absolutes;
    void addAbsolute(Extent extent);
};

/// The bytes a place may touch, from the start of its root: all of an indexed array. False when they are not fixed to
/// THIS or the image.
bool extentOf(const types::TypeTable& types, const tree::Place& place, WriteSummary::Extent& extent);

/// The writes of this function's own statements, without its callees'.
[[nodiscard]] WriteSummary ownWrites(const tree::Program& program, uint32_t function);

} // namespace plc::facts
