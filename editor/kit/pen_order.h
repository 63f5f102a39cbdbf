// The order in which a pen passes the four values of a pixel column: without it a falling curve would be drawn up and
// down again in every column and become a band. Pure C++, any thread.
#pragma once

#include <array>
#include <cstddef>

namespace plc::kit {

/// First, the extremes, last; each once, the extreme that lies against the way of the curve first.
class PenOrder {
public:
    PenOrder(double first, double minimum, double maximum, double last) {
        add(first);
        const bool falls = last < first;
        add(falls ? maximum : minimum);
        add(falls ? minimum : maximum);
        add(last);
    }
    // A range itself, so that one made in the head of a loop lives as long as the loop.
    [[nodiscard]] const double* begin() const { return m_values.data(); }
    [[nodiscard]] const double* end() const { return m_values.data() + m_count; }

private:
    void add(double value) {
        if (m_count == 0 || m_values[m_count - 1] != value) m_values[m_count++] = value;
    }
    std::array<double, 4> m_values{};
    size_t m_count = 0;
};

} // namespace plc::kit
