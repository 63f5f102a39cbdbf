// The session's helper thread: optimises programs, saves the retain file, forgets old versions. Jobs run one after the
// other; `tick` is called about twenty times a second in between.
#pragma once
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace plc::session {

class Worker {
public:
    explicit Worker(std::function<void()> tick);
    ~Worker(); // finishes the job at work, drops the others
    void post(std::function<void()> job);

private:
    void run();
    std::function<void()> m_tick;
    std::mutex m_mutex;
    std::condition_variable m_changed;
    std::deque<std::function<void()>> m_jobs;
    bool m_isQuitting = false;
    std::thread m_thread;
};

} // namespace plc::session
