// libFuzzer's mutator for scripts, with the last of them as donors. Included once per fuzz target.
#pragma once
#include "tests/fuzz/scripts.h"

#include <cstring>

extern "C" size_t LLVMFuzzerMutate(unsigned char* data, size_t size, size_t maxSize);

extern "C" size_t LLVMFuzzerCustomMutator(unsigned char* data, size_t size, size_t maxSize, unsigned seed) {
    static plc::fuzz::Lent lent;
    plc::testing::Damage damage(seed);
    if (damage.pick(16) == 0) return LLVMFuzzerMutate(data, size, maxSize);
    const std::string mutant =
        plc::fuzz::changedScript(std::string(reinterpret_cast<const char*>(data), size), lent, damage);
    if (mutant.empty() || mutant.size() > maxSize) return LLVMFuzzerMutate(data, size, maxSize);
    std::memcpy(data, mutant.data(), mutant.size());
    return mutant.size();
}
