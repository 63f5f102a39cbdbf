// Devices and served controllers in the studio's window; settings of its own.
#include "editor/kit/theme.h"
#include "runtime/compiler/jit/jit.h"
#include "runtime/controller/controller.h"

#include <QApplication>
#include <QSettings>
#include <QTemporaryDir>

#include <gtest/gtest.h>

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    QTemporaryDir settings;
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, settings.path());
    QApplication application(argc, argv);
    plc::jit::setRuntimeSymbols(plc::controller::runtimeSymbols());
    plc::kit::Theme::install(application, plc::kit::ThemeChoice::Light);
    return RUN_ALL_TESTS();
}
