// A wrong and a right program for each diagnostic, from runtime/diagnostics/examples; built in. Immutable, any thread.
#pragma once
#include <span>
#include <string_view>

namespace plc::diagnostics {

struct Example {
    std::string_view side;     // "right" or "wrong"
    std::string_view fileName; // "P2001.st"
    std::string_view text;
};
[[nodiscard]] std::span<const Example> examples();

} // namespace plc::diagnostics
