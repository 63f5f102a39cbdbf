#include "editor/kit/curve_words.h"

#include <QHash>
#include <QRegularExpression>

namespace plc::kit {

namespace {

// What programs and texts call them in English and German; white and black are no colours for curves.
const QHash<QString, QString>& colorWords() {
    static const QHash<QString, QString> words = {
        {"red", "red"},       {"rot", "red"},      {"rote", "red"},      {"roter", "red"},     {"rotes", "red"},
        {"yellow", "yellow"}, {"gelb", "yellow"},  {"gelbe", "yellow"},  {"gelber", "yellow"}, {"gelbes", "yellow"},
        {"amber", "yellow"},  {"green", "green"},  {"gruen", "green"},   {"grün", "green"},    {"grüne", "green"},
        {"grüner", "green"},  {"grünes", "green"}, {"blue", "blue"},     {"blau", "blue"},     {"blaue", "blue"},
        {"blauer", "blue"},   {"blaues", "blue"},  {"orange", "orange"},
    };
    return words;
}

/// "bLampRed_2" is b, Lamp, Red.
QStringList partsOf(const QString& name) {
    static const QRegularExpression word(QStringLiteral("\\p{Lu}+(?!\\p{Ll})|\\p{Lu}?\\p{Ll}+"));
    QStringList out;
    for (auto it = word.globalMatch(name); it.hasNext();) out += it.next().captured().toLower();
    return out;
}

/// Programs write m3/h where texts write m³/h, and C for °C.
QString plainUnit(QString text) {
    return text.replace(u'²', u'2').replace(u'³', u'3').replace(u'·', u'*').remove(u'°').replace(u'µ', u'u');
}

/// "Flow [l/min]" says its unit itself, whatever the program calls it; the index of "Main.row[3]" is none.
bool endsWithBracket(const QString& name) {
    static const QRegularExpression bracket(QStringLiteral("\\s\\[[^\\]\\d][^\\]]*\\]\\s*$"));
    return bracket.match(name).hasMatch();
}

} // namespace

bool namesUnit(const QString& name, const QString& wanted) {
    if (wanted.isEmpty()) return false;
    if (endsWithBracket(name)) return true;
    static const QRegularExpression closing(QStringLiteral("[\\])\\s]+$"));
    const QString open = plainUnit(QString(name).remove(closing)), unit = plainUnit(wanted);
    if (open.size() <= unit.size() || !open.endsWith(unit)) return false;
    const QChar before = open[open.size() - unit.size() - 1];
    return !before.isLetterOrNumber() && before != u'_' && before != u'.';
}

QString withUnit(const QString& name, const QString& unit) {
    return unit.isEmpty() || namesUnit(name, unit) ? name : QStringLiteral("%1 [%2]").arg(name, unit);
}

QString colorNamed(const QString& name) {
    QString found;
    for (const QString& word : partsOf(name.section(u'.', -1))) {
        const QString color = colorWords().value(word);
        if (color.isEmpty() || color == found) continue;
        if (!found.isEmpty()) return {};
        found = color;
    }
    return found;
}

} // namespace plc::kit
