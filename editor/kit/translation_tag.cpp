#include "editor/kit/translation_tag.h"

#include <QLocale>

namespace plc::kit {

QString translationTag(const QString& language) {
    QString name = language;
    name.replace(u'-', u'_');
    if (name.section(u'_', 0, 0) != QStringLiteral("zh")) return name.section(u'_', 0, 0);
    const bool isSimplified = QLocale(name).script() == QLocale::SimplifiedHanScript;
    return isSimplified ? QStringLiteral("zh_CN") : QStringLiteral("en");
}

} // namespace plc::kit
