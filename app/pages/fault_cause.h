// The divisor of a statement in which the controller has divided by zero: what an engineer asks about first. A
// function, any thread.
#pragma once
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>

namespace plc::app {

/// Where it begins in the statement, and its length; none where several divisors may be meant.
[[nodiscard]] std::optional<std::pair<uint32_t, uint32_t>> zeroDivisor(std::string_view statement);

} // namespace plc::app
