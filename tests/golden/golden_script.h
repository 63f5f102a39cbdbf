// What a golden file asks for and expects, line by line. Beside `name.st` stands one of
//
//   name.expected      run it:            scans 3                 so many scans
//                                         Main.start := TRUE      a write before the next scan
//                                         force Main.x := 5 / release Main.x
//                                         reset warm | cold | origin
//                                         Main.count = 3          value of an expression (as toText shows it)
//                                         fault division by zero at 12    the controller has stopped at line 12
//   name.diagnostics   check it: every message as `line:column-column code: text`, nothing else
//
// `library toolbox` and `with other.st` lines at the top add to what is compiled, `setting %word` and the like say how
// (driver::setRecordedSettings). `#` begins a comment. Each run is
// made twice, with quick and with optimised code, and both must give the same. `golden --update` writes what came out.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace plc::golden {

enum class LineKind { Comment, Library, With, Setting, Scans, Write, Force, Release, Reset, Expect, Fault, Unknown };

struct Line {
    LineKind kind = LineKind::Unknown;
    std::string text;  // as written
    std::string left;  // path, expression, name
    std::string right; // value
};

[[nodiscard]] std::vector<Line> parseScript(std::string_view text);

} // namespace plc::golden
