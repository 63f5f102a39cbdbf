// The server's tests need an application object: panels are widgets that are never shown.
#include "runtime/compiler/jit/jit.h"
#include "runtime/controller/controller.h"

#include <QApplication>
#include <gtest/gtest.h>

int main(int argc, char** argv) {
    if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication application(argc, argv);
    plc::jit::setRuntimeSymbols(plc::controller::runtimeSymbols());
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
