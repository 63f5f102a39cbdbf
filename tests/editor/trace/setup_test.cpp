// Trace set-ups on disk: what is read, what is refused, and that nothing of other versions is lost.
#include "editor/trace/setup/trace_setup.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

using namespace plc::trace;

namespace {

TraceSetup full() {
    TraceSetup s = setupOf({"Main.pid.q_rOut", "Main.run"});
    s.title = "Loop";
    s.span = 2'500'000'000;
    s.every = 5;
    s.condition = "Main.run";
    s.hasTable = true;
    s.cursorA = 1'250'000'000;
    s.trigger = {"Main.run", TriggerEdge::Falling, TriggerMode::Single, 500'000'000, 2'000'000'000, {}};
    s.charts = {ChartSetup{"Upper",
                           2,
                           {AxisSetup{"Temperature", "°C", ScaleMode::Fixed, -10, 120.5, false, {}},
                            AxisSetup{"", "%", ScaleMode::Fit, 0, 100, true, {}}},
                           {}},
                ChartSetup{}};
    s.channels[0].axis = 1;
    s.channels[0].color = "#c2255c";
    s.channels[0].style = ChannelStyle::Line;
    s.channels[0].scale = 0.1;
    s.channels[1].chart = 1;
    s.channels[1].isVisible = false;
    return s;
}

} // namespace

TEST(TraceSetup, ReadsBackWhatItWrote) {
    const TraceSetup setup = full();
    const std::string text = writeSetup(setup);
    auto again = readSetup(text, "t");
    ASSERT_TRUE(again) << again.error().english();
    EXPECT_EQ(writeSetup(*again), text) << "loading and saving changes no byte";
    again->origin = {};
    again->trigger.origin = {};
    for (auto& c : again->charts) {
        c.origin = {};
        for (auto& a : c.axes) a.origin = {};
    }
    for (auto& c : again->channels) c.origin = {};
    EXPECT_EQ(*again, setup);
}

TEST(TraceSetup, KeepsUnknownFieldsInTheirPlaces) {
    const std::string text = R"({
  "version": 1,
  "future": {
    "deep": [1, 2]
  },
  "title": "x",
  "trigger": {
    "hysteresis": 0.5
  },
  "charts": [
    {
      "background": "grid"
    }
  ],
  "channels": [
    {
      "smooth": true,
      "expression": "Main.a",
      "note": "mine",
      "unit": "V"
    }
  ],
  "last": null
}
)";
    auto setup = readSetup(text, "t");
    ASSERT_TRUE(setup) << setup.error().english();
    const std::string written = writeSetup(*setup);
    EXPECT_EQ(Json::parse(written), Json::parse(text));
    EXPECT_EQ(writeSetup(*readSetup(written, "t")), written);
    setup->channels[0].unit = "mV";
    const std::string edited = writeSetup(*setup);
    EXPECT_NE(edited.find("\"note\": \"mine\""), std::string::npos);
    EXPECT_NE(edited.find("\"hysteresis\": 0.5"), std::string::npos);
    EXPECT_LT(edited.find("\"smooth\""), edited.find("\"expression\""));
    EXPECT_LT(edited.find("\"note\""), edited.find("\"unit\""));
}

TEST(TraceSetup, NumbersAreShort) {
    TraceSetup setup = setupOf({"a"});
    setup.span = 2'000'000'000;
    setup.channels[0].scale = 0.1;
    const std::string text = writeSetup(setup);
    EXPECT_NE(text.find("\"span\": 2,"), std::string::npos) << text;
    EXPECT_NE(text.find("\"scale\": 0.1"), std::string::npos) << text;
}

TEST(TraceSetup, RefusesWhatDoesNotFitAndNamesThePlace) {
    struct Row {
        const char* text;
        const char* part;
    };
    for (const Row& row :
         {Row{"{", "not valid JSON"}, Row{"[]", "object"},
          Row{R"({"channels": [{"chart": 1}]})", "channels[0]: \"expression\""},
          Row{R"({"channels": [{"expression": "a", "style": "dotted"}]})", "one of automatic, line, hold, digital"},
          Row{R"({"span": "long"})", "\"span\""}, Row{R"({"version": 99})", "newer"},
          Row{R"({"charts": 5})", "\"charts\" must be a list"}, Row{R"({"every": 0})", "\"every\""}}) {
        const auto setup = readSetup(row.text, "file");
        ASSERT_FALSE(setup) << row.text;
        EXPECT_NE(setup.error().message.english().find(row.part), std::string::npos) << setup.error().message.english();
        EXPECT_EQ(setup.error().place, "file");
    }
}

TEST(TraceSetup, MakesTheChartsThatChannelsName) {
    const auto setup = readSetup(R"({"channels": [{"expression": "a", "chart": 2, "axis": 1}]})", "t");
    ASSERT_TRUE(setup);
    ASSERT_EQ(setup->charts.size(), 3u);
    EXPECT_EQ(setup->charts[2].axes.size(), 2u);
}

TEST(TraceSetup, AFileWithoutChangesIsNotWritten) {
    const auto path = std::filesystem::temp_directory_path() / "stepwise_setup_test.trace.json";
    ASSERT_TRUE(saveSetup(full(), path.string()));
    const auto before = std::filesystem::last_write_time(path);
    const auto loaded = loadSetup(path.string());
    ASSERT_TRUE(loaded);
    ASSERT_TRUE(saveSetup(*loaded, path.string()));
    EXPECT_EQ(std::filesystem::last_write_time(path), before);
    std::filesystem::remove(path);
    EXPECT_FALSE(loadSetup(path.string()));
}
