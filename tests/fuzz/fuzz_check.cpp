// The front end at thousands of texts a second: no code is made. Most mutations are by the grammar, so that they reach
// the checker and lowering.
#include "tests/fuzz/grammar_mutator.h"

#include "tests/fuzz/entries_impl.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, size_t size) {
    return plc::fuzz::verdict(plc::fuzz::checkText(std::string_view(reinterpret_cast<const char*>(data), size)));
}
