#include "editor/kit/message_text.h"

#include <QCoreApplication>
#include <QHash>
#include <QLocale>
#include <QRegularExpression>
#include <QTranslator>

#include <algorithm>
#include <map>
#include <memory>
#include <vector>

namespace plc::kit {

namespace {

struct Template {
    const char* context;
    const char* text;
};
const Template kTemplates[] = {
#define PLC_MESSAGE(Text) {"Errors", Text},
#include "runtime/base/messages.def"
#define PLC_DIAGNOSTIC(Name, Severity, Code, Text) {"Diagnostics", Text},
#include "runtime/diagnostics/diagnostics.def"
};

struct Pattern {
    const Template* source;
    QRegularExpression form;
    std::vector<int> arguments; // of each capture
    qsizetype words = 0;        // characters that are no argument
};

Pattern patternOf(const Template& source) {
    static const QRegularExpression argument(QStringLiteral("\\{(\\d+)\\}"));
    const QString text = QString::fromUtf8(source.text);
    Pattern pattern{&source, {}, {}, 0};
    QString form;
    qsizetype at = 0;
    for (auto found = argument.globalMatch(text); found.hasNext();) {
        const QRegularExpressionMatch each = found.next();
        const QString before = text.mid(at, each.capturedStart() - at);
        form += QRegularExpression::escape(before) + QStringLiteral("(.+?)");
        pattern.words += before.size();
        pattern.arguments.push_back(each.captured(1).toInt());
        at = each.capturedEnd();
    }
    form += QRegularExpression::escape(text.mid(at));
    pattern.words += text.size() - at;
    pattern.form =
        QRegularExpression(QRegularExpression::anchoredPattern(form), QRegularExpression::DotMatchesEverythingOption);
    return pattern;
}

/// Those that say most first, so that a sentence is not taken for an argument of a shorter one.
const std::vector<Pattern>& patterns() {
    static const std::vector<Pattern> all = [] {
        std::vector<Pattern> made;
        for (const Template& each : kTemplates) made.push_back(patternOf(each));
        std::erase_if(made, [](const Pattern& each) { return each.words < 4; });
        std::stable_sort(made.begin(), made.end(),
                         [](const Pattern& a, const Pattern& b) { return a.words > b.words; });
        return made;
    }();
    return all;
}

QString inLanguage(const Template& source, const QString& language) {
    if (language.isEmpty()) return QCoreApplication::translate(source.context, source.text);
    static std::map<QString, std::unique_ptr<QTranslator>> translators;
    std::unique_ptr<QTranslator>& translator = translators[language];
    if (!translator) {
        translator = std::make_unique<QTranslator>();
        (void)translator->load(QStringLiteral(":/translations/stepwise_%1.qm").arg(language.section('-', 0, 0)));
    }
    const QString text = translator->translate(source.context, source.text);
    return text.isEmpty() ? QString::fromUtf8(source.text) : text;
}

QString translated(const QString& english, const QString& language, int depth) {
    constexpr int kDeepest = 4; // an error that tells of an error that tells of…
    if (depth < kDeepest)
        for (const Pattern& pattern : patterns()) {
            const QRegularExpressionMatch match = pattern.form.match(english);
            if (!match.hasMatch()) continue;
            // In one go: an argument may hold braces itself.
            const QString text = inLanguage(*pattern.source, language);
            QString out;
            qsizetype at = 0;
            static const QRegularExpression argument(QStringLiteral("\\{(\\d+)\\}"));
            for (auto found = argument.globalMatch(text); found.hasNext();) {
                const QRegularExpressionMatch each = found.next();
                out += text.mid(at, each.capturedStart() - at);
                for (size_t i = 0; i < pattern.arguments.size(); ++i)
                    if (pattern.arguments[i] == each.captured(1).toInt())
                        out += translated(match.captured(static_cast<int>(i) + 1), language, depth + 1);
                at = each.capturedEnd();
            }
            return out + text.mid(at);
        }
    // "src/main.st:3: sentence", "Main.x: sentence"
    const qsizetype colon = english.indexOf(QStringLiteral(": "));
    if (colon <= 0 || depth >= kDeepest) return english;
    return english.left(colon + 2) + translated(english.mid(colon + 2), language, depth + 1);
}

} // namespace

QString messageText(const std::string& english, const QString& language) {
    constexpr qsizetype kKept = 2000; // the same few are asked for in every frame
    static QHash<QString, QString> known;
    const QString text = QString::fromStdString(english);
    const QString key = (language.isEmpty() ? QLocale().name() : language) + QChar(u'\n') + text;
    if (const auto it = known.constFind(key); it != known.constEnd()) return *it;
    if (known.size() >= kKept) known.clear();
    return *known.insert(key, translated(text, language, 0));
}

QString messageText(const Error& error, const QString& language) {
    const QString text = messageText(error.message, language);
    return error.place.empty() ? text : QString::fromStdString(error.place) + QStringLiteral(": ") + text;
}

} // namespace plc::kit
