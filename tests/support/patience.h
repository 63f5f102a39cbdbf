// How long a test waits for what must happen: so long that only what never happens runs out of it, on a busy machine
// and under a sanitizer as well. A test that is green waits no longer for that.
#pragma once

namespace plc {

/// Milliseconds.
#ifdef PLC_SANITIZED
inline constexpr int kPatience = 300'000;
#else
inline constexpr int kPatience = 60'000;
#endif

} // namespace plc
