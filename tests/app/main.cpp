// Windows are tested with real events on real windows; each test begins with settings of its own.
#include "tests/app/killed_save.h"

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
    qputenv("STEPWISE_PROJECTS", settings.filePath("projects").toUtf8()); // copies of examples
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, settings.path());
    QApplication application(argc, argv);
    plc::jit::setRuntimeSymbols(plc::controller::runtimeSymbols());
    if (const QString folder = qEnvironmentVariable("STEPWISE_SAVE_FOLDER"); !folder.isEmpty())
        return plc::app::saveWithoutEnd(folder);
    plc::kit::Theme::install(application, plc::kit::ThemeChoice::Light);
    return RUN_ALL_TESTS();
}
