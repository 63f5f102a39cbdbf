// A value on its way between a device and a variable: the numbers a device speaks, and the bytes they are in the image.
// Values and pure functions; encoding numbers allocates nothing, so the scan thread may do it.
#pragma once
#include "projects/devices/configuration/device.h"
#include "runtime/image/layout.h"

#include <cstddef>
#include <span>

namespace plc::devices {

struct Sample {
    enum class Kind : uint8_t { None, Integer, Unsigned /* the bit pattern in `integer` */, Real, Text /* UTF-8 */ };
    Kind kind = Kind::None;
    int64_t integer = 0;
    double real = 0;
    std::string text;

    [[nodiscard]] static Sample of(int64_t number) { return {Kind::Integer, number, 0, {}}; }
    [[nodiscard]] static Sample ofUnsigned(uint64_t number) {
        return {Kind::Unsigned, static_cast<int64_t>(number), 0, {}};
    }
    [[nodiscard]] static Sample of(double number) { return {Kind::Real, 0, number, {}}; }
    [[nodiscard]] static Sample ofText(std::string utf8) { return {Kind::Text, 0, 0, std::move(utf8)}; }
    [[nodiscard]] bool isNumber() const { return kind != Kind::None && kind != Kind::Text; }
    [[nodiscard]] double number() const; // of a number
    /// For people: "12", "0.5", "text"; "" for none.
    [[nodiscard]] std::string shown() const;
    bool operator==(const Sample&) const = default;
};

/// A variable that a channel, a quality or a state is mapped to.
struct Target {
    image::Place place;
    types::TypeKind kind{}; // that stores it
    types::Family family{};
    uint32_t size = 0; // bytes; a bit has 1
    uint32_t capacity = 0;
    types::StringCode strings{};                      // what the bytes of a STRING are
    std::optional<std::pair<int64_t, int64_t>> range; // of a subrange
    bool takesRealBits = false;                       // a bit string of the size of the device's REAL: gets its bits
    std::string typeName;
};

/// The variable of a path or address; an address has the type of the variable that is located there. Only types that a
/// channel can carry have one: BOOL, numbers, TIME, STRING, and enums and subranges of them.
[[nodiscard]] Result<Target> resolve(const image::Layout& layout, const std::string& path, WireType wire);
/// The type alone does not fit, whatever the value; and: a value may not.
[[nodiscard]] bool canCarry(const Channel& channel, const Target& target);
[[nodiscard]] bool mayNotFit(const Channel& channel, const Target& target);

/// The bytes of the variable, target.size of them; false: it does not fit.
[[nodiscard]] bool encode(const Sample& sample, const Target& target, std::span<std::byte> into);
/// What the image holds there (at the variable's offset).
[[nodiscard]] Sample decode(const Target& target, std::span<const std::byte> image);

} // namespace plc::devices
