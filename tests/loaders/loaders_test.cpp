// Every file that comes from outside besides ST, damaged at random: it is refused or read, written again and read the
// same; no crash, no hang. STEPWISE_SEED repeats a run, STEPWISE_LONG=1 takes many more rounds.
#include "projects/session/session.h"
#include "runtime/base/messages.h"
#include "tests/fuzz/inputs_impl.h"
#include "tests/support/damage.h"
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
            bad = damage.json(Damage::Json::parse(text), Damage::Json::parse(good[damage.pick(good.size())])).dump();
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
TEST(Loaders, RecipesSurviveDamage) { damageAll("recipes", readRecipes, filesThatEnd("recipes.json"), 1500, true); }
TEST(Loaders, DevicesSurviveDamage) { damageAll("devices", readDevices, filesThatEnd("devices.json"), 1500, true); }
TEST(Loaders, PeopleSurviveDamage) {
    const std::string people = R"({"timeout": 60, "roles": [{"name": "operator", "rights": ["operate"]}],
        "users": [{"name": "anna", "roles": ["operator"], "language": "de", "startPanel": "main"}]})";
    damageAll("people", readPeople, {people}, 1500, true);
}
TEST(Loaders, TranslationsSurviveDamage) {
    const auto table =
        hmi::TextTable::parse("key,comment,en,de\na,,Start,\nb,,Level %d,Stand %d\n", QStringLiteral("texts.csv"));
    ASSERT_TRUE(table);
    std::vector<std::string> good;
    for (const auto version : {hmi::XliffVersion::V12, hmi::XliffVersion::V20})
        good.push_back(hmi::writeXliff(*table, {version, "en", "de", "hmi/texts.csv"}));
    damageAll("xliff", readTranslations, good, 1500, false);
}
TEST(Loaders, ForeignTracesSurviveDamage) {
    damageAll("table", readForeignTrace,
              {"time,level,pump\n0.0,1.5,TRUE\n0.1,1.6,FALSE\n0.2,1.7,FALSE\n", "Zeit;Druck\n0,0;1,5\n0,1;1,6\n",
               "timestamp,a\n2024-01-01T00:00:00.000Z,1\n2024-01-01T00:00:00.100Z,2\n"},
              1500, false);
}
TEST(Loaders, ForeignProjectsSurviveDamage) {
    damageAll("foreign", readForeignProject,
              {std::string(1, '\0') + R"(<?xml version="1.0" encoding="utf-8"?>
<project xmlns="http://www.plcopen.org/xml/tc6_0200"><types><dataTypes/><pous><pou name="Main" pouType="program">
<interface><localVars><variable name="x"><type><INT/></type></variable></localVars></interface>
<body><ST><xhtml xmlns="http://www.w3.org/1999/xhtml">x := x + 1;</xhtml></ST></body></pou></pous></types>
<instances><configurations/></instances></project>)",
               std::string(1, '\1') + R"(<?xml version="1.0" encoding="utf-8"?>
<TcPlcObject Version="1.1.0.1"><POU Name="Main"><Declaration><![CDATA[PROGRAM Main
VAR x : INT; END_VAR]]></Declaration><Implementation><ST><![CDATA[x := x + 1;]]></ST></Implementation></POU></TcPlcObject>)",
               std::string(1, '\2') +
                   "\n(* @NESTEDCOMMENTS := 'Yes' *)\nPROGRAM Main\nVAR\n\tx: INT;\nEND_VAR\n(* @END_DECLARATION "
                   ":= '0' *)\nx := x + 1;\nEND_PROGRAM\n"},
              1500, false);
}

TEST(Loaders, PastFindingsReadTheSameAgain) {
    readTexts("key,comment,en\r\n \xEF\xBB\xBFkey,,\xEF\xBB\xBFword\r\n"); // a mark of byte order that is not the
                                                                           // file's first
}

TEST(Loaders, JsonNestedWithoutEndIsRefused) {
    for (const auto read : {readPanel, readAlarms, readTraceSetup, readProjectFile}) refusesDeepNesting(read);
}

} // namespace
} // namespace plc::fuzz
