// Lines of the user's text and the statements (sites) that code can stand at. Pure functions over a program; any
// thread.
#pragma once
#include "runtime/image/program.h"

namespace plc::debug {

/// A breakpoint's place: the statement that starts on the line, or on the first line after it with one. Code that was
/// made several times from one statement has several sites.
struct SitesOfLine {
    uint32_t line = 0; // where it really stands; 0 = there is no statement any more
    std::vector<uint32_t> sites;
};
[[nodiscard]] SitesOfLine sitesOfLine(const image::CompiledProgram& program, FileId file, uint32_t line);

/// The file of that path in the program's sources.
[[nodiscard]] FileId fileOfPath(const image::CompiledProgram& program, std::string_view path);

} // namespace plc::debug
