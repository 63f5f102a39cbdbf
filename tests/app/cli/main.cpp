// The commands run as a user calls them, words in, text out; each test in a folder of its own.
#include "runtime/compiler/jit/jit.h"
#include "runtime/controller/controller.h"

#include <QApplication>

#include <gtest/gtest.h>

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    QApplication application(argc, argv);
    plc::jit::setRuntimeSymbols(plc::controller::runtimeSymbols());
    return RUN_ALL_TESTS();
}
