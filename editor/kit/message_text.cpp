#include "editor/kit/message_text.h"

#include "editor/kit/occurrence_text.h"
#include "editor/kit/translation_tag.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>
#include <QTranslator>

#include <map>
#include <memory>

namespace plc::kit {

namespace {

/// The texts of a panel's language, which need not be the studio's.
const QTranslator& translatorFor(const QString& language) {
    static std::map<QString, std::unique_ptr<QTranslator>> translators;
    std::unique_ptr<QTranslator>& translator = translators[language];
    if (!translator) {
        translator = std::make_unique<QTranslator>();
        (void)translator->load(QStringLiteral(":/translations/stepwise_%1.qm").arg(translationTag(language)));
    }
    return *translator;
}

std::string sentence(const messages::Form& form, const QString& language) {
    if (!*form.context) // no words: the decimal sign
        return (language.isEmpty() ? QLocale() : QLocale(language)).decimalPoint().toStdString();
    const QString text = language.isEmpty() ? QCoreApplication::translate(form.context, form.text)
                                            : translatorFor(language).translate(form.context, form.text);
    return text.isEmpty() ? form.text : text.toStdString();
}

} // namespace

QString messageText(const Message& message, const QString& language) {
    return QString::fromStdString(
        messages::render(message, [&](const messages::Form& form) { return sentence(form, language); }));
}

QString occurrenceText(const Message& message, const QString& language) {
    // What to do follows a semicolon, in every language; an argument may have one of its own.
    return QString::fromStdString(messages::render(message, [&](const messages::Form& form) {
        const QString all = QString::fromStdString(sentence(form, language));
        static const QRegularExpression remedy(QStringLiteral("; |；"));
        const auto found = remedy.match(all); // in French a narrow blank is before it
        return (found.hasMatch() ? all.left(found.capturedStart()).trimmed() : all).toStdString();
    }));
}

namespace {

QString withPlace(const Error& error, const QString& text) {
    return error.place.empty() ? text : QString::fromStdString(error.place) + QStringLiteral(": ") + text;
}

} // namespace

QString messageText(const Error& error, const QString& language) {
    return withPlace(error, messageText(error.message, language));
}

QString occurrenceText(const Error& error, const QString& language) {
    return withPlace(error, occurrenceText(error.message, language));
}

} // namespace plc::kit
