// A compiled program without its code, as bytes: layout, initial image, tasks, functions, sites and the texts it was
// made from. `stepwise build` puts them beside the object code, the runner reads them (no compiler is there). Values,
// any thread.
#pragma once
#include "runtime/image/program.h"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace plc::image {

struct PortableProgram {
    std::shared_ptr<CompiledProgram> program; // its code is not part of it
    std::string name;                         // of the project
    int64_t calendarStartNs = 0;              // at the first scan, unless the run says otherwise
    // What a recording tells of its program (history::History::describeProgram).
    std::vector<std::pair<std::string, std::string>> sources;
    std::vector<std::string> libraries;
    std::vector<std::pair<std::string, std::string>> libraryTexts;
};

[[nodiscard]] std::string toBytes(const PortableProgram& portable);
/// None: not what toBytes() of the same version wrote.
[[nodiscard]] std::optional<PortableProgram> fromBytes(std::string_view bytes);

/// Values of pointers, references and interfaces are shown by the path of what they point to. The table may outlive the
/// program: then the number is left.
void nameReferences(const std::shared_ptr<CompiledProgram>& program);

} // namespace plc::image
