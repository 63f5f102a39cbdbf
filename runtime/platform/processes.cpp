#include "runtime/platform/processes.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <string_view>
#include <sys/wait.h>
#include <unistd.h>

namespace plc::platform {

int64_t processId() { return ::getpid(); }
std::string userNumber() { return std::to_string(::getuid()); }

bool isGone(int64_t process) {
    return process > 0 && process < INT32_MAX && ::kill(static_cast<pid_t>(process), 0) != 0 && errno == ESRCH;
}

std::string ownProgram() {
    std::error_code ignored;
    return std::filesystem::read_symlink("/proc/self/exe", ignored).string();
}

std::optional<std::string> programInPath(const std::string& name) {
    const char* all = std::getenv("PATH");
    std::string_view rest = all ? all : "/usr/bin:/bin";
    while (!rest.empty()) {
        const size_t end = std::min(rest.find(':'), rest.size());
        const std::filesystem::path file = std::filesystem::path(rest.substr(0, end)) / name;
        if (end > 0 && ::access(file.c_str(), X_OK) == 0) return file.string();
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return {};
}

std::optional<int> runProgram(const std::vector<std::string>& words) {
    std::vector<char*> argv;
    for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
    argv.push_back(nullptr);
    const pid_t child = ::fork();
    if (child == 0) {
        ::execv(argv[0], argv.data());
        ::_exit(127);
    }
    int status = 0;
    while (child > 0 && ::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (child < 0 || !WIFEXITED(status)) return {};
    return WEXITSTATUS(status);
}

} // namespace plc::platform
