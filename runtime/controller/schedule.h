// Which task is due when (D11: a scan is one pass at an instant at which at least one task is due). Owned by the
// controller, scan thread only. Due times lie on each task's own grid from time 0, so they follow from the time of the
// last scan alone: that is what makes going back in time exact.
#pragma once
#include "runtime/controller/task_statistics.h"
#include "runtime/image/program.h"

namespace plc::controller {

using Nanoseconds = std::chrono::nanoseconds;

struct TaskRun {
    const image::Task* task = nullptr;
    int64_t interval = 0; // cyclic: > 0
    int64_t due = 0;
    int64_t lateness = 0; // of this scan, real time
    bool isDue = false, hasRun = false;
    bool isPending = false;     // event: edge seen, not run yet
    bool triggerBefore = false; // event: value of SINGLE when last looked at
    uint32_t watchdogStreak = 0;
    uint64_t runs = 0; // since the controller was made
    TaskStatistics statistics;
};

class Schedule {
public:
    /// `lastTime` < 0: no scan yet. Statistics of tasks of the same name go on.
    void setTasks(const std::vector<image::Task>& tasks, Nanoseconds freewheelingInterval);
    /// Due times after a scan at `lastTime` (< 0: none yet).
    void rebase(int64_t lastTime);
    [[nodiscard]] int64_t nextDue() const { return m_nextDue; }
    /// Latest instant up to `at` at which a task is due (nextDue() ≤ at).
    [[nodiscard]] int64_t lastInstant(int64_t at) const;
    /// Marks what is due at `instant`; `everything`: the first scan after a start, all cyclic tasks run. Returns
    /// skipped instants.
    uint64_t begin(int64_t instant, int64_t at, bool everything);
    /// The most urgent due task that has not run in this scan, plant or not; null when none is left.
    [[nodiscard]] TaskRun* next(bool isSimulation);
    /// Tasks of this kind that are due are passed over (STOP, FAULT).
    void skip(bool isSimulation);

    [[nodiscard]] bool hasEvents() const { return m_hasEvents; }
    [[nodiscard]] bool hasSimulation() const { return m_hasSimulation; }
    /// Looks at SINGLE of the event tasks; a rising edge makes the task due.
    void sampleTriggers(const std::byte* image, bool plcRuns);
    void restoreTriggers(const std::byte* image); // values and pending edges of a recorded image
    void storePending(image::ImageHeader& header) const;
    /// The same beside an image: the pending edges and the values last looked at, a bit for each event task.
    struct Triggers {
        uint64_t pending = 0, before = 0;
    };
    [[nodiscard]] Triggers triggers() const;
    void setTriggers(Triggers triggers);

    [[nodiscard]] std::vector<TaskRun>& runs() { return m_runs; }
    [[nodiscard]] const std::vector<TaskRun>& runs() const { return m_runs; }

private:
    void findNextDue();
    std::vector<TaskRun> m_runs; // by priority, then declaration
    int64_t m_baseInterval = 0;  // pulse of a program without cyclic tasks; 0 = there are some
    int64_t m_baseDue = 0;
    int64_t m_nextDue = 0;
    bool m_hasEvents = false, m_hasSimulation = false;
};

void addRun(TaskRun& run, int64_t elapsedNs);

} // namespace plc::controller
