// The first byte says which kind of file the rest is. What is JSON is mostly changed as such, with one of the last
// files of its kind as the donor: a change of bytes seldom leaves it readable.
#include "tests/fuzz/application.h"
#include "tests/fuzz/inputs_impl.h"
#include "tests/support/damage.h"

#include <array>
#include <cstring>
#include <iterator>
#include <optional>

namespace {

using plc::testing::Damage;
constexpr size_t kKinds = std::size(plc::fuzz::kInputs);

} // namespace

extern "C" size_t LLVMFuzzerMutate(unsigned char* data, size_t size, size_t maxSize);

extern "C" size_t LLVMFuzzerCustomMutator(unsigned char* data, size_t size, size_t maxSize, unsigned seed) {
    static std::array<std::array<Damage::Json, 16>, kKinds> recent;
    Damage damage(seed);
    if (size == 0 || damage.pick(8) == 0) return LLVMFuzzerMutate(data, size, maxSize);
    std::optional<Damage::Json> json = Damage::readable({reinterpret_cast<const char*>(data) + 1, size - 1});
    if (!json) return LLVMFuzzerMutate(data, size, maxSize);
    auto& ofItsKind = recent[data[0] % kKinds];
    const Damage::Json& donor = ofItsKind[damage.pick(ofItsKind.size())];
    const std::string mutant = damage.json(*json, donor.is_null() ? *json : donor)
                                   .dump(-1, ' ', false, Damage::Json::error_handler_t::replace);
    ofItsKind[damage.pick(ofItsKind.size())] = std::move(*json);
    if (mutant.size() >= maxSize) return LLVMFuzzerMutate(data, size, maxSize);
    std::memcpy(data + 1, mutant.data(), mutant.size());
    return mutant.size() + 1;
}

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, size_t size) {
    plc::fuzz::needApplication();
    if (size == 0) return 0;
    plc::fuzz::kInputs[data[0] % kKinds].read(std::string(reinterpret_cast<const char*>(data) + 1, size - 1));
    return 0;
}
