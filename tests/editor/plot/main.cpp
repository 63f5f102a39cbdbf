// Test program of the plot: real events on real widgets without a display.
#include "editor/kit/theme.h"

#include <QApplication>

#include <gtest/gtest.h>

int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    ::testing::InitGoogleTest(&argc, argv);
    QApplication application(argc, argv);
    plc::kit::Theme::install(application, plc::kit::ThemeChoice::Light);
    return RUN_ALL_TESTS();
}
