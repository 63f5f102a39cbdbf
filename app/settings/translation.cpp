#include "app/settings/translation.h"

#include "editor/kit/kept_translator.h"
#include "editor/kit/translation_tag.h"

#include <QApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>

namespace plc::app {

namespace {

struct Language {
    const char* tag;
    const char* name; // in itself, so that who cannot read the present one finds it
};
constexpr Language kLanguages[] = {{"en", "English"},  {"de", "Deutsch"}, {"da", "Dansk"},
                                   {"fr", "Français"}, {"es", "Español"}, {"zh_CN", "简体中文"}};

} // namespace

QStringList translatedLanguages() {
    QStringList out;
    for (const Language& language : kLanguages) out << language.tag;
    return out;
}

QString ownNameOf(const QString& language) {
    for (const Language& known : kLanguages)
        if (language == known.tag) return known.name;
    return language;
}

void installTranslation(QApplication& application, const QString& tag) {
    QString language = kit::translationTag(tag.isEmpty() ? QLocale::system().name() : tag);
    if (!translatedLanguages().contains(language)) language = "en";
    // Those of the language before, when the window is rebuilt in another one.
    for (QTranslator* before : application.findChildren<QTranslator*>(QString(), Qt::FindDirectChildrenOnly))
        delete before;
    auto* texts = new kit::KeptTranslator(&application);
    if (texts->load(":/translations/stepwise_" + language + ".qm")) application.installTranslator(texts);
    auto* qt = new kit::KeptTranslator(&application); // buttons of Qt's own dialogs
    if (qt->load("qtbase_" + language, QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
        application.installTranslator(qt);
    QLocale::setDefault(QLocale(language));
}

} // namespace plc::app
