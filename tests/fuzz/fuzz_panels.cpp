// What a person does on panels of any shape while the program runs; an input is a script.
#include "tests/fuzz/panels_impl.h"
#include "tests/fuzz/script_mutator.h"

#include <QApplication>

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, size_t size) {
    static int count = 1;
    static char name[] = "fuzz_panels";
    static char* words[] = {name, nullptr};
    static QApplication* const application = (qputenv("QT_QPA_PLATFORM", "offscreen"), new QApplication(count, words));
    (void)application;
    plc::fuzz::operatePanels(std::string(reinterpret_cast<const char*>(data), size));
    return 0;
}
