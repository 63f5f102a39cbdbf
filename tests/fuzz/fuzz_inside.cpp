// What is said of recorded scans: looks, a scan walked through and back, answers, coverage. Of small programs, most of
// them changed by the grammar; only programs that ran are kept.
#include "tests/fuzz/grammar_mutator.h"

#include "tests/fuzz/inside_impl.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, size_t size) {
    static const bool ready = (plc::jit::setRuntimeSymbols(plc::controller::runtimeSymbols()), true);
    (void)ready;
    return plc::fuzz::verdict(plc::fuzz::lookInside(std::string_view(reinterpret_cast<const char*>(data), size)));
}
