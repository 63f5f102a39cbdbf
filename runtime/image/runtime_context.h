// THE CONTRACT, part 2: what generated code gets beside the image, and how it leaves on a fault. One RuntimeContext
// belongs to one scan thread. Plain data with a fixed layout: codegen addresses its members by offsetof.
#pragma once
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace plc::image {

enum class FaultCode : uint32_t {
    None = 0,
    DivisionByZero,
    IndexOutOfRange, // detail: index, low, high
    NullReference,
    ForeignReference, // pointer outside declared variables, or not at an instance of the right type
    MissingInOut,
    StringIndex,   // detail: index, 0, length - 1
    Watchdog,      // loop budget or wall-clock watchdog
    StackOverflow, // recursion depth or frame area
    AbstractCall,
    Stopped,         // the scan was abandoned on request (reset or close while halted)
    ValueOutOfRange, // of a subrange; detail: value, low, high
};

/// Each call that is not inlined away leaves its site here; depth counts the live ones. The record is written around
/// the call and describes the callee; the program a task runs has none of its own (the controller knows it), unless its
/// entry makes one with site 0.
struct CallRecord {
    uint32_t site = 0;     // DebugMap site of the call
    uint32_t function = 0; // index into CompiledProgram::functions
    uint32_t instance = 0; // image offset of THIS, 0 = none
    uint32_t frame = 0;    // image offset of its frame, 0 = none
};

inline constexpr uint32_t kMaximumDepth = 256;
inline constexpr uint32_t kDirtyPage = 1024;
[[nodiscard]] constexpr uint32_t dirtyPageCount(uint32_t imageSize) {
    return imageSize / kDirtyPage + 1;
} // without the one behind

struct RuntimeContext {
    std::byte* image = nullptr;
    uint32_t dataBegin = 64; // declared variables: [dataBegin, dataEnd)
    uint32_t dataEnd = 0;
    uint32_t frameTop = 0;    // next free byte of the frame area
    uint32_t imageSize = 0;   // end of the frame area
    int64_t loopBudget = 0;   // charged by loops and calls; at < 0 generated code calls plcBudgetUsedUp
    uint32_t depth = 0;       // live entries of calls
    uint32_t currentSite = 0; // quick tier: the statement being executed
    FaultCode fault = FaultCode::None;
    uint32_t faultSite = 0;
    int64_t faultDetail[3] = {};
    /// Quick tier: one byte per site; not 0 = call plcAtSite before the statement (breakpoint, step, coverage).
    uint8_t* siteFlags = nullptr;
    void* owner = nullptr; // the Controller
    CallRecord calls[kMaximumDepth];
    /// Code of large programs (Code::marksWrites) sets the byte of each kDirtyPage bytes of the image it writes to; one
    /// more byte behind takes what lies outside. The recording then looks at those pages only.
    uint8_t* dirtyPages = nullptr;
    uint64_t stackLimit = 0; // set by each entry: recursive functions do not go below it on the thread's own stack
};

/// How a protected part of a function ends when no fault leaves it; exception codes are greater.
enum class Leaving : uint32_t { End, Exit, Continue, Return };
using ProtectedPart = uint32_t (*)(RuntimeContext*, std::byte* image, std::byte* self, int64_t frame);

/// Entry of a program, function block body or task part: runs to its end or leaves through plcFault.
using Entry = void (*)(RuntimeContext*, std::byte* image, uint32_t instance);

} // namespace plc::image

// Called by generated code; defined by the controller (runtime/controller/fault_exit.cpp) and registered with the JIT
// through RuntimeSymbols, so that neither compiler nor JIT knows the controller.
namespace plc::image {
struct RuntimeSymbols {
    /// Never returns: unwinds to the scan's entry (longjmp). Fault code, site and detail are in the context.
    void (*fault)(RuntimeContext*) = nullptr;
    /// Refills context->loopBudget or faults with Watchdog.
    void (*budgetUsedUp)(RuntimeContext*) = nullptr;
    /// The statement at `site` is about to run (only called where siteFlags[site] != 0).
    void (*atSite)(RuntimeContext*, uint32_t site, uint32_t instance, uint32_t frame) = nullptr;
    /// Runs a protected part of a function (__TRY) on the same THIS and frame. How it was left: a Leaving, or the
    /// exception code of the fault that left it (the fault itself is in the context).
    uint32_t (*protect)(RuntimeContext*, std::byte* image, std::byte* self, int64_t frame, ProtectedPart) = nullptr;
};
} // namespace plc::image
