// libFuzzer's mutator for ST: by the grammar mostly, by bytes now and then, with one of the last texts as the donor.
// Included once per fuzz target.
#pragma once
#include "tests/fuzz/grammar.h"

#include <array>
#include <cstring>

extern "C" size_t LLVMFuzzerMutate(unsigned char* data, size_t size, size_t maxSize);

extern "C" size_t LLVMFuzzerCustomMutator(unsigned char* data, size_t size, size_t maxSize, unsigned seed) {
    static std::array<std::string, 64> recent;
    if (seed % 8 == 0) return LLVMFuzzerMutate(data, size, maxSize);
    const std::string text(reinterpret_cast<const char*>(data), size);
    const std::string mutant = plc::fuzz::mutateByGrammar(text, recent[seed / 8 % recent.size()], seed);
    recent[seed / 512 % recent.size()] = text;
    const size_t kept = mutant.size() < maxSize ? mutant.size() : maxSize;
    std::memcpy(data, mutant.data(), kept);
    return kept;
}
