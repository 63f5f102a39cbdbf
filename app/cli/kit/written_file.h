// A file that a command writes because an option asks for it: refused before hours are simulated if its place cannot
// take it, and written whole. Functions, any thread.
#pragma once
#include "runtime/base/result.h"

#include <string>

namespace plc::cli {

/// The folder exists and the name is not that of a folder.
[[nodiscard]] Result<void> checkPlace(const std::string& path);
[[nodiscard]] Result<void> writeFile(const std::string& path, const std::string& text);

} // namespace plc::cli
