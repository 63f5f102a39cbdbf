// Whole sessions with the debug adapter: every file below scripts is one test; --update writes what came back. And what
// needs more than a script: a thousand scans back, a recording, damaged messages.
#include "projects/debug_adapter/adapter.h"
#include "runtime/compiler/jit/jit.h"
#include "tests/support/eventually.h"
#include "tests/support/paths.h"
#include "tests/support/repeats.h"
#include "tests/support/rpc_script.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <thread>

namespace fs = std::filesystem;

namespace plc::dap {
namespace {

bool updates = false;

std::string folderOfTests() { return sourceDir() + "/tests/projects/debug_adapter"; }

/// A copy of the project, and an adapter that has not been asked anything yet.
class DebugAdapter : public ::testing::Test {
protected:
    DebugAdapter() { names["${ROOT}"] = root.string(); }

    std::vector<std::string> exchange(const std::string& message) {
        m_sent.clear();
        adapter.receive(message);
        return std::move(m_sent);
    }
    /// Works until the event comes; the test fails when it does not within a minute.
    std::vector<std::string> waitFor(const std::string& event) {
        m_sent.clear();
        const std::string wanted = "\"event\":\"" + event + "\"";
        EXPECT_TRUE(eventually([&] {
            adapter.work();
            return !m_sent.empty() && m_sent.back().find(wanted) != std::string::npos;
        })) << "there was no event "
            << event;
        if (m_sent.empty()) m_sent.emplace_back(R"({"body":{}})"); // it failed; what follows shall not crash
        return std::move(m_sent);
    }
    /// The body of the response.
    Json request(const std::string& command, const Json& arguments = Json::object()) {
        const Json message{{"seq", ++m_sequence}, {"type", "request"}, {"command", command}, {"arguments", arguments}};
        const Json response = Json::parse(exchange(protocol::toText(message)).front());
        EXPECT_TRUE(response["success"].get<bool>()) << response.dump();
        return response.contains("body") ? response["body"] : Json::object();
    }
    Json stopAfter(const std::string& command, const Json& arguments = Json::object()) {
        request(command, arguments);
        return Json::parse(waitFor("stopped").back())["body"];
    }
    void launch(const Json& lines, const Json& more = Json::object()) {
        request("initialize");
        Json arguments{{"program", (root / "plant").string()}, {"pace", "fastest"}};
        arguments.update(more);
        request("launch", arguments);
        setBreakpoints(lines);
    }
    Json setBreakpoints(const Json& lines) {
        return request("setBreakpoints",
                       {{"source", {{"path", (root / "plant/src/main.st").string()}}}, {"breakpoints", lines}});
    }
    std::string value(const std::string& expression) {
        const Json top = request("stackTrace", {{"threadId", 1}})["stackFrames"].front();
        return request("evaluate", {{"expression", expression}, {"frameId", top["id"]}})["result"].get<std::string>();
    }
    int line() { return request("stackTrace", {{"threadId", 1}})["stackFrames"].front()["line"].get<int>(); }

