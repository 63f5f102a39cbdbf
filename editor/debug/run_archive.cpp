#include "editor/debug/run_archive.h"

#include <QDir>
#include <QFileInfo>

#include <algorithm>

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

Result<void> RunArchive::keep(const session::Session& session) {
    const history::Statistics recorded = session.history().statistics();
    if (m_folder.isEmpty() || m_budget <= 0 || recorded.end == recorded.first || !QDir().mkpath(m_folder)) return {};
    const QString name = QString("%1-%2%3.rec") // two runs may end in one second
                             .arg(QDateTime::currentDateTime().toString(kStamp))
                             .arg(++m_number, 3, 10, QChar('0'))
                             .arg(session.status().fault ? kFault : "");
    if (auto saved = session.history().save((m_folder + "/" + name).toStdString()); !saved) return saved;
    removeOldest(m_folder, m_budget);
    return {};
}

std::vector<RunArchive::Run> RunArchive::runs() const {
    return m_folder.isEmpty() ? std::vector<Run>() : runsIn(m_folder);
}

} // namespace plc::editor
