// Small programs in quick code, a quarter of them in optimised code as well. Only programs that ran are kept, and most
// mutations are by the grammar, so that most of what is tried is a program.
#include "tests/fuzz/grammar_mutator.h"

#include "tests/fuzz/entries_impl.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, size_t size) {
    static const bool ready = (plc::jit::setRuntimeSymbols(plc::controller::runtimeSymbols()), true);
    (void)ready;
    return plc::fuzz::verdict(plc::fuzz::runText(std::string_view(reinterpret_cast<const char*>(data), size)));
}
