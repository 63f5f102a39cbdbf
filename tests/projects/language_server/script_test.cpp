// Whole sessions with the language server: every file below scripts is one test; --update writes what came back.
#include "projects/language_server/server.h"
#include "tests/support/paths.h"
#include "tests/support/rpc_script.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace fs = std::filesystem;

namespace plc::lsp {
namespace {

bool updates = false;

std::string folderOfTests() { return sourceDir() + "/tests/projects/language_server"; }

/// A copy of the project, and a server that has not been asked anything yet.
class LanguageServer : public ::testing::Test {
protected:
    LanguageServer() {
        ::setenv("XDG_CACHE_HOME", (m_root / "cache").c_str(), 1);
        names["${ROOT}"] = m_root.string();
    }

    std::vector<std::string> exchange(const std::string& message) {
        m_sent.clear();
        server.receive(message);
        while (server.hasWork()) server.work();
        return m_sent;
    }

    FolderCopy m_copy{folderOfTests() + "/plant", ::testing::UnitTest::GetInstance()->current_test_info()->name()};
    const fs::path& m_root = m_copy.root();
    std::map<std::string, std::string> names;
    std::vector<std::string> m_sent;
    Server server{[this](const Json& message) { m_sent.push_back(protocol::toText(message)); }, {}};
};

class Script : public LanguageServer {
public:
    explicit Script(fs::path file) : m_file(std::move(file)) {}
    void TestBody() override {
        const std::string script = contentOf(m_file);
        const std::string played = playScript(script, names,
                                              {[this](const std::string& message) { return exchange(message); },
                                               [](const std::string&) { return std::vector<std::string>(); }});
        if (updates)
            std::ofstream(m_file, std::ios::binary) << played;
        else
            EXPECT_EQ(played, script) << m_file;
    }

private:
    fs::path m_file;
};

// ---------------------------------------------------------------- what no client should send

/// One thing of the message is another: a value of another type, a byte, an end too early.
std::string damaged(const std::string& message, uint32_t& random) {
    const auto next = [&](size_t below) {
        random = random * 1664525u + 1013904223u;
        return below == 0 ? 0 : (random >> 8) % below;
    };
    static const char* const values[] = {"null", "-1", "1e400", "\"\"", "[]", "{}", "true", "99999999999999999999"};
    std::string out = message;
    switch (next(4)) {
    case 0:
        out[next(out.size())] = static_cast<char>(next(256));
        return out;
    case 1:
        return out.substr(0, next(out.size()));
    default: {
        const size_t colon = out.find(':', next(out.size()));
        if (colon == std::string::npos) return out;
        const size_t end = out.find_first_of(",}]", colon);
        return out.replace(colon + 1, end - colon - 1, values[next(std::size(values))]);
    }
    }
}

TEST_F(LanguageServer, SurvivesDamagedMessages) {
    uint32_t random = 7;
    if (const char* seed = std::getenv("STEPWISE_SEED"))
        random = static_cast<uint32_t>(std::strtoul(seed, nullptr, 10));
    SCOPED_TRACE("seed " + std::to_string(random));
    std::vector<std::string> messages;
    for (const auto& entry : fs::directory_iterator(folderOfTests() + "/scripts"))
        for (std::string& each : messagesOf(contentOf(entry.path()), names)) messages.push_back(std::move(each));
    ASSERT_GT(messages.size(), 30u);
    size_t refused = 0;
    for (int round = 0; round < 5; ++round)
        for (const std::string& message : messages) {
            if (message.find("\"shutdown\"") != std::string::npos || message.find("\"exit\"") != std::string::npos)
                continue;
            for (const std::string& answer : exchange(damaged(message, random)))
                refused += answer.find("\"error\":{\"code\":-32") != std::string::npos;
            (void)exchange(message);
        }
    EXPECT_GT(refused, 20u);
    EXPECT_FALSE(server.isOver());
    (void)exchange(
        R"({"jsonrpc":"2.0","method":"textDocument/didOpen","params":{"textDocument":{"uri":"file:///after_all.st",)"
        R"("languageId":"st","version":1,"text":"FUNCTION_BLOCK AfterAll\nEND_FUNCTION_BLOCK\n"}}})");
    const auto answers = exchange(R"({"jsonrpc":"2.0","id":4711,"method":"textDocument/documentSymbol",)"
                                  R"("params":{"textDocument":{"uri":"file:///after_all.st"}}})");
    ASSERT_FALSE(answers.empty());
    EXPECT_NE(answers.front().find("\"id\":4711,\"result\":[{\"name\":\"AfterAll\""), std::string::npos)
        << answers.front();
}

TEST_F(LanguageServer, DiagnosticsComeAlsoWhenQuestionsFollowTheChangeAtOnce) {
    (void)exchange(R"({"jsonrpc":"2.0","id":1,"method":"initialize","params":{"capabilities":{}}})");
    (void)exchange(
        R"({"jsonrpc":"2.0","method":"textDocument/didOpen","params":{"textDocument":{"uri":"file:///typed.st",)"
        R"("languageId":"st","version":1,"text":"FUNCTION_BLOCK Typed\nEND_FUNCTION_BLOCK\n"}}})");
    m_sent.clear();
    // As Kate sends them: the questions have arrived before anybody is idle.
    server.receive(std::string(R"({"jsonrpc":"2.0","method":"textDocument/didChange","params":{"textDocument":)"
                               R"({"uri":"file:///typed.st","version":2},"contentChanges":[{"text":"slip := 1;"}]}})"));
    server.receive(std::string(R"({"jsonrpc":"2.0","id":2,"method":"textDocument/semanticTokens/full",)"
                               R"("params":{"textDocument":{"uri":"file:///typed.st"}}})"));
    ASSERT_TRUE(server.hasWork());
    while (server.hasWork()) server.work();
    EXPECT_TRUE(std::any_of(m_sent.begin(), m_sent.end(), [](const std::string& each) {
        return each.find("publishDiagnostics") != std::string::npos && each.find("slip") != std::string::npos;
    }));
}

/// A controller of which the values are known.
struct KnownValues final : LiveValues {
    void want(std::vector<std::string> expressions) override { wanted = std::move(expressions); }
    std::optional<std::string> valueOf(const std::string& expression) const override {
        const auto it = values.find(expression);
        return it == values.end() ? std::nullopt : std::optional(it->second);
    }
    uint64_t revision() const override { return number; }
    std::vector<std::string> wanted;
    std::map<std::string, std::string> values;
    uint64_t number = 0;
};

TEST_F(LanguageServer, ValuesOfARunningControllerAreBesideTheLines) {
    const auto known = std::make_shared<KnownValues>();
    Server live([this](const Json& message) { m_sent.push_back(protocol::toText(message)); }, {{}, known});
    const auto say = [&](const std::string& message) {
        m_sent.clear();
        live.receive(message);
        while (live.hasWork()) live.work();
        return m_sent.empty() ? std::string() : m_sent.front();
    };
    EXPECT_NE(say(R"({"jsonrpc":"2.0","id":1,"method":"initialize","params":{"capabilities":)"
                  R"({"workspace":{"inlayHint":{"refreshSupport":true}}}}})")
                  .find(R"("inlayHintProvider":true)"),
              std::string::npos);
    const std::string uri = "file://" + m_root.string() + "/plant/src/main.st";
    (void)say(R"({"jsonrpc":"2.0","method":"textDocument/didOpen","params":{"textDocument":{"uri":")" + uri +
              R"(","version":1,"text":"PROGRAM Main\nVAR pump : Pump; level : INT; END_VAR\n)"
              R"(pump(start := level > 80, speed := level);\nlevel := level + 1; // up\nEND_PROGRAM\n"}}})");
    const std::string ask = R"({"jsonrpc":"2.0","id":2,"method":"textDocument/inlayHint","params":{"textDocument":)"
                            R"({"uri":")" +
                            uri + R"("},"range":{"start":{"line":0,"character":0},"end":{"line":9,"character":0}}}})";
    EXPECT_NE(say(ask).find(R"("result":[])"), std::string::npos) << "nothing is known yet";
    EXPECT_TRUE(std::find(known->wanted.begin(), known->wanted.end(), "Main.level") != known->wanted.end());
    m_sent.clear();
    live.refreshHints();
    EXPECT_TRUE(m_sent.empty());
    known->values["Main.level"] = "81";
    known->number = 1;
    live.refreshHints();
    live.refreshHints();
    ASSERT_EQ(m_sent.size(), 1u) << "once for a change";
    EXPECT_NE(m_sent.front().find("workspace/inlayHint/refresh"), std::string::npos);
    const std::string hints = say(ask);
    EXPECT_NE(hints.find(R"({"position":{"line":2,"character":42},"label":"level = 81","paddingLeft":true})"),
              std::string::npos)
        << hints;
    EXPECT_NE(hints.find(R"({"position":{"line":3,"character":25},"label":"level = 81")"), std::string::npos) << hints;
    EXPECT_EQ(hints.find("pump = "), std::string::npos) << "a block has no value of its own";
}

