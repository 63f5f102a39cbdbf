// Direct addresses as they are written: %IX0.7, %MW4, %QX1.2.3, %M*. Pure functions over text; the compiler, the
// layout's paths and the exchange with other tools read addresses here.
#pragma once
#include "runtime/types/value.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace plc::image {

enum class Area : uint8_t { Header, Input, Output, Memory, Global, Program, Frame };

/// What the number of %MW1 counts: bytes, or (CODESYS, Beremiz, OpenPLC) elements of the size its letter says, so that
/// %MW1 is in %MB2 and %MB3. Bits are %MX<byte>.<bit> in both.
enum class Addressing : uint8_t { Bytes, Words };

/// A place of an area. `bit` ≥ 0: one bit of the byte.
struct DirectAddress {
    Area area = Area::Input;
    types::TypeKind kind = types::TypeKind::Bool;
    uint32_t byte = 0;
    int16_t bit = -1;
    bool isOpen = false;         // %I*
    bool isHierarchical = false; // %IW3.1, %QX1.2.3: `byte` says nothing, Layout::hierarchical has its place
};

[[nodiscard]] std::optional<DirectAddress> parseAddress(std::string_view text, Addressing addressing);
/// "%MW4" of a flat address in that way of counting; nothing when no number says it (%MW of an odd byte in words).
[[nodiscard]] std::optional<std::string> addressText(const DirectAddress& address, Addressing addressing);
/// One spelling of each hierarchical address: "%IX1.2.3" for "%i01.2.3".
[[nodiscard]] std::string hierarchicalName(std::string_view text);

} // namespace plc::image
