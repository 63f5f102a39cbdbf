// The first byte says which kind of file the rest is.
#include "tests/fuzz/inputs_impl.h"

#include <QApplication>

#include <iterator>

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, size_t size) {
    static int count = 1;
    static char name[] = "fuzz_inputs";
    static char* words[] = {name, nullptr};
    static QApplication* const application = (qputenv("QT_QPA_PLATFORM", "offscreen"), new QApplication(count, words));
    (void)application;
    if (size == 0) return 0;
    plc::fuzz::kInputs[data[0] % std::size(plc::fuzz::kInputs)].read(
        std::string(reinterpret_cast<const char*>(data) + 1, size - 1));
    return 0;
}
