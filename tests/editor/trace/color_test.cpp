// The colour of a channel: its own, else the one that its name says, else the next of the theme.
#include "editor/kit/contrast.h"
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

/// What the curve of the only channel is drawn in.
QColor drawnOf(const char* own) {
    TraceSetup setup;
    setup.charts.emplace_back();
    setup.channels.emplace_back();
    setup.channels[0].expression = "Main.level";
    setup.channels[0].color = own;
    plot::PlotModel model;
    applySetup(model, setup, nullptr, nullptr);
    return model.curves.at(0).color;
}

TEST(ChannelColor, OfALightGroundCanBeReadOnADarkOne) {
    const char* const chosen[] = {"#1f5fbf", "#c03030", "#7a4fa3", "#2c7c86",
                                  "#404040", "#000080", "#8a5a00", "#ffd040"};
    EXPECT_EQ(drawnOf("#1f5fbf"), QColor("#1f5fbf"));
    kit::Theme::current().setChoice(kit::ThemeChoice::Dark);
    for (const char* color : chosen) {
        const QColor drawn = drawnOf(color);
        EXPECT_GE(kit::contrast(drawn, kit::colors().plotGround), 4.5) << color << " as " << drawn.name().toStdString();
        if (QColor(color).hslSaturationF() > 0.1F) {
            EXPECT_NEAR(drawn.hslHueF(), QColor(color).hslHueF(), 0.02) << color << ": the same colour, lighter";
        }
    }
    EXPECT_EQ(drawnOf("#ffd040"), QColor("#ffd040")) << "light enough";
    kit::Theme::current().setChoice(kit::ThemeChoice::Light);
}

} // namespace
} // namespace plc::trace