    FolderCopy m_copy{folderOfTests() + "/plant", ::testing::UnitTest::GetInstance()->current_test_info()->name()};
    const fs::path& root = m_copy.root();
    std::map<std::string, std::string> names;
    std::vector<std::string> m_sent;
    int m_sequence = 0;
    Adapter adapter{[this](const Json& message) { m_sent.push_back(protocol::toText(message)); }};
};

class Script : public DebugAdapter {
public:
    explicit Script(fs::path file) : m_file(std::move(file)) {}
    void TestBody() override {
        const std::string script = contentOf(m_file);
        const std::string played = playScript(script, names,
                                              {[this](const std::string& message) { return exchange(message); },
                                               [this](const std::string& event) { return waitFor(event); }});
        if (updates)
            std::ofstream(m_file, std::ios::binary) << played;
        else
            EXPECT_EQ(played, script) << m_file;
    }

private:
    fs::path m_file;
};

// ---------------------------------------------------------------- back through the recording

/// The way back looks into each scan, which takes a tenth of a second under the thread sanitizer.
constexpr int fewScans(int full) { return repeats(repeats(full)); }

TEST_F(DebugAdapter, StepsBackOverAThousandScans) {
    const int back = fewScans(1000);
    const std::string last = std::to_string(1200 - back);
    launch({{{"line", 18}, {"condition", "scans = 1200"}}});
    EXPECT_EQ(stopAfter("configurationDone")["reason"], "breakpoint");
    ASSERT_EQ(value("scans"), "1200");
    setBreakpoints(Json::array());
    int steps = 0;
    for (std::string scans = "1200"; scans != last && steps < 10'000; ++steps) {
        ASSERT_EQ(stopAfter("stepBack")["reason"], "step");
        if (line() == 18) scans = value("scans");
    }
    // 18, 19, 20, 21, 23 in each scan; the call of the block is stepped over.
    EXPECT_EQ(steps, 5 * back);
    EXPECT_EQ(value("counter.count"), std::to_string(2 * (1200 - back)));
    stopAfter("next");
    EXPECT_EQ(value("scans"), std::to_string(1200 - back + 1));
}

TEST_F(DebugAdapter, BeforeTheProgramHasBegunThereIsNothingBehind) {
    launch(Json::array());
    for (const char* back : {"stepBack", "reverseContinue"})
        EXPECT_EQ(stopAfter(back).value("text", ""), "The recording begins here") << back;
}

TEST_F(DebugAdapter, GoesBackToABreakpointAndForwardIntoTheLiveScanAgain) {
    launch({{{"line", 23}, {"condition", "scans = " + std::to_string(fewScans(1000))}}});
    stopAfter("configurationDone");
    setBreakpoints({{{"line", 33}, {"condition", "count = 8"}}});
    EXPECT_EQ(stopAfter("reverseContinue")["reason"], "breakpoint");
    EXPECT_EQ(line(), 33);
    EXPECT_EQ(value("count"), "8");
    EXPECT_EQ(value("Main.scans"), "5");
    setBreakpoints({{{"line", 18}, {"condition", "scans = 1500"}}}); // not recorded yet
    EXPECT_EQ(stopAfter("continue")["reason"], "breakpoint");
    EXPECT_EQ(value("scans"), "1500");
    EXPECT_EQ(request("setExpression", {{"expression", "Main.scans"}, {"value", "7"}})["value"], "7")
        << "it is the live scan";
    stopAfter("next");
    EXPECT_EQ(value("scans"), "8");
}

TEST_F(DebugAdapter, StandsAtTheSameStatementOfTheRecordingAfterTheFirstStepBack) {
    launch({{{"line", 44}, {"condition", "Main.scans = 10"}}});
    stopAfter("configurationDone"); // in a function that Main called: Twice := result
    EXPECT_EQ(value("result"), "40");
    stopAfter("stepBack");
    EXPECT_EQ(line(), 43);
    EXPECT_EQ(value("x"), "20");
    stopAfter("stepBack");
    EXPECT_EQ(line(), 21) << "the statement that called";
}

TEST_F(DebugAdapter, PausesAWayBackThatFindsNothing) {
    launch({{{"line", 18}, {"condition", "scans = " + std::to_string(fewScans(3000))}}});
    stopAfter("configurationDone");
    setBreakpoints({{{"line", 18}, {"condition", "scans = 32000"}}});
    request("reverseContinue");
    request("pause");
    EXPECT_EQ(Json::parse(waitFor("stopped").back())["body"]["reason"], "pause");
    EXPECT_EQ(stopAfter("reverseContinue")["text"], "The recording begins here");
    EXPECT_EQ(value("scans"), "0");
}

TEST_F(DebugAdapter, PausesARunningProgram) {
    launch(Json::array(), {{"pace", "real"}});
    request("configurationDone");
    EXPECT_EQ(stopAfter("pause")["reason"], "pause");
    EXPECT_GE(line(), 18);
}

TEST_F(DebugAdapter, DebugsARecording) {
    const std::string file = (root / "plant.rec").string();
    {
        auto debuggee = Debuggee::launch({(root / "plant").string(), {}, {session::Pace::Fastest, 1.0}, false});
        ASSERT_TRUE(debuggee) << debuggee.error().english();
        const auto project = (*debuggee)->program().sources;
        driver::BuildInput input;
        for (const SourceText& each : project.files)
            if (!each.path().starts_with("library/")) input.files.push_back({each.path(), std::string(each.text())});
        session::Session session(driver::build(input));
        session.runHere([](const controller::Controller& controller) { return controller.nextScan() >= 50; });
        ASSERT_TRUE(session.history().save(file));
    }
    request("initialize");
    request("attach", {{"recording", file}});
    EXPECT_EQ(stopAfter("configurationDone")["reason"], "entry");
    EXPECT_EQ(value("scans"), "50");
    stopAfter("stepBack");
    EXPECT_EQ(line(), 21);
    EXPECT_EQ(stopAfter("continue")["text"], "The recording ends here");
    const std::string refused = exchange(
        R"({"seq":99,"type":"request","command":"setExpression","arguments":{"expression":"Main.scans","value":"7"}})")
        [0];
    EXPECT_NE(refused.find("A recorded scan cannot be changed"), std::string::npos) << refused;
}

// ---------------------------------------------------------------- what no client should send

TEST_F(DebugAdapter, SurvivesDamagedMessages) {
    uint32_t random = 7;
    if (const char* seed = std::getenv("STEPWISE_SEED"))
        random = static_cast<uint32_t>(std::strtoul(seed, nullptr, 10));
    SCOPED_TRACE("seed " + std::to_string(random));
    const auto next = [&](size_t below) {
        random = random * 1664525u + 1013904223u;
        return below == 0 ? 0 : (random >> 8) % below;
    };
    launch({{{"line", 18}, {"condition", "scans = 20"}}});
    stopAfter("configurationDone");
    std::vector<std::string> messages;
    for (const auto& entry : fs::directory_iterator(folderOfTests() + "/scripts"))
        for (std::string& each : messagesOf(contentOf(entry.path()), names)) messages.push_back(std::move(each));
    ASSERT_GT(messages.size(), 30u);
    static const char* const values[] = {"null", "-1", "1e400", "\"\"", "[]", "{}", "true", "99999999999999999999"};
    size_t refused = 0;
    for (int round = 0; round < 5; ++round)
        for (const std::string& message : messages) {
            if (message.find("disconnect") != std::string::npos || message.find("terminate") != std::string::npos ||
                message.find("restart") != std::string::npos)
                continue;
            std::string bad = message;
            const size_t colon = bad.find(':', next(bad.size()));
            if (next(4) == 0 || colon == std::string::npos)
                bad[next(bad.size())] = static_cast<char>(next(256));
            else
                bad.replace(colon + 1, bad.find_first_of(",}]", colon) - colon - 1, values[next(std::size(values))]);
            for (const std::string& answer : exchange(bad))
                refused += answer.find("\"success\":false") != std::string::npos;
            if (adapter.hasWork()) (void)exchange(R"({"seq":1,"type":"request","command":"pause","arguments":{}})");
            if (adapter.hasWork()) (void)waitFor("stopped");
        }
    EXPECT_GT(refused, 20u);
    EXPECT_FALSE(adapter.isOver());
    EXPECT_EQ(request("threads")["threads"].front()["name"], "Fast");
}

void registerScripts() {
    for (const auto& entry : fs::directory_iterator(folderOfTests() + "/scripts")) {
        const fs::path file = entry.path();
        ::testing::RegisterTest("DebugAdapterScript", file.stem().c_str(), nullptr, nullptr, __FILE__, __LINE__,
                                [file]() -> DebugAdapter* { return new Script(file); });
    }
}

} // namespace
} // namespace plc::dap

int main(int argc, char** argv) {
    ::testing::InitGoogleTest(&argc, argv);
    plc::dap::updates = argc > 1 && std::string_view(argv[1]) == "--update";
    plc::jit::setRuntimeSymbols(plc::controller::runtimeSymbols());
    plc::dap::registerScripts();
    return RUN_ALL_TESTS();
}
