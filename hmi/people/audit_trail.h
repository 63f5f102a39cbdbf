// Who did what when, in a file that is only ever longer: each line holds a check sum over itself and the line before,
// so that a change shows. CSV, so that it can be read anywhere. One writer; main thread.
#pragma once
#include "hmi/model/json.h" // Qt before the standard library, as moc wants it
#include "runtime/base/result.h"

#include <QDateTime>
#include <QString>

#include <memory>
#include <vector>

class QFile;

namespace plc::hmi {

struct AuditEntry {
    QDateTime at;   // UTC
    QString user;   // empty: nobody was logged in
    QString action; // "write", "log in", "log out", "log in refused", "acknowledge", "recipe"…
    QString what;   // the variable, the alarm, the recipe
    QString from, to;
    QString place;   // panel and element
    QString comment; // "confirmed"
    bool operator==(const AuditEntry&) const = default;
};

class AuditTrail {
public:
    AuditTrail();
    ~AuditTrail();
    /// Goes on with this file, or begins it. A line cut by a power failure is completed and stays.
    Result<void> open(const QString& path);
    bool isOpen() const { return m_file != nullptr; }
    /// On the disk when it returns.
    Result<void> add(const AuditEntry& entry);

private:
    std::unique_ptr<QFile> m_file;
    QByteArray m_last; // check sum of the last line
};

struct AuditRead {
    std::vector<AuditEntry> entries;
    int firstBroken = 0; // line whose check sum is not what it should be; 0: none
};
Result<AuditRead> readAudit(const QString& path);
/// A table for a spreadsheet, without the check sums.
std::string auditToCsv(const std::vector<AuditEntry>& entries);

} // namespace plc::hmi
