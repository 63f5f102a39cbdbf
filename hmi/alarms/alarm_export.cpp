#include "hmi/alarms/alarm_export.h"

#include <QDateTime>

namespace plc::hmi {

namespace {

QString quoted(QString field) {
    if (!field.contains(u',') && !field.contains(u'"') && !field.contains(u'\n')) return field;
    return u'"' + field.replace(u'"', QStringLiteral("\"\"")) + u'"';
}

QString moment(const std::optional<qint64>& clock) {
    if (!clock) return {};
    return QDateTime::fromMSecsSinceEpoch(*clock / 1'000'000, Qt::UTC)
        .toString(QStringLiteral("yyyy-MM-dd HH:mm:ss.zzz"));
}

QString stateName(AlarmState state) {
    switch (state) {
    case AlarmState::Normal:
        return QStringLiteral("gone");
    case AlarmState::Unacknowledged:
        return QStringLiteral("unacknowledged");
    case AlarmState::Acknowledged:
        return QStringLiteral("acknowledged");
    case AlarmState::Returned:
        return QStringLiteral("gone unacknowledged");
    }
    return {};
}

} // namespace

std::string alarmsAsCsv(const std::vector<AlarmEntry>& entries, const TextCatalog& texts, const QString& language) {
    QString out = QStringLiteral("raised,gone,acknowledged,state,run,id,class,priority,text\n");
    for (const AlarmEntry& entry : entries) {
        const QStringList fields{moment(entry.raisedClock),
                                 moment(entry.returnedClock),
                                 moment(entry.acknowledgedClock),
                                 stateName(entry.state),
                                 entry.isOfEarlierRun ? QStringLiteral("earlier") : QStringLiteral("present"),
                                 entry.id,
                                 entry.className,
                                 QString::number(entry.priority),
                                 AlarmBook::render(entry, texts, language)};
        QStringList written;
        for (const QString& field : fields) written += quoted(field);
        out += written.join(u',') + u'\n';
    }
    return out.toStdString();
}

} // namespace plc::hmi
