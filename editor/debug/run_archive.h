// The runs of a project that have ended: each is kept on disk as a recording until newer ones need the room, so that
// starting again, closing and creating another project lose nothing. Owned by RunControl; GUI thread.
#pragma once
#include "projects/session/session.h"

#include <QDateTime>
#include <QString>

#include <vector>

namespace plc::editor {

class RunArchive {
public:
    struct Run {
        QString path;
        QDateTime ended;
        bool isFault = false; // a fault ended it
        qint64 bytes = 0;
    };

    /// Of the project; "" keeps nothing.
    void setFolder(const QString& folder) { m_folder = folder; }
    /// For all runs of a project together; 0 keeps none. The newest run stays even when it alone is larger.
    void setBudget(qint64 bytes) { m_budget = bytes; }
    /// What the session has recorded, before it goes.
    Result<void> keep(const session::Session& session);
    /// What is kept of the project, the newest first.
    [[nodiscard]] std::vector<Run> runs() const;

private:
    QString m_folder;
    qint64 m_budget = qint64(1) << 30;
    int m_number = 0; // of the runs of this program
};

} // namespace plc::editor
