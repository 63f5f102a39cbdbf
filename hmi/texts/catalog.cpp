#include "hmi/texts/catalog.h"

namespace plc::hmi {

bool isTextKey(const QString& text) { return text.size() > 1 && text[0] == u'@' && text[1] != u'@'; }

QString keyOf(const QString& text) { return isTextKey(text) ? text.mid(1) : QString(); }

std::optional<QString> TextCatalog::find(const QString& key, const QString& tag) const {
    const int row = m_table.rowOf(key);
    if (row < 0) return {};
    auto chain = m_chains.find(tag);
    if (chain == m_chains.end()) {
        std::vector<int> columns;
        for (const QString& one : m_settings.chain(tag))
            if (const int column = m_table.columnOf(one); column >= 0) columns.push_back(column);
        chain = m_chains.insert(tag, columns);
    }
    const QStringList& texts = m_table.rows()[static_cast<size_t>(row)].texts;
    for (const int column : *chain)
        if (!texts[column].isEmpty()) return texts[column];
    return {};
}

QString TextCatalog::text(const QString& reference, const QString& tag) const {
    if (!isTextKey(reference)) return reference.startsWith(QStringLiteral("@@")) ? reference.mid(1) : reference;
    const QString key = keyOf(reference);
    const bool pseudo = tag.compare(kPseudoTag, Qt::CaseInsensitive) == 0 && m_table.columnOf(tag) < 0;
    const std::optional<QString> found = find(key, pseudo ? m_settings.languages.value(0) : tag);
    if (!found) return u'‹' + key + u'›';
    return pseudo ? pseudoText(*found) : *found;
}

QString TextCatalog::listText(const QString& prefix, qint64 index, const QString& tag) const {
    if (prefix.isEmpty()) return {};
    const QString key = (isTextKey(prefix) ? keyOf(prefix) : prefix) + u'.' + QString::number(index);
    return m_table.contains(key) ? text(u'@' + key, tag) : QString();
}

QString TextCatalog::fill(const QString& reference, const QString& tag,
                          const std::function<Value(const QString&)>& valueOf) const {
    const QString raw = text(reference, tag);
    if (!raw.contains(u'{') && !raw.contains(u'}')) return raw;
    return TextTemplate::parse(raw).fill(valueOf, localeOf(tag));
}

} // namespace plc::hmi
