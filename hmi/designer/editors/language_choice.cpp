#include "hmi/designer/editors/language_choice.h"

#include "editor/kit/inputs/text_question.h"
#include "hmi/texts/language.h"

#include <QComboBox>
#include <QCompleter>
#include <QCoreApplication>
#include <QLineEdit>
#include <QLocale>
#include <QMap>
#include <QRegularExpression>

namespace plc::hmi {

namespace {

/// Tag → its English name, folded.
const QMap<QString, QString>& knownLanguages() {
    static const QMap<QString, QString> known = [] {
        QMap<QString, QString> all;
        for (const QLocale& each :
             QLocale::matchingLocales(QLocale::AnyLanguage, QLocale::AnyScript, QLocale::AnyTerritory))
            if (each.language() != QLocale::C)
                all.insert(QLocale::languageToCode(each.language()),
                           QLocale::languageToString(each.language()).toCaseFolded());
        for (const char* variety : {"en-GB", "en-US", "fr-CA", "pt-BR", "zh-CN", "zh-TW"})
            all.insert(QString::fromLatin1(variety), {});
        return all;
    }();
    return known;
}

} // namespace

QStringList languagesToChoose() {
    QStringList out;
    for (const QString& tag : knownLanguages().keys()) out << QStringLiteral("%1 (%2)").arg(nativeName(tag), tag);
    std::sort(out.begin(), out.end(),
              [](const QString& a, const QString& b) { return QString::localeAwareCompare(a, b) < 0; });
    return out;
}

QString languageTagOf(const QString& typed) {
    QString text = typed.trimmed();
    static const QRegularExpression inBrackets(QStringLiteral("\\(([^()]+)\\)$"));
    if (const auto match = inBrackets.match(text); match.hasMatch()) text = match.captured(1);
    const QString folded = text.toCaseFolded();
    if (folded.isEmpty()) return {};
    for (auto it = knownLanguages().begin(); it != knownLanguages().end(); ++it)
        if (folded == it.value() || folded == nativeName(it.key()).toCaseFolded()) return it.key();
    static const QRegularExpression tag(QStringLiteral("^([A-Za-z]{2,3})((-[A-Za-z0-9]{1,8})*)$"));
    const auto match = tag.match(text);
    if (!match.hasMatch() || !knownLanguages().contains(match.captured(1).toLower())) return {};
    return match.captured(1).toLower() + match.captured(2);
}

namespace {

QString whyNot(const QString& typed, const QString& tag) {
    if (tag.isEmpty())
        return QCoreApplication::translate(
                   "plc::hmi::TextEditor",
                   "%1 is not a language tag; choose one from the list, or enter a tag such as de or zh-CN")
            .arg(typed);
    return QCoreApplication::translate("plc::hmi::TextEditor", "The table already has %1; choose another language")
        .arg(typed);
}

} // namespace

QString askForLanguage(const QStringList& taken, QWidget* parent) {
    QString chosen;
    const auto take = [&](const QString& typed) {
        const QString tag = languageTagOf(typed);
        if (tag.isEmpty() || taken.contains(tag)) return whyNot(typed, tag);
        chosen = tag;
        return QString();
    };
    kit::TextQuestion question(
        QCoreApplication::translate("plc::hmi::TextEditor", "Add a language"),
        QCoreApplication::translate("plc::hmi::TextEditor", "Language tag, for example de or zh-CN"), {}, take, parent);
    question.setComboBoxItems(languagesToChoose());
    question.setComboBoxEditable(true);
    question.setTextValue(QStringLiteral("Deutsch (de)"));
    // A list below the field: a name completed in it would take the first Enter, and the place of a tag that is typed.
    auto* choice = question.findChild<QComboBox*>();
    choice->completer()->setCompletionMode(QCompleter::PopupCompletion);
    choice->completer()->setFilterMode(Qt::MatchContains);
    QObject::connect(choice->lineEdit(), &QLineEdit::returnPressed, &question, &QDialog::accept);
    choice->lineEdit()->selectAll();
    question.ask();
    return chosen;
}

} // namespace plc::hmi
