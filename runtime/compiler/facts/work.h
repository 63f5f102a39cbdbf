// How much work code does at most before it is charged again. Scans are bounded by units of work, not by the clock:
// loop passes, long functions, large copies and long texts are paid for where they happen, so that every tier and every
// machine stops at the same place. Made once per program from the checked tree; immutable afterwards.
#pragma once
#include "runtime/compiler/tree/tree.h"

#include <functional>
#include <unordered_map>

namespace plc::facts {

/// A unit is about one pass of a small loop: so many nodes of the tree, bytes copied or characters of a text.
inline constexpr uint64_t kNodesPerUnit = 64, kBytesPerUnit = 256, kCharactersPerUnit = 128;
/// What is smaller is counted with the statements around it and costs nothing of its own at run time.
inline constexpr uint64_t kLargeCopy = 4096, kLongText = 512;

[[nodiscard]] constexpr uint64_t copyUnits(uint64_t bytes) { return bytes < kLargeCopy ? 0 : bytes / kBytesPerUnit; }
[[nodiscard]] constexpr uint64_t textUnits(uint64_t capacity) {
    return capacity < kLongText ? 0 : capacity / kCharactersPerUnit;
}
/// Copying a value of `type`, or a text function on it, is charged where it happens.
[[nodiscard]] bool isChargedByItself(const types::TypeTable& types, types::TypeId type);

/// A call of a short function is counted by the caller; long functions and those in a cycle of calls pay at their
/// entry.
class WorkTable {
public:
    /// The functions a call can reach.
    using CalleesOf = std::function<std::vector<uint32_t>(const tree::Call&)>;
    WorkTable() = default;
    /// `order`: every function after those it calls, as far as the calls have no cycles.
    WorkTable(const tree::Program& program, const std::vector<uint32_t>& order, const std::vector<bool>& inCycle,
              const CalleesOf& calleesOf);
    /// Units a function pays at its entry; 0: it is short.
    [[nodiscard]] uint64_t atEntry(uint32_t function) const { return m_functions[function].atEntry; }
    /// Units of a jump back in a function: its whole body.
    [[nodiscard]] uint64_t ofJump(uint32_t function) const { return 1 + m_functions[function].nodes / kNodesPerUnit; }
    /// Units of one pass of a loop.
    [[nodiscard]] uint64_t ofPass(const tree::Stmt& loop) const;

private:
    struct OfFunction {
        uint64_t nodes = 0;   // on the longest way through it, without loops
        uint64_t ofCall = 0;  // nodes that its callers count
        uint64_t atEntry = 0; // units
    };
    class Measure;
    std::vector<OfFunction> m_functions;
    std::unordered_map<const tree::Stmt*, uint64_t> m_passes; // nodes
};

} // namespace plc::facts
