#include "editor/debug/run_archive.h"

#include "editor/kit/message_text.h"
#include "editor/kit/post.h"

#include <QDir>
#include <QFileInfo>

#include <algorithm>
#include <chrono>

namespace plc::editor {

namespace {
constexpr size_t kMostRuns = 50; // a list that can be read
const char* const kStamp = "yyyyMMdd-HHmmss";
const char* const kFault = "-fault";

std::vector<RunArchive::Run> runsIn(const QString& folder) {
    std::vector<RunArchive::Run> out;
    for (const QFileInfo& file : QDir(folder).entryInfoList({"*.rec"}, QDir::Files)) {
        const QDateTime ended = QDateTime::fromString(file.fileName().left(15), kStamp);
        if (ended.isValid())
            out.push_back({file.filePath(), ended, file.completeBaseName().endsWith(kFault), file.size()});
    }
    std::sort(out.begin(), out.end(),
              [](const RunArchive::Run& a, const RunArchive::Run& b) { return a.path > b.path; });
    return out;
}

void removeOldest(const QString& folder, qint64 budget) {
    qint64 sum = 0;
    size_t number = 0;
    for (const RunArchive::Run& run : runsIn(folder)) {
        sum += run.bytes;
        if (number++ > 0 && (sum > budget || number > kMostRuns)) QFile::remove(run.path);
    }
}
} // namespace

RunArchive::RunArchive(QObject* parent) : QObject(parent) {
    m_writer = std::thread([this] { work(); });
}

RunArchive::~RunArchive() {
    {
        const std::lock_guard lock(m_mutex);
        m_quits = true;
    }
    m_changed.notify_all();
    m_writer.join();
}

void RunArchive::keep(std::unique_ptr<session::Session> session) {
    if (!session) return;
    session->end(); // what is retained is on disk before another session reads it
    const history::Statistics recorded = session->history().statistics();
    if (m_folder.isEmpty() || m_budget <= 0 || recorded.end == recorded.first || !QDir().mkpath(m_folder)) return;
    const bool isFault = session->status().fault.has_value();
    const QString name = QString("%1-%2%3.rec") // two runs may end in one second
                             .arg(QDateTime::currentDateTime().toString(kStamp))
                             .arg(++m_number, 3, 10, QChar('0'))
                             .arg(isFault ? kFault : "");
    {
        const std::lock_guard lock(m_mutex);
        m_jobs.push_back({std::move(session), m_folder + "/" + name, m_budget});
    }
    m_changed.notify_all();
}

std::vector<RunArchive::Run> RunArchive::runs() const {
    return m_folder.isEmpty() ? std::vector<Run>() : runsIn(m_folder);
}

bool RunArchive::isWriting() const {
    const std::lock_guard lock(m_mutex);
    return m_isWriting || !m_jobs.empty();
}

void RunArchive::wait(Progress& progress) {
    std::unique_lock lock(m_mutex);
    const auto isDone = [this] { return !m_isWriting && m_jobs.empty(); };
    while (!m_changed.wait_for(lock, std::chrono::milliseconds(50), isDone)) {
        if (progress.reached(m_progress.share())) continue;
        m_progress.cancel();
        m_jobs.clear();
    }
}

void RunArchive::work() {
    std::unique_lock lock(m_mutex);
    for (;;) {
        m_changed.wait(lock, [this] { return m_quits || !m_jobs.empty(); });
        if (m_jobs.empty()) return;
        Job job = std::move(m_jobs.front());
        m_jobs.pop_front();
        m_isWriting = true;
        lock.unlock();
        write(job);
        job.session.reset();
        lock.lock();
        m_isWriting = false;
        m_changed.notify_all();
    }
}

void RunArchive::write(Job& job) {
    const Result<void> saved = job.session->history().save(job.path.toStdString(), &m_progress);
    if (m_progress.isCancelled()) {
        QFile::remove(job.path);
        return;
    }
    removeOldest(QFileInfo(job.path).path(), job.budget);
    kit::post(this, [this, saved, path = job.path] {
        if (saved)
            emit kept(path);
        else
            emit failed(tr("The recording of the last run was not kept: %1").arg(kit::messageText(saved.error())));
    });
}

} // namespace plc::editor
