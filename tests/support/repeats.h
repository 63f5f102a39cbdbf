// How often a test does again what only figures or chance need. Sanitizers find on the first ways what they find, and
// take ten to thirty times as long.
#pragma once
#include <algorithm>

namespace plc {

#ifdef PLC_SANITIZED
inline constexpr int kFewer = 6;
#else
inline constexpr int kFewer = 1;
#endif

/// At least one.
template <class Number> constexpr Number repeats(Number full) {
    return std::max(Number{1}, full / static_cast<Number>(kFewer));
}

} // namespace plc
