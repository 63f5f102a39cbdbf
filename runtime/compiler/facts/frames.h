// Where the locals of functions lie in the frame area of the image. Pure functions over the checked tree; any thread.
#pragma once
#include "runtime/compiler/tree/tree.h"

namespace plc::facts {

/// Where the locals of a function lie in its frame. Text and aggregate result first, then text and aggregate parameters
/// in order (so that every implementation of a method agrees about them), then the rest.
struct FrameLayout {
    std::vector<uint32_t> offsets; // by local; kNoFrame = in a register
    uint32_t size = 0;
};
inline constexpr uint32_t kNoFrame = 0xffffffffu;
[[nodiscard]] FrameLayout layFrameOut(const types::TypeTable& types, const tree::Function& function,
                                      const std::vector<bool>& inMemory);
[[nodiscard]] bool isScalar(const types::TypeTable& types, types::TypeId type);
[[nodiscard]] uint32_t slotSize(const types::TypeTable& types, const tree::Local& local);

} // namespace plc::facts
