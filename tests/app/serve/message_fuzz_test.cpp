// Messages that nobody of ours would send, by the thousand, through all that a browser's message passes: the parser,
// the panel, its overlays, its frames. Ten million with STEPWISE_LONG.
#include "hmi/web/web_panel.h"
#include "tests/hmi/running.h"

#include <random>

namespace plc::hmi::web {
namespace {

constexpr const char* kWords[] = {"hello", "drawn",  "down",     "move",  "up",       "cancel", "wheel", "key",
                                  "login", "logout", "activate", "panel", "language", "scale",  "other", ""};
constexpr const char* kTexts[] = {"main", "pop", "en",   "da", "ar",      "Enter",   "Escape", "Backspace", "7",
                                  "-",    "a",   "anna", "..", "\\u0000", "\\ud800", "@start", "$x",        "'"};

class Fuzz {
public:
    explicit Fuzz(uint32_t seed) : m_random(seed) {}

    QByteArray message() {
        QByteArray out = R"({"t":")" + QByteArray(pick(kWords)) + '"';
        if (chance(2)) out += R"(,"text":")" + QByteArray(pick(kTexts)) + '"';
        if (chance(4)) out += R"(,"more":")" + QByteArray(pick(kTexts)) + '"';
        if (chance(2)) out += ",\"x\":" + number() + ",\"y\":" + number();
        if (chance(2)) out += ",\"n\":" + number();
        out += '}';
        for (int changes = chance(3) ? 1 + static_cast<int>(below(4)) : 0; changes > 0; --changes) mutate(out);
        return out;
    }

private:
    uint32_t below(uint32_t limit) { return m_random() % limit; }
    bool chance(uint32_t of) { return below(of) == 0; }
    template <size_t N> const char* pick(const char* const (&from)[N]) { return from[below(N)]; }

    QByteArray number() {
        static constexpr const char* kOdd[] = {"-1", "1e300", "-1e9", "0.0001", "99999999999", "null", "\"7\"", "[]"};
        return chance(6) ? QByteArray(pick(kOdd)) : QByteArray::number(static_cast<int>(below(1100)));
    }

    void mutate(QByteArray& bytes) {
        if (bytes.isEmpty()) return;
        const auto at = static_cast<qsizetype>(below(static_cast<uint32_t>(bytes.size())));
        switch (below(4)) {
        case 0:
            bytes[at] = static_cast<char>(below(256));
            return;
        case 1:
            bytes.remove(at, 1 + below(6));
            return;
        case 2:
            bytes.insert(at, bytes.mid(at, 1 + below(12)));
            return;
        default:
            bytes.insert(at, QByteArray(static_cast<qsizetype>(below(40)), static_cast<char>(below(256))));
        }
    }

    std::mt19937 m_random;
};

struct Browsers {
    PanelProject project = machineProject();
    session::Session session{builtMachine()};
    PaintStore store;
    std::unique_ptr<OperatorStation> keeper;
    std::unique_ptr<WebPanel> panel;

    Browsers() {
        project.panels.push_back(
            {QStringLiteral("main"),
             panelOf(R"({"id": "go", "kind": "button", "rect": [20, 20, 160, 60], "target": "Main.start"},
                {"id": "e", "kind": "numberEntry", "rect": [200, 20, 160, 60], "target": "Main.count", "minimum": "0", "maximum": "9"},
                {"id": "t", "kind": "textEntry", "rect": [400, 20, 160, 60], "target": "Main.name"},
                {"id": "s", "kind": "slider", "rect": [20, 120, 300, 60], "target": "Main.level"},
                {"id": "p", "kind": "button", "rect": [400, 120, 160, 60], "action": "popup", "panel": "pop"},
                {"id": "l", "kind": "languages", "rect": [600, 20, 260, 44]},
                {"id": "a", "kind": "alarmList", "rect": [20, 220, 560, 240]})")});
        project.panels.push_back(
            {QStringLiteral("pop"),
             panelOf(R"({"id": "x", "kind": "button", "rect": [20, 20, 160, 60], "action": "close"})")});
        project.startPanel = QStringLiteral("main");
        keeper = std::make_unique<OperatorStation>(project, &session);
        open();
    }
    void open() {
        panel = std::make_unique<WebPanel>(project, session, store, *keeper);
        EXPECT_TRUE(panel->take({.word = ClientWord::Hello, .number = 1}));
    }
    double number(const char* path) {
        const auto expression = session.expression(path);
        const std::vector<std::byte> image = session.snapshot();
        EXPECT_TRUE(expression && !image.empty());
        const types::Value value = expression->evaluate(image).value;
        const int64_t* whole = std::get_if<int64_t>(&value.data);
        return whole ? static_cast<double>(*whole) : value.real();
    }
    void runFor(std::chrono::milliseconds time) {
        const auto until = session.status().time + time;
        session.runHere([&](const controller::Controller& controller) { return controller.lastTime() >= until; });
    }
};

int messages() {
    const int wanted = qEnvironmentVariableIntValue("STEPWISE_MESSAGES"); // a share of the long run
    return wanted > 0 ? wanted : qEnvironmentVariableIsSet("STEPWISE_LONG") ? 10'000'000 : 20'000;
}

void feed(Browsers& browsers, bool isOperator, uint32_t seed) {
    Fuzz fuzz(seed);
    qint64 now = 0;
    int understood = 0;
    for (int i = 0; i < messages(); ++i) {
        const std::optional<ClientMessage> message = parseClientMessage(fuzz.message());
        if (message && browsers.panel->take(*message)) {
            ++understood;
        } else if (message) { // the server drops who says that
            browsers.open();
            if (isOperator) browsers.panel->setOperator(QStringLiteral("operator"));
        }
        if (i % 50 != 0) continue;
        now += 33;
        const WebPanel::Output out = browsers.panel->next(now);
        ASSERT_LT(out.frame.size(), 4 << 20);
        QCoreApplication::processEvents();
    }
    EXPECT_GT(understood, messages() / 50) << "most of it must get further than the parser";
}

TEST(MessageFuzz, AStrangersMessagesCrashNothingAndWriteNothing) {
    Browsers browsers;
    browsers.session.controller().start();
    browsers.runFor(std::chrono::milliseconds(50));
    feed(browsers, false, 1);
    browsers.runFor(std::chrono::milliseconds(50));
    EXPECT_EQ(browsers.number("Main.presses"), 0);
    EXPECT_EQ(browsers.number("Main.level"), 12.5);
}

TEST(MessageFuzz, AnOperatorsNonsenseCrashesNothing) {
    Browsers browsers;
    browsers.session.controller().start();
    browsers.panel->setOperator(QStringLiteral("operator"));
    feed(browsers, true, 2);
    browsers.runFor(std::chrono::milliseconds(50));
    EXPECT_NE(browsers.number("Main.level"), 12.5) << "some of it must reach the controller";
}

} // namespace
} // namespace plc::hmi::web
