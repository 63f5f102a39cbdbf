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
    /// Jumps back to the innermost run().
    [[noreturn]] void leave();

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
    std::jmp_buf m_entry;
};

} // namespace plc::controller
