// How far declarations may be nested and how large they may become, so that no program text ends the checker: what goes
// further is reported. The recursion of everything that walks types, values and trees later is bounded by these too.
#pragma once
#include <cstddef>
#include <cstdint>

namespace plc::sema {

/// Bytes of all data together, and of the frames of one path of calls.
inline constexpr uint64_t kMaximumData = uint64_t(256) << 20;
/// Bytes of the initial values of all types together.
inline constexpr uint64_t kMaximumInitialBytes = kMaximumData;
/// Bytes of a structured value inside a body, which becomes a tree of its elements.
inline constexpr uint64_t kMaximumConstantBytes = uint64_t(4) << 20;
/// Elements of one array whose initial values need code of their own.
inline constexpr size_t kMaximumInitialisedByCode = 10'000;
/// Types in types; types::parseValue reads 64 levels.
inline constexpr uint32_t kMaximumNesting = 60;
/// Bases of a block or interface above each other.
inline constexpr uint32_t kMaximumBases = 100;
/// Declarations that wait for each other, counted by the size of what each of them needs from the stack.
inline constexpr uint32_t kMaximumWaiting = 1500;

/// One declaration that waits for what it needs, while it lives. A chain of them in reverse order is as deep as long.
class Waiting {
public:
    Waiting(uint32_t& counter, uint32_t cost, uint32_t limit = kMaximumWaiting) : m_counter(counter), m_cost(cost) {
        // what is deep by itself is limited by the parser, and may start a chain
        isTooDeep = m_counter > 0 && m_counter + m_cost > limit;
        m_counter += m_cost;
    }
    ~Waiting() { m_counter -= m_cost; }
    Waiting(const Waiting&) = delete;
    bool isTooDeep = false;

private:
    uint32_t& m_counter;
    uint32_t m_cost;
};

} // namespace plc::sema
