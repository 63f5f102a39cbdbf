// The colour of a channel: its own, else the one that its name says, else the next of the theme.
#include "editor/kit/theme.h"
#include "editor/trace/curves/trace_plot.h"

#include <gtest/gtest.h>

namespace plc::trace {
namespace {

TEST(ChannelColor, IsTheOneThatTheNameSays) {
    TraceSetup setup;
    for (const char* const expression : {"IO.Red", "Main.level", "IO.Green"}) {
        ChannelSetup channel;
        channel.expression = expression;
        setup.channels.push_back(channel);
    }
    EXPECT_GT(channelColor(setup, 0).red(), 2 * channelColor(setup, 0).green());
    EXPECT_EQ(channelColor(setup, 1), kit::colors().curve(1));
    EXPECT_GT(channelColor(setup, 2).green(), channelColor(setup, 2).red());
    setup.channels[0].color = "#0000ff";
    EXPECT_EQ(channelColor(setup, 0), QColor(0, 0, 255));
    setup.channels[1].label = "Yellow lamp";
    EXPECT_NE(channelColor(setup, 1), kit::colors().curve(1));
}

} // namespace
} // namespace plc::trace
