// Durations as other tools write them, as literals of TIME. Pure functions, any thread.
#pragma once
#include <string>
#include <string_view>

namespace plc::exchange {

/// "T#50ms" of "PT0.05S", "t#50ms", or "50" with the unit "ms"; empty when it is no duration.
[[nodiscard]] std::string durationText(std::string_view text, std::string_view unit = {});

} // namespace plc::exchange
