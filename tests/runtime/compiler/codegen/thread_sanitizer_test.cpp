// Under the thread sanitizer generated code is instrumented like the rest: a race between two threads in it is
// reported. Elsewhere asking for the instrumentation is an error that says so, not a crash.
#include "tests/runtime/compiler/codegen/tree_builder.h"

#include <atomic>
#include <thread>

#ifdef PLC_THREAD_SANITIZED
namespace {
std::atomic<int> g_reports = 0;
}
extern "C" {
[[gnu::visibility("default")]] void __tsan_on_report(void*); // called by the sanitizer for each report
void __tsan_on_report(void*) { ++g_reports; }
[[gnu::visibility("default")]] const char* __tsan_default_options();
const char* __tsan_default_options() { return "exitcode=0:halt_on_error=0"; } // the tests below count the reports
}
#endif

namespace plc::test {

#ifdef PLC_THREAD_SANITIZED
namespace {
/// Two threads add to a variable of one image, or each to one of its own.
int reportsOf(bool share) {
    Bench t;
    const auto dint = of(TypeKind::Dint);
    const uint32_t counters[] = {t.global(dint), t.global(dint)};
    uint32_t mains[2];
    for (int n = 0; n < 2; ++n) {
        mains[n] = t.function(n ? "Second" : "First");
        const uint32_t at = counters[share ? 0 : n];
        t.add(mains[n], t.assign(t.at(at, dint), t.binary(BinaryOp::Add, t.load(t.at(at, dint)), t.constant(dint, 1))));
    }
    t.makeFresh();
    codegen::Options options;
    options.tier = codegen::Tier::Optimised;
    options.threadSanitizer = true;
    const auto code = jit::compile(t.program, options);
    EXPECT_TRUE(code) << (code ? "" : code.error().english());
    if (!code) return -1;
    const int before = g_reports;
    const auto run = [&](uint32_t main) {
        auto context = std::make_unique<image::RuntimeContext>();
        context->image = t.image();
        context->frameTop = t.program.layout.frameBegin;
        for (int i = 0; i < 1000; ++i) (*code)->entries[main](context.get(), t.image(), 0);
    };
    std::thread first(run, mains[0]), second(run, mains[1]);
    first.join();
    second.join();
    return g_reports - before;
}
} // namespace

TEST(ThreadSanitizer, ReportsARaceInGeneratedCode) { EXPECT_GT(reportsOf(true), 0); }

TEST(ThreadSanitizer, IsQuietAboutVariablesOfTheirOwn) { EXPECT_EQ(0, reportsOf(false)); }

#else

TEST(ThreadSanitizer, CanNotBeAskedForOutsideItsProcess) {
    Bench t;
    const auto dint = of(TypeKind::Dint);
    const uint32_t a = t.global(dint);
    const uint32_t main = t.function("Main");
    t.add(main, t.assign(t.at(a, dint), t.constant(dint, 1)));
    t.makeFresh();
    codegen::Options options;
    options.threadSanitizer = true;
    const auto code = jit::compile(t.program, options);
    ASSERT_FALSE(code);
    EXPECT_NE(std::string::npos, code.error().message.english().find("sanitizer"));
}

#endif

} // namespace plc::test
