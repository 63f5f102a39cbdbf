// Widgets of the text editor without a window around them.
#include "editor/kit/theme.h"

#include <QApplication>

#include <gtest/gtest.h>

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    QApplication application(argc, argv);
    plc::kit::Theme::install(application, plc::kit::ThemeChoice::Light);
    return RUN_ALL_TESTS();
}
