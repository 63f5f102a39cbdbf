// What compiled object code calls, by the names it calls it: the same functions the JIT hands to its code (jit.cpp).
// The text functions of runtime/library have these names already; memcpy and the like are the C library's.
#include "runtime/controller/controller.h"
#include "runtime/image/written_pages.h"

#include <cmath>
#include <cstring>

using plc::image::RuntimeContext;

extern "C" {

#define PLC_MATH1(Name)                                                                                                \
    double plc_##Name(double x) { return std::Name(x); }                                                               \
    float plc_##Name##f(float x) { return std::Name(x); }
#define PLC_MATH2(Name)                                                                                                \
    double plc_##Name(double x, double y) { return std::Name(x, y); }                                                  \
    float plc_##Name##f(float x, float y) { return std::Name(x, y); }
PLC_MATH1(log)
PLC_MATH1(log10)
PLC_MATH1(exp)
PLC_MATH1(sin)
PLC_MATH1(cos)
PLC_MATH1(tan)
PLC_MATH1(asin)
PLC_MATH1(acos)
PLC_MATH1(atan)
PLC_MATH1(sinh)
PLC_MATH1(cosh)
PLC_MATH1(tanh)
PLC_MATH2(pow)
PLC_MATH2(atan2)
PLC_MATH2(fmod)
#undef PLC_MATH1
#undef PLC_MATH2

int32_t plc_compare_bytes(const void* a, const void* b, uint32_t size) { return std::memcmp(a, b, size); }

void plc_fault(RuntimeContext* context) { plc::controller::runtimeSymbols().fault(context); }
void plc_budget_used_up(RuntimeContext* context) { plc::controller::runtimeSymbols().budgetUsedUp(context); }
void plc_at_site(RuntimeContext* context, uint32_t site, uint32_t instance, uint32_t frame) {
    plc::controller::runtimeSymbols().atSite(context, site, instance, frame);
}
uint32_t plc_protect(RuntimeContext* context, std::byte* image, std::byte* self, int64_t frame,
                     plc::image::ProtectedPart part) {
    return plc::controller::runtimeSymbols().protect(context, image, self, frame, part);
}

/// The libraries' functions that generated code may call by itself: here they get into the runner.
#define PLC_OWN1(Name)                                                                                                 \
    reinterpret_cast<Any>(static_cast<double (*)(double)>(&::Name)),                                                   \
        reinterpret_cast<Any>(static_cast<float (*)(float)>(&::Name##f))
using Any = void (*)();
extern const Any plc_needed[];
const Any plc_needed[] = {PLC_OWN1(floor),
                          PLC_OWN1(ceil),
                          PLC_OWN1(trunc),
                          PLC_OWN1(sqrt),
                          PLC_OWN1(fabs),
                          PLC_OWN1(rint),
                          PLC_OWN1(nearbyint),
                          PLC_OWN1(roundeven),
                          reinterpret_cast<Any>(&::memcpy),
                          reinterpret_cast<Any>(&::memmove),
                          reinterpret_cast<Any>(&::memset),
                          reinterpret_cast<Any>(&::bcmp)};
#undef PLC_OWN1

void plc_mark_written(uint8_t* dirtyPages, int64_t offset, int64_t length, int64_t pages) {
    plc::image::markWritten(dirtyPages, offset, length, pages);
}
}
