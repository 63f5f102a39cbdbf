// Runs recorded scans again on an image of its own (D13): what the history says a scan began from, the program version
// it had, and then the result held against the recording. Belongs to one thread, never the scan thread; it only reads
// the history.
#pragma once
#include "runtime/controller/controller.h"
#include "runtime/history/history.h"

#include <functional>
#include <map>

namespace plc::inside {

using history::Position;

constexpr uint32_t kClockEnd = 24; // of the header: what is before it is set when the scan begins, out of its stamp

/// A place whose bytes came out otherwise than recorded.
struct Difference {
    uint32_t offset = 0, size = 0;
    std::string path; // of the first byte
};

struct Rerun {
    history::ScanInput input;
    std::vector<std::byte> image; // as it came out, data part
    std::vector<Difference> differences;
    std::optional<controller::Fault> fault, simulationFault;
    /// Why it may differ: "recorded by an earlier version, which kept no journal"; empty: no reason known.
    Message doubt;
    [[nodiscard]] bool isExact() const { return differences.empty(); }
};

/// `prepare` sees the context before each time the scan is made (where it stood at a breakpoint, more than once).
struct RerunHow {
    std::shared_ptr<const image::Code> code; // null: the program's quick code
    std::function<void(image::RuntimeContext&)> prepare;
    controller::Nanoseconds clockBack{}; // the program sees its clock that much earlier
};

/// Something was written at a breakpoint, in the middle of the scan: it is made again until the result is the recorded
/// one.
[[nodiscard]] bool stoodAtBreakpoint(const history::ScanInput& input);

class Rerunner {
public:
    using How = RerunHow;
    explicit Rerunner(const history::History& history) : m_history(history) {}
    Rerunner(const Rerunner&) = delete;
    Rerunner& operator=(const Rerunner&) = delete;

    /// Asked every few milliseconds of a scan; true: whoever asked no longer wants to know, and the scan is left in its
    /// middle. Null: nobody will.
    void setCancel(std::function<bool()> isCancelled) { m_isCancelled = std::move(isCancelled); }
    [[nodiscard]] bool isCancelled() const { return m_isCancelled && m_isCancelled(); }
    /// Scan `position` again. Fails with Cancelled when it was left, with ScanNoLongerRecorded when there is nothing to
    /// compare it with.
    [[nodiscard]] Result<Rerun> run(Position position, const How& how = {});
    /// From a changed beginning (what if, why not); nothing to compare with. Of no use when cancelled meanwhile.
    [[nodiscard]] Rerun runFrom(history::ScanInput input, const How& how = {});

private:
    /// A controller that keeps the image as the recording would: before a fault made the outputs safe.
    struct Machine final : controller::ScanObserver {
        explicit Machine(std::shared_ptr<const image::CompiledProgram> program) : controller(std::move(program)) {
            controller.addObserver(*this);
        }
        void scanFinished(std::span<const std::byte> bytes, uint64_t, controller::Nanoseconds) override {
            image.assign(bytes.begin(), bytes.end());
        }
        void programChanged(std::shared_ptr<const image::CompiledProgram>) override {}
        void eventHappened(const controller::Event&) override {}
        controller::Controller controller;
        std::vector<std::byte> image;
    };
    [[nodiscard]] Machine& machineOf(const std::shared_ptr<const image::CompiledProgram>& program);
    void make(Rerun& rerun, const How& how, uint32_t occurrence);

    const history::History& m_history;
    std::map<const image::CompiledProgram*, std::unique_ptr<Machine>> m_machines;
    std::function<bool()> m_isCancelled;
};

} // namespace plc::inside
