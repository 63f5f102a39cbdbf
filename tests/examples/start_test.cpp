// Whoever presses F5 on an example sees its machine at work within seconds, without a hand on the panel.
#include "tests/examples/example_names.h"
#include "tests/examples/shown.h"

#include "app/cli/command_line.h"
#include "app/cli/panels/commands.h"
#include "app/cli/run/timed_write.h"
#include "hmi/player/panel_commands.h"
#include "projects/storage/project_file.h"

#include <gtest/gtest.h>

#include <iostream>

namespace plc {
namespace {

constexpr std::chrono::seconds kWatched{8};            // of somebody who has pressed F5
constexpr size_t kLeastElements = 2, kLeastValues = 2; // that are something else by then

class Start : public ::testing::TestWithParam<std::string> {};

TEST_P(Start, MovesItsPanelWithinSecondsWithoutAHand) {
    const auto project = projects::openProject({exampleFolder(GetParam())});
    ASSERT_TRUE(project) << project.error().english();
    const hmi::PanelProject panels = hmi::loadPanelProject(*project);
    const hmi::NamedPanel* panel = panels.find(panels.startPanel);
    ASSERT_TRUE(panel);
    driver::Built built = driver::build(project->buildInput());
    ASSERT_TRUE(built.program) << built.failure.english();
    const auto arguments = cli::Arguments::parse(cli::panelCommand().spec, {});
    ASSERT_TRUE(arguments) << arguments.error().english();
    session::Session session(std::move(built), session::Settings{});
    const auto ran = cli::runProject(*arguments, session.built(), session, kWatched, "");
    ASSERT_TRUE(ran) << ran.error().english();
    EXPECT_FALSE(session.controller().fault()) << session.controller().fault()->message.english();

    ShownElements shown(panels, session);
    shown.add(*panel);
    EXPECT_EQ(shown.watch(kWatched), "");
    const std::set<std::string> moved = shown.moved();
    std::cout << GetParam() << ": " << moved.size() << " of " << shown.count() << " elements with values change, "
              << shown.movedValues() << " values:";
    for (const std::string& name : moved) std::cout << " " << name;
    std::cout << "\n";
    EXPECT_GE(moved.size(), kLeastElements);
    EXPECT_GE(shown.movedValues(), kLeastValues);
}

INSTANTIATE_TEST_SUITE_P(Examples, Start, ::testing::ValuesIn(exampleNames()),
                         [](const auto& info) { return info.param; });

} // namespace
} // namespace plc
