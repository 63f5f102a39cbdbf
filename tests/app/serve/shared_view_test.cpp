// Browsers that look at the same thing share its recording, and each still has exactly what it would have alone.
#include "hmi/web/web_panel.h"

#include "tests/hmi/running.h"

#include <QElapsedTimer>

namespace plc::hmi::web {
namespace {

std::string grid(int count) {
    std::string out = R"({"id":"tab","kind":"tab","rect":[300,200,300,160],"pages":[{"title":"1"},{"title":"2"}]},
                         {"id":"go","kind":"button","rect":[20,300,160,60],"text":"Go","target":"Main.start"})";
    for (int i = 0; i < count; ++i)
        out += R"(,{"id":"n)" + std::to_string(i) + R"(","kind":"number","value":"Main.count + )" + std::to_string(i) +
               R"(","fontSize":11,"rect":[)" + std::to_string(i % 10 * 60) + "," + std::to_string(i / 10 * 20) +
               ",58,18]}";
    return out;
}

struct Watchers {
    PanelProject project = machineProject();
    session::Session session{builtMachine()};
    PaintStore store;
    std::unique_ptr<OperatorStation> keeper;
    std::vector<std::unique_ptr<WebPanel>> panels;
    uint64_t scans = 0;

    explicit Watchers(int count, const std::string& elements = grid(100)) {
        project.panels.push_back({QStringLiteral("main"), panelOf(elements)});
        project.startPanel = QStringLiteral("main");
        keeper = std::make_unique<OperatorStation>(project, &session);
        for (int i = 0; i < count; ++i) add();
    }
    WebPanel& add(const QString& language = {}) {
        panels.push_back(std::make_unique<WebPanel>(project, session, store, *keeper));
        ClientMessage hello;
        hello.word = ClientWord::Hello;
        hello.more = language;
        hello.number = 1;
        EXPECT_TRUE(panels.back()->take(hello));
        return *panels.back();
    }
    void scan() {
        ++scans;
        session.runHere([&](const controller::Controller& controller) { return controller.nextScan() >= scans; });
    }
};

TEST(SharedView, WatchersGetWhatTheyWouldGetAlone) {
    Watchers shared(3), alone(1);
    for (qint64 now = 0; now < 600; now += 33) {
        shared.scan();
        alone.scan();
        const WebPanel::Output expected = alone.panels[0]->next(now);
        for (const auto& panel : shared.panels) {
            const WebPanel::Output out = panel->next(now);
            ASSERT_EQ(out.frame, expected.frame) << now;
            ASSERT_EQ(out.texts, expected.texts) << now;
        }
    }
    EXPECT_EQ(shared.store.views().size(), 1);
}

TEST(SharedView, WhoTouchesItHasAViewOfTheirOwnAndTheOthersKeepTheirs) {
    Watchers watchers(2);
    watchers.scan();
    (void)watchers.panels[0]->next(0);
    (void)watchers.panels[1]->next(0);
    // The second page of the tab, chosen by one of them.
    for (const ClientWord word : {ClientWord::Down, ClientWord::Up}) {
        ClientMessage touch;
        touch.word = word;
        touch.at = {500, 210};
        ASSERT_TRUE(watchers.panels[1]->take(touch));
    }
    const PanelScene& own = watchers.panels[1]->player().scene();
    EXPECT_EQ(own.view(QStringLiteral("tab"))->currentPage(), 1);
    EXPECT_EQ(watchers.panels[0]->player().scene().view(QStringLiteral("tab"))->currentPage(), 0);
    EXPECT_FALSE(watchers.panels[1]->next(33).frame.isEmpty());
    EXPECT_TRUE(watchers.panels[0]->next(33).frame.isEmpty()) << "nothing changed for the other";
    // What it has after many frames of its own is what a new one would be sent.
    for (qint64 now = 66; now < 400; now += 33) {
        watchers.scan();
        (void)watchers.panels[0]->next(now);
        (void)watchers.panels[1]->next(now);
    }
}

TEST(SharedView, LanguagesThemesAndOperatorsDoNotShare) {
    Watchers watchers(1);
    WebPanel& danish = watchers.add(QStringLiteral("da"));
    WebPanel& known = watchers.add();
    known.setOperator(QStringLiteral("anna"));
    watchers.scan();
    const QByteArray english = watchers.panels[0]->next(0).frame;
    EXPECT_FALSE(danish.next(0).frame.isEmpty());
    EXPECT_EQ(watchers.store.views().size(), 2) << "one for each language, none for who is logged in";
    EXPECT_FALSE(known.next(0).frame.isEmpty());
    EXPECT_EQ(watchers.store.views().size(), 2);
    ClientMessage calm;
    calm.word = ClientWord::Motion;
    calm.number = 0;
    ASSERT_TRUE(watchers.panels[0]->take(calm));
    (void)watchers.panels[0]->next(33);
    EXPECT_EQ(watchers.store.views().size(), 3);
}

TEST(SharedView, WhoWasSlowIsSentWhatItMissed) {
    Watchers watchers(2);
    watchers.scan();
    (void)watchers.panels[0]->next(0);
    const QByteArray first = watchers.panels[1]->next(0).frame;
    EXPECT_FALSE(first.isEmpty());
    // The first one leads for a while; then it is gone for a while, and the other one records.
    for (qint64 now = 33; now < 330; now += 33) watchers.scan(), (void)watchers.panels[0]->next(now);
    for (qint64 now = 330; now < 660; now += 33) watchers.scan(), (void)watchers.panels[1]->next(now);
    // Both come to the same picture: nothing is left to send when nothing changes.
    (void)watchers.panels[0]->next(700);
    (void)watchers.panels[1]->next(700);
    EXPECT_TRUE(watchers.panels[0]->next(733).frame.isEmpty());
    EXPECT_TRUE(watchers.panels[1]->next(733).frame.isEmpty());
}

TEST(SharedView, TenWatchersOfAThousandElements) {
    std::string elements;
    for (int i = 0; i < 1000; ++i)
        elements += (i ? "," : "") + std::string(R"({"id":"n)") + std::to_string(i) +
                    R"(","kind":"number","value":"Main.count + )" + std::to_string(i) + R"(","fontSize":11,"rect":[)" +
                    std::to_string(i % 40 * 16) + "," + std::to_string(i / 40 * 16) + ",60,14]}";
    Watchers watchers(10, elements);
    double one = 0, rest = 0;
    qsizetype bytes = 0;
    constexpr int kFrames = 30;
    QElapsedTimer clock;
    for (int frame = 0; frame < kFrames; ++frame) {
        watchers.scan();
        clock.start();
        bytes += watchers.panels[0]->next(frame * 33).frame.size();
        one += static_cast<double>(clock.nsecsElapsed()) / 1e6;
        clock.start();
        for (int i = 1; i < 10; ++i) (void)watchers.panels[static_cast<size_t>(i)]->next(frame * 33);
        rest += static_cast<double>(clock.nsecsElapsed()) / 1e6;
    }
    std::printf("1,000 changing elements: first browser %.1f ms, nine more %.1f ms a frame, %.1f kB each\n",
                one / kFrames, rest / kFrames, static_cast<double>(bytes) / kFrames / 1000);
    EXPECT_LT(rest, 9 * one) << "nine that watch cost less than nine that draw";
}

} // namespace
} // namespace plc::hmi::web
