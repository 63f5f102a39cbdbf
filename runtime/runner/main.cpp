// The program that `stepwise build` links object code with: controller and recording without a compiler. It runs on
// the main thread; what it runs is in the same file (code_symbols.cpp says what the code calls).
#include "runtime/controller/controller.h"
#include "runtime/controller/leave_hook.h"
#include "runtime/controller/retain.h"
#include "runtime/history/history.h"
#include "runtime/image/portable_program.h"
#include "runtime/image/written_pages.h"
#include "runtime/platform/scheduling.h"
#include "runtime/platform/streams.h"
#include "runtime/runner/errors.h"
#include "runtime/runner/options.h"

#include <csignal>
#include <cstdio>
#include <thread>

// What the object file defines.
struct EntryRow {
    uint64_t function;
    plc::image::Entry code;
};
extern "C" {
extern const EntryRow plcEntries[] asm("plc.entries.0");
extern const char stepwise_program[];
extern const uint64_t stepwise_program_size;
}

namespace plc::runner {

namespace {

enum ExitCode : int { kGood = 0, kProgramWrong = 1, kWrongUse = 2 };

volatile std::sig_atomic_t g_isInterrupted = 0;
extern "C" void onInterrupt(int) { g_isInterrupted = 1; }
bool isInterrupted() { return g_isInterrupted != 0; }

int wrongUse(const Error& error) {
    std::fprintf(stderr, "%s\n", error.english().c_str());
    return kWrongUse;
}

/// Every scan into the recording, as a session of the studio does it.
class Recorder : public controller::ScanObserver {
public:
    Recorder(history::History& history, const controller::Controller& controller)
        : m_history(history), m_controller(controller) {}
    void scanFinished(std::span<const std::byte> image, uint64_t scan, std::chrono::nanoseconds time) override {
        m_history.append(image, scan, time, m_controller.dirtyPages());
    }
    void programChanged(std::shared_ptr<const image::CompiledProgram> program) override {
        m_history.beginProgram(std::move(program));
    }
    void eventHappened(const controller::Event& event) override {
        m_history.mark(static_cast<int>(event.kind), event.text, event.time);
    }
    void outsideActed(const image::Outside& outside) override { m_history.outsideActed(outside); }

private:
    history::History& m_history;
    const controller::Controller& m_controller;
};

std::shared_ptr<image::Code> linkedCode(const image::CompiledProgram& program) {
    auto code = std::make_shared<image::Code>();
    code->marksWrites = image::marksWrites(program.layout);
    code->entries.resize(program.functions.size(), nullptr);
    for (const EntryRow* row = plcEntries; row->function != 0; ++row) code->entries[row->function] = row->code;
    return code;
}

Result<void> apply(controller::Controller& controller, const Write& write) {
    if (write.isForce && (write.text == "RELEASE" || write.text == "release")) return controller.release(write.path);
    const image::Layout& layout = controller.program().layout;
    const auto place = layout.find(write.path);
    if (!place) return place.error();
    const auto value = types::parseValue(*layout.types, place->type, write.text);
    if (!value) return Error{errors::NotAValue(write.text, write.path, (*layout.types)[place->type].name), ""};
    return write.isForce ? controller.force(write.path, *value) : controller.write(write.path, *value);
}

/// A mistyped path or value is reported before anything runs.
Result<void> checkNames(const Options& options, const controller::Controller& controller) {
    for (const std::string& path : options.watches)
        if (auto value = controller.read(path); !value) return value.error();
    for (const Write& write : options.writes)
        if (auto place = controller.program().layout.find(write.path); !place) return place.error();
    return {};
}

/// The wall time of the scan to come; a signal wakes it.
void waitUntil(std::chrono::steady_clock::time_point when) {
    while (!isInterrupted() && !platform::sleepUntil(when)) {
    }
}

Result<void> runScans(const Options& options, controller::Controller& controller) {
    auto length = options.length;
    if (!length && !options.scans && !options.isReal) length = std::chrono::seconds(10);
    const auto begin = std::chrono::steady_clock::now();
    controller.start();
    size_t next = 0;
    for (uint64_t done = 0; !isInterrupted() && controller.state() == controller::State::Running; ++done) {
        const std::chrono::nanoseconds due = controller.nextDue();
        if ((length && due >= *length) || (options.scans && done >= *options.scans)) break;
        if (options.isReal) waitUntil(begin + due);
        if (isInterrupted()) break;
        for (; next < options.writes.size() && options.writes[next].at <= due; ++next)
            if (auto written = apply(controller, options.writes[next]); !written) return written;
        controller.scan();
    }
    return {};
}

std::string placeText(const image::CompiledProgram& program, const SourceRange& range) {
    if (!range.file.isValid() || range.file.index() >= program.sources.files.size()) return "?";
    const SourceText& file = program.sources[range.file];
    return file.path() + ":" + std::to_string(file.lineColumn(range.begin).line);
}

void report(const Options& options, const controller::Controller& controller) {
    for (const std::string& path : options.watches)
        if (const auto value = controller.read(path))
            std::printf("%s  %s\n", path.c_str(), types::toText(*controller.program().layout.types, *value).c_str());
    if (const auto& fault = controller.fault())
        std::printf("fault: %s\n  in task %s at %s, scan %llu\n", fault->message.english().c_str(), fault->task.c_str(),
                    placeText(controller.program(), fault->range).c_str(),
                    static_cast<unsigned long long>(fault->scan));
    std::printf("%llu scans, last at %s\n", static_cast<unsigned long long>(controller.nextScan()),
                types::durationText(controller.lastTime().count()).c_str());
}

Result<void> restore(const std::string& file, controller::Controller& controller) {
    if (file.empty()) return {};
    const auto leaves = controller::loadRetain(file);
    if (!leaves) return leaves.error();
    (void)controller::restoreRetained(controller, *leaves);
    return {};
}

int run(const Options& options, const image::PortableProgram& portable) {
    controller::Settings settings;
    settings.calendarStartNs = options.calendarStartNs.value_or(portable.calendarStartNs);
    history::History history;
    controller::Controller controller(portable.program, settings);
    Recorder recorder(history, controller);
    history.describeProgram(portable.program, portable.sources, portable.libraries, portable.libraryTexts);
    if (auto restored = restore(options.retainFile, controller); !restored) return wrongUse(restored.error());
    controller::setLeaveHook(controller, isInterrupted);
    if (!options.recordFile.empty()) controller.addObserver(recorder);
    if (auto good = checkNames(options, controller); !good) return wrongUse(good.error());
    if (auto ran = runScans(options, controller); !ran) return wrongUse(ran.error());
    report(options, controller);
    const bool isFault = controller.state() == controller::State::Fault;
    controller.stop();
    int code = isFault ? kProgramWrong : kGood;
    if (!options.recordFile.empty())
        if (auto saved = history.save(options.recordFile); !saved) code = wrongUse(saved.error());
    if (!options.retainFile.empty()) {
        const auto leaves = controller::retainedLeaves(controller.program().layout, controller.image());
        if (auto saved = controller::saveRetain(options.retainFile, leaves); !saved) code = wrongUse(saved.error());
    }
    return code;
}

int main(int argc, char** argv) {
    const auto options = parseOptions({argv + 1, argv + argc});
    if (!options) return wrongUse(options.error());
    auto portable = image::fromBytes({stepwise_program, stepwise_program_size});
    if (!portable) return wrongUse({errors::Damaged(), ""});
    if (options->wantsHelp || options->wantsVersion) {
        std::fputs(options->wantsHelp ? helpText(portable->name).c_str() : "built by Stepwise " STEPWISE_VERSION "\n",
                   stdout);
        return kGood;
    }
    platform::catchInterrupts(onInterrupt);
    portable->program->quick = linkedCode(*portable->program);
    return run(*options, *portable);
}

} // namespace

} // namespace plc::runner

int main(int argc, char** argv) { return plc::runner::main(argc, argv); }
