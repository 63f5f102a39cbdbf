#include "runtime/controller/fault_exit.h"

#include "runtime/controller/controller.h"
#include "runtime/controller/leave_hook.h"

namespace plc::controller {

bool FaultExit::run(void (*body)(void*), void* argument) {
    m_innermost = nullptr;
    if (setjmp(m_entry) != 0) return false;
    body(argument);
    return true;
}

void FaultExit::leave() {
    m_innermost = nullptr;
    std::longjmp(m_entry, 1);
}

namespace {

/// Of __SYSTEM.ExceptionCode (runtime/library/st/standard/system_types.st). 0: the fault cannot be caught: what takes
/// too long would only take longer, and a scan that is abandoned is over.
uint32_t exceptionCode(image::FaultCode fault) {
    switch (fault) {
    case image::FaultCode::DivisionByZero:
        return 0x102;
    case image::FaultCode::IndexOutOfRange:
    case image::FaultCode::StringIndex:
        return 0x101;
    case image::FaultCode::NullReference:
    case image::FaultCode::ForeignReference:
    case image::FaultCode::MissingInOut:
        return 0x51;
    case image::FaultCode::StackOverflow:
        return 0x54;
    case image::FaultCode::AbstractCall:
        return 0x50;
    case image::FaultCode::ValueOutOfRange:
        return 0x103;
    case image::FaultCode::None:
    case image::FaultCode::Watchdog:
    case image::FaultCode::Stopped:
        return 0;
    }
    return 0;
}

} // namespace

uint32_t FaultExit::protect(image::RuntimeContext& context, std::byte* self, int64_t frame, image::ProtectedPart part) {
    Protected here; // not initialised: the buffer is large and setjmp fills it
    here.outer = m_innermost;
    here.depth = context.depth;
    m_innermost = &here;
    const uint32_t left =
        setjmp(here.entry) == 0 ? part(&context, context.image, self, frame) : exceptionCode(context.fault);
    m_innermost = here.outer;
    context.depth = here.depth;
    return left;
}

void FaultExit::raise(image::RuntimeContext& context) {
    if (m_innermost == nullptr || exceptionCode(context.fault) == 0) leave();
    std::longjmp(m_innermost->entry, 1);
}

namespace {

FaultExit& exitOf(image::RuntimeContext* context) { return *static_cast<FaultExit*>(context->owner); }

void fault(image::RuntimeContext* context) { exitOf(context).raise(*context); }

uint32_t protect(image::RuntimeContext* context, std::byte*, std::byte* self, int64_t frame,
                 image::ProtectedPart part) {
    return exitOf(context).protect(*context, self, frame, part);
}

void budgetUsedUp(image::RuntimeContext* context) {
    FaultExit& exit = exitOf(context);
    const FaultExit::Refill done = exit.refill(exit.self);
    if (done == FaultExit::Refill::GoOn) return;
    context->fault = done == FaultExit::Refill::Leave ? image::FaultCode::Stopped : image::FaultCode::Watchdog;
    if (context->faultSite == 0) context->faultSite = context->currentSite;
    exit.leave();
}

void atSite(image::RuntimeContext* context, uint32_t site, uint32_t instance, uint32_t frame) {
    FaultExit& exit = exitOf(context);
    if (exit.atSite(exit.self, site, instance, frame)) return;
    context->fault = image::FaultCode::Stopped;
    context->faultSite = site;
    exit.leave();
}

} // namespace

void setLeaveHook(Controller& controller, std::function<bool()> wantsToLeave) {
    exitOf(&controller.context()).wantsToLeave = std::move(wantsToLeave);
}

image::RuntimeSymbols runtimeSymbols() { return {&fault, &budgetUsedUp, &atSite, &protect}; }

} // namespace plc::controller
