#include "runtime/base/assert.h"

#include <cstdio>
#include <cstdlib>

namespace plc {

void reportBrokenAssert(const char* condition, const char* file, int line) {
    std::fprintf(stderr, "stepwise: internal error: %s (%s:%d)\n", condition, file, line);
#ifndef NDEBUG
    std::abort();
#endif
}

} // namespace plc
