// The one way out of generated code on a fault (D5): a jump back to the scan's entry. Owned by the controller, scan
// thread only. No frame between run() and a fault may own anything with a destructor.
#pragma once
#include "runtime/image/runtime_context.h"

#include <csetjmp>
#include <functional>

namespace plc::controller {

class ScanEdge;

class FaultExit {
public:
    /// Runs body(argument); false when it left through a fault (code, site and detail are in the context).
    [[nodiscard]] bool run(void (*body)(void*), void* argument);
    /// Jumps back to run().
    [[noreturn]] void leave();
    /// Runs a protected part of a function; a fault inside that can be caught comes back here, not to run().
    uint32_t protect(image::RuntimeContext& context, std::byte* self, int64_t frame, image::ProtectedPart part);
    /// A fault: back to the innermost protected part, or to run() when nothing protects or the fault cannot be caught.
    [[noreturn]] void raise(image::RuntimeContext& context);

    void* self = nullptr;               // handed to the callbacks
    std::function<bool()> wantsToLeave; // asked before each refill; may be empty
    enum class Refill : uint8_t { GoOn, UsedUp, Leave };
    ScanEdge* edge = nullptr; // asked before each scan; null: there are no devices
    /// Called when the portion of the budget is used up: refilled, or not because there is no more or because the scan
    /// is to be left.
    Refill (*refill)(void* self) = nullptr;
    /// Called at a flagged statement: false = leave the scan.
    bool (*atSite)(void* self, uint32_t site, uint32_t instance, uint32_t frame) = nullptr;

private:
    /// A protected part that is being run, on the stack of the scan.
    struct Protected {
        std::jmp_buf entry;
        Protected* outer;
        uint32_t depth;
    };
    std::jmp_buf m_entry;
    Protected* m_innermost = nullptr;
};

} // namespace plc::controller
