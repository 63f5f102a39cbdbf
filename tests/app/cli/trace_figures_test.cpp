// `stepwise trace` beyond curves over time: XY, spectrum, response, runs, tables, remarks; and what it refuses.
#include "app/cli/command_line.h"
#include "tests/support/paths.h"

#include <QFile>
#include <QImage>
#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>

namespace {

struct Said {
    int code;
    std::string out, err;
};

Said say(std::vector<std::string> words) {
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    words.insert(words.begin(), "trace");
    const int code = plc::cli::runCommandLine(words);
    return {code, testing::internal::GetCapturedStdout(), testing::internal::GetCapturedStderr()};
}

const std::string kLoop = plc::sourceDir() + "/projects/examples/pid_pt1";

/// A bench with a sine of 3 Hz and its answer a quarter turn later.
std::string tableIn(const QTemporaryDir& folder) {
    const std::string path = folder.filePath("bench.csv").toStdString();
    std::ofstream out(path);
    out.precision(15);
    out << "time_s,Force [N],Way [mm]\n";
    for (int i = 0; i < 4096; ++i) { // 3 Hz is a line of the spectrum
        const double t = i / 256.0, turn = 2 * std::numbers::pi * 3 * t;
        out << t << ',' << 4 * std::sin(turn) << ',' << -2 * std::cos(turn) << '\n';
    }
    return path;
}

} // namespace

TEST(TraceFigures, ASpectrumOfATableNamesItsPeak) {
    QTemporaryDir folder;
    const std::string picture = folder.filePath("s.png").toStdString();
    const Said said = say({"--recording", tableIn(folder), "--spectrum", "Force", "--picture", picture});
    ASSERT_EQ(said.code, 0) << said.err;
    EXPECT_NE(said.out.find("3 Hz (4"), std::string::npos) << said.out;
    EXPECT_EQ(QImage(QString::fromStdString(picture)).size(), QSize(1200, 700));
}

TEST(TraceFigures, AnXyPlotGoesIntoATable) {
    QTemporaryDir folder;
    const QString csv = folder.filePath("xy.csv");
    const Said said = say({"--recording", tableIn(folder), "--xy", "Force,Way", "--csv", csv.toStdString()});
    ASSERT_EQ(said.code, 0) << said.err;
    QFile file(csv);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    const auto lines = file.readAll().trimmed().split('\n');
    ASSERT_EQ(lines.size(), 4097);
    for (qsizetype i = 1; i < lines.size(); i += 97) {
        const auto cells = lines[i].split(',');
        EXPECT_NEAR(std::pow(cells[2].toDouble() / 4, 2) + std::pow(cells[3].toDouble() / 2, 2), 1, 1e-3);
    }
}

TEST(TraceFigures, RunsOfAProjectAreLaidOverEachOther) {
    QTemporaryDir folder;
    const std::string picture = folder.filePath("runs.svg").toStdString();
    const Said said = say({kLoop, "--for", "60s", "--runs", "IO.Measured", "--trigger", "Main.SetPoint > 0.0",
                           "--before", "1s", "--after", "5s", "--picture", picture});
    ASSERT_EQ(said.code, 0) << said.err;
    EXPECT_NE(said.out.find("run"), std::string::npos) << said.out;
    EXPECT_TRUE(QFile::exists(QString::fromStdString(picture)));
}

TEST(TraceFigures, DerivedChannelsAndMeasuredOnesAreInTheTable) {
    QTemporaryDir folder;
    const QString csv = folder.filePath("a.csv");
    const Said said =
        say({kLoop, "--for", "2s", "--channels", "Main.SetPoint,FILTER(Main.SetPoint, T#200ms)", "--measured",
             tableIn(folder) + "=Way,Force * 2.0", "--note", "1s=Look here", "--csv", csv.toStdString()});
    ASSERT_EQ(said.code, 0) << said.err;
    QFile file(csv);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    const QByteArray head = file.readLine();
    EXPECT_TRUE(head.contains("Way (bench)")) << head.toStdString();
    EXPECT_TRUE(head.contains("FILTER")) << head.toStdString();
}

TEST(TraceFigures, WrongWordsAreRefusedWithTheRemedy) {
    QTemporaryDir folder;
    const std::string table = tableIn(folder);
    for (const auto& [words, say_] :
         {std::pair{std::vector<std::string>{"--xy", "Force"}, "two expressions"},
          std::pair{std::vector<std::string>{"--xy", "Force,Way", "--spectrum", "Way"}, "Only one of"},
          std::pair{std::vector<std::string>{"--spectrum", "Force", "--window", "round"}, "hann"},
          std::pair{std::vector<std::string>{"--channels", "Force", "--note", "soon"}, "a time and a text"},
          std::pair{std::vector<std::string>{"--channels", "Force", "--measured", "x.csv"}, "a file and expressions"},
          std::pair{std::vector<std::string>{"--channels", "Force", "--measured", "gone.csv=A"}, "gone.csv"},
          std::pair{std::vector<std::string>{"--channels", "FILTER(Force)"}, "needs a time"},
          std::pair{std::vector<std::string>{"--channels", "Fource"}, "is not declared"}}) {
        std::vector<std::string> all{"--recording", table};
        all.insert(all.end(), words.begin(), words.end());
        const Said said = say(all);
        EXPECT_NE(said.code, 0) << words.back();
        EXPECT_NE(said.err.find(say_), std::string::npos) << words.back() << ": " << said.err;
    }
}
