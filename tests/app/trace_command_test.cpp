// `stepwise trace` as its user types it: files written, texts printed, wrong words refused.
#include "app/cli/command_line.h"
#include "tests/support/paths.h"

#include "projects/session/session.h"
#include "runtime/compiler/jit/jit.h"

#include <QFile>
#include <QImage>
#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <filesystem>

namespace {

const std::string Examples = plc::sourceDir() + "/projects/examples/";

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

QList<QByteArray> linesOf(const QString& path) {
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << path.toStdString();
    return file.readAll().trimmed().split('\n');
}

} // namespace

TEST(TraceCommand, DrawsTheProjectsOwnSetup) {
    QTemporaryDir folder;
    const QString picture = folder.filePath("loop.png"), csv = folder.filePath("loop.csv");
    const Said said = say({Examples + "pid_pt1", "--for", "2s", "--picture", picture.toStdString(), "--csv",
                           csv.toStdString(), "--size", "800x500", "--statistics"});
    EXPECT_EQ(said.code, 0) << said.err;
    EXPECT_EQ(QImage(picture).size(), QSize(800, 500));
    const auto lines = linesOf(csv);
    EXPECT_EQ(lines.size(), 41) << "2 s at 50 ms, and the header";
    EXPECT_EQ(lines[0], "time [s],Set point,Open loop,Closed loop,Output");
    EXPECT_NE(said.out.find("Closed loop"), std::string::npos);
    EXPECT_NE(said.out.find("RMS"), std::string::npos);
}

TEST(TraceCommand, ChannelsMayHoldCommasInBrackets) {
    QTemporaryDir folder;
    const QString csv = folder.filePath("a.csv");
    const Said said = say({Examples + "pid_pt1", "--for", "1s", "--channels",
                           "Main.SetPoint,LIMIT(-50.0, Main.SetPoint, 50.0)", "--csv", csv.toStdString()});
    ASSERT_EQ(said.code, 0) << said.err;
    const auto lines = linesOf(csv);
    for (qsizetype i = 1; i < lines.size(); ++i) {
        const auto cells = lines[i].split(',');
        EXPECT_EQ(std::clamp(cells[1].toDouble(), -50.0, 50.0), cells[2].toDouble()) << lines[i].toStdString();
    }
}

TEST(TraceCommand, WritesAndTriggersActAtTheirTimes) {
    const Said said =
        say({Examples + "pid_pt1", "--for", "4s", "--set", "Main.Amplitude=30@2s", "--channels", "Main.SetPoint",
             "--trigger", "ABS(Main.SetPoint) < 50.0", "--before", "100ms", "--after", "1s", "--statistics"});
    ASSERT_EQ(said.code, 0) << said.err;
    EXPECT_NE(said.out.find("Triggered at 2 s"), std::string::npos) << said.out;
    const Said never = say(
        {Examples + "pid_pt1", "--for", "1s", "--channels", "Main.SetPoint", "--trigger", "Main.SetPoint > 1000.0"});
    EXPECT_EQ(never.code, 0);
    EXPECT_NE(never.out.find("did not fire"), std::string::npos);
}

TEST(TraceCommand, ARecordingDrawsLikeTheRun) {
    QTemporaryDir folder;
    const QString rec = folder.filePath("a.rec"), one = folder.filePath("1.csv"), two = folder.filePath("2.csv");
    testing::internal::CaptureStdout();
    ASSERT_EQ(plc::cli::runCommandLine({"run", Examples + "pid_pt1", "--for", "2s", "--record", rec.toStdString()}), 0);
    testing::internal::GetCapturedStdout();
    ASSERT_EQ(
        say({"--recording", rec.toStdString(), "--channels", "Main.SetPoint,IO.Drive", "--csv", one.toStdString()})
            .code,
        0);
    ASSERT_EQ(
        say({Examples + "pid_pt1", "--for", "2s", "--channels", "Main.SetPoint,IO.Drive", "--csv", two.toStdString()})
            .code,
        0);
    EXPECT_EQ(linesOf(one), linesOf(two));
}

