#include "runtime/controller/scan_start.h"

#include "runtime/controller/controller_state.h"

namespace plc::controller {

image::ScanStart completed(image::ScanStart start, const image::CompiledProgram& program, const std::byte* image) {
    const auto& header = *reinterpret_cast<const image::ImageHeader*>(image);
    Schedule schedule;
    schedule.setTasks(program.tasks, {});
    schedule.restoreTriggers(image);
    const Schedule::Triggers triggers = schedule.triggers();
    start.isFirst = (header.reserved[2] & kFirstScanPending) != 0;
    start.isSimulationFirst = (header.reserved[2] & kSimulationFirstPending) != 0;
    start.pendingEvents = triggers.pending;
    start.triggersBefore = triggers.before;
    return start;
}

} // namespace plc::controller
