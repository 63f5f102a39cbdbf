// What panels, alarms, traces and tests name counts as used; what is no file is never replaced.
#include "projects/storage/project_file.h"
#include "runtime/compiler/driver/driver.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

using namespace plc;
namespace fs = std::filesystem;

namespace {

class Folder {
public:
    Folder() : m_path(fs::temp_directory_path() / ("stepwise-companions-" + std::to_string(::getpid()))) {
        fs::create_directories(m_path);
    }
    ~Folder() {
        std::error_code ignored;
        fs::remove_all(m_path, ignored);
    }
    void write(const std::string& name, const std::string& text) const {
        fs::create_directories((m_path / name).parent_path());
        std::ofstream(m_path / name, std::ios::binary) << text;
    }
    [[nodiscard]] std::string path() const { return m_path.string(); }

private:
    fs::path m_path;
};

std::vector<std::string> unusedIn(const projects::Project& project) {
    std::vector<std::string> out;
    const driver::Checked checked = driver::check(project.buildInput());
    for (const auto& diagnostic : checked.analysis->diagnostics)
        if (diagnostics::codeOf(diagnostic.kind) == "P3005" || diagnostics::codeOf(diagnostic.kind) == "P3006")
            out.push_back(diagnostic.message.english());
    return out;
}

TEST(Leftovers, OfASavingThatWasKilledAreGoneWhenTheProjectIsOpened) {
    const Folder folder;
    folder.write("src/main.st", "PROGRAM Main\nVAR x : INT; END_VAR\nx := 1;\nEND_PROGRAM\n");
    const std::string gone = std::to_string(INT32_MAX - 1); // no system has so many processes
    const std::string alive = std::to_string(::getpid());
    for (const char* name : {"project.json", "src/main.st", "hmi/start.panel.json", "traces/a.trace.json"}) {
        folder.write(std::string(name) + ".saving-" + gone, "half");
        folder.write(std::string(name) + ".saving-" + alive, "half");
    }
    folder.write("src/notes.saving-later", "a file of the user's");
    ASSERT_TRUE(projects::openProject({folder.path()}));
    for (const char* name : {"project.json", "src/main.st", "hmi/start.panel.json", "traces/a.trace.json"}) {
        EXPECT_FALSE(fs::exists(folder.path() + "/" + name + ".saving-" + gone)) << name;
        EXPECT_TRUE(fs::exists(folder.path() + "/" + name + ".saving-" + alive)) << name;
    }
    EXPECT_TRUE(fs::exists(folder.path() + "/src/notes.saving-later"));
    EXPECT_TRUE(fs::exists(folder.path() + "/src/main.st"));
}

} // namespace

TEST(Companions, VariablesThatOnlyPanelsAlarmsTracesAndTestsNameAreUsed) {
    const Folder folder;
    folder.write("project.json", "{\"name\":\"p\"}");
    folder.write("src/main.st",
                 "VAR_GLOBAL\n    shown, alone : INT;\nEND_VAR\nPROGRAM Main\nVAR\n    button, lamp : BOOL;\n    "
                 "alarmed, traced, tested, nobody : INT;\nEND_VAR\nlamp := button;\nEND_PROGRAM\n");
    folder.write("hmi/main.panel.json", R"({"elements":[{"variable":"Main.button"},{"text":"{shown}"}]})");
    folder.write("hmi/alarms.json", R"([{"condition":"Main.alarmed > 3"}])");
    folder.write("traces/all.trace.json", R"({"channels":["main.TRACED"]})");
    folder.write("tests/main.st", "TEST 'counts'\n    ASSERT Main.tested = 0;\nEND_TEST\n");
    const auto project = projects::openProject({folder.path()});
    ASSERT_TRUE(project);
    EXPECT_EQ(unusedIn(*project), (std::vector<std::string>{"alone is never used; remove its declaration",
                                                            "nobody is never used; remove its declaration"}));
}

TEST(Companions, APipeIsNotReplacedByAFile) {
    const Folder folder;
    const std::string pipe = folder.path() + "/pipe";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_FALSE(projects::writeFileAtomically(pipe, "text"));
    EXPECT_TRUE(fs::is_fifo(pipe));
}
