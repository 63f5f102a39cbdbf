#include "editor/kit/message_text.h"

#include "editor/kit/translation_tag.h"

#include <QCoreApplication>
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
    const QString text = language.isEmpty() ? QCoreApplication::translate(form.context, form.text)
                                            : translatorFor(language).translate(form.context, form.text);
    return text.isEmpty() ? form.text : text.toStdString();
}

} // namespace

QString messageText(const Message& message, const QString& language) {
    return QString::fromStdString(
        messages::render(message, [&](const messages::Form& form) { return sentence(form, language); }));
}

QString messageText(const Error& error, const QString& language) {
    const QString text = messageText(error.message, language);
    return error.place.empty() ? text : QString::fromStdString(error.place) + QStringLiteral(": ") + text;
}

} // namespace plc::kit
