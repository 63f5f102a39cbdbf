// What travels to a browser: nothing when nothing changed, little when little did.
#include "drawn_panel.h"
#include "thousand_elements.h"

#include "hmi/web/panel_stream.h"
#include "tests/hmi/running.h"

#include <QElapsedTimer>

namespace plc::hmi::web {
namespace {

struct Streamed {
    PanelProject project = machineProject();
    HeldValues values;
    PaintStore store;
    std::unique_ptr<PanelPlayer> player;
    std::unique_ptr<PanelStream> stream;
    explicit Streamed(const std::string& elements) {
        project.panels.push_back({QStringLiteral("p"), panelOf(elements)});
        project.startPanel = QStringLiteral("p");
        player = std::make_unique<PanelPlayer>(project, nullptr);
        player->setStepped();
        player->scene().setValues(&values);
        stream = std::make_unique<PanelStream>(store, *player);
    }
    ~Streamed() { player->scene().setValues(nullptr); }
    qsizetype bytes() { return stream->frame(0).size(); }
};

/// Numbers side by side: "a0", "a1" …
std::string numbers(int count) {
    std::string out;
    for (int i = 0; i < count; ++i)
        out += (i ? "," : "") + std::string(R"({"id":"e)") + std::to_string(i) + R"(","kind":"number","value":"a)" +
               std::to_string(i) + R"(","fontSize":11,"rect":[)" + std::to_string(i % 40 * 16) + "," +
               std::to_string(i / 40 * 16) + ",60,14]}";
    return out;
}

TEST(PanelStream, SendsTheWholePictureOnceAndThenOnlyWhatChanged) {
    Streamed s(numbers(100));
    for (int i = 0; i < 100; ++i) s.values.set(QStringLiteral("a%1").arg(i), Value::ofReal(i));
    const qsizetype first = s.bytes();
    EXPECT_GT(first, 3000);
    EXPECT_EQ(s.bytes(), 0);
    s.values.set(QStringLiteral("a7"), Value::ofReal(8));
    const qsizetype one = s.bytes();
    EXPECT_GT(one, 0);
    EXPECT_LT(one, 600) << "one number, with neighbours that lie over it";
    EXPECT_EQ(s.bytes(), 0);
    s.stream->restart();
    EXPECT_GT(s.bytes(), 3000);
}

TEST(PanelStream, WhatABrowserKeepsOfAllFramesIsWhatANewOneIsSent) {
    Streamed s(serve::thousandElements());
    serve::DrawnPanel kept, fresh;
    for (int frame = 0; frame < 12; ++frame) {
        for (int i = 0; i < 1000; i += frame % 3 + 1) { // others each time: some commands stay, some come and go
            s.values.set(QStringLiteral("Main.r[%1]").arg(i), Value::ofReal(50 + 45 * std::sin(frame * 0.3 + i)));
            s.values.set(QStringLiteral("Main.b[%1]").arg(i), Value::ofBool((frame + i) % 4 < 2));
        }
        ASSERT_TRUE(kept.take(s.stream->frame(frame * 33))) << kept.problem().toStdString();
    }
    PanelStream another(s.store, *s.player);
    ASSERT_TRUE(fresh.take(another.frame(12 * 33))) << fresh.problem().toStdString();
    ASSERT_EQ(kept.elements().size(), 1000u);
    for (const auto& [index, element] : fresh.elements()) EXPECT_EQ(kept.elements().at(index), element) << index;
}

TEST(PanelStream, WordsForScreenReadersAreWhatIsSeen) {
    Streamed s(R"({"id":"t","kind":"text","rect":[0,0,200,40],"text":"@start"},
                  {"id":"b","kind":"button","rect":[0,60,200,60],"text":"@start","target":"x"})");
    s.bytes();
    const auto list = nlohmann::json::parse(s.stream->words().toStdString())["list"];
    ASSERT_EQ(list.size(), 2u);
    EXPECT_EQ(list[0][1].get<std::string>(), "Start");
    EXPECT_FALSE(list[0][2].get<bool>());
    EXPECT_TRUE(list[1][2].get<bool>()) << "a button can be pressed";
    EXPECT_TRUE(s.stream->words().isEmpty());
    s.player->setLanguage(QStringLiteral("ar"));
    s.bytes();
    EXPECT_TRUE(s.stream->words().contains(QStringLiteral("بدء").toUtf8()));
}

TEST(PanelStream, TwentyChangingElementsNeedLessThanFiftyKilobytesASecond) {
    Streamed s(numbers(1000));
    const auto change = [&](int frame, int count) {
        for (int i = 0; i < count; ++i)
            s.values.set(QStringLiteral("a%1").arg(i * 50), Value::ofReal(50 + 45 * std::sin(frame * 0.3 + i)));
    };
    change(0, 20);
    s.bytes();
    for (int frame = 1; frame < 30; ++frame) change(frame, 20), s.bytes(); // the digits are known now
    qsizetype bytes = 0;
    for (int frame = 30; frame < 60; ++frame) {
        change(frame, 20);
        bytes += s.bytes();
    }
    std::printf("20 of 1,000 elements, 30 frames: %.1f kB\n", static_cast<double>(bytes) / 1000);
    EXPECT_LT(bytes, 50'000);
}

TEST(PanelStream, AThousandChangingElements) {
    Streamed s(numbers(1000));
    qsizetype bytes = 0;
    QElapsedTimer clock;
    clock.start();
    constexpr int kFrames = 30;
    for (int frame = 0; frame < kFrames; ++frame) {
        for (int i = 0; i < 1000; ++i)
            s.values.set(QStringLiteral("a%1").arg(i), Value::ofReal(50 + 45 * std::sin(frame * 0.3 + i)));
        bytes += s.bytes();
    }
    std::printf("1,000 changing elements: %.1f ms and %.1f kB a frame\n",
                static_cast<double>(clock.elapsed()) / kFrames, static_cast<double>(bytes) / kFrames / 1000);
    EXPECT_GT(bytes, 0);
}

} // namespace
} // namespace plc::hmi::web
