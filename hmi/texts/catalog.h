// Finds the text for a key in a language: the table plus the languages' fallback chain. Held by the player or the
// designer and read by views; main thread, or a copy elsewhere.
#pragma once
#include "hmi/texts/format.h"
#include "hmi/texts/text_table.h"

namespace plc::hmi {

/// "@key" names a text of the table, "@@…" is a text that begins with @, all else is the text itself.
bool isTextKey(const QString& text);
QString keyOf(const QString& text);

class TextCatalog {
public:
    TextCatalog() = default;
    TextCatalog(TextTable table, LanguageSettings settings)
        : m_table(std::move(table)), m_settings(std::move(settings)) {}

    const TextTable& table() const { return m_table; }
    const LanguageSettings& settings() const { return m_settings; }
    void setTable(TextTable table) { m_table = std::move(table), m_chains.clear(); }
    void setSettings(LanguageSettings settings) { m_settings = std::move(settings), m_chains.clear(); }

    /// The text of a property in the language: of its key by the fallback chain; a key without text shows as ‹key›.
    QString text(const QString& reference, const QString& tag) const;
    /// Text `index` of the list, or an empty one.
    QString listText(const QString& prefix, qint64 index, const QString& tag) const;
    QString fill(const QString& reference, const QString& tag,
                 const std::function<Value(const QString&)>& valueOf) const;

private:
    std::optional<QString> find(const QString& key, const QString& tag) const;
    TextTable m_table;
    LanguageSettings m_settings;
    mutable QHash<QString, std::vector<int>> m_chains; // columns to ask, by tag
};

} // namespace plc::hmi
