#include "editor/inside/inside_desk.h"

#include "editor/kit/post.h"

#include <algorithm>
#include <utility>

namespace plc::editor {

InsideDesk::InsideDesk(RunControl& control, QObject* parent) : QObject(parent), m_control(control) {
    connect(&control, &RunControl::sessionAboutToEnd, this, &InsideDesk::letGo);
    connect(&control, &RunControl::recordedMustClose, this, &InsideDesk::letGo);
    m_thread = std::thread([this] { work(); });
}

InsideDesk::~InsideDesk() {
    letGo();
    {
        const std::lock_guard lock(m_mutex);
        m_quits = true;
    }
    m_changed.notify_all();
    m_thread.join();
}

/// Those that wait go, the one that is worked on is let know; how many went. Under the lock.
size_t InsideDesk::drop(const QString& key) {
    if (m_isWorking && m_workingOn == key) *m_stopsWorking = true;
    return std::erase_if(m_jobs, [&](const Job& job) { return job.key == key; });
}

bool InsideDesk::ask(const QString& key, Work work, Needs needs) {
    const history::History* history = m_control.shownHistory();
    if (!history || (needs == Needs::Recording && history->statistics().scans == 0)) return false;
    size_t given = 0;
    {
        const std::lock_guard lock(m_mutex);
        given = drop(key);
        m_jobs.push_back({key, std::move(work), history, m_control.recorded(), m_control.hold(), m_generation});
    }
    m_changed.notify_all();
    setOpen(m_open + 1 - static_cast<int>(given));
    return true;
}

void InsideDesk::cancel(const QString& key) {
    size_t given = 0;
    {
        const std::lock_guard lock(m_mutex);
        given = drop(key);
    }
    setOpen(m_open - static_cast<int>(given));
}

void InsideDesk::setOpen(int open) {
    const bool wasBusy = isBusy();
    m_open = open;
    if (wasBusy != isBusy()) emit busyChanged(isBusy());
}

/// The recording goes: nobody reads it any more when this returns.
void InsideDesk::letGo() {
    {
        std::unique_lock lock(m_mutex);
        ++m_generation;
        m_jobs.clear();
        if (m_isWorking) *m_stopsWorking = true;
        m_changed.wait(lock, [this] { return !m_isWorking; });
        m_bench.reset();
        m_benchOwner.reset();
    }
    setOpen(0);
}

void InsideDesk::work() {
    std::unique_lock lock(m_mutex);
    while (true) {
        m_changed.wait(lock, [this] { return m_quits || !m_jobs.empty(); });
        if (m_quits) return;
        Job job = std::move(m_jobs.front());
        m_jobs.pop_front();
        m_isWorking = true;
        m_workingOn = job.key;
        m_stopsWorking = job.isCancelled;
        if (!m_bench || &m_bench->history != job.history) {
            m_bench = std::make_unique<Bench>(*job.history);
            m_benchOwner = job.owner;
        }
        m_bench->insight.setCancel([isCancelled = job.isCancelled] { return isCancelled->load(); });
        lock.unlock();
        const Finish finish = job.work(*m_bench);
        kit::post(this, [this, generation = job.generation, isCancelled = job.isCancelled, finish] {
            answered(generation, *isCancelled, finish);
        });
        job = {}; // the hold goes while nobody waits for this thread
        lock.lock();
        m_isWorking = false;
        m_changed.notify_all();
    }
}

void InsideDesk::answered(uint64_t generation, bool isCancelled, const Finish& finish) {
    {
        const std::lock_guard lock(m_mutex);
        if (generation != m_generation) return;
    }
    setOpen(std::max(0, m_open - 1));
    if (finish && !isCancelled) finish();
}

} // namespace plc::editor
