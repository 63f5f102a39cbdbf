// When RETAIN and PERSISTENT values go to and come from disk: restored before the first scan, saved at a stop, a fault,
// at intervals and at the end. The helper thread saves from the published snapshot, so the scan never waits for a disk.
#include "projects/session/session_state.h"
#include "runtime/base/messages.h"
#include "runtime/controller/retain.h"
#include "runtime/platform/files.h"

#include <filesystem>

namespace plc::session {

void Session::State::loadRetained() {
    if (settings.retainFile.empty()) return;
    const Result<std::vector<controller::RetainedLeaf>> leaves = controller::loadRetain(settings.retainFile);
    if (!leaves) {
        // What cannot be read is kept aside: it would be written over at the next save, and may be a file named by
        // mistake.
        const std::string aside = settings.retainFile + ".damaged";
        std::error_code none;
        const bool isKept = std::filesystem::is_regular_file(settings.retainFile, none) &&
                            std::filesystem::file_size(settings.retainFile, none) > 0 &&
                            platform::replaceFile(settings.retainFile, aside);
        shared.retainProblem = errors::withPlace(leaves.error());
        if (isKept) shared.retainProblem = errors::RetainKeptAs(shared.retainProblem, aside);
        return;
    }
    const controller::RetainOutcome outcome = controller::restoreRetained(controller, *leaves);
    if (outcome.lost.empty()) return;
    constexpr size_t kNamed = 8;
    std::vector<std::string> names(
        outcome.lost.begin(), outcome.lost.begin() + static_cast<ptrdiff_t>(std::min(kNamed, outcome.lost.size())));
    if (outcome.lost.size() > kNamed) names.push_back("…");
    shared.retainProblem = errors::RetainLost(outcome.lost.size(), std::move(names));
}

Result<void> Session::State::saveRetained(const image::Layout& layout, std::span<const std::byte> image) const {
    return controller::saveRetain(settings.retainFile, controller::retainedLeaves(layout, image));
}

Result<void> Session::saveRetained() const {
    if (m->settings.retainFile.empty()) return {};
    if (!m->isQueueing.load()) return m->saveRetained(m->controller.program().layout, m->controller.image());
    Snapshot now;
    latest(now);
    if (!now.program) return {};
    return m->saveRetained(now.program->layout, now.image);
}

/// Worker.
void Session::State::tick() {
    if (settings.record) versions->keepOnly(history.programs(), current.load());
    if (settings.retainFile.empty()) return;
    const int64_t now = wallNow();
    const bool isStopped = wantsRetainSaved.exchange(false);
    const uint64_t done = scans.load(std::memory_order_relaxed);
    if (!isStopped && (now - lastRetainSave < settings.retainInterval.count() || done == lastRetainScan)) return;
    lastRetainSave = now;
    lastRetainScan = done;
    Snapshot newest;
    if (!published.read([&](const Snapshot& s) { newest = s; }) || !newest.program) return;
    const Result<void> saved = saveRetained(newest.program->layout, newest.image);
    {
        const std::lock_guard lock(mutex);
        shared.retainProblem = saved ? Message() : errors::withPlace(saved.error());
    }
    if (saved) post(When::Now, [this] { controller.report(controller::EventKind::RetainSaved, {}); });
}

} // namespace plc::session
