// The folders of projects/examples, so that a new example is tested by being there.
#pragma once
#include "tests/support/paths.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace plc {

inline std::string exampleFolder(const std::string& name) { return plc::sourceDir() + "/projects/examples/" + name; }

/// Every folder, whatever it holds: one without a project is a finding, not left out.
inline std::vector<std::string> exampleNames() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(exampleFolder("")))
        if (entry.is_directory()) names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

} // namespace plc
