#include "tests/bench/kernels.h"

#include "runtime/library/text_runtime.h"
#include "runtime/types/type.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace plc::bench {

namespace {

// ---------------------------------------------------------------- guards

[[noreturn, gnu::cold, gnu::noinline]] void fault(const char* what, int64_t a, int64_t b, int64_t c) {
    std::fprintf(stderr, "%s %ld %ld %ld\n", what, static_cast<long>(a), static_cast<long>(b), static_cast<long>(c));
    std::abort();
}
[[gnu::cold, gnu::noinline]] void budgetUsedUp(Guards&) { fault("watchdog", 0, 0, 0); }

inline void charge(Guards& g, int64_t passes) {
    g.budget -= passes;
    if (g.budget < 0) [[unlikely]]
        budgetUsedUp(g);
}
inline size_t at(int64_t index, int64_t low, int64_t high) {
    if (index < low || index > high) [[unlikely]]
        fault("index", index, low, high);
    return static_cast<size_t>(index - low);
}
inline int32_t add(int32_t a, int32_t b) {
    return static_cast<int32_t>(static_cast<uint32_t>(a) + static_cast<uint32_t>(b));
}
inline int32_t sub(int32_t a, int32_t b) {
    return static_cast<int32_t>(static_cast<uint32_t>(a) - static_cast<uint32_t>(b));
}
inline int32_t mul(int32_t a, int32_t b) {
    return static_cast<int32_t>(static_cast<uint32_t>(a) * static_cast<uint32_t>(b));
}
inline int32_t quotient(int32_t a, int32_t b) {
    if (b == 0) [[unlikely]]
        fault("division", 0, 0, 0);
    return b == -1 ? sub(0, a) : a / b;
}
inline int32_t remainder(int32_t a, int32_t b) {
    if (b == 0) [[unlikely]]
        fault("division", 0, 0, 0);
    return b == -1 ? 0 : a % b;
}

// ---------------------------------------------------------------- kernels

class Integer : public Kernel {
public:
    void scan(Guards& g) override {
        if (m_n >= 1) charge(g, m_n);
        for (m_i = 1; m_i <= m_n; ++m_i) {
            m_x ^= m_x << 13;
            m_x ^= m_x >> 17;
            m_x ^= m_x << 5;
            m_divisor = add(static_cast<int32_t>(m_x & 15), 1);
            m_sum = sub(add(m_sum, static_cast<int32_t>(m_x % 1000)), quotient(m_i, m_divisor));
        }
        m_check = m_sum;
    }
    double check() const override { return m_check; }

private:
    int32_t m_i = 0, m_n = 20000;
    uint32_t m_x = 2463534242;
    int32_t m_divisor = 0, m_sum = 0, m_check = 0;
};

class Real : public Kernel {
public:
    void scan(Guards& g) override {
        charge(g, 1000);
        for (m_i = 0; m_i <= 999; ++m_i) {
            m_phase = m_phase + 0.0123f;
            if (m_phase > 3.0f) m_phase = m_phase - 6.0f;
            m_samples[at(m_i, 0, 999)] =
                ((((0.00833f * m_phase * m_phase) - 0.16667f) * m_phase * m_phase) + 1.0f) * m_phase;
        }
        charge(g, 1000);
        for (m_i = 0; m_i <= 999; ++m_i) {
            m_x = m_samples[at(m_i, 0, 999)];
            m_y = 0.0675f * m_x + 0.1349f * m_x1 + 0.0675f * m_x2 + 1.143f * m_y1 - 0.4128f * m_y2;
            m_x2 = m_x1;
            m_x1 = m_x;
            m_y2 = m_y1;
            m_y1 = m_y;
            m_samples[at(m_i, 0, 999)] = m_y;
        }
        m_check = m_y;
    }
    double check() const override { return static_cast<double>(m_check); }

private:
    int32_t m_i = 0;
    float m_samples[1000] = {};
    float m_x = 0, m_y = 0, m_y1 = 0, m_y2 = 0, m_x1 = 0, m_x2 = 0, m_phase = 0, m_check = 0;
};

class Array : public Kernel {
public:
    void scan(Guards& g) override {
        m_count = 0;
        charge(g, 10000);
        for (m_i = 0; m_i <= 9999; ++m_i) m_composite[at(m_i, 0, 9999)] = false;
        charge(g, 9998);
        for (m_i = 2; m_i <= 9999; ++m_i) {
            if (m_composite[at(m_i, 0, 9999)]) continue;
            m_count = add(m_count, 1);
            m_k = add(m_i, m_i);
            while (m_k <= 9999) {
                charge(g, 1);
                m_composite[at(m_k, 0, 9999)] = true;
                m_k = add(m_k, m_i);
            }
        }
        m_seed = 12345;
        charge(g, 300);
        for (m_i = 1; m_i <= 300; ++m_i) {
            m_seed = add(mul(m_seed, 1103), 12345) % 65536;
            m_numbers[at(m_i, 1, 300)] = m_seed;
        }
        charge(g, 299);
        for (m_i = 2; m_i <= 300; ++m_i) {
            m_value = m_numbers[at(m_i, 1, 300)];
            m_k = m_i - 1;
            while (m_k >= 1 && m_numbers[at(m_k, 1, 300)] > m_value) {
                charge(g, 1);
                m_numbers[at(int64_t(add(m_k, 1)), 1, 300)] = m_numbers[at(m_k, 1, 300)];
                m_k = sub(m_k, 1);
            }
            m_numbers[at(add(m_k, 1), 1, 300)] = m_value;
        }
        m_check = add(m_count, m_numbers[149]);
    }
    double check() const override { return m_check; }

private:
    bool m_composite[10000] = {};
    int32_t m_numbers[300] = {};
    int32_t m_i = 0, m_k = 0, m_value = 0, m_seed = 0, m_count = 0, m_check = 0;
};

class Matrix : public Kernel {
public:
    void scan(Guards& g) override {
        charge(g, 40);
        for (m_i = 1; m_i <= 40; ++m_i) {
            charge(g, 40);
            for (m_j = 1; m_j <= 40; ++m_j) {
                m_a[at(m_i, 1, 40)][at(m_j, 1, 40)] = static_cast<double>(m_i - m_j) / 7.0;
                m_b[at(m_i, 1, 40)][at(m_j, 1, 40)] = static_cast<double>(m_i + m_j) / 9.0;
            }
        }
        charge(g, 40);
        for (m_i = 1; m_i <= 40; ++m_i) {
            charge(g, 40);
            for (m_j = 1; m_j <= 40; ++m_j) {
                m_sum = 0;
                charge(g, 40);
                for (m_k = 1; m_k <= 40; ++m_k)
                    m_sum += m_a[at(m_i, 1, 40)][at(m_k, 1, 40)] * m_b[at(m_k, 1, 40)][at(m_j, 1, 40)];
                m_c[at(m_i, 1, 40)][at(m_j, 1, 40)] = m_sum;
            }
        }
        m_check = m_c[16][22];
    }
    double check() const override { return m_check; }

private:
    double m_a[40][40] = {}, m_b[40][40] = {}, m_c[40][40] = {};
    int16_t m_i = 0, m_j = 0, m_k = 0;
    double m_sum = 0, m_check = 0;
};

struct Ramp {
    float target = 0, slope = 0.5f;
    bool reset = false;
    float value = 0;
    bool reached = false;
    int32_t steps = 0;
    void call() {
        if (reset) {
            value = 0;
            steps = 0;
        } else if (value + slope < target) {
            value = value + slope;
            steps = add(steps, 1);
        } else if (value - slope > target) {
            value = value - slope;
            steps = add(steps, 1);
        } else {
            value = target;
        }
        reached = value == target;
    }
};

class Blocks : public Kernel {
public:
    void scan(Guards& g) override {
        m_sum = 0;
        charge(g, 50);
        for (m_pass = 1; m_pass <= 50; ++m_pass) {
            charge(g, 200);
            for (m_i = 0; m_i <= 199; ++m_i) {
                Ramp& ramp = m_ramps[at(m_i, 0, 199)];
                ramp.target = static_cast<float>(mul(m_i, m_pass)) * 0.25f;
                ramp.slope = 1.5f;
                ramp.reset = m_pass == 20;
                ramp.call();
                if (ramp.reached) m_arrived = add(m_arrived, 1);
                m_sum = m_sum + ramp.value;
            }
        }
        m_check = m_sum + static_cast<float>(m_arrived % 1000);
    }
    double check() const override { return static_cast<double>(m_check); }

private:
    Ramp m_ramps[200];
    int32_t m_pass = 0, m_i = 0, m_arrived = 0;
    float m_sum = 0, m_check = 0;
};

class Strings : public Kernel {
public:
    void scan(Guards& g) override {
        m_n = 0;
        charge(g, 500);
        for (m_i = 1; m_i <= 500; ++m_i) {
            char number[21], longer[81];
            plc_text_from_integer(number, 20, static_cast<uint32_t>(types::TypeKind::Dint), mul(m_i, 37));
            plc_text_assign(m_line, 80, "value=", 6);
            plc_text_append(m_line, 80, number, 20);
            plc_text_append(m_line, 80, ";unit=mm", 8);
            m_at = static_cast<int16_t>(plc_text_find(m_line, 80, ";", 1));
            plc_text_mid(longer, 80, m_line, 80, 7, static_cast<int16_t>(m_at - 7));
            plc_text_assign(m_part, 20, longer, 80);
            uint8_t ok = 0;
            const auto value = static_cast<int32_t>(
                plc_text_to_integer(m_part, 20, static_cast<uint32_t>(types::TypeKind::Dint), &ok));
            m_n = add(m_n, add(value, static_cast<int16_t>(plc_text_length(m_line, 80))));
            if (plc_text_compare(m_part, 20, "370", 3) == 0) m_n = add(m_n, 1);
        }
        m_check = m_n;
    }
    double check() const override { return m_check; }

private:
    char m_line[81] = {}, m_part[21] = {};
    int32_t m_i = 0, m_n = 0;
    int16_t m_at = 0;
    int32_t m_check = 0;
};

class Machine : public Kernel {
public:
    void scan(Guards& g) override {
        charge(g, 20000);
        for (m_i = 1; m_i <= 20000; ++m_i) {
            m_start = m_pattern & 1;
            m_stop = ((m_pattern >> 3) & 1) && ((m_pattern >> 7) & 1);
            m_ready = (m_pattern >> 5) & 1;
            m_pattern = static_cast<uint16_t>(static_cast<uint16_t>((m_pattern << 1) | (m_pattern >> 15)) ^
                                              static_cast<uint16_t>(m_i & 3));
            switch (m_state) {
            case 0:
                if (m_start) m_state = 1;
                break;
            case 1:
                if (m_ready) {
                    m_state = 2;
                    m_moves = add(m_moves, 1);
                } else if (m_stop) {
                    m_state = 9;
                }
                break;
            case 2:
                m_state = 3;
                break;
            case 3:
                if (m_start && m_ready) m_state = 4;
                break;
            case 4:
                if (m_stop) {
                    m_state = 9;
                } else {
                    m_state = 5;
                    m_moves = add(m_moves, 1);
                }
                break;
            case 5:
                if (!m_ready) m_state = 6;
                break;
            case 6:
                m_state = 7;
                m_good = add(m_good, 1);
                break;
            case 7:
                if (m_start || m_stop) m_state = 8;
                break;
            case 8:
                m_state = 0;
                m_moves = add(m_moves, 1);
                break;
            case 9:
                m_bad = add(m_bad, 1);
                m_state = 0;
                break;
            }
        }
        m_check = add(add(mul(m_good, 3), mul(m_bad, 5)), m_moves);
    }
    double check() const override { return m_check; }

private:
    int16_t m_state = 0;
    uint16_t m_pattern = 0xB2E5;
    int32_t m_i = 0, m_good = 0, m_bad = 0, m_moves = 0;
    bool m_start = false, m_stop = false, m_ready = false;
    int32_t m_check = 0;
};

inline float limit(float low, float value, float high) {
    const float raised = value > low ? value : low;
    return high < raised ? high : raised;
}

struct Controller {
    float setpoint = 0, actual = 0, kp = 2, ti = 8, td = 0.5f, dt = 0.1f;
    float output = 0;
    float integral = 0, lastError = 0, error = 0, derivative = 0;
    void call() {
        error = setpoint - actual;
        if (std::fabs(error) < 0.01f) error = 0;
        integral = limit(-50, integral + error * dt / ti, 50);
        derivative = (error - lastError) / dt;
        lastError = error;
        output = limit(0, kp * (error + integral + td * derivative), 100);
    }
};

struct Plant {
    float power = 0, dt = 0.1f, temperature = 20, wall = 20;
    void call() {
        wall = wall + dt * (power * 0.8f - (wall - temperature) * 0.4f) / 5.0f;
        temperature = temperature + dt * ((wall - temperature) * 0.4f - (temperature - 20.0f) * 0.05f) / 12.0f;
    }
};

class Pid : public Kernel {
public:
    void scan(Guards& g) override {
        charge(g, 5000);
        for (m_i = 1; m_i <= 5000; ++m_i) {
            m_pid.setpoint = m_i > 2500 ? 60.0f : 80.0f;
            m_pid.actual = m_oven.temperature;
            m_pid.call();
            m_oven.power = m_pid.output;
            m_oven.call();
        }
        m_check = m_oven.temperature;
    }
    double check() const override { return static_cast<double>(m_check); }

private:
    Controller m_pid;
    Plant m_oven;
    int32_t m_i = 0;
    float m_check = 0;
};

int32_t gcd(Guards& g, int32_t a, int32_t b) {
    while (b != 0) {
        charge(g, 1);
        const int32_t rest = remainder(a, b);
        a = b;
        b = rest;
    }
    return a;
}

int32_t largest(Guards& g, int32_t* values, int64_t low, int64_t high) {
    int32_t best = values[at(low, low, high)];
    const auto first = static_cast<int32_t>(low + 1), last = static_cast<int32_t>(high);
    if (first <= last) charge(g, int64_t(last) - first + 1);
    for (int32_t i = first; i <= last; ++i)
        if (values[at(i, low, high)] > best) best = values[at(i, low, high)];
    return best;
}

class Calls : public Kernel {
public:
    void scan(Guards& g) override {
        m_sum = 0;
        charge(g, 200);
        for (m_i = 1; m_i <= 200; ++m_i) {
            m_values[at(m_i, 1, 200)] = gcd(g, mul(m_i, 36), add(5040, m_i));
            m_sum = add(m_sum, m_values[at(m_i, 1, 200)]);
        }
        charge(g, 20);
        for (m_i = 1; m_i <= 20; ++m_i) m_sum = add(m_sum, largest(g, m_values, 1, 200));
        m_check = m_sum;
    }
    double check() const override { return m_check; }

private:
    int32_t m_values[200] = {};
    int32_t m_i = 0, m_sum = 0, m_check = 0;
};

class Checksum : public Kernel {
public:
    void scan(Guards& g) override {
        charge(g, 1024);
        for (m_i = 0; m_i <= 1023; ++m_i) m_telegram[at(m_i, 0, 1023)] = static_cast<uint8_t>(m_i * 7 + 3);
        m_crc = 0xFFFF;
        charge(g, 1024);
        for (m_i = 0; m_i <= 1023; ++m_i) {
            m_crc = m_crc ^ m_telegram[at(m_i, 0, 1023)];
            charge(g, 8);
            for (m_bit = 1; m_bit <= 8; ++m_bit) {
                if (m_crc & 1)
                    m_crc = static_cast<uint16_t>(m_crc >> 1) ^ 0xA001;
                else
                    m_crc = m_crc >> 1;
            }
        }
        m_check = m_crc;
    }
    double check() const override { return m_check; }

private:
    uint8_t m_telegram[1024] = {};
    int16_t m_i = 0, m_bit = 0;
    uint16_t m_crc = 0;
    int32_t m_check = 0;
};

struct Ton {
    bool in = false;
    int64_t pt = 0;
    bool q = false;
    int64_t et = 0;
    bool running = false;
    int64_t begin = 0;
    void call(const Guards& g) {
        if (!in) {
            q = false;
            et = 0;
            running = false;
        } else if (!q) {
            if (!running) {
                running = true;
                begin = g.timeNs;
            }
            et = g.timeNs - begin;
            if (et >= pt) {
                et = pt;
                q = true;
            }
        }
    }
};

struct Ctu {
    bool cu = false, r = false;
    int16_t pv = 0;
    bool q = false;
    int16_t cv = 0;
    bool before = false;
    void call() {
        const bool edge = cu && !before;
        before = cu;
        if (r)
            cv = 0;
        else if (edge && cv < 32767)
            cv = static_cast<int16_t>(cv + 1);
        q = cv >= pv;
    }
};

struct RTrig {
    bool clk = false, q = false, before = false;
    void call() {
        q = clk && !before;
        before = clk;
    }
};

class Timers : public Kernel {
public:
    void scan(Guards& g) override {
        charge(g, 50);
        for (m_pass = 1; m_pass <= 50; ++m_pass) {
            charge(g, 100);
            for (m_i = 1; m_i <= 100; ++m_i) {
                Ton& delay = m_delays[at(m_i, 1, 100)];
                delay.in = static_cast<int16_t>(m_pass + m_i) % 4 != 0;
                delay.pt = 0;
                delay.call(g);
                RTrig& edge = m_edges[at(m_i, 1, 100)];
                edge.clk = delay.q;
                edge.call();
                Ctu& counter = m_counters[at(m_i, 1, 100)];
                counter.cu = edge.q;
                counter.r = m_pass == 10;
                counter.pv = 5;
                counter.call();
                if (counter.q) m_done = add(m_done, 1);
            }
        }
        m_check = m_done;
    }
    double check() const override { return m_check; }

private:
    Ton m_delays[100];
    Ctu m_counters[100];
    RTrig m_edges[100];
    int16_t m_pass = 0, m_i = 0;
    int32_t m_done = 0, m_check = 0;
};

} // namespace

std::unique_ptr<Kernel> makeKernel(const char* name) {
    const auto is = [&](const char* wanted) { return std::strcmp(name, wanted) == 0; };
    if (is("integer")) return std::make_unique<Integer>();
    if (is("real")) return std::make_unique<Real>();
    if (is("array")) return std::make_unique<Array>();
    if (is("matrix")) return std::make_unique<Matrix>();
    if (is("blocks")) return std::make_unique<Blocks>();
    if (is("strings")) return std::make_unique<Strings>();
    if (is("machine")) return std::make_unique<Machine>();
    if (is("pid")) return std::make_unique<Pid>();
    if (is("calls")) return std::make_unique<Calls>();
    if (is("checksum")) return std::make_unique<Checksum>();
    if (is("timers")) return std::make_unique<Timers>();
    return nullptr;
}

} // namespace plc::bench
