// Whoever opens an example sees a machine at work: it is whole (texts, pictures, trace, tests), its panels are without
// findings in every language, and in a minute of plant time with its start actions nothing faults and the panel moves.
#include "tests/examples/example_names.h"
#include "tests/examples/shown.h"
#include "tests/examples/text_of.h"

#include "app/cli/command_line.h"
#include "app/cli/panels/commands.h"
#include "app/cli/run/timed_write.h"
#include "hmi/player/panel_commands.h"
#include "projects/storage/project_file.h"
#include "projects/testing/test_run.h"

#include <QCryptographicHash>

#include <gtest/gtest.h>

#include <map>
#include <regex>
#include <set>
#include <sstream>

namespace plc {
namespace {

using std::chrono::nanoseconds;

std::vector<std::string> filesWith(const std::string& folder, const std::string& ending) {
    std::vector<std::string> out;
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(folder, ignored))
        if (entry.path().string().ends_with(ending)) out.push_back(entry.path().filename().string());
    return out;
}

/// The words of a line of docs/pictures.txt: `panel …` and `trace …` say what starts the machine and when its picture
/// is taken, `elements NUMBER` how many elements of its panels must then change (5 where it does not say).
std::vector<std::string> pictureOptions(const std::string& folder, const std::string& kind) {
    std::istringstream file(textOf(folder + "/docs/pictures.txt"));
    for (std::string line; std::getline(file, line);) {
        std::istringstream words(line);
        std::string word;
        words >> word;
        if (word != kind) continue;
        std::vector<std::string> out;
        while (words >> word) out.push_back(word);
        return out;
    }
    return {};
}

class Example : public ::testing::TestWithParam<std::string> {
protected:
    void SetUp() override {
        auto opened = projects::openProject({folder});
        ASSERT_TRUE(opened) << opened.error().english();
        project = std::move(*opened);
        panels = hmi::loadPanelProject(project);
    }
    const std::string folder = exampleFolder(GetParam());
    projects::Project project;
    hmi::PanelProject panels;
};

TEST_P(Example, HasReadmeWithPicturesPanelTraceTestsAndFourLanguages) {
    EXPECT_FALSE(project.panels.empty());
    EXPECT_NE(panels.find(panels.startPanel), nullptr) << "start panel \"" << panels.startPanel.toStdString() << "\"";
    EXPECT_FALSE(filesWith(folder + "/traces", ".trace.json").empty());
    EXPECT_FALSE(filesWith(folder + "/tests", ".st").empty());
    EXPECT_GE(project.languages.size(), 4u);
    for (const std::string needed : {"en", "de", "da"})
        EXPECT_TRUE(std::any_of(project.languages.begin(), project.languages.end(), [&](const std::string& tag) {
            return tag == needed || tag.starts_with(needed + "-");
        })) << needed;
    EXPECT_FALSE(pictureOptions(folder, "panel").empty()) << "docs/pictures.txt says how the machine is started";
    EXPECT_FALSE(pictureOptions(folder, "trace").empty());

    const std::string readme = textOf(folder + "/README.md");
    EXPECT_TRUE(readme.starts_with("# "));
    for (const std::string section : {"## What to watch", "## What to try", "## What you learn"})
        EXPECT_NE(readme.find("\n" + section + "\n"), std::string::npos) << section;
    EXPECT_NE(readme.find("\n3. "), std::string::npos) << "three things to try";
    std::set<std::string> pictures;
    const std::regex picture(R"(!\[[^\]]+\]\(([^)]+)\))");
    for (std::sregex_iterator at(readme.begin(), readme.end(), picture), end; at != end; ++at)
        pictures.insert((*at)[1]);
    EXPECT_TRUE(pictures.count("docs/panel.png") && pictures.count("docs/trace.png"));
    for (const std::string& path : pictures)
        EXPECT_FALSE(QImage(QString::fromStdString(folder + "/" + path)).isNull()) << path;
}

/// Each alarm of a project comes in one of its tests at least.
TEST_P(Example, TestsTheConditionsOfItsAlarms) {
    std::map<std::string, bool> came;
    for (const hmi::AlarmDefinition& alarm : panels.alarms.definitions()) came[alarm.condition.toStdString()] = false;
    if (came.empty()) return;
    plc::testing::Options options;
    options.finished = [&](session::Session& session) {
        const history::History& history = session.history();
        for (auto& [condition, isThere] : came) {
            if (isThere) continue;
            const auto expression = session.expression(condition);
            ASSERT_TRUE(expression) << condition << ": " << expression.error().message.english();
            isThere = expression->isTrue(history.seek(history.statistics().first)) ||
                      history
                          .find(*expression, session.recompile(condition), history.statistics().first,
                                history::History::Direction::Forward)
                          .has_value();
        }
    };
    const auto report = plc::testing::runTests(project, options);
    ASSERT_TRUE(report) << report.error().english();
    EXPECT_EQ(report->failed(), 0u);
    for (const auto& [condition, isThere] : came)
        EXPECT_TRUE(isThere) << "no test of the project in which " << condition;
}

/// Nobody needs the README to see something happen: a line on the start panel says what to press.
TEST_P(Example, SaysOnItsPanelWhatToPress) {
    const std::string panel = textOf(folder + "/hmi/" + panels.startPanel.toStdString() + ".panel.json");
    EXPECT_TRUE(panel.find("\"id\": \"press\"") != std::string::npos ||
                panel.find("\"id\": \"hint\"") != std::string::npos);
}

TEST_P(Example, SpeaksEveryLanguageAndItsPanelsAreWithoutFindings) {
    for (const Error& problem : panels.problems) ADD_FAILURE() << problem.english();
    const driver::Checked checked = driver::check(project.buildInput());
    EXPECT_FALSE(checked.analysis->hasErrors);
    for (const hmi::Finding& finding : hmi::checkPanels(panels, checked)) ADD_FAILURE() << finding.text().toStdString();
}

/// docs/examples.md links each sentence of a description to the TEST that shows it.
TEST_P(Example, HasTheTestsThatTheDocumentationNames) {
    const std::string page = textOf(folder + "/../../../docs/examples.md");
    const std::regex link(R"(\[([^\]]+)\]\(\.\./projects/examples/([^/]+)/([^)]+)\))");
    for (std::sregex_iterator at(page.begin(), page.end(), link), end; at != end; ++at) {
        if ((*at)[2] != GetParam()) continue;
        const std::string title = (*at)[1], file = (*at)[3];
        EXPECT_NE(textOf(folder + "/" + file).find("TEST '" + title + "'"), std::string::npos) << file << ": " << title;
    }
}

/// docs/odd_cases.md has a tick for each odd case of a system, which names its TEST.
TEST_P(Example, HasTheTestsThatTheOddCasesName) {
    const std::string page = textOf(folder + "/../../../docs/odd_cases.md");
    const std::regex tick(R"-(\(\.\./projects/examples/([^/]+)/([^ )]+) "([^"]+)"\))-");
    size_t ticks = 0;
    for (std::sregex_iterator at(page.begin(), page.end(), tick), end; at != end; ++at, ++ticks) {
        if ((*at)[1] != GetParam()) continue;
        const std::string file = (*at)[2], title = (*at)[3];
        EXPECT_NE(textOf(folder + "/" + file).find("TEST '" + title + "'"), std::string::npos) << file << ": " << title;
    }
    EXPECT_GT(ticks, 200u);
}

/// Every file that a picture of a project depends on, by its path.
std::vector<std::string> picturedFiles(const std::string& folder) {
    std::vector<std::string> files = {"docs/pictures.txt", "project.json"};
    for (const std::string part : {"src", "hmi", "traces"})
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder + "/" + part))
            if (entry.is_regular_file())
                files.push_back(std::filesystem::relative(entry.path(), folder).generic_string());
    std::sort(files.begin(), files.end());
    return files;
}

