// Manual pages and completions say what the commands' tables say, in forms that man, bash and zsh read without
// complaint.
#include "tests/app/cli/command_fixture.h"
#include "tests/support/patience.h"

#include <QProcess>

#include <gtest/gtest.h>

#include <set>

namespace plc {
namespace {

class Manual : public CommandTest {
protected:
    /// Standard output and error of a program that must end well.
    static std::string outputOf(const QString& program, const QStringList& words) {
        QProcess process;
        process.setProcessChannelMode(QProcess::MergedChannels);
        process.start(program, words);
        EXPECT_TRUE(process.waitForFinished(kPatience)) << program.toStdString();
        EXPECT_EQ(process.exitCode(), 0) << program.toStdString();
        return process.readAll().toStdString();
    }
    /// What bash offers for the words typed so far.
    std::set<std::string> offered(const QStringList& typed) {
        const QString script =
            QString("source '%1'; COMP_WORDS=(%2); COMP_CWORD=%3; _stepwise; printf '%s\\n' \"${COMPREPLY[@]}\"")
                .arg(QString::fromStdString(path("completion/stepwise")), typed.join(' '))
                .arg(typed.size() - 1);
        std::istringstream lines(outputOf("bash", {"-c", script}));
        std::set<std::string> out;
        for (std::string line; std::getline(lines, line);) out.insert(line);
        return out;
    }
};

} // namespace

TEST_F(Manual, EveryCommandHasAPageWithAllItsOptions) {
    ASSERT_EQ(command({"doc", "man", "--out", path("man1")}), 0) << err;
    const std::string overview = read("man1/stepwise.1");
    for (const cli::Command& each : cli::commands()) {
        const std::string name(each.spec.name), page = read("man1/stepwise-" + name + ".1");
        EXPECT_NE(overview.find("stepwise\\-" + name), std::string::npos) << name;
        EXPECT_NE(page.find(".SH NAME\nstepwise\\-" + name + " \\- "), std::string::npos) << name;
        for (const cli::OptionSpec& option : each.spec.options) {
            std::string escaped;
            for (const char c : option.name) escaped += c == '-' ? "\\-" : std::string(1, c);
            EXPECT_NE(page.find("\\fB" + escaped + "\\fR"), std::string::npos) << name << " " << option.name;
        }
    }
}

TEST_F(Manual, ThePagesAreSoundTroff) {
    ASSERT_EQ(command({"doc", "man", "--out", path("man1")}), 0) << err;
    for (const cli::Command& each : cli::commands()) {
        const QString page = QString::fromStdString(path("man1/stepwise-" + std::string(each.spec.name) + ".1"));
        EXPECT_EQ(outputOf("groff", {"-man", "-Tutf8", "-Kutf8", "-wall", "-z", page}), "") << page.toStdString();
    }
}

TEST_F(Manual, BashOffersCommandsOptionsAndTheirValues) {
    ASSERT_EQ(command({"doc", "completion", "--out", path("completion")}), 0) << err;
    const auto first = offered({"stepwise", "''"});
    for (const cli::Command& each : cli::commands()) {
        EXPECT_TRUE(first.contains(std::string(each.spec.name))) << each.spec.name;
        const auto options =
            offered({"stepwise", QString::fromUtf8(each.spec.name.data(), qsizetype(each.spec.name.size())), "--"});
        for (const cli::OptionSpec& option : each.spec.options)
            EXPECT_TRUE(options.contains(std::string(option.name))) << each.spec.name << " " << option.name;
    }
    EXPECT_EQ(offered({"stepwise", "run", "--sc"}), std::set<std::string>{"--scans"});
    EXPECT_EQ(offered({"stepwise", "build", "--target", "''"}), (std::set<std::string>{"x86_64", "aarch64"}));
    const auto files = offered({"stepwise", "run", "--csv", QString::fromStdString(path("completion/"))});
    EXPECT_TRUE(files.contains(path("completion/stepwise")));
}

TEST_F(Manual, ZshReadsItsCompletion) {
    ASSERT_EQ(command({"doc", "completion", "--out", path("completion")}), 0) << err;
    EXPECT_EQ(outputOf("zsh", {"-n", QString::fromStdString(path("completion/_stepwise"))}), "");
    const std::string text = read("completion/_stepwise");
    EXPECT_TRUE(text.starts_with("#compdef stepwise\n"));
    for (const cli::Command& each : cli::commands())
        for (const cli::OptionSpec& option : each.spec.options)
            EXPECT_NE(text.find("'*" + std::string(option.name) + (option.value.empty() ? "[" : "=[")),
                      std::string::npos)
                << each.spec.name << " " << option.name;
}

TEST_F(Manual, ItSaysWhatItCanWrite) {
    EXPECT_EQ(command({"doc", "poem"}), 2);
    EXPECT_NE(err.find("stepwise doc library, diagnostics, man or completion"), std::string::npos) << err;
    EXPECT_EQ(command({"doc", "man", "--out", "/proc/man1"}), 2);
    EXPECT_NE(err.find("cannot be written"), std::string::npos) << err;
}

} // namespace plc
