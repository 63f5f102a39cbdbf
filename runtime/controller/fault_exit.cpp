#include "runtime/controller/fault_exit.h"

#include "runtime/controller/controller.h"
#include "runtime/controller/leave_hook.h"

namespace plc::controller {

bool FaultExit::run(void (*body)(void*), void* argument) {
    if (setjmp(m_entry) != 0) return false;
    body(argument);
    return true;
}

void FaultExit::leave() { std::longjmp(m_entry, 1); }

namespace {

FaultExit& exitOf(image::RuntimeContext* context) { return *static_cast<FaultExit*>(context->owner); }

void fault(image::RuntimeContext* context) { exitOf(context).leave(); }

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

image::RuntimeSymbols runtimeSymbols() { return {&fault, &budgetUsedUp, &atSite}; }

} // namespace plc::controller
