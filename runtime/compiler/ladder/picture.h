// A laid out diagram as characters (for a diff, a mail, a terminal) and as SVG. Pure functions; any thread.
#pragma once
#include "runtime/compiler/ladder/layout.h"

namespace plc::ladder {

[[nodiscard]] std::string asText(const Layout& layout);
/// Follows the viewer's light or dark preference.
[[nodiscard]] std::string asSvg(const Layout& layout, std::string_view title);

/// What the window and the SVG draw a cell with.
inline constexpr double kCellWidth = 7.3, kCellHeight = 17;

} // namespace plc::ladder