/// The pictures of the README are of the project as it is: docs/make_pictures.sh writes what they were made from.
TEST_P(Example, HasPicturesOfWhatItIsNow) {
    QCryptographicHash sum(QCryptographicHash::Sha256);
    for (const std::string& file : picturedFiles(folder)) {
        sum.addData(QByteArray::fromStdString(file + "\n"));
        sum.addData(QByteArray::fromStdString(textOf(folder + "/" + file)));
    }
    std::string recorded;
    std::istringstream(textOf(folder + "/docs/pictures.sum")) >> recorded;
    EXPECT_EQ(recorded, sum.result().toHex().toStdString())
        << "the pictures are older than the project: run docs/make_pictures.sh dev " << GetParam();
}

TEST_P(Example, RunsAMinuteWithoutAFaultAndItsPanelMoves) {
    driver::Built built = driver::build(project.buildInput());
    ASSERT_TRUE(built.program) << built.failure.english();
    const auto arguments = cli::Arguments::parse(cli::panelCommand().spec, pictureOptions(folder, "panel"));
    ASSERT_TRUE(arguments) << arguments.error().english();
    nanoseconds length = std::chrono::minutes(1);
    if (const auto text = arguments->value("--at")) {
        const auto time = cli::parseDuration(*text);
        ASSERT_TRUE(time) << time.error().english();
        length = std::max(length, *time);
    }
    session::Settings settings;
    settings.historyBudget = size_t(1) << 30;
    session::Session session(std::move(built), settings);
    const auto ran = cli::runProject(*arguments, session.built(), session, length, "");
    ASSERT_TRUE(ran) << ran.error().english();
    EXPECT_EQ(session.controller().state(), controller::State::Running);
    EXPECT_FALSE(session.controller().fault()) << session.controller().fault()->message.english();
    EXPECT_FALSE(session.controller().simulationFault()) << session.controller().simulationFault()->message.english();
    EXPECT_GE(session.controller().lastTime() + std::chrono::seconds(2), length);

    ShownElements shown(panels, session);
    for (const hmi::NamedPanel& panel : panels.panels) shown.add(panel);
    EXPECT_EQ(shown.watch(length), "") << "shows nothing";
    const size_t moved = shown.moved().size();
    std::string still;
    for (const std::string& name : shown.still()) still += " " + name;
    std::cout << GetParam() << ": " << moved << " of " << shown.count() << " elements with values change\n";
    const std::vector<std::string> named = pictureOptions(folder, "elements");
    const size_t wanted = named.empty() ? 5 : std::stoul(named[0]);
    EXPECT_GE(wanted, 2u);
    EXPECT_GE(moved, wanted) << "still:" << still;
}

INSTANTIATE_TEST_SUITE_P(Examples, Example, ::testing::ValuesIn(exampleNames()),
                         [](const auto& info) { return info.param; });

} // namespace
} // namespace plc
