#include "projects/storage/leftovers.h"

#include "runtime/platform/processes.h"

#include <cstdlib>
#include <filesystem>
#include <vector>

namespace plc::projects {

namespace fs = std::filesystem;

namespace {

constexpr const char* kMark = ".saving-"; // the process follows

bool isLeftOver(const std::string& name) {
    const size_t mark = name.rfind(kMark);
    if (mark == std::string::npos || mark == 0) return false;
    const std::string number = name.substr(mark + std::string(kMark).size());
    if (number.empty() || number.find_first_not_of("0123456789") != std::string::npos) return false;
    const long process = std::strtol(number.c_str(), nullptr, 10);
    return platform::isGone(process);
}

} // namespace

std::string nameWhileSaving(const std::string& path) { return path + kMark + std::to_string(platform::processId()); }

void removeLeftovers(const std::string& folder) {
    for (const char* part : {"", "src", "tests", "hmi", "traces"}) {
        std::error_code ignored;
        std::vector<fs::path> gone; // a folder is not changed while it is read
        for (const auto& entry : fs::directory_iterator(fs::path(folder) / part, ignored))
            if (entry.is_regular_file(ignored) && isLeftOver(entry.path().filename().string()))
                gone.push_back(entry.path());
        for (const fs::path& path : gone) fs::remove(path, ignored);
    }
}

} // namespace plc::projects
