#include "app/translation.h"

#include <QApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>

namespace plc::app {

QStringList translatedLanguages() { return {"en", "de", "da"}; }

void installTranslation(QApplication& application, const QString& tag) {
    QString language = tag.isEmpty() ? QLocale::system().name().section('_', 0, 0) : tag;
    if (!translatedLanguages().contains(language)) language = "en";
    // Those of the language before, when the window is built anew in another one.
    for (QTranslator* before : application.findChildren<QTranslator*>(QString(), Qt::FindDirectChildrenOnly))
        delete before;
    auto* texts = new QTranslator(&application);
    if (texts->load(":/translations/stepwise_" + language + ".qm")) application.installTranslator(texts);
    auto* qt = new QTranslator(&application); // buttons of Qt's own dialogs
    if (qt->load("qtbase_" + language, QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
        application.installTranslator(qt);
    QLocale::setDefault(QLocale(language));
}

} // namespace plc::app
