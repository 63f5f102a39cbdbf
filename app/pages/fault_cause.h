// What an engineer asks about first when a statement has failed: the divisor that was zero, the index that was out of
// range, the reference that was NULL, the value that a subrange does not have, the condition of an endless loop. A
// function, any thread.
#pragma once
#include "runtime/image/runtime_context.h"

#include <functional>
#include <optional>
#include <string_view>
#include <utility>

namespace plc::app {

/// Whether the name at that place of the statement is followed to a variable without a `^`: of a REFERENCE or
/// interface.
using IsFollowed = std::function<bool(uint32_t begin, uint32_t end)>;

/// Where it begins in the statement (of a loop: its head), and its length; none where several may be meant.
[[nodiscard]] std::optional<std::pair<uint32_t, uint32_t>>
causeOfFault(image::FaultCode code, std::string_view statement, const IsFollowed& isFollowed = {});

} // namespace plc::app
