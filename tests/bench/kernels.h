// The kernels of kernels/*.st in C++, as a careful programmer would write them by hand: state in a structure that lives
// on between scans, wrapping integers, the same guards (index, division, loop budget). Compiled with -O2.
#pragma once
#include <cstdint>
#include <memory>

namespace plc::bench {

struct Guards {
    int64_t budget = INT64_MAX / 2;
    int64_t timeNs = 0;
};

class Kernel {
public:
    virtual ~Kernel() = default;
    virtual void scan(Guards& guards) = 0;
    [[nodiscard]] virtual double check() const = 0;
};

/// By the name of its .st file; null when there is none.
[[nodiscard]] std::unique_ptr<Kernel> makeKernel(const char* name);

} // namespace plc::bench
