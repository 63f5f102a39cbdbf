#include "editor/kit/kept_translator.h"

#include <QCoreApplication>

#include <algorithm>

namespace plc::kit {

QString KeptTranslator::translate(const char* context, const char* source, const char* disambiguation, int n) const {
    const QString text = QTranslator::translate(context, source, disambiguation, n);
    const bool isChinese =
        std::any_of(text.begin(), text.end(), [](QChar c) { return c.script() == QChar::Script_Han; });
    if (!isChinese || text.size() > 40) return text; // longer ones are sentences
    const std::lock_guard lock(m_mutex);
    m_sources.insert(text, QString::fromUtf8(source));
    return text;
}

QString KeptTranslator::sourceOf(const QString& translated) {
    if (!qApp) return {};
    for (const KeptTranslator* each : qApp->findChildren<KeptTranslator*>()) {
        const std::lock_guard lock(each->m_mutex);
        if (const auto found = each->m_sources.constFind(translated); found != each->m_sources.cend()) return *found;
    }
    return {};
}

} // namespace plc::kit
