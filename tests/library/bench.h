// A little plant of one program: ST text, libraries and a task interval in; scans in virtual time, reads and writes by
// path. A program that does not compile, or a fault, throws with the message, which fails the test.
#pragma once
#include "projects/session/session.h"
#include "runtime/compiler/jit/jit.h"

#include <chrono>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace plc::test {

using controller::Nanoseconds;
using namespace std::chrono_literals;

inline driver::Built buildText(const std::string& text, const std::vector<std::string>& libraries) {
    static const bool once = (jit::setRuntimeSymbols(controller::runtimeSymbols()), true);
    (void)once;
    driver::BuildInput input;
    input.files.push_back({"bench.st", text});
    input.libraries = libraries;
    driver::Built built = driver::build(input);
    if (built.program) return built;
    std::string message = built.failure.english();
    for (const diagnostics::Diagnostic& diagnostic : built.checked.analysis->diagnostics)
        if (diagnostic.severity == diagnostics::Severity::Error)
            message += diagnostics::renderText(*built.checked.sources, diagnostic, false);
    throw std::runtime_error("does not compile: " + message);
}

/// The program `body` with `declarations`, called `Main`, in a task of `interval`.
inline std::string programText(const std::string& declarations, const std::string& body, Nanoseconds interval) {
    return "PROGRAM Main\n" + declarations + "\n" + body +
           "\nEND_PROGRAM\n\nCONFIGURATION Bench\nRESOURCE Cpu ON Soft\nTASK Cyclic (INTERVAL := T#" +
           std::to_string(interval.count() / 1000) +
           "us, PRIORITY := 1);\nPROGRAM Main WITH Cyclic : Main;\nEND_RESOURCE\nEND_CONFIGURATION\n";
}

class Bench {
public:
    Bench(const std::string& declarations, const std::string& body, std::vector<std::string> libraries,
          Nanoseconds interval = 10ms)
        : Bench(buildText(programText(declarations, body, interval), libraries)) {}
    explicit Bench(driver::Built built)
        : m_built(std::move(built)), m_controller(std::make_unique<controller::Controller>(m_built.program)) {
        m_controller->start();
    }

    void scan(int count = 1) {
        for (int i = 0; i < count; ++i) {
            const bool good = m_controller->scan();
            if (!good || m_controller->fault())
                throw std::runtime_error(
                    "fault: " + (m_controller->fault() ? m_controller->fault()->message.english() : std::string("?")));
        }
    }
    /// Scans until the scan at `time` has been made.
    void scanUntil(Nanoseconds time) {
        while (m_controller->nextDue() <= time) scan();
    }
    /// The controller as if it had run until `time`: the next scan comes then.
    void jumpTo(Nanoseconds time) {
        const std::vector<std::byte> image(m_controller->image().begin(), m_controller->image().end());
        m_controller->resumeFrom(m_controller->sharedProgram(), image, m_controller->nextScan(), time);
        m_controller->start();
    }

    [[nodiscard]] types::Value value(const std::string& path) const {
        auto read = m_controller->read(pathOf(path));
        if (!read) throw std::runtime_error(read.error().english());
        return *read;
    }
    [[nodiscard]] double real(const std::string& path) const {
        const types::Value read = value(path);
        if (const auto* number = std::get_if<double>(&read.data)) return *number;
        return static_cast<double>(read.integer());
    }
    [[nodiscard]] bool is(const std::string& path) const { return value(path).isTrue(); }
    [[nodiscard]] int64_t integer(const std::string& path) const { return value(path).integer(); }
    [[nodiscard]] std::string text(const std::string& path) const { return std::get<std::string>(value(path).data); }

    /// A REAL, integer, BOOL (0, 1) or TIME in nanoseconds.
    void set(const std::string& path, double number) {
        types::Value changed = value(path);
        if (std::holds_alternative<double>(changed.data))
            changed.data = static_cast<double>(static_cast<float>(number));
        else
            changed.data = static_cast<int64_t>(number);
        write(path, changed);
    }
    void set(const std::string& path, Nanoseconds duration) {
        types::Value changed = value(path);
        changed.data = static_cast<int64_t>(duration.count());
        write(path, changed);
    }
    void write(const std::string& path, const types::Value& changed) {
        if (auto done = m_controller->write(pathOf(path), changed); !done)
            throw std::runtime_error(done.error().english());
    }

    [[nodiscard]] controller::Controller& controller() { return *m_controller; }
    [[nodiscard]] const driver::Built& built() const { return m_built; }

private:
    [[nodiscard]] static std::string pathOf(const std::string& path) { return "Main." + path; }

    driver::Built m_built;
    std::unique_ptr<controller::Controller> m_controller;
};

} // namespace plc::test
