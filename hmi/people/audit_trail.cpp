#include "hmi/people/audit_trail.h"

#include "hmi/model/errors.h"
#include "hmi/texts/csv.h"
#include "runtime/platform/files.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>

namespace plc::hmi {

namespace {

const QByteArray kHead = "time,user,action,what,from,to,place,comment,sum\n";

QByteArray sumOf(const QByteArray& before, const QByteArray& line) {
    return QCryptographicHash::hash(before + '\n' + line, QCryptographicHash::Sha256).toHex().left(32);
}

QStringList fieldsOf(const AuditEntry& entry) {
    return {entry.at.toUTC().toString(Qt::ISODateWithMs),
            entry.user,
            entry.action,
            entry.what,
            entry.from,
            entry.to,
            entry.place,
            entry.comment};
}

/// One line: what breaks lines becomes blanks.
QByteArray lineOf(const AuditEntry& entry) {
    QStringList fields = fieldsOf(entry);
    for (QString& field : fields)
        for (QChar& c : field)
            if (c < u' ') c = u' ';
    return QByteArray::fromStdString(writeCsvRow(fields)).trimmed();
}

QStringList split(const QByteArray& line) {
    const auto table = parseCsv(line.toStdString(), {});
    return table && !table->rows.empty() ? table->rows.front() : QStringList();
}

AuditEntry entryOf(const QStringList& fields) {
    return {QDateTime::fromString(fields.value(0), Qt::ISODateWithMs),
            fields.value(1),
            fields.value(2),
            fields.value(3),
            fields.value(4),
            fields.value(5),
            fields.value(6),
            fields.value(7)};
}

} // namespace

AuditTrail::AuditTrail() = default;
AuditTrail::~AuditTrail() = default;

Result<void> AuditTrail::open(const QString& path) {
    m_file.reset();
    m_last.clear();
    QDir().mkpath(QFileInfo(path).path());
    auto file = std::make_unique<QFile>(path);
    if (!file->open(QIODevice::ReadWrite))
        return Error{errors::AuditNotWritten(file->errorString().toStdString()), path.toStdString()};
    const QByteArray bytes = file->readAll();
    if (bytes.isEmpty()) {
        file->write(kHead);
    } else {
        const qsizetype end = bytes.endsWith('\n') ? bytes.size() - 1 : bytes.size();
        const qsizetype begin = bytes.lastIndexOf('\n', end - 1) + 1;
        const QByteArray line = bytes.mid(begin, end - begin);
        if (line + '\n' != kHead) m_last = line.mid(line.lastIndexOf(',') + 1);
        if (end == bytes.size()) file->write("\n");
    }
    if (!file->flush()) return Error{errors::AuditNotWritten(file->errorString().toStdString()), path.toStdString()};
    m_file = std::move(file);
    return {};
}

Result<void> AuditTrail::add(const AuditEntry& entry) {
    if (!m_file) return {};
    const QByteArray line = lineOf(entry), sum = sumOf(m_last, line);
    const QByteArray bytes = line + ',' + sum + '\n';
    if (m_file->write(bytes) != bytes.size() || !m_file->flush() || !platform::syncFile(m_file->handle()))
        return Error{errors::AuditNotWritten(m_file->errorString().toStdString()), m_file->fileName().toStdString()};
    m_last = sum;
    return {};
}

Result<AuditRead> readAudit(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return Error{errors::AuditNotRead(file.errorString().toStdString()), path.toStdString()};
    AuditRead out;
    QByteArray last;
    int number = 0;
    while (!file.atEnd()) {
        QByteArray line = file.readLine();
        ++number;
        if (line.endsWith('\n')) line.chop(1);
        if (number == 1) {
            if (line + '\n' != kHead) out.firstBroken = 1;
            continue;
        }
        const qsizetype comma = line.lastIndexOf(',');
        const QByteArray sum = line.mid(comma + 1);
        if (comma < 0 || sum != sumOf(last, line.left(comma)))
            if (!out.firstBroken) out.firstBroken = number;
        last = sum;
        if (comma > 0) out.entries.push_back(entryOf(split(line.left(comma))));
    }
    return out;
}

std::string auditToCsv(const std::vector<AuditEntry>& entries) {
    QByteArray out = "time,user,action,what,from,to,place,comment\n";
    for (const AuditEntry& entry : entries) out += lineOf(entry) + '\n';
    return out.toStdString();
}

} // namespace plc::hmi
