#include "runtime/inside/rerun.h"

#include "runtime/base/messages.h"
#include "runtime/controller/leave_hook.h"
#include "runtime/inside/texts.h"

#include <algorithm>
#include <cstring>

namespace plc::inside {

namespace {
constexpr uint32_t kOccurrences = 64; // of a statement that the scan stood at; which one is not recorded
constexpr size_t kMachinesKept = 4;   // versions of the program
} // namespace

Rerunner::Machine& Rerunner::machineOf(const std::shared_ptr<const image::CompiledProgram>& program) {
    auto found = m_machines.find(program.get());
    if (found != m_machines.end()) return *found->second;
    // A machine holds two images; somebody who walks over many online changes needs each only for a while.
    if (m_machines.size() >= kMachinesKept) m_machines.clear();
    auto fresh = std::make_unique<Machine>(program);
    controller::setLeaveHook(fresh->controller, [this] { return isCancelled(); }); // watched, a scan takes far longer
    return *(m_machines[program.get()] = std::move(fresh));
}

void Rerunner::make(Rerun& rerun, const How& how, uint32_t occurrence) {
    const history::ScanInput& input = rerun.input;
    Machine& machine = machineOf(input.program);
    controller::Rerun wanted;
    // Behind the data are frames: they hold what the scan before left, and no program reads them first.
    wanted.image = std::span(input.image).first(std::min<size_t>(input.image.size(), input.program->layout.dataEnd));
    wanted.start = &input.start;
    wanted.scan = input.stamp.scan;
    wanted.instant = input.stamp.time;
    wanted.calendarStartNs = input.calendarStartNs;
    wanted.code = how.code ? how.code : input.program->quick;
    wanted.startIsPartial = input.startIsPartial;
    wanted.notes = input.notes;
    wanted.occurrence = occurrence;
    wanted.clockBack = how.clockBack;
    if (how.prepare) how.prepare(machine.controller.context());
    (void)machine.controller.rerun(wanted);
    rerun.image = machine.image;
    rerun.fault = machine.controller.fault();
    rerun.simulationFault = machine.controller.simulationFault();
}

Rerun Rerunner::runFrom(history::ScanInput input, const How& how) {
    Rerun rerun;
    rerun.input = std::move(input);
    make(rerun, how, 0);
    return rerun;
}

namespace {

void compare(Rerun& rerun, std::span<const std::byte> recorded) {
    rerun.differences.clear();
    const image::Layout& layout = rerun.input.program->layout;
    const auto end = static_cast<uint32_t>(std::min<size_t>({recorded.size(), rerun.image.size(), layout.dataEnd}));
    // What is in front of kClockEnd was handed to the scan; only what the program made of it can differ.
    if (end <= kClockEnd ||
        std::memcmp(recorded.data() + kClockEnd, rerun.image.data() + kClockEnd, end - kClockEnd) == 0)
        return;
    for (uint32_t at = kClockEnd; at < end; ++at) {
        if (recorded[at] == rerun.image[at]) continue;
        if (!rerun.differences.empty() && rerun.differences.back().offset + rerun.differences.back().size == at) {
            ++rerun.differences.back().size;
            continue;
        }
        rerun.differences.push_back({at, 1, layout.pathAt(at)});
    }
}

} // namespace

bool stoodAtBreakpoint(const history::ScanInput& input) {
    return std::any_of(input.notes.begin(), input.notes.end(),
                       [](const image::OutsideNote& note) { return note.site != 0; });
}

Result<Rerun> Rerunner::run(Position position, const How& how) {
    Result<history::ScanInput> input = m_history.inputOf(position);
    if (!input) return input.error();
    Rerun rerun;
    rerun.input = std::move(*input);
    if (!rerun.input.hasJournal) rerun.doubt = texts::NoJournal();
    // A write at a breakpoint took effect in the middle of the scan, at a statement that may have run many times. Which
    // time is found by trying: the one that gives the recorded image is the one.
    const bool stood = stoodAtBreakpoint(rerun.input);
    for (uint32_t occurrence = 0; occurrence < (stood ? kOccurrences : 1); ++occurrence) {
        make(rerun, how, occurrence);
        if (isCancelled()) return Error{errors::Cancelled(), ""};
        const std::vector<std::byte> recorded = m_history.seek(position);
        if (recorded.empty()) return Error{errors::ScanNoLongerRecorded(), ""}; // forgotten meanwhile
        compare(rerun, recorded);
        if (rerun.isExact()) return rerun;
    }
    if (stood) rerun.doubt = texts::StoodAtBreakpoint();
    return rerun;
}

} // namespace plc::inside
