// Tables of other tools: what they call the time, how they separate, where their head is; and what is wrong with one.
#include "projects/waveform/table.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace plc::waveform;

namespace {

Table read(const std::string& text) {
    auto table = parseTable(text);
    EXPECT_TRUE(table) << (table ? "" : table.error().message.english());
    return table ? *table : Table();
}

} // namespace

TEST(Table, OfOurOwnRun) {
    const Table table = read("scan,time_s,Main.Level,Main.On\n0,0.000,1.5,FALSE\n1,0.010,,TRUE\n");
    ASSERT_EQ(table.columns.size(), 3U); // the number of the scan is one of them
    EXPECT_EQ(table.columns[1].name, "Main.Level");
    EXPECT_EQ(table.columns[1].value, (std::vector<double>{1.5, 1.5}));
    EXPECT_TRUE(table.columns[2].isBool);
    EXPECT_FALSE(table.columns[1].isBool);
    EXPECT_EQ(table.time, (std::vector<double>{0, 0.01}));
}

TEST(Table, OfOurOwnTraceHasUnits) {
    const Table table = read("time [s],Level [m],\"Pump, left [%]\"\n-0.5,1,50\n0,2,60\n");
    ASSERT_EQ(table.columns.size(), 2U);
    EXPECT_EQ(table.columns[0].name, "Level");
    EXPECT_EQ(table.columns[0].unit, "m");
    EXPECT_EQ(table.columns[1].name, "Pump, left");
    EXPECT_EQ(table.columns[1].unit, "%");
}

TEST(Table, OfAPlotterWithUnixTimesAndUnevenRows) {
    const Table table = read("__time,/robot/x,/robot/y\n1700000000.25,1,\n1700000000.5,,7\n1700000001.0,2,8\n");
    ASSERT_EQ(table.columns.size(), 2U);
    EXPECT_EQ(table.columns[0].value[1], 1);
    EXPECT_TRUE(std::isnan(table.columns[1].value[0]));
    EXPECT_DOUBLE_EQ(table.time[2] - table.time[0], 0.75);
}

TEST(Table, OfAnOlderPlcToolHasLinesAboveTheHeadAndBlanks) {
    const Table table = read("Sampling Trace\nC:\\lights.pro\nCycle PLC_PRG.Counter PLC_PRG.Light\n0 2 1\n20 3 0\n");
    ASSERT_EQ(table.columns.size(), 2U);
    EXPECT_EQ(table.columns[1].name, "PLC_PRG.Light");
    EXPECT_DOUBLE_EQ(table.time[1], 0.02);
}

TEST(Table, OfAScopeHasATimeBeforeEachChannel) {
    const Table table =
        read("Name\tScope\nTime (ms)\tSpeed\tTime (ms)\tTorque\n0\t1\t0\t10\n1\t2\t2\t20\n2\t3\t4\t30\n");
    ASSERT_EQ(table.columns.size(), 2U);
    EXPECT_EQ(table.time, (std::vector<double>{0, 0.001, 0.002, 0.004}));
    EXPECT_EQ(table.columns[0].value, (std::vector<double>{1, 2, 3, 3}));
    EXPECT_EQ(table.columns[1].value, (std::vector<double>{10, 10, 20, 30}));
}

TEST(Table, OfAScopeWithItsHeadOfSeveralLines) {
    // a column of times for each group of channels with one sampling time; the slower ones end earlier
    const std::string text = "Name\tscope\r\nFile\tC:\\scope.csv\r\nStarttime of export\t132959733843760000\r\n\r\n"
                             "Name\tquick\tName\tspeed\ttorque\r\nSymbolComment\t\tSymbolComment\t\t\r\n"
                             "Data-Type\tREAL32\tData-Type\tREAL64\tBIT\r\n"
                             "SampleTime[ms]\t0,5\tSampleTime[ms]\t1\t1\r\n"
                             "Unit\t(None)\tUnit\tdV (Voltage)\t(None)\r\n\r\n"
                             "0\t1,5\t0\t10\t0\r\n0,5\t2\t1\t20\t1\r\n1\t2,5\t \t \t \r\nEOF\r\n";
    const Table table = read(text);
    ASSERT_EQ(table.columns.size(), 3U);
    EXPECT_EQ(table.time, (std::vector<double>{0, 0.0005, 0.001}));
    EXPECT_EQ(table.columns[0].value, (std::vector<double>{1.5, 2, 2.5}));
    EXPECT_EQ(table.columns[1].name, "speed");
    EXPECT_EQ(table.columns[1].unit, "dV");
    EXPECT_EQ(table.columns[1].value, (std::vector<double>{10, 10, 20}));
    EXPECT_EQ(table.columns[2].value, (std::vector<double>{0, 0, 1}));
    const Table dates = read("Name;a;b\nData-Type;REAL32;REAL32\n\n132959733843760000;1;2\n132959733843770000;3;4\n");
    ASSERT_EQ(dates.columns.size(), 2U);
    EXPECT_NEAR(dates.time[1] - dates.time[0], 0.001, 1e-5);
    EXPECT_EQ(dates.columns[1].value, (std::vector<double>{2, 4}));
}

TEST(Table, WithDatesAndDecimalCommas) {
    const Table table = read("Date;Height;Width;\n2026-03-01 06:00:00;1,5;2\n2026-03-01 06:00:00.250;1,75;2\n");
    ASSERT_EQ(table.columns.size(), 2U);
    EXPECT_DOUBLE_EQ(table.columns[0].value[1], 1.75);
    EXPECT_NEAR(table.time[1] - table.time[0], 0.25, 1e-6);
}

TEST(Table, WhatIsWrongIsSaidWithItsLine) {
    for (const auto& [text, words] :
         {std::pair{"a,b\n1,2\n", "no column of times"}, std::pair{"time_s,a\n0,1\nx,2\n", "Line 3 has no number"},
          std::pair{"time_s,a\n2,1\n1,2\n", "line 3"}, std::pair{"time_s,a\n", "no rows"},
          std::pair{"time_s,state\n0,idle\n1,busy\n", "no column of numbers"}, std::pair{"", "no column of times"}}) {
        const auto table = parseTable(text);
        ASSERT_FALSE(table) << text;
        EXPECT_NE(table.error().message.english().find(words), std::string::npos) << table.error().message.english();
    }
}

TEST(Table, AColumnThatIsNotThereIsSuggested) {
    const Table table = read("time_s,Level\n0,1\n");
    EXPECT_EQ(*columnOf(table, "level"), 0U);
    const auto none = columnOf(table, "Levl");
    ASSERT_FALSE(none);
    EXPECT_NE(none.error().message.english().find("Level"), std::string::npos);
}