TEST_F(LanguageServer, KnowsAFileThatIsOpenUnderTwoUris) {
    (void)exchange(R"({"jsonrpc":"2.0","id":1,"method":"initialize","params":{"capabilities":{}}})");
    const std::string plain = "file://" + m_root.string() + "/plant/src/main.st",
                      other = "file://" + m_root.string() + "/plant/./src/m%61in.st";
    const std::string text = "PROGRAM Main\\nVAR x : INT; END_VAR\\nx := x + 1;\\nEND_PROGRAM\\n";
    for (const std::string& uri : {plain, other})
        (void)exchange(R"({"jsonrpc":"2.0","method":"textDocument/didOpen","params":{"textDocument":{"uri":")" + uri +
                       R"(","version":1,"text":")" + text + "\"}}}");
    (void)exchange(R"({"jsonrpc":"2.0","method":"textDocument/didClose","params":{"textDocument":{"uri":")" + plain +
                   "\"}}}");
    const auto answers =
        exchange(R"({"jsonrpc":"2.0","id":2,"method":"textDocument/hover","params":{"textDocument":{"uri":")" + other +
                 R"("},"position":{"line":2,"character":0}}})");
    ASSERT_FALSE(answers.empty());
    EXPECT_NE(answers.front().find("x : INT"), std::string::npos) << answers.front();
}

