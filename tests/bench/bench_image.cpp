#include "tests/bench/bench_image.h"

#include "runtime/compiler/jit/jit.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace plc::bench {

namespace {
[[noreturn]] void stop(image::RuntimeContext* context) {
    std::fprintf(stderr, "the program faulted: code %u at site %u\n", static_cast<unsigned>(context->fault),
                 context->faultSite);
    std::exit(1);
}
void refill(image::RuntimeContext* context) { context->loopBudget = INT64_MAX / 2; }
void atSite(image::RuntimeContext*, uint32_t, uint32_t, uint32_t) {}
} // namespace

void registerBenchSymbols() { jit::setRuntimeSymbols({stop, refill, atSite}); }

BenchImage::BenchImage(const image::CompiledProgram& program)
    : m_program(program), m_bytes(program.layout.imageSize + 64) {
    m_image = m_bytes.data() + (64 - reinterpret_cast<uintptr_t>(m_bytes.data()) % 64) % 64;
    std::memcpy(m_image, program.initialImage.data(), program.initialImage.size());
    static std::vector<uint8_t> flags;
    flags.resize(std::max(flags.size(), program.sites.size() + 1));
    m_context.image = m_image;
    m_context.dataEnd = program.layout.dataEnd;
    m_context.frameTop = program.layout.frameBegin;
    m_context.imageSize = program.layout.imageSize;
    m_context.siteFlags = flags.data();
    m_context.loopBudget = INT64_MAX / 2;
    if (program.initializer != 0) program.quick->entries[program.initializer](&m_context, m_image, 0);
}

void BenchImage::scan(const image::Code& code) {
    for (const image::Task& task : m_program.tasks)
        for (const image::TaskProgram& p : task.programs) {
            m_context.depth = 0;
            m_context.loopBudget = INT64_MAX / 2;
            code.entries[p.function](&m_context, m_image, m_program.layout.roots[p.root].offset);
        }
}

double BenchImage::number(const std::string& path) const {
    const auto place = m_program.layout.find(path);
    if (!place) {
        std::fprintf(stderr, "%s\n", place.error().english().c_str());
        std::exit(1);
    }
    const types::TypeTable& types = *m_program.layout.types;
    const types::Value value = types::readValue(types, place->type, {m_image + place->offset, types[place->type].size});
    return std::holds_alternative<double>(value.data) ? value.real() : static_cast<double>(value.integer());
}

driver::Built buildOrDie(const std::string& name, const std::string& text) {
    driver::BuildInput input;
    input.files.push_back({name, text});
    driver::Built built = driver::build(input);
    if (built.program) return built;
    for (const auto& diagnostic : built.checked.analysis->diagnostics)
        if (diagnostic.severity == diagnostics::Severity::Error)
            std::fprintf(stderr, "%s: %s\n", name.c_str(), diagnostic.message.english().c_str());
    std::fprintf(stderr, "%s does not compile %s\n", name.c_str(), built.failure.english().c_str());
    std::exit(1);
}

} // namespace plc::bench
