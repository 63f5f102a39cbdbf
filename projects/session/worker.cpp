#include "projects/session/worker.h"

namespace plc::session {

Worker::Worker(std::function<void()> tick) : m_tick(std::move(tick)), m_thread([this] { run(); }) {}

Worker::~Worker() {
    {
        const std::lock_guard lock(m_mutex);
        m_isQuitting = true;
    }
    m_changed.notify_one();
    m_thread.join();
}

void Worker::post(std::function<void()> job) {
    {
        const std::lock_guard lock(m_mutex);
        m_jobs.push_back(std::move(job));
    }
    m_changed.notify_one();
}

void Worker::run() {
    std::unique_lock lock(m_mutex);
    while (!m_isQuitting) {
        if (m_jobs.empty()) m_changed.wait_for(lock, std::chrono::milliseconds(50));
        if (m_isQuitting) return;
        std::function<void()> job = m_tick;
        if (!m_jobs.empty()) {
            job = std::move(m_jobs.front());
            m_jobs.pop_front();
        }
        lock.unlock();
        job();
        job = nullptr;
        lock.lock();
    }
}

} // namespace plc::session
