// Tables of other tools: what they call the time, how they separate, where their head is; and what is wrong with one.
#include "projects/waveform/table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

using namespace plc::waveform;

namespace {

Table read(const std::string& text) {
    auto table = parseTable(text);
    EXPECT_TRUE(table) << (table ? "" : table.error().message.english());
    return table ? *table : Table();
}

void expectTimes(const Table& table, const std::vector<double>& times) {
    ASSERT_EQ(table.time.size(), times.size());
    for (size_t i = 0; i < times.size(); ++i) EXPECT_NEAR(table.time[i], times[i], 1e-12);
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

TEST(Table, OfAScopeSeparatedByAnyCharacter) {
    const Table table =
        read("Name:scope:\nFile:C\n\nName:speed:torque:\nData-Type:REAL32:REAL32:\nUnit:(None):V (Voltage):\n\n"
             "0:1.5:2:\n1:2.5:3:\n");
    ASSERT_EQ(table.columns.size(), 2U);
    EXPECT_EQ(table.columns[0].name, "speed");
    EXPECT_EQ(table.columns[1].unit, "V");
    EXPECT_EQ(table.columns[1].value, (std::vector<double>{2, 3}));
}

TEST(Table, OfAScopeSeparatedByBlanksWithABlankInANameHasTheSymbolsInstead) {
    const Table table =
        read("Name scope\n\nName the speed torque\nData-Type REAL32 REAL32\nSampleTime[ms] 1 1\n"
             "SymbolName MAIN.drive MAIN.drive\nUnit (None) V (Voltage)\nUnit ScaleFactor 1 1\n\n0 1 10\n1 2 20\n");
    ASSERT_EQ(table.columns.size(), 2U);
    EXPECT_EQ(table.columns[0].name, "MAIN.drive");
    EXPECT_EQ(table.columns[1].name, "MAIN.drive_2");
    EXPECT_EQ(table.columns[0].unit + table.columns[1].unit, ""); // cannot be told apart
    EXPECT_EQ(table.columns[1].value, (std::vector<double>{10, 20}));
}

namespace {

std::string codesysTrace(const char* flags) {
    return std::string("[key]; [value]\r\nVersion; 0x03050000\r\nName; Application.Trace\r\nIecTaskName; MainTask\r\n"
                       "Comment; \r\nBufferEntries; 1000\r\nFlags; ") +
           flags +
           "\r\n0.Variable; PLC_PRG.level\r\n0.Class; 14\r\n0.Data; \r\n; 51; 1.5\r\n; 102; 2.5\r\n; 152; 3.5\r\n"
           "1.Variable; PLC_PRG.on\r\n1.Data; \r\n; 51; FALSE\r\n; 152; TRUE\r\n"
           "2.Variable; PLC_PRG.name\r\n2.Data; \r\n; 51; a; b\r\n";
}

} // namespace

TEST(Table, OfACodesysTraceAsCsv) {
    const Table table = read(codesysTrace("16"));
    ASSERT_EQ(table.columns.size(), 2U); // the text is none
    expectTimes(table, {0.051, 0.102, 0.152});
    EXPECT_EQ(table.columns[0].name, "PLC_PRG.level");
    EXPECT_EQ(table.columns[0].value, (std::vector<double>{1.5, 2.5, 3.5}));
    EXPECT_EQ(table.columns[1].value, (std::vector<double>{0, 0, 1}));
    EXPECT_TRUE(table.columns[1].isBool);
    // with a condition, too, its bit is beside that of the unit
    for (const char* flags : {"32", "36", "0x20"})
        EXPECT_NEAR(read(codesysTrace(flags)).time[0], 51e-6, 1e-12) << flags;
}

TEST(Table, OfACodesysTraceAsText) {
    const Table table = read("Editor V3.5 SP20 Trace: Trace\nC:\\Line 2\\plant.project\n"
                             "Zeitstempel(ms) PLC_PRG.level PLC_PRG.on\n18 714.325 TRUE\n48 716.325 FALSE\n");
    ASSERT_EQ(table.columns.size(), 2U);
    EXPECT_EQ(table.columns[0].value, (std::vector<double>{714.325, 716.325}));
    EXPECT_DOUBLE_EQ(table.time[1], 0.048);
    EXPECT_DOUBLE_EQ(read("Editor Trace: a\nx\nTimestamp(\xC2\xB5s) a b\n1000 1 2\n2000 1 3\n").time[1], 0.002);
}

namespace {

std::string codesysXml(const std::string& micro, const std::string& times) {
    return "<Trace><TraceConfiguration><Single Name=\"Record\"><Single Name=\"MicroSeconds\" Type=\"bool\">" + micro +
           "</Single></Single></TraceConfiguration><TraceData Version=\"1.0.0.0\"><TraceRecord>"
           "<TraceVariable VarName=\"PLC_PRG.level\" Type=\"System.Double\"><Values>1.5,2.5,3.5</Values><Timestamps>" +
           times +
           "</Timestamps></TraceVariable><TraceVariable VarName=\"PLC_PRG.on\" Type=\"System.Boolean\">"
           "<Values>False,True</Values><Timestamps>18,79</Timestamps></TraceVariable></TraceRecord></TraceData></"
           "Trace>";
}

/// In a file of its own, as bytes.
plc::Result<Table> readFile(const std::string& bytes) {
    // Named for the test: others run beside it.
    const std::string path =
        testing::TempDir() + testing::UnitTest::GetInstance()->current_test_info()->name() + ".trace";
    std::ofstream(path, std::ios::binary) << bytes;
    return readTable(path);
}

} // namespace

TEST(Table, OfACodesysTraceFile) {
    const std::string text = codesysXml("False", "18,48,79");
    std::string wide = "\xFF\xFE"; // as it is saved
    for (const char c : text) wide += std::string{c, '\0'};
    for (const std::string& bytes : {text, wide}) {
        const auto table = readFile(bytes);
        ASSERT_TRUE(table) << table.error().message.english();
        ASSERT_EQ(table->columns.size(), 2U);
        expectTimes(*table, {0.018, 0.048, 0.079});
        EXPECT_EQ(table->columns[0].value, (std::vector<double>{1.5, 2.5, 3.5}));
        EXPECT_EQ(table->columns[1].value, (std::vector<double>{0, 0, 1}));
        EXPECT_TRUE(table->columns[1].isBool);
    }
    EXPECT_NEAR(readFile(codesysXml("True", "18,48,79"))->time[1], 48e-6, 1e-12);
}

TEST(Table, ABrokenCodesysTraceSaysWhatIsWrong) {
    for (const auto& [bytes, words] :
         {std::pair{codesysXml("False", "18,48"), "3 values but 2 times"},
          std::pair{codesysXml("False", "18,9,79"), "run backwards"},
          std::pair{codesysXml("False", "18,48,79").substr(0, 300), "cannot be read as XML"},
          std::pair{std::string("<Trace></Trace>"), "no column of numbers"},
          std::pair{std::string("[key]; [value]\n0.Variable; a\n0.Data; \n"), "no rows"},
          std::pair{std::string("[key]; [value]\n; 5; 1\n"), "Line 2 is not a sample"},
          std::pair{std::string("0.Variable; a\n; x; 1\n"), "Line 2 is not a sample"},
          std::pair{std::string("0.Variable; a\n; 5; 1\n; 4; 1\n"), "line 3"}}) {
        const auto table = readFile(bytes);
        ASSERT_FALSE(table) << bytes;
        EXPECT_NE(table.error().message.english().find(words), std::string::npos) << table.error().message.english();
    }
}

TEST(Table, InTheCharactersOfWindowsAndOfWideText) {
    const auto narrow = readFile("time_s;Temp [\xB0"
                                 "C]\n0;1,5\n1;2,5\n");
    ASSERT_TRUE(narrow);
    EXPECT_EQ(narrow->columns[0].unit, "\xC2\xB0"
                                       "C");
    std::string wide = "\xFE\xFF";
    for (const char c : std::string("time_s\tLevel\n0\t1,5\n")) wide += std::string{'\0', c};
    const auto table = readFile(wide);
    ASSERT_TRUE(table) << table.error().message.english();
    EXPECT_EQ(table->columns[0].value, (std::vector<double>{1.5}));
    EXPECT_FALSE(readTable(testing::TempDir())); // a folder
    const auto noise = readFile(std::string("PK\3\4\0\0time_s,a\n0,1\n", 19));
    ASSERT_FALSE(noise);
    EXPECT_NE(noise.error().message.english().find("not a table"), std::string::npos);
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
          std::pair{"time_s,state\n0,idle\n1,busy\n", "no column of numbers"}, std::pair{"", "empty"}}) {
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

TEST(Table, ADecimalCommaIsOneInQuotesToo) {
    // what a spreadsheet set to German writes where the comma separates; marks between thousands are none of the number
    const Table table =
        read("time_s,a,b,c,d\n\"0,0\",\"1,25\",\"1.234,5\",\"1,234.5\",\"1,234,567\"\n\"0,1\",2,3,4,5\n");
    expectTimes(table, {0, 0.1});
    ASSERT_EQ(table.columns.size(), 4U);
    EXPECT_EQ(table.columns[0].value[0], 1.25);
    EXPECT_EQ(table.columns[1].value[0], 1234.5);
    EXPECT_EQ(table.columns[2].value[0], 1234.5);
    EXPECT_EQ(table.columns[3].value[0], 1234567);
}

TEST(Table, AColumnThatCannotBeMeantSaysWhy) {
    const Table table = read("t,valve,valve,state,level\n0,1,2,open,3\n1,1,2,shut,NaN\n");
    const auto problem = [&](const char* name) {
        const auto column = columnOf(table, name);
        return column ? std::string("none") : column.error().message.english();
    };
    EXPECT_EQ(problem("valve"), "The table has 2 columns valve; give each its own heading");
    EXPECT_NE(problem("state").find("has no numbers"), std::string::npos) << problem("state");
    EXPECT_EQ(problem("level"), "none");
    for (const char* nothing : {"", "\n\n", "\xEF\xBB\xBF\r\n"}) {
        const auto empty = parseTable(nothing);
        ASSERT_FALSE(empty);
        EXPECT_EQ(empty.error().message.english(), "The file is empty; export the table again");
    }
}

namespace {

/// The distance of the first two rows, and the first value of the last column.
void expectRead(const std::string& text, double step, double value) {
    const auto table = parseTable(text);
    ASSERT_TRUE(table) << text << table.error().message.english();
    ASSERT_GE(table->time.size(), 2U) << text;
    EXPECT_NEAR(table->time[1] - table->time[0], step, 1e-5) << text;
    EXPECT_DOUBLE_EQ(table->columns.back().value[0], value) << text;
}

} // namespace

TEST(Table, TimesAsOtherToolsWriteThem) {
    // a spreadsheet and a panel set to German
    expectRead("\xEF\xBB\xBF"
               "Datum/Uhrzeit;Istwert\r\n29.03.2026 01:59:59,500;1,5\r\n29.03.2026 02:00:00,250;2\r\n",
               0.75, 1.5);
    expectRead("Datum;Uhrzeit;Istwert\n1.3.2026;23:59:59;1,5\n2.3.2026;00:00:01;2\n", 2, 1.5);
    // over the change to summer time the zone says how long it took
    expectRead("timestamp,pv\n2026-03-29T01:59:59+01:00,5\n2026-03-29T03:00:00+02:00,6\n", 1, 5);
    expectRead("Time,pv\n2026-03-29T01:59:59.900Z,5\n2026-03-29T02:00:00.150Z,6\n", 0.25, 5);
    // since 1970
    expectRead("epoch_ms,pv\n1774742280000,5\n1774742280500,6\n", 0.5, 5);
    expectRead("timestamp,pv\n1774742280000,5\n1774742280500,6\n", 0.5, 5);
    expectRead("time,pv\n1774742280000000000,5\n1774742280500000000,6\n", 0.5, 5);
    expectRead("ms\tPV\n0\t5\n500\t6\n", 0.5, 5);
    // a historian in the United States; the day is what no month can be, or what runs
    expectRead("Date Time,pv\n03/29/2026 11:59:59.5 AM,5\n03/29/2026 12:00:00.0 PM,6\n", 0.5, 5);
    expectRead("Date Time,pv\n29/03/2026 11:59:59,5\n29/03/2026 12:00:00,6\n", 1, 5);
    expectRead("Date Time,pv\n03/04/2026 00:00:00,5\n04/04/2026 00:00:00,6\n", 86'400, 5);
    expectRead("Date Time,pv\n03/04/2026 00:00:00,5\n03/05/2026 00:00:00,6\n", 86'400, 5);
    // the time of day alone goes on at midnight
    expectRead("time,pv\n23:59:59.5,5\n00:00:00.25,6\n", 0.75, 5);
    expectRead("time,pv\n12:30,5\n12:31,6\n", 60, 5);
    // days of a spreadsheet
    expectRead("Date,pv\n46110.0,5\n46110.00001157407,6\n", 1, 5);
}

TEST(Table, ARowOfUnitsBelowTheHeadings) {
    const Table table = read("\"Time\",\"PV\",\"OP\"\n\"ms\",\"m3/h\",\"%\"\n\"0\",\"1\",\"2\"\n\"500\",\"1\",\"2\"\n");
    expectTimes(table, {0, 0.5});
    EXPECT_EQ(table.columns[0].unit, "m3/h");
    EXPECT_EQ(table.columns[1].unit, "%");
    const auto wrong = parseTable("time,state,pv\nlater,idle,off\n1,busy,2\n"); // no units
    ASSERT_FALSE(wrong);
    EXPECT_NE(wrong.error().message.english().find("Line 2"), std::string::npos);
}

TEST(Table, ATimeThatIsNoneIsSaid) {
    for (const char* cell : {"25:99:00", "12:3x:00", "31.02.2026 12:00:00", "2026-13-01 00:00:00", "1.2.2026 noon"}) {
        const auto table = parseTable(std::string("time,pv\n") + cell + ",5\n");
        ASSERT_FALSE(table) << cell;
        EXPECT_NE(table.error().message.english().find("Line 2"), std::string::npos) << cell;
    }
}

namespace {

std::vector<std::string> notesOf(const std::string& text) {
    std::vector<std::string> out;
    for (const plc::Message& note : read(text).notes) out.push_back(note.english());
    return out;
}

} // namespace

TEST(TableNotes, NothingIsSaidOfATableAsItShouldBe) {
    EXPECT_TRUE(notesOf("time_s,Level,On,Comment\n0,1,FALSE,start\n1,,TRUE,\n2,3,,end\n").empty());
    // a separator at the end of the header, and the empty cells of a spreadsheet beyond it
    EXPECT_TRUE(notesOf("time_s;Level;\n0;1\n1;2;\n2;3;;;\n").empty());
    // columns with times of their own end where they end
    EXPECT_TRUE(notesOf("Time (ms)\tSpeed\tTime (ms)\tTorque\n0\t1\t0\t10\n1\t2\n2\t3\n").empty());
}

TEST(TableNotes, WordsAmongNumbersAreCounted) {
    const std::string text = "time_s,Level,Flow\n0,1,5\n1,Bad,5\n2,#N/A,5\n3,4,NaN\n";
    EXPECT_EQ(read(text).columns[0].value, (std::vector<double>{1, 1, 1, 4}));
    EXPECT_EQ(notesOf(text),
              (std::vector<std::string>{
                  "Column Level: 2 cells are not numbers, the first (Bad) in line 3; the value above it is kept",
                  "Column Flow: 1 cell is not a number, the first (NaN) in line 5; the value above it is kept"}));
}

TEST(TableNotes, ShortAndLongRowsAreCounted) {
    EXPECT_EQ(notesOf("time_s,Level,Flow\n0,1,5\n1,2\n2,3\n3,4,6\n"),
              (std::vector<std::string>{
                  "2 rows have fewer cells than the header, the first in line 3; the values above are kept"}));
    EXPECT_EQ(
        notesOf("time_s,Level\n0,1,5\n1,2,5\n2,3\n"),
        (std::vector<std::string>{"2 rows have more cells than the header, the first in line 2; the surplus cells "
                                  "are ignored. Put numbers with a decimal comma in quotes"}));
}

TEST(TableNotes, RowsWithTheTimeOfTheRowAboveAreCounted) {
    EXPECT_EQ(
        notesOf("time_s,Level\n0,1\n1,2\n1,3\n2,4\n"),
        (std::vector<std::string>{"1 row has the same time as the row above, the first in line 4; it is left out"}));
}

TEST(LongTable, EachNameBecomesAColumn) {
    const Table table = read("timestamp;tag;value;unit;quality\n2026-03-01T06:00:00+01:00;Level;1,5;m;Good\n"
                             "2026-03-01T06:00:00+01:00;Pump;TRUE;;Good\n2026-03-01T06:00:01+01:00;Level;2,5;m;Good\n"
                             "2026-03-01T06:00:03+01:00;Pump;FALSE;;Good\n");
    ASSERT_EQ(table.columns.size(), 2U);
    EXPECT_EQ(table.columns[0].name, "Level");
    EXPECT_EQ(table.columns[0].unit, "m");
    EXPECT_EQ(table.columns[0].value, (std::vector<double>{1.5, 2.5, 2.5}));
    EXPECT_EQ(table.columns[1].value, (std::vector<double>{1, 1, 0}));
    EXPECT_TRUE(table.columns[1].isBool);
    EXPECT_FALSE(table.columns[0].isBool);
    EXPECT_EQ(table.time[0], 1772341200); // 05:00 UTC
    EXPECT_EQ(table.time[2] - table.time[0], 3);
    EXPECT_TRUE(table.notes.empty());
}

TEST(LongTable, NamesMayFollowOneAfterTheOther) {
    for (const char* head : {"Time,Name,Value\n", "\xEF\xBB\xBFtime_s,Variable,Wert\n", "_time,_field,_value\n",
                             "date,tagname,\"Value [bar]\"\n"}) {
        const Table table = read(std::string(head) + "0,Level,1\n1,Level,2\n2,Level,3\n0,Flow,10\n2,Flow,30\n");
        ASSERT_EQ(table.columns.size(), 2U) << head;
        EXPECT_EQ(table.time, (std::vector<double>{0, 1, 2})) << head;
        EXPECT_EQ(table.columns[0].value, (std::vector<double>{1, 2, 3})) << head;
        EXPECT_EQ(table.columns[1].value, (std::vector<double>{10, 10, 30})) << head;
    }
}

TEST(LongTable, OfADataBaseWithMillisecondsSince1970) {
    const Table table = read("_measurement,_field,_time,_value\nboiler,t,1772341200000,20\nboiler,p,1772341200500,1.2\n"
                             "boiler,t,1772341201000,21\n");
    ASSERT_EQ(table.columns.size(), 2U);
    EXPECT_EQ(table.columns[0].name, "t");
    expectTimes(table, {1772341200, 1772341200.5, 1772341201});
}

TEST(LongTable, OfAWinCcPanel) {
    const Table table = read("\"VarName\";\"TimeString\";\"VarValue\";\"Validity\";\"Time_ms\"\n"
                             "\"Level\";\"21.09.2012 14:12:33\";1,5;1;41173591582,176\n"
                             "\"Flow\";\"21.09.2012 14:12:33\";7;1;41173591584,491\n"
                             "\"Level\";\"21.09.2012 14:12:33\";2,5;1;41173591587,963\n"
                             "\"$RT_COUNT$\";3;;;\n");
    ASSERT_EQ(table.columns.size(), 2U);
    ASSERT_EQ(table.time.size(), 3U);
    EXPECT_NEAR(table.time[0], 1348236712.7, 0.01); // 21.09.2012 14:11:52.7 by that column
    EXPECT_NEAR(table.time[2] - table.time[0], 0.5, 0.01);
    EXPECT_EQ(table.columns[0].value.back(), 2.5);
}

TEST(LongTable, WhatIsNotAsItShouldBeIsSaid) {
    EXPECT_EQ(notesOf("time_s,name,value\n0,Level,1\n1,Level,Bad\n2,Level,3\n2,Level,4\n0,State,idle\n"),
              (std::vector<std::string>{
                  "Column Level: 1 cell is not a number, the first (Bad) in line 3; the value above it is kept",
                  "1 row has the same time as the row above, the first in line 5; it is left out"}));
    EXPECT_EQ(read("time_s,name,value\n0,Level,1\n0,State,idle\n").withoutNumbers, (std::vector<std::string>{"State"}));
    const auto back = parseTable("time_s,name,value\n1,Level,1\n0,Level,2\n");
    ASSERT_FALSE(back);
    EXPECT_NE(back.error().message.english().find("line 3"), std::string::npos);
}

TEST(LongTable, AColumnOfNumbersCalledNameIsOneAsAnyOther) {
    const Table table = read("time_s,point,value\n0,1,10\n1,2,20\n");
    ASSERT_EQ(table.columns.size(), 2U);
    EXPECT_EQ(table.columns[0].name, "point");
}
