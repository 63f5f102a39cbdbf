// Where the locals of functions lie in the frame area of the image. Pure functions over the checked tree; any thread.
#pragma once
#include "runtime/base/result.h"
#include "runtime/compiler/tree/tree.h"

namespace plc::facts {

/// Where the locals of a function lie in its frame. Text and aggregate result first, then text and aggregate parameters
/// in order (so that every implementation of a method agrees about them), then the rest.
struct FrameLayout {
    std::vector<uint32_t> offsets; // by local; kNoFrame = in a register. Right up to kMaximumFrame
    uint64_t size = 0;             // may be more: then the program is refused
};
inline constexpr uint32_t kNoFrame = 0xffffffffu;
/// The image ends there, so no frame can be longer.
inline constexpr uint64_t kMaximumFrame = uint64_t(1) << 30;
[[nodiscard]] FrameLayout layFrameOut(const types::TypeTable& types, const tree::Function& function,
                                      const std::vector<bool>& inMemory);
/// What the frame area of the image holds.
[[nodiscard]] uint64_t frameRoom(const tree::Program& program);
/// The error of a program whose locals do not fit: `function`, with what it calls, needs so many bytes.
[[nodiscard]] Error tooLarge(const tree::Program& program, uint32_t function, uint64_t bytes);
[[nodiscard]] bool isScalar(const types::TypeTable& types, types::TypeId type);
[[nodiscard]] uint32_t slotSize(const types::TypeTable& types, const tree::Local& local);

} // namespace plc::facts
