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

bool InsideDesk::ask(const QString& key, Work work) {
    const history::History* history = m_control.shownHistory();
    if (!history || history->statistics().scans == 0) return false;
    size_t given = 0;
    {
        const std::lock_guard lock(m_mutex);
        given = std::erase_if(m_jobs, [&](const Job& job) { return job.key == key; });
        m_jobs.push_back({key, std::move(work), history, m_control.recordedOwner(), m_control.hold(), m_generation});
    }
    m_changed.notify_all();
    setOpen(m_open + 1 - static_cast<int>(given));
    return true;
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
        if (!m_bench || &m_bench->history != job.history) {
            m_bench = std::make_unique<Bench>(*job.history);
            m_benchOwner = job.owner;
        }
        lock.unlock();
        const Finish finish = job.work(*m_bench);
        kit::post(this, [this, generation = job.generation, finish] { answered(generation, finish); });
        job = {}; // the hold goes while nobody waits for this thread
        lock.lock();
        m_isWorking = false;
        m_changed.notify_all();
    }
}

void InsideDesk::answered(uint64_t generation, const Finish& finish) {
    {
        const std::lock_guard lock(m_mutex);
        if (generation != m_generation) return;
    }
    setOpen(std::max(0, m_open - 1));
    if (finish) finish();
}

} // namespace plc::editor
