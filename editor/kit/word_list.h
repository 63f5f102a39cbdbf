// Lists of names with commas between them, as roles are written. Pure functions; any thread.
#pragma once
#include <QStringList>

namespace plc::kit {

inline QStringList wordsOf(const QString& list) {
    QStringList out;
    for (const QString& one : list.split(u',', Qt::SkipEmptyParts))
        if (!one.trimmed().isEmpty()) out += one.trimmed();
    return out;
}

/// "a, b" with b chosen is "a"; with c chosen, "a, b, c".
inline QString withToggled(const QString& list, const QString& word) {
    QStringList words = wordsOf(list);
    if (words.removeIf([&](const QString& one) { return one.compare(word, Qt::CaseInsensitive) == 0; }) == 0)
        words += word;
    return words.join(QStringLiteral(", "));
}

} // namespace plc::kit
