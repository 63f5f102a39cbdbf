// Runs compiled programs without a controller: image, context and the three functions generated code calls. One thread.
#pragma once
#include "runtime/compiler/driver/driver.h"
#include "runtime/image/program.h"

namespace plc::bench {

class BenchImage {
public:
    explicit BenchImage(const image::CompiledProgram& program);
    /// Every program of every task once, with this tier's code.
    void scan(const image::Code& code);
    [[nodiscard]] double number(const std::string& path) const;

private:
    const image::CompiledProgram& m_program;
    std::vector<std::byte> m_bytes;
    std::byte* m_image = nullptr;
    image::RuntimeContext m_context;
};

void registerBenchSymbols();
[[nodiscard]] driver::Built buildOrDie(const std::string& name, const std::string& text);

} // namespace plc::bench
