// Typed index into a vector: an id is a word of its own type, so a step cannot be passed where a task is meant.
// A default id is "none". Values, no owner, any thread.
#pragma once
#include <compare>
#include <cstdint>
#include <functional>

namespace plc {

template <class Tag> struct Id {
    static constexpr uint32_t kNone = 0xffffffffu;
    uint32_t value = kNone;

    constexpr Id() = default;
    constexpr explicit Id(uint32_t index) : value(index) {}
    constexpr explicit Id(size_t index) : value(static_cast<uint32_t>(index)) {}
    constexpr explicit Id(int index) : value(static_cast<uint32_t>(index)) {}
    [[nodiscard]] constexpr bool isValid() const { return value != kNone; }
    [[nodiscard]] constexpr size_t index() const { return value; }
    constexpr auto operator<=>(const Id&) const = default;
};

} // namespace plc

template <class Tag> struct std::hash<plc::Id<Tag>> {
    size_t operator()(plc::Id<Tag> id) const noexcept { return std::hash<uint32_t>()(id.value); }
};
