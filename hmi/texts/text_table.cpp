#include "hmi/texts/text_table.h"

#include "hmi/model/errors.h"

#include <QRegularExpression>

#include <limits>
#include <optional>

namespace plc::hmi {

Result<TextTable> TextTable::parse(const std::string& bytes, const QString& place, std::vector<Error>* problems) {
    Result<CsvTable> csv = problems ? parseDamagedCsv(bytes, place) : parseCsv(bytes, place);
    if (!csv) return csv.error();
    const auto fail = [&](int line, Message message) {
        return Error{std::move(message), (place + u':' + QString::number(line)).toStdString()};
    };
    TextTable table;
    if (csv->rows.empty()) return table;
    const QStringList& header = csv->rows.front();
    if (header.size() < 2 || header[0].trimmed().compare(QStringLiteral("key"), Qt::CaseInsensitive) != 0 ||
        header[1].trimmed().compare(QStringLiteral("comment"), Qt::CaseInsensitive) != 0)
        return fail(1, errors::TextHeader(Verbatim("key,comment")));
    for (qsizetype i = 2; i < header.size(); ++i) {
        const QString tag = header[i].trimmed();
        if (tag.isEmpty()) return fail(1, errors::ColumnWithoutLanguage(i + 1));
        if (table.columnOf(tag) >= 0) return fail(1, errors::LanguageTwice(toUtf8(tag)));
        table.m_tags += tag;
    }
    std::vector<Error> found;
    auto damage = csv->damaged.begin();
    const auto keepDamageBefore = [&](int line) {
        for (; damage != csv->damaged.end() && damage->line < line; ++damage) {
            found.push_back(damage->error);
            table.m_unread.push_back({table.m_rows.size(), damage->bytes + "\r\n"});
        }
    };
    for (size_t i = 1; i < csv->rows.size(); ++i) {
        const QStringList& cells = csv->rows[i];
        const int line = csv->lines[i];
        keepDamageBefore(line);
        Row row{cells.value(0).trimmed(), cells.value(1), {}, line};
        const int other = table.m_index.value(row.key, -1);
        std::optional<Error> wrong;
        if (cells.size() > header.size())
            wrong = fail(line, errors::TooManyFields(cells.size(), header.size()));
        else if (row.key.isEmpty())
            wrong = fail(line, errors::LineWithoutKey());
        else if (other >= 0)
            wrong = fail(line, errors::KeyTwice(toUtf8(row.key), table.m_rows[static_cast<size_t>(other)].line));
        if (wrong) {
            found.push_back(*wrong);
            table.m_unread.push_back({table.m_rows.size(), writeCsvRow(cells)});
            continue;
        }
        for (qsizetype column = 2; column < header.size(); ++column) row.texts += cells.value(column);
        table.m_index[row.key] = static_cast<int>(table.m_rows.size());
        table.m_rows.push_back(std::move(row));
    }
    keepDamageBefore(std::numeric_limits<int>::max());
    if (!found.empty() && !problems) return found.front();
    if (problems) problems->insert(problems->end(), found.begin(), found.end());
    return table;
}

std::string TextTable::write() const {
    std::string out = writeCsv({QStringList{QStringLiteral("key"), QStringLiteral("comment")} + m_tags});
    auto unread = m_unread.begin();
    for (size_t i = 0; i < m_rows.size(); ++i) {
        for (; unread != m_unread.end() && unread->before <= i; ++unread) out += unread->bytes;
        out += writeCsvRow(QStringList{m_rows[i].key, m_rows[i].comment} + m_rows[i].texts);
    }
    for (; unread != m_unread.end(); ++unread) out += unread->bytes;
    return out;
}

int TextTable::columnOf(const QString& tag) const {
    for (qsizetype i = 0; i < m_tags.size(); ++i)
        if (m_tags[i].compare(tag, Qt::CaseInsensitive) == 0) return static_cast<int>(i);
    return -1;
}

QString TextTable::text(const QString& key, const QString& tag) const {
    const int row = rowOf(key), column = columnOf(tag);
    return row < 0 || column < 0 ? QString() : m_rows[static_cast<size_t>(row)].texts.value(column);
}

void TextTable::addLanguage(const QString& tag) {
    if (columnOf(tag) >= 0) return;
    m_tags += tag;
    for (Row& row : m_rows) row.texts += QString();
}

void TextTable::removeLanguage(const QString& tag) {
    const int column = columnOf(tag);
    if (column < 0) return;
    m_tags.removeAt(column);
    for (Row& row : m_rows) row.texts.removeAt(column);
}

void TextTable::setText(const QString& key, const QString& tag, const QString& text) {
    if (!contains(key)) {
        m_index[key] = static_cast<int>(m_rows.size());
        m_rows.push_back({key, {}, QStringList(m_tags.size()), 0});
    }
    addLanguage(tag);
    m_rows[static_cast<size_t>(rowOf(key))].texts[columnOf(tag)] = text;
}

void TextTable::setComment(const QString& key, const QString& comment) {
    if (const int row = rowOf(key); row >= 0) m_rows[static_cast<size_t>(row)].comment = comment;
}

bool TextTable::renameKey(const QString& from, const QString& to) {
    if (!contains(from) || contains(to) || to.isEmpty()) return false;
    m_rows[static_cast<size_t>(rowOf(from))].key = to;
    reindex();
    return true;
}

void TextTable::removeKey(const QString& key) {
    if (const int row = rowOf(key); row >= 0) m_rows.erase(m_rows.begin() + row);
    reindex();
}

int TextTable::listLength(const QString& prefix) const {
    int length = 0;
    while (contains(prefix + u'.' + QString::number(length))) ++length;
    return length;
}

QStringList TextTable::listPrefixes() const {
    QStringList out;
    for (const Row& row : m_rows)
        if (row.key.endsWith(QStringLiteral(".0"))) out += row.key.chopped(2);
    return out;
}

QString TextTable::newKeyFor(const QString& panel, const QString& text) const {
    static const QRegularExpression other(QStringLiteral("[^\\p{L}\\p{N}]+"));
    QString words = text.toLower()
                        .replace(QRegularExpression(QStringLiteral("\\{[^}]*\\}")), QString())
                        .replace(other, QStringLiteral("_"));
    words = words.left(32);
    while (words.startsWith(u'_')) words.remove(0, 1);
    while (words.endsWith(u'_')) words.chop(1);
    if (words.isEmpty()) words = QStringLiteral("text");
    const QString stem = panel.isEmpty() ? words : panel + u'.' + words;
    if (!contains(stem)) return stem;
    for (int number = 2;; ++number)
        if (const QString key = stem + u'_' + QString::number(number); !contains(key)) return key;
}

QString TextTable::keyOfText(const QString& tag, const QString& text) const {
    const int column = columnOf(tag);
    if (column < 0 || text.isEmpty()) return {};
    for (const Row& row : m_rows)
        if (row.texts.value(column) == text) return row.key;
    return {};
}

void TextTable::reindex() {
    m_index.clear();
    for (size_t i = 0; i < m_rows.size(); ++i) m_index[m_rows[i].key] = static_cast<int>(i);
}

} // namespace plc::hmi
