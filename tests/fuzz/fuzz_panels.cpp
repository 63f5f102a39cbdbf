// What a person does on panels of any shape while the program runs; an input is a script.
#include "tests/fuzz/application.h"
#include "tests/fuzz/panels_impl.h"
#include "tests/fuzz/script_mutator.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, size_t size) {
    plc::fuzz::needApplication();
    plc::fuzz::operatePanels(std::string(reinterpret_cast<const char*>(data), size));
    return 0;
}
