// The runs of a project that have ended: each is kept on disk as a recording until newer ones need the room, so that
// starting again, closing and creating another project lose nothing. Owned by RunControl; GUI thread, the files are
// written on a thread of their own, one after the other.
#pragma once
#include "projects/session/session.h"
#include "runtime/base/progress.h"

#include <QDateTime>
#include <QObject>

#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace plc::editor {

class RunArchive : public QObject {
    Q_OBJECT
public:
    struct Run {
        QString path;
        QDateTime ended;
        bool isFault = false; // a fault ended it
        qint64 bytes = 0;
    };

    explicit RunArchive(QObject* parent = nullptr);
    ~RunArchive() override; // waits until all is written

    /// Of the project; "" keeps nothing.
    void setFolder(const QString& folder) { m_folder = folder; }
    [[nodiscard]] const QString& folder() const { return m_folder; }
    /// For all runs of a project together; 0 keeps none. The newest run stays even when it alone is larger.
    void setBudget(qint64 bytes) { m_budget = bytes; }
    /// Ends the session and takes what it has recorded; returns at once.
    void keep(std::unique_ptr<session::Session> session);
    /// What is kept of the project, the newest first.
    [[nodiscard]] std::vector<Run> runs() const;
    [[nodiscard]] bool isWriting() const;
    /// Until all is written; any thread. Cancelled, what is not written yet is lost.
    void wait(Progress& progress);

signals:
    void kept(const QString& path);
    void failed(const QString& message);

private:
    struct Job {
        std::unique_ptr<session::Session> session;
        QString path;
        qint64 budget = 0;
    };
    void work();
    void write(Job& job);

    QString m_folder;
    qint64 m_budget = qint64(1) << 30;
    int m_number = 0; // of the runs of this program
    mutable std::mutex m_mutex;
    std::condition_variable m_changed;
    std::deque<Job> m_jobs;
    bool m_isWriting = false, m_quits = false;
    Progress m_progress;
    std::thread m_writer;
};

} // namespace plc::editor
