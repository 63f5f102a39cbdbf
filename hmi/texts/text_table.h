// hmi/texts.csv in memory: keys, comments and one column per operator language. A value, any thread.
#pragma once
#include "hmi/texts/csv.h"

#include <QHash>

namespace plc::hmi {

class TextTable {
public:
    struct Row {
        QString key, comment;
        QStringList texts; // one per language column
        int line = 0;      // in the file; 0 for a new one
    };

    /// The header is `key,comment,<tag>…`; two rows with one key are refused with both lines. With `problems`, such a
    /// row costs only itself: it is named there and stays in the file.
    static Result<TextTable> parse(const std::string& bytes, const QString& place,
                                   std::vector<Error>* problems = nullptr);
    std::string write() const;

    const QStringList& tags() const { return m_tags; }
    const std::vector<Row>& rows() const { return m_rows; }
    int rowOf(const QString& key) const { return m_index.value(key, -1); }
    bool contains(const QString& key) const { return m_index.contains(key); }
    /// The column of exactly this tag (without case), or -1.
    int columnOf(const QString& tag) const;
    /// The text, or an empty one.
    QString text(const QString& key, const QString& tag) const;

    void addLanguage(const QString& tag);
    void removeLanguage(const QString& tag);
    /// Adds the key if it is new.
    void setText(const QString& key, const QString& tag, const QString& text);
    void setComment(const QString& key, const QString& comment);
    bool renameKey(const QString& from, const QString& to);
    void removeKey(const QString& key);
    /// Number of entries `prefix.0`, `prefix.1`… without a gap.
    int listLength(const QString& prefix) const;
    QStringList listPrefixes() const;
    /// A key for a text typed in a panel: words of the text behind the panel's name, free in this table.
    QString newKeyFor(const QString& panel, const QString& text) const;
    /// The key that has this text in the language, below the panel's name if possible.
    QString keyOfText(const QString& tag, const QString& text) const;

private:
    struct Unread {
        size_t before = 0; // the row of this number
        std::string bytes; // with the end of the line
    };
    void reindex();
    QStringList m_tags;
    std::vector<Row> m_rows;
    std::vector<Unread> m_unread; // lines of the file that are no rows of ours
    QHash<QString, int> m_index;
};

} // namespace plc::hmi