TEST_F(LanguageServer, TakesUpWhatChangesOnDisk) {
    (void)exchange(R"({"jsonrpc":"2.0","id":1,"method":"initialize","params":{"capabilities":{}}})");
    const std::string uri = "file://" + m_root.string() + "/plant/src/main.st";
    (void)exchange(R"({"jsonrpc":"2.0","method":"textDocument/didOpen","params":{"textDocument":{"uri":")" + uri +
                   R"(","version":1,"text":"PROGRAM Main\nVAR p : Pump; END_VAR\np();\nEND_PROGRAM\n"}}})");
    const char* const changed =
        R"({"jsonrpc":"2.0","method":"workspace/didChangeWatchedFiles","params":{"changes":[]}})";
    fs::remove(m_root / "plant/src/pump.st");
    const auto gone = exchange(changed);
    EXPECT_TRUE(std::any_of(gone.begin(), gone.end(), [](const std::string& each) {
        return each.find("src/main.st") != std::string::npos && each.find("\"severity\":1") != std::string::npos;
    }));
    // Without its project the file stands for itself.
    fs::remove(m_root / "plant/project.json");
    const auto alone = exchange(changed);
    ASSERT_FALSE(alone.empty());
    std::ofstream(m_root / "plant/project.json") << "{";
    const auto broken = exchange(changed);
    EXPECT_TRUE(std::any_of(broken.begin(), broken.end(), [](const std::string& each) {
        return each.find("window/showMessage") != std::string::npos;
    }));
}

TEST_F(LanguageServer, ChecksWithTheSettingsOfTheProject) {
    std::ofstream(m_root / "plant/project.json")
        << R"({"stringEncoding": "Windows-1251", "addressing": "word", "memoryForNew": 1024})";
    const std::string uri = "file://" + m_root.string() + "/plant/src/settings.st";
    (void)exchange(R"({"jsonrpc":"2.0","id":1,"method":"initialize","params":{"capabilities":{}}})");
    // two words behind each other, no memory for __NEW, no letter of Latin-1: each would be an error or a warning
    const auto answers = exchange(
        R"({"jsonrpc":"2.0","method":"textDocument/didOpen","params":{"textDocument":{"uri":")" + uri +
        R"(","version":1,"text":"PROGRAM Settings\nVAR\n a AT %MW0 : WORD := 1;\n b AT %MW1 : WORD := 2;\n)"
        R"( s : STRING := '\u041D\u0430';\n p : POINTER TO INT;\nEND_VAR\nIF p = 0 THEN\n p := __NEW(INT);\nEND_IF\n)"
        R"(IF a = b AND s = '' THEN\n __DELETE(p);\nEND_IF\nEND_PROGRAM\n"}}})");
    ASSERT_FALSE(answers.empty());
    EXPECT_TRUE(std::none_of(answers.begin(), answers.end(), [](const std::string& each) {
        return each.find("settings.st") != std::string::npos && each.find("\"severity\":1") != std::string::npos;
    }));
}

