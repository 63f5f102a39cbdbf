#include "projects/session/recorded_run.h"

#include "projects/session/versions.h"
#include "runtime/base/messages.h"

namespace plc::session {

Result<std::shared_ptr<RecordedRun>> RecordedRun::open(const std::string& path, Progress* progress) {
    std::shared_ptr<RecordedRun> run(new RecordedRun);
    Message failure;
    auto history = history::History::load(
        path,
        [&](const history::History::Sources& sources) -> std::shared_ptr<const image::CompiledProgram> {
            auto built = std::make_shared<const driver::Built>(driver::build(recordedInput(sources), progress));
            if (!built->program) {
                failure = built->failure.isEmpty() ? errors::RecordedProgramHasErrors() : built->failure;
                return nullptr;
            }
            run->m_program = built->program;
            run->versions()->add(std::move(built));
            return run->m_program;
        },
        progress);
    if (!history && isCancelled(progress)) return history.error();
    if (!history) return failure.isEmpty() ? history.error() : Error{errors::RecordingNotOpened(failure), path};
    run->m_history = std::move(*history);
    return run;
}

std::shared_ptr<RecordedRun> RecordedRun::of(driver::Built built, std::unique_ptr<history::History> history) {
    std::shared_ptr<RecordedRun> run(new RecordedRun);
    run->m_program = built.program;
    run->m_history = std::move(history);
    run->versions()->add(std::make_shared<const driver::Built>(std::move(built)));
    return run;
}

Status RecordedRun::status() const {
    const history::Statistics all = m_history->statistics();
    Status status;
    status.scans = all.scans;
    if (all.end == all.first) return status;
    status.position = all.end - 1;
    if (const auto stamp = m_history->stamp(status.position)) status.time = stamp->time;
    return status;
}

void RecordedRun::latest(Snapshot& into) const {
    const history::Statistics all = m_history->statistics();
    into = {};
    if (all.end == all.first) return;
    into.position = all.end - 1;
    into.image = m_history->seek(into.position, &into.program);
    if (const auto stamp = m_history->stamp(into.position)) {
        into.scan = stamp->scan;
        into.time = stamp->time;
    }
}

} // namespace plc::session
