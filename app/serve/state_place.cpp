#include "app/serve/state_place.h"

#include "runtime/platform/files.h"
#include "runtime/platform/processes.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace plc::serve {

namespace fs = std::filesystem;

namespace {

fs::path fromEnvironment(const char* name) {
    const char* value = std::getenv(name);
    return value ? fs::path(value) : fs::path();
}

bool isBelow(const fs::path& folder, const fs::path& top) {
    return !top.empty() && std::mismatch(top.begin(), top.end(), folder.begin(), folder.end()).first == top.end();
}

bool mayKeepIn(const fs::path& project) {
    std::error_code ignored;
    for (const fs::path& folder : {project / ".stepwise" / "serve", project / ".stepwise", project})
        if (fs::exists(folder, ignored)) return platform::mayWriteIn(folder.string());
    return true; // not there: what opens it says so
}

/// Two projects of one name have two folders, and each the same one at each start.
std::string markOf(const fs::path& project) {
    uint32_t hash = 2166136261u; // FNV-1a
    for (const char c : project.string()) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
    char out[16];
    std::snprintf(out, sizeof out, "%08x", hash);
    return out;
}

} // namespace

Surroundings surroundings() {
    Surroundings out;
    const fs::path program = platform::ownProgram();
    if (!program.empty()) out.installation = program.parent_path().parent_path() / "share" / "stepwise";
    const std::string given = fromEnvironment("STATE_DIRECTORY").string();
    out.service = given.substr(0, given.find(':'));
    out.user = fromEnvironment("XDG_STATE_HOME");
    if (out.user.empty())
        if (const fs::path home = fromEnvironment("HOME"); !home.empty()) out.user = home / ".local" / "state";
    return out;
}

fs::path stateFolderOf(const fs::path& project, const Surroundings& around) {
    if (!around.service.empty()) return around.service;
    std::error_code ignored;
    const fs::path real = fs::weakly_canonical(project, ignored);
    const bool isForeign = isBelow(real, around.installation) || !mayKeepIn(real);
    if (!isForeign || around.user.empty()) return project / ".stepwise" / "serve";
    return around.user / "stepwise" / (real.filename().string() + "-" + markOf(real));
}

} // namespace plc::serve
