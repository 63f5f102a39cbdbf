#include "runtime/controller/schedule.h"

#include <algorithm>
#include <bit>
#include <climits>

namespace plc::controller {

namespace {

constexpr size_t kHistogramSize = 24; // up to 2^23 µs, over 8 s

bool triggerValue(const TaskRun& run, const std::byte* image) {
    const auto byte = static_cast<uint8_t>(image[run.task->trigger->offset]);
    const int bit = run.task->trigger->bit;
    return bit >= 0 ? (byte >> bit & 1) != 0 : byte != 0;
}
bool isEvent(const TaskRun& run) { return run.task->kind == image::TaskKind::Event && run.task->trigger.has_value(); }

} // namespace

void Schedule::setTasks(const std::vector<image::Task>& tasks, Nanoseconds freewheelingInterval) {
    std::vector<std::pair<TaskStatistics, uint64_t>> before;
    for (TaskRun& run : m_runs) before.emplace_back(std::move(run.statistics), run.runs);
    m_runs.clear();
    m_hasEvents = m_hasSimulation = false;
    bool hasCyclic = false;
    for (const image::Task& task : tasks) {
        TaskRun run;
        run.task = &task;
        if (task.kind == image::TaskKind::Cyclic) run.interval = task.interval.count() > 0 ? task.interval.count() : 0;
        hasCyclic = hasCyclic || run.interval > 0;
        m_hasEvents = m_hasEvents || isEvent(run);
        m_hasSimulation = m_hasSimulation || task.isSimulation;
        const auto old =
            std::find_if(before.begin(), before.end(), [&](const auto& s) { return s.first.name == task.name; });
        if (old != before.end()) {
            run.statistics = std::move(old->first);
            run.runs = old->second;
        }
        run.statistics.name = task.name;
        run.statistics.histogram.resize(kHistogramSize);
        m_runs.push_back(std::move(run));
    }
    std::stable_sort(m_runs.begin(), m_runs.end(),
                     [](const TaskRun& a, const TaskRun& b) { return a.task->priority < b.task->priority; });
    m_baseInterval = hasCyclic ? 0 : std::max<int64_t>(1, freewheelingInterval.count());
}

void Schedule::rebase(int64_t lastTime) {
    const auto after = [&](int64_t interval) { return lastTime < 0 ? 0 : (lastTime / interval + 1) * interval; };
    for (TaskRun& run : m_runs) {
        run.isDue = run.hasRun = false;
        if (run.interval) run.due = after(run.interval);
    }
    if (m_baseInterval) m_baseDue = after(m_baseInterval);
    findNextDue();
}

void Schedule::findNextDue() {
    int64_t next = m_baseInterval ? m_baseDue : INT64_MAX;
    for (const TaskRun& run : m_runs)
        if (run.interval && run.due < next) next = run.due;
    m_nextDue = next;
}

int64_t Schedule::lastInstant(int64_t at) const {
    int64_t instant = m_nextDue;
    const auto consider = [&](int64_t interval, int64_t due) {
        if (interval && due <= at) instant = std::max(instant, due + (at - due) / interval * interval);
    };
    consider(m_baseInterval, m_baseDue);
    for (const TaskRun& run : m_runs) consider(run.interval, run.due);
    return instant;
}

uint64_t Schedule::begin(int64_t instant, int64_t at, bool everything) {
    uint64_t skipped = 0;
    const auto advance = [&](int64_t& due, int64_t interval) -> uint64_t {
        uint64_t missed = 0;
        if (instant - due >= interval) {
            missed = static_cast<uint64_t>((instant - due) / interval);
            due += static_cast<int64_t>(missed) * interval;
        }
        due += interval;
        skipped = std::max(skipped, missed);
        return missed;
    };
    if (m_baseInterval && m_baseDue <= instant) advance(m_baseDue, m_baseInterval);
    for (TaskRun& run : m_runs) {
        run.hasRun = false;
        run.lateness = 0;
        switch (run.task->kind) {
        case image::TaskKind::Cyclic:
            if (run.interval == 0) {
                run.isDue = true;
                break;
            }
            run.isDue = everything;
            if (run.due > instant) break;
            run.isDue = true;
            run.statistics.overruns += advance(run.due, run.interval);
            run.lateness = at - (run.due - run.interval);
            break;
        case image::TaskKind::Event:
            run.isDue = run.isPending;
            break;
        case image::TaskKind::Freewheeling:
            run.isDue = true;
            break;
        }
    }
    findNextDue();
    return skipped;
}

TaskRun* Schedule::next(bool isSimulation) {
    for (TaskRun& run : m_runs) {
        if (!run.isDue || run.task->isSimulation != isSimulation) continue;
        run.isDue = false;
        run.hasRun = true;
        run.isPending = false;
        ++run.runs;
        return &run;
    }
    return nullptr;
}

void Schedule::skip(bool isSimulation) {
    for (TaskRun& run : m_runs)
        if (run.task->isSimulation == isSimulation) run.isDue = run.isPending = false;
}

void Schedule::sampleTriggers(const std::byte* image, bool plcRuns) {
    for (TaskRun& run : m_runs) {
        if (!isEvent(run)) continue;
        const bool value = triggerValue(run, image);
        const bool isRising = value && !run.triggerBefore;
        run.triggerBefore = value;
        if (!isRising || !(plcRuns || run.task->isSimulation)) continue;
        run.isPending = true;
        if (!run.hasRun) run.isDue = true;
    }
}

// Pending edges are kept in the image, by number of the event task, so that a recorded scan holds all that the next one
// needs.
void Schedule::restoreTriggers(const std::byte* image) {
    const auto& header = *reinterpret_cast<const image::ImageHeader*>(image);
    size_t number = 0;
    for (TaskRun& run : m_runs) {
        if (!isEvent(run)) continue;
        run.triggerBefore = triggerValue(run, image);
        run.isPending = number < 64 && (header.reserved[number / 32] >> (number % 32) & 1) != 0;
        ++number;
    }
}

void Schedule::storePending(image::ImageHeader& header) const {
    header.reserved[0] = header.reserved[1] = 0;
    size_t number = 0;
    for (const TaskRun& run : m_runs) {
        if (!isEvent(run)) continue;
        if (run.isPending && number < 64) header.reserved[number / 32] |= 1u << (number % 32);
        ++number;
    }
}

Schedule::Triggers Schedule::triggers() const {
    Triggers all;
    uint64_t bit = 1;
    for (const TaskRun& run : m_runs) {
        if (!isEvent(run)) continue;
        if (run.isPending) all.pending |= bit;
        if (run.triggerBefore) all.before |= bit;
        bit <<= 1;
    }
    return all;
}

void Schedule::setTriggers(Triggers triggers) {
    uint64_t bit = 1;
    for (TaskRun& run : m_runs) {
        if (!isEvent(run)) continue;
        run.isPending = (triggers.pending & bit) != 0;
        run.triggerBefore = (triggers.before & bit) != 0;
        bit <<= 1;
    }
}

void addRun(TaskRun& run, int64_t elapsedNs) {
    TaskStatistics& s = run.statistics;
    s.lastNs = elapsedNs;
    s.minNs = s.count ? std::min(s.minNs, elapsedNs) : elapsedNs;
    s.maxNs = std::max(s.maxNs, elapsedNs);
    ++s.count;
    s.meanNs += (static_cast<double>(elapsedNs) - s.meanNs) / static_cast<double>(s.count);
    s.jitterNs = std::max(s.jitterNs, run.lateness);
    const auto micros = static_cast<uint64_t>(std::max<int64_t>(0, elapsedNs) / 1000);
    ++s.histogram[std::min<size_t>(kHistogramSize - 1, static_cast<size_t>(std::bit_width(micros)))];
}

} // namespace plc::controller
