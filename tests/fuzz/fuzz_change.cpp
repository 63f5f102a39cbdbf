// Online change: a program that runs is exchanged for a mutant of itself and back.
#include "tests/fuzz/grammar_mutator.h"

#include "tests/fuzz/entries_impl.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, size_t size) {
    static const bool ready = (plc::jit::setRuntimeSymbols(plc::controller::runtimeSymbols()), true);
    (void)ready;
    return plc::fuzz::verdict(plc::fuzz::changeText(std::string_view(reinterpret_cast<const char*>(data), size)));
}
