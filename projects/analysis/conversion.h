// "Show as ST" and "Show as IL": one body of a project in the other language, as edits of its file. The project is
// checked before and after, so that what comes out has the right types and compiles. Pure functions; any thread.
#pragma once
#include "runtime/base/result.h"
#include "runtime/compiler/driver/driver.h"

#include <string>
#include <vector>

namespace plc::analysis {

enum class TextLanguage : uint8_t { St, Il };

/// A body that is written in ST or IL.
struct BodyPlace {
    std::string unit; // "Main", "Motor.Start"
    TextLanguage language = TextLanguage::St;
    SourceRange range;
};
/// Of programs, functions, blocks, their methods and actions, in order of the text.
[[nodiscard]] std::vector<BodyPlace> bodiesOf(std::string_view text);

struct Conversion {
    std::string unit;
    std::vector<diagnostics::TextEdit> edits; // of the one file, by place, not overlapping
    std::string text;                         // the file after them
};
/// The body of `unit` in the other language. The error says what has no like there.
[[nodiscard]] Result<Conversion> convertBody(const driver::BuildInput& input, std::string_view path,
                                             std::string_view unit, TextLanguage to);

} // namespace plc::analysis
