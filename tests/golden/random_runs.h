// How random programs are run and compared: the values after each scan, the fault where there is one. Functions and
// values of one thread.
#pragma once
#include "runtime/compiler/driver/driver.h"
#include "runtime/controller/controller.h"
#include "tests/golden/random_generator.h"

#include <string>
#include <vector>

namespace plc::golden {

constexpr int kScans = 6;

/// What a program left behind: the bytes of the whole image, or those of its instance.
struct Scanned {
    std::vector<std::vector<std::byte>> images;
    std::string fault, faultMessage; // with and without its place
    std::string faultLine;           // the statement in the text
    size_t stops = 0;                // at statements
};

enum class Run : uint8_t { Newest /* code */, Asked /* at every statement */ };

[[nodiscard]] controller::Settings randomSettings();
/// Takes over what stopped the controller, if anything has.
void takeFault(const controller::Controller& controller, Scanned& into);
void askAtEveryStatement(controller::Controller& controller, size_t& stops);

/// Where two images of an instance differ, else "". A NaN keeps its sign or not; texts differ behind their end.
/// `from`: the offset in the image of their first bytes.
[[nodiscard]] std::string differenceIn(const image::CompiledProgram& program, const image::Root& root,
                                       const std::vector<std::byte>& a, const std::vector<std::byte>& b, uint32_t from);
/// Between two runs of an instance: its faults or the first scan that differs, else "".
[[nodiscard]] std::string differenceBetween(const image::CompiledProgram& program, const image::Root& root,
                                            const Scanned& a, const Scanned& b, uint32_t from);
/// What the expression evaluator says otherwise of the watched expressions, after the last scan of `run`; "" when
/// nothing. Of the one at which the program faulted it must say the same fault. `image`: all of it.
[[nodiscard]] std::string evaluatedOtherwise(const driver::Built& built, const std::string& instance,
                                             const RandomProgram& program, const Scanned& run,
                                             std::span<const std::byte> image);

/// Errors that chance makes: a constant index or divisor that cannot be.
[[nodiscard]] bool isByChance(const diagnostics::Diagnostic& diagnostic);

} // namespace plc::golden
