// Alarms that people have set aside (ISA-18.2): shelved for a while, or out of service until they are put back. They go
// on being recorded, only the lists of present alarms leave them out. Kept in a file; times are arguments. One owner,
// main thread.
#pragma once
#include "runtime/base/result.h"

#include <QDateTime>
#include <QMap>
#include <QString>

#include <optional>
#include <vector>

namespace plc::hmi {

struct SetAside {
    QString alarm; // id
    QString user, reason;
    QDateTime since;
    std::optional<QDateTime> until; // shelved; none: out of service
};

class AlarmSuppression {
public:
    /// The longest time for which an alarm can be shelved.
    static constexpr int kLongestSeconds = 24 * 3600;

    /// Goes on with what the file holds; a file that is not there is an empty one.
    Result<void> open(const QString& path);
    Result<void> shelve(const QString& alarm, int seconds, const QString& user, const QString& reason,
                        const QDateTime& now);
    Result<void> takeOutOfService(const QString& alarm, const QString& user, const QString& reason,
                                  const QDateTime& now);
    /// Back into the list.
    Result<void> putBack(const QString& alarm);
    /// Those whose time is over come back; their ids.
    std::vector<QString> expire(const QDateTime& now);

    const SetAside* find(const QString& alarm) const;
    bool isAside(const QString& alarm) const { return find(alarm) != nullptr; }
    std::vector<SetAside> all() const;

private:
    Result<void> put(SetAside one);
    Result<void> save() const;
    QMap<QString, SetAside> m_aside;
    QString m_path;
};

} // namespace plc::hmi
