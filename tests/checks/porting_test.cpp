// What only a POSIX system has is in one folder, runtime/platform, and docs/porting.md says of each of its files what
// another system would use. The runner of built programs is for Linux alone but keeps the rule.
#include "tests/support/paths.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

namespace {

namespace fs = std::filesystem;

constexpr const char* kPlatform = "runtime/platform";

std::string textOf(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

/// Headers that are neither of C++, nor of C, nor ours.
const std::regex& posixHeader() {
    static const std::regex all(
        "#\\s*include <((unistd|fcntl|poll|sched|signal|pty|dlfcn|pthread|termios|dirent|netdb|pwd|grp|spawn|syslog|"
        "strings|glob|fnmatch|ftw|ucontext|execinfo|semaphore|mqueue|utime|langinfo|ifaddrs|link|libgen|aio|regex|"
        "setjmp|utmp|wordexp)\\.h|(sys|netinet|net|arpa|linux|asm|systemd)/[a-z_/]+\\.h)>");
    return all;
}

/// Calls and names that come along with other headers on Linux, too.
const std::regex& posixName() {
    static const std::regex all(
        "(^|[^\\w:>.])::(open|close|read|write|fsync|rename|unlink|stat|fstat|access|poll|ppoll|kill|fork|execv|execvp|"
        "waitpid|prctl|clock_gettime|clock_nanosleep|nanosleep|usleep|sleep|getpid|getuid|geteuid|isatty|dup|dup2|"
        "fdopen|fileno|pipe|socket|connect|bind|listen|accept|accept4|recv|send|sendto|setsockopt|mmap|mlockall|"
        "flock|fcntl|ioctl|readlink|symlink|umask|chmod|mkdir|mkstemp|mkdtemp|sched_\\w+|pthread_\\w+|gmtime_r|"
        "localtime_r|timegm|strcasecmp)\\s*\\(|\\b(SIGPIPE|SIGHUP|SIGKILL|SIGUSR1|SIGCHLD|STDIN_FILENO|STDOUT_FILENO|"
        "STDERR_FILENO|CLOCK_MONOTONIC|O_CLOEXEC|S_ISREG|M_PI|pid_t|ssize_t|timespec)\\b|\"/proc/");
    return all;
}

bool isSource(const fs::path& file) { return file.extension() == ".cpp" || file.extension() == ".h"; }

std::vector<fs::path> sources() {
    std::vector<fs::path> out;
    for (const char* top : {"runtime", "projects", "editor", "hmi", "app"})
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(plc::sourceDir() + "/" + top))
            if (isSource(entry.path())) out.push_back(entry.path());
    return out;
}

bool isOfPlatform(const fs::path& file) {
    return fs::relative(file, plc::sourceDir()).parent_path().generic_string() == kPlatform;
}

} // namespace

TEST(Porting, PosixIsInOneFolder) {
    size_t inside = 0;
    for (const fs::path& file : sources()) {
        const std::string text = textOf(file);
        std::smatch found;
        const bool isPosix =
            std::regex_search(text, found, posixHeader()) || std::regex_search(text, found, posixName());
        if (!isPosix) continue;
        if (isOfPlatform(file))
            ++inside;
        else
            ADD_FAILURE() << file << " has " << found.str() << ": call a function of " << kPlatform;
    }
    EXPECT_GE(inside, 5u) << "the search finds nothing";
}

TEST(Porting, EachFileOfThePlatformIsListed) {
    const std::string page = textOf(plc::sourceDir() + "/docs/porting.md");
    size_t files = 0;
    for (const fs::path& file : sources()) {
        if (!isOfPlatform(file) || file.extension() != ".cpp") continue;
        ++files;
        EXPECT_NE(page.find("`" + file.filename().string() + "`"), std::string::npos)
            << file << ": docs/porting.md does not say what another system would use";
    }
    EXPECT_GE(files, 5u);
}
