// PLC_ASSERT(condition, recovery): we are wrong. Tests and debug builds stop; the shipped studio logs the place
// and runs the recovery (`return`, `return {}`, `continue`), so that the user's session goes on.
#pragma once

namespace plc {
/// Writes the place to stderr; aborts in builds without NDEBUG.
void reportBrokenAssert(const char* condition, const char* file, int line);
} // namespace plc

#define PLC_ASSERT(condition, recovery)                                                                                \
    do {                                                                                                               \
        if (!(condition)) [[unlikely]] {                                                                               \
            ::plc::reportBrokenAssert(#condition, __FILE__, __LINE__);                                                 \
            recovery;                                                                                                  \
        }                                                                                                              \
    } while (false)
