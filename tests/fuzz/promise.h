// A promise that is not kept ends the process: libFuzzer and the test runner both see that.
#pragma once
#include <cstdlib>

namespace plc::fuzz {

inline void promise(bool kept) {
    if (!kept) std::abort();
}

} // namespace plc::fuzz
