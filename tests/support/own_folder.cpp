// The temporary folder of a test program: one of its own inside the system's, in TMPDIR before main() begins, and
// removed when the program ends. What a program that was killed has left, the next one removes. Part of every test
// program; nobody calls it.
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <unistd.h>
#include <vector>

namespace plc::tests {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMark = "stepwise-test-"; // the process follows, and six letters

bool isLeftOver(const std::string& name) {
    if (!name.starts_with(kMark)) return false;
    const long process = std::strtol(name.c_str() + std::string(kMark).size(), nullptr, 10);
    return process > 0 && ::kill(static_cast<pid_t>(process), 0) != 0 && errno == ESRCH;
}

void removeLeftovers(const fs::path& folder) {
    std::error_code ignored;
    std::vector<fs::path> gone; // a folder is not changed while it is read
    for (const auto& entry : fs::directory_iterator(folder, ignored))
        if (isLeftOver(entry.path().filename().string())) gone.push_back(entry.path());
    for (const fs::path& path : gone) fs::remove_all(path, ignored);
}

class OwnFolder {
public:
    OwnFolder() {
        std::error_code ignored;
        const fs::path all = fs::temp_directory_path(ignored);
        if (all.empty()) return;
        removeLeftovers(all);
        std::string name = (all / (kMark + std::to_string(m_process) + "-XXXXXX")).string();
        if (!::mkdtemp(name.data())) return; // then the system's has to do
        m_path = name;
        ::setenv("TMPDIR", m_path.c_str(), 1);
    }
    ~OwnFolder() {
        std::error_code ignored;
        if (!m_path.empty() && ::getpid() == m_process) fs::remove_all(m_path, ignored); // not a child that ends
    }

private:
    pid_t m_process = ::getpid();
    fs::path m_path;
};

const OwnFolder kOwn;

} // namespace
} // namespace plc::tests
