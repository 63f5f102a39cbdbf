// Every file that comes from outside besides ST, damaged at random: it is refused or read, written again and read the
// same; no crash, no hang. STEPWISE_SEED repeats a run, STEPWISE_LONG=1 takes many more rounds.
#include "projects/session/session.h"
#include "runtime/base/messages.h"
#include "tests/fuzz/inputs_impl.h"
#include "tests/loaders/damage.h"
#include "tests/support/paths.h"

#include <gtest/gtest.h>

#include <sstream>

namespace plc::fuzz {
namespace {

namespace fs = std::filesystem;
using plc::testing::Damage;

std::string contentOf(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

std::vector<std::string> filesThatEnd(const std::string& ending) {
    std::vector<fs::path> paths;
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(plc::sourceDir()) / "projects" / "examples"))
        if (entry.path().filename().string().ends_with(ending)) paths.push_back(entry.path());
    std::sort(paths.begin(), paths.end());
    std::vector<std::string> out;
    for (const fs::path& path : paths) out.push_back(contentOf(path));
    return out;
}

/// The round's text is kept in a file until it has gone well, so that a crash leaves it behind.
class Keep {
public:
    explicit Keep(const char* name)
        : m_path(fs::temp_directory_path() /
                 ("stepwise_loader_" + std::string(name) + "_" + std::to_string(::getpid()))) {}
    ~Keep() {
        std::error_code none;
        fs::remove(m_path, none);
    }
    void put(const std::string& text) const { std::ofstream(m_path, std::ios::binary | std::ios::trunc) << text; }

private:
    fs::path m_path;
};

void damageAll(const char* name, void (*read)(const std::string&), const std::vector<std::string>& good, int rounds,
               bool isJson) {
    ASSERT_FALSE(good.empty());
    const char* given = std::getenv("STEPWISE_SEED");
    const char* wantsAll = std::getenv("STEPWISE_LONG");
    const unsigned seed = given ? static_cast<unsigned>(std::atoi(given)) : std::random_device()();
    std::printf("STEPWISE_SEED=%u\n", seed);
    std::fflush(stdout);
    if (wantsAll && *wantsAll == '1') rounds *= 5;
    Damage damage(seed);
    const Keep keep(name);
    for (const std::string& text : good) read(text);
    for (int i = 0; i < rounds; ++i) {
        const std::string& text = good[damage.pick(good.size())];
        std::string bad;
        if (isJson && i % 2 == 0)
            bad = damage.json(Damage::Json::parse(text)).dump();
        else if (i % 16 == 1)
            bad = damage.bytes(400);
        else
            bad = damage.text(text);
        keep.put(bad);
        read(bad);
    }
}

/// Refused or read: at least it ends. Deeper than any stack.
void refusesDeepNesting(void (*read)(const std::string&)) {
    for (const char* piece : {"[", "{\"a\":", "{\"elements\":[", "{\"charts\":[{\"axes\":"}) {
        std::string text;
        for (int i = 0; i < 200'000; ++i) text += piece;
        read(text);
    }
    read(std::string("{\"name\":\"deep\",\"extra\":") + std::string(100'000, '[') + std::string(100'000, ']') + "}");
    read("{\"name\":\"big\",\"size\":1e999,\"elements\":[]}");
}

std::string recording() {
    driver::BuildInput input;
    input.files.push_back(
        {"main.st", "VAR_GLOBAL g : ARRAY[0..200] OF INT; END_VAR PROGRAM Main VAR x : INT; s : STRING; END_VAR x := x "
                    "+ 1; g[x MOD 200] := x; s := INT_TO_STRING(x); END_PROGRAM\n"});
    const driver::Built built = driver::build(input);
    EXPECT_TRUE(built.program);
    session::Session session(built);
    session.runHere([](const controller::Controller& c) { return c.nextScan() == 500; });
    session.history().mark(5, errors::Plainly(Verbatim("here")), std::chrono::milliseconds(5));
    const std::string path = scratch().write("good.stwrec", "");
    EXPECT_TRUE(session.history().save(path));
    return contentOf(path);
}

std::string retained() {
    const std::vector<controller::RetainedLeaf> leaves{{"Main.x", "INT", {std::byte{7}, std::byte{0}}},
                                                       {"Main.s", "STRING(4)", {std::byte{65}, std::byte{0}}}};
    const std::string path = scratch().write("good.retain", "");
    EXPECT_TRUE(controller::saveRetain(path, leaves));
    return contentOf(path);
}

TEST(Loaders, PanelsWithSizesBeyondAllBoundsAreChecked) {
    for (const char* size : {"1.6e22", "-1e300", "1e308", "0"})
        readPanel(std::string("{\"version\": 1, \"size\": [800, " + std::string(size) +
                              "], \"elements\": [{\"id\": \"t\", \"kind\": \"text\", ") +
                  "\"rect\": [0, 0, 90, 30], \"text\": \"Level\", \"fontSize\": " + size + "}]}");
}

TEST(Loaders, PanelsSurviveDamage) { damageAll("panel", readPanel, filesThatEnd(".panel.json"), 160, true); }
TEST(Loaders, TextsSurviveDamage) { damageAll("texts", readTexts, filesThatEnd("texts.csv"), 1500, false); }
TEST(Loaders, AlarmsSurviveDamage) { damageAll("alarms", readAlarms, filesThatEnd("alarms.json"), 1500, true); }
TEST(Loaders, TraceSetupsSurviveDamage) { damageAll("trace", readTraceSetup, filesThatEnd(".trace.json"), 1500, true); }
TEST(Loaders, ProjectFilesSurviveDamage) {
    damageAll("project", readProjectFile, filesThatEnd("project.json"), 1500, true);
}
TEST(Loaders, RecordingsSurviveDamage) { damageAll("recording", readRecording, {recording()}, 150, false); }
TEST(Loaders, RetainFilesSurviveDamage) { damageAll("retain", readRetainFile, {retained()}, 1500, false); }

TEST(Loaders, PastFindingsReadTheSameAgain) {
    readTexts("key,comment,en\r\n \xEF\xBB\xBFkey,,\xEF\xBB\xBFword\r\n"); // a mark of byte order that is not the
                                                                           // file's first
}

TEST(Loaders, JsonNestedWithoutEndIsRefused) {
    for (const auto read : {readPanel, readAlarms, readTraceSetup, readProjectFile}) refusesDeepNesting(read);
}

} // namespace
} // namespace plc::fuzz
