// Asks recorded scans what they computed (runtime/inside), on a thread of its own: of the controller's recording, or of
// the one that is shown from a file. Answers come back on the GUI thread, and not at all when the session has ended
// meanwhile or nobody waits for them. Owned by the main window; GUI thread.
#pragma once
#include "editor/debug/run_control.h"
#include "runtime/inside/why.h"

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

namespace plc::editor {

class InsideDesk : public QObject {
    Q_OBJECT
public:
    /// What a question works with; belongs to the desk's thread.
    struct Bench {
        explicit Bench(const history::History& of) : history(of), insight(of), reasoner(insight) {}
        const history::History& history;
        inside::Insight insight;
        inside::Reasoner reasoner;
    };
    /// What is done with the answer, on the GUI thread.
    using Finish = std::function<void()>;
    using Work = std::function<Finish(Bench&)>;

    explicit InsideDesk(RunControl& control, QObject* parent = nullptr);
    ~InsideDesk() override;

    /// What there has to be: a scan that stands in the controller needs no recorded one.
    enum class Needs : uint8_t { Recording, Controller };
    /// False: there is nothing to ask. A question under the same key gives way to this one, answered by half or not.
    bool ask(const QString& key, Work work, Needs needs = Needs::Recording);
    /// Nobody waits for the answer any more. Long work looks at Insight::isCancelled().
    void cancel(const QString& key);
    [[nodiscard]] bool isBusy() const { return m_open > 0; }

signals:
    void busyChanged(bool busy);

private:
    struct Job {
        QString key;
        Work work;
        const history::History* history = nullptr;
        std::shared_ptr<const void> owner; // of a recording from a file
        RunControl::Hold hold;             // the session stays until it is answered
        uint64_t generation = 0;
        std::shared_ptr<std::atomic<bool>> isCancelled = std::make_shared<std::atomic<bool>>(false);
    };
    [[nodiscard]] size_t drop(const QString& key);
    void letGo();
    void work();
    void answered(uint64_t generation, bool isCancelled, const Finish& finish);
    void setOpen(int open);

    RunControl& m_control;
    int m_open = 0; // asked and not answered
    std::mutex m_mutex;
    std::condition_variable m_changed;
    std::deque<Job> m_jobs;
    uint64_t m_generation = 0;
    bool m_isWorking = false, m_quits = false;
    QString m_workingOn;                               // key of the question that is being answered
    std::shared_ptr<std::atomic<bool>> m_stopsWorking; // and the word that nobody waits for it
    std::unique_ptr<Bench> m_bench;
    std::shared_ptr<const void> m_benchOwner;
    std::thread m_thread;
};

} // namespace plc::editor
