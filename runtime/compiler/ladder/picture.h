// A laid out diagram as characters (for a diff, a mail, a terminal) and as SVG. Pure functions; any thread.
#pragma once
#include "runtime/compiler/ladder/layout.h"

namespace plc::ladder {

[[nodiscard]] std::string asText(const Layout& layout);
/// How contacts and coils are drawn.
enum class Symbols : uint8_t {
    Bars,    // of IEC 61131-3, as in ANSI ladders: two bars, and round coils
    Circuit, // of IEC 60617, as in circuit diagrams: a lever that closes or opens, and coils as rectangles
};

/// Follows the viewer's light or dark preference.
[[nodiscard]] std::string asSvg(const Layout& layout, std::string_view title, Symbols symbols = Symbols::Bars);

/// What the window and the SVG draw a cell with.
inline constexpr double kCellWidth = 7.3, kCellHeight = 17;

} // namespace plc::ladder