TEST(TraceCommand, EveryShippedSetupDraws) {
    QTemporaryDir folder;
    int drawn = 0;
    for (const auto& project : std::filesystem::directory_iterator(Examples)) {
        const auto traces = project.path() / "traces";
        if (!std::filesystem::is_directory(traces)) continue;
        for (const auto& file : std::filesystem::directory_iterator(traces)) {
            const QString picture = folder.filePath(QString("%1.png").arg(drawn++));
            const Said said = say({project.path().string(), "--setup", file.path().string(), "--for", "300ms",
                                   "--picture", picture.toStdString()});
            EXPECT_EQ(said.code, 0) << file.path() << ": " << said.err;
            EXPECT_FALSE(QImage(picture).isNull()) << file.path();
        }
    }
    EXPECT_GT(drawn, 3);
}

TEST(TraceCommand, RefusesWrongUseWithAReason) {
    struct Row {
        std::vector<std::string> words;
        const char* part;
    };
    for (const Row& row :
         {Row{{}, "needs a project"}, Row{{Examples + "motor", "--for", "1s", "--channels", "Main.nothing"}, "nothing"},
          Row{{Examples + "pid_pt1", "--setup", "missing"}, "missing"},
          Row{{Examples + "pid_pt1", "--size", "big"}, "--size"},
          Row{{Examples + "pid_pt1", "--for", "1s", "--picture", "a.gif"}, ".png"},
          Row{{Examples + "pid_pt1", "--cursors", "1s"}, "--cursors"},
          Row{{Examples + "pid_pt1", "--for", "ten"}, "ten"}}) {
        const Said said = say(row.words);
        EXPECT_EQ(said.code, 2);
        EXPECT_NE(said.err.find(row.part), std::string::npos) << said.err;
    }
}

TEST(ReplayCommand, EveryScanIsReadAsTheProgramMeantItThatMadeIt) {
    static const bool once = (plc::jit::setRuntimeSymbols(plc::controller::runtimeSymbols()), true);
    (void)once;
    const auto build = [](const char* text) {
        plc::driver::BuildInput input;
        input.files.push_back({"main.st", text});
        return plc::driver::build(input);
    };
    QTemporaryDir folder;
    const std::string rec = folder.filePath("a.rec").toStdString(), csv = folder.filePath("a.csv").toStdString();
    {
        plc::session::Session session(build("PROGRAM Main VAR a : INT; END_VAR a := a + 1; END_PROGRAM"));
        session.controller().start();
        for (int i = 0; i < 10; ++i) ASSERT_TRUE(session.controller().scan());
        // Another variable lies where `a` was.
        session.changeProgram(build("PROGRAM Main VAR first : LREAL := 7.0; a : INT; END_VAR a := a + 1; END_PROGRAM"),
                              [](const plc::controller::OnlineChangeReport&) {});
        for (int i = 0; i < 10; ++i) ASSERT_TRUE(session.controller().scan());
        ASSERT_TRUE(session.history().save(rec));
    }
    const auto replay = [](std::vector<std::string> words) {
        testing::internal::CaptureStdout();
        testing::internal::CaptureStderr();
        words.insert(words.begin(), "replay");
        const int code = plc::cli::runCommandLine(words);
        return Said{code, testing::internal::GetCapturedStdout(), testing::internal::GetCapturedStderr()};
    };
    const Said found =
        replay({rec, "--find", "Main.a = 3", "--watch", "Main.a", "--watch", "Main.first", "--csv", csv});
    ASSERT_EQ(found.code, 0) << found.err;
    EXPECT_NE(found.out.find("Main.a      3\n"), std::string::npos) << found.out;
    EXPECT_NE(found.out.find("Main.first  (did not exist at that scan)"), std::string::npos) << found.out;
    const auto lines = linesOf(QString::fromStdString(csv));
    ASSERT_EQ(lines.size(), 21);
    for (qsizetype i = 1; i < lines.size(); ++i)
        EXPECT_EQ(lines[i].trimmed().split(',')[2].toInt(), i) << lines[i].constData();
    EXPECT_EQ(lines[5].trimmed().split(',')[3], "");
    EXPECT_EQ(lines[20].trimmed().split(',')[3].toDouble(), 7.0);
    EXPECT_EQ(replay({rec, "--find", "Main.a"}).code, 2) << "no condition";
    EXPECT_NE(replay({rec, "--watch", "Main.none"}).err.find("none"), std::string::npos);
    EXPECT_EQ(replay({folder.filePath("no.rec").toStdString()}).code, 2);
}
