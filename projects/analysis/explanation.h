// What a diagnostic means, by example: a program that earns it, what the checker says of it, and one that is right.
// `stepwise explain`, F1 in the studio and docs/diagnostics.md show it. Values, any thread.
#pragma once
#include "runtime/compiler/driver/driver.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace plc::analysis {

struct Explanation {
    diagnostics::Kind kind{};
    std::string_view wrong, right;
    driver::Checked checkedWrong;
    /// Those of this kind, the first in the text first. That of a watch (a line "// watch: EXPRESSION") has no place.
    std::vector<diagnostics::Diagnostic> findings;
};

/// "P3025", in either case; none for a code that there is not.
[[nodiscard]] std::optional<Explanation> explain(std::string_view code);
/// Line numbers before each line, as the checker counts them.
[[nodiscard]] std::string numbered(std::string_view program);
/// Every code, in order.
[[nodiscard]] std::vector<std::string_view> diagnosticCodes();
/// docs/diagnostics.md: every code with its two programs.
[[nodiscard]] std::string diagnosticsReference();

} // namespace plc::analysis
