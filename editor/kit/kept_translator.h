// A translator that remembers what it was asked: the English behind a translated text gives a menu entry its letter in
// a language without Latin letters. Owned by the application; translates on any thread, as Qt asks it to.
#pragma once
#include <QHash>
#include <QTranslator>

#include <mutex>

namespace plc::kit {

class KeptTranslator : public QTranslator {
    Q_OBJECT
public:
    using QTranslator::QTranslator;
    QString translate(const char* context, const char* source, const char* disambiguation, int n) const override;
    /// Of a text translated before, by any translator of this kind that the application has; "" of others.
    [[nodiscard]] static QString sourceOf(const QString& translated);

private:
    mutable std::mutex m_mutex;
    mutable QHash<QString, QString> m_sources; // of texts with Chinese characters alone
};

} // namespace plc::kit
