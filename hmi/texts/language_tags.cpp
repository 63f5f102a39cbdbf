#include "hmi/texts/language_tags.h"

#include "hmi/texts/language.h"

#include <QRegularExpression>

namespace plc::hmi {

bool isLanguageTag(const QString& tag) {
    if (tag.compare(kPseudoTag, Qt::CaseInsensitive) == 0) return true;
    static const QRegularExpression shape(QStringLiteral("^[A-Za-z]{2,3}(-[A-Za-z0-9]{1,8})*$"));
    if (!shape.match(tag).hasMatch()) return false;
    const QString language = tag.section(u'-', 0, 0).toLower();
    // Qt takes a code that it does not know for no language at all, which it calls C.
    return QLocale(language).language() != QLocale::C;
}

QString closestTag(const QStringList& languages, const QLocale& reader) {
    const QString own = reader.name().replace(u'_', u'-'), language = own.section(u'-', 0, 0);
    for (const QString& tag : languages)
        if (tag.compare(own, Qt::CaseInsensitive) == 0) return tag;
    for (const QString& tag : languages)
        if (tag.section(u'-', 0, 0).compare(language, Qt::CaseInsensitive) == 0) return tag;
    return languages.value(0);
}

} // namespace plc::hmi