// ---------------------------------------------------------------- places

TEST(Places, CountUtf16Units) {
    const Places places("a\xC3\xA9\xF0\x9F\x98\x80z\r\nb\rc");
    const std::pair<Position, uint32_t> table[] = {{{0, 0}, 0},  {{0, 1}, 1},  {{0, 2}, 3},  {{0, 4}, 7}, {{0, 5}, 8},
                                                   {{1, 0}, 10}, {{1, 1}, 11}, {{2, 0}, 12}, {{2, 1}, 13}};
    for (const auto& [position, offset] : table) {
        EXPECT_EQ(places.offsetOf(position), offset) << position.line << ":" << position.character;
        EXPECT_EQ(places.positionOf(offset), position) << offset;
    }
    EXPECT_EQ(places.offsetOf({0, 3}), 3u) << "between the halves of a pair: before the character";
    EXPECT_EQ(places.offsetOf({0, 99}), 8u) << "behind the line: its end";
    EXPECT_EQ(places.offsetOf({99, 0}), 13u) << "behind the text: its end";
}

TEST(Places, NameFilesAsUris) {
    EXPECT_EQ(uriOfPath("/a b/Pumpe \xC3\xBC%.st"), "file:///a%20b/Pumpe%20%C3%BC%25.st");
    EXPECT_EQ(pathOfUri("file:///a%20b/Pumpe%20%c3%bc%25.st"), "/a b/Pumpe \xC3\xBC%.st");
    EXPECT_EQ(pathOfUri("file:///a/../b.st"), "/b.st");
    EXPECT_EQ(pathOfUri("untitled:1"), std::nullopt);
    EXPECT_EQ(pathOfUri("file:///a%00b"), std::nullopt);
}

// ---------------------------------------------------------------- layout

std::string applied(std::string text, const std::vector<diagnostics::TextEdit>& edits) {
    for (auto edit = edits.rbegin(); edit != edits.rend(); ++edit)
        text.replace(edit->range.begin, edit->range.end - edit->range.begin, edit->text);
    return text;
}

TEST(FormattingEdits, MakeTheTextAndTouchOnlyWhatDiffers) {
    const std::pair<const char*, const char*> table[] = {
        {"if a then\nb:=1;\nend_if", "IF a THEN\n    b := 1;\nEND_IF\n"},
        {"x := 1;\n", "x := 1;\n"},
        {"", "\n"},
        {"\t x", "x"},
        {"abc", "xyz def"},
        {"ab c", "a bc"},
    };
    for (const auto& [before, after] : table)
        EXPECT_EQ(applied(before, formattingEdits(before, after)), after) << before;
    EXPECT_TRUE(formattingEdits("x := 1;\n", "x := 1;\n").empty());
    EXPECT_EQ(formattingEdits("a;\nb ;\n", "a;\nb;\n").size(), 1u);
}

void registerScripts() {
    for (const auto& entry : fs::directory_iterator(folderOfTests() + "/scripts")) {
        const fs::path file = entry.path();
        ::testing::RegisterTest("LanguageServerScript", file.stem().c_str(), nullptr, nullptr, __FILE__, __LINE__,
                                [file]() -> LanguageServer* { return new Script(file); });
    }
}

} // namespace
} // namespace plc::lsp

int main(int argc, char** argv) {
    ::testing::InitGoogleTest(&argc, argv);
    plc::lsp::updates = argc > 1 && std::string_view(argv[1]) == "--update";
    plc::lsp::registerScripts();
    return RUN_ALL_TESTS();
}
