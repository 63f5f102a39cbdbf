#include "hmi/texts/language.h"

namespace plc::hmi {

namespace {

QStringList toStrings(const Json& list) {
    QStringList out;
    if (!list.is_array()) return out;
    for (const Json& item : list)
        if (item.is_string()) out += toQString(item);
    return out;
}

struct UnitPair {
    const char *from, *to;
    double factor, offset;
};

constexpr UnitPair kUnits[] = {
    {"°C", "°F", 1.8, 32},
    {"K", "°C", 1, -273.15},
    {"bar", "psi", 14.503773773, 0},
    {"kPa", "psi", 0.14503773773, 0},
    {"m", "ft", 3.280839895, 0},
    {"mm", "in", 0.03937007874, 0},
    {"cm", "in", 0.3937007874, 0},
    {"km/h", "mph", 0.6213711922, 0},
    {"m/s", "ft/s", 3.280839895, 0},
    {"kg", "lb", 2.2046226218, 0},
    {"l", "gal", 0.26417205236, 0},
    {"m³", "ft³", 35.314666721, 0},
    {"l/min", "gpm", 0.26417205236, 0},
    {"kW", "hp", 1.3410220896, 0},
    {"Nm", "lbf·ft", 0.7375621493, 0},
};

/// Units that are words, in the languages of the panel's own texts; the others are the same everywhere.
struct UnitWord {
    const char *unit, *language, *word;
};
constexpr UnitWord kUnitWords[] = {
    {"pcs", "de", "Stk"},    {"pcs", "da", "stk"},    {"pcs", "es", "uds"},   {"pcs", "fr", "pcs"},
    {"pcs", "ar", "قطعة"},   {"pcs", "zh", "件"},     {"rpm", "de", "U/min"}, {"rpm", "da", "o/min"},
    {"rpm", "fr", "tr/min"}, {"rpm", "ar", "دورة/د"}, {"rpm", "zh", "转/分"}, {"min", "ar", "د"},
    {"min", "zh", "分钟"},   {"s", "ar", "ث"},        {"s", "zh", "秒"},      {"h", "ar", "س"},
    {"h", "zh", "小时"},     {"h", "da", "t"},        {"d", "de", "Tage"},    {"d", "zh", "天"},
};

QString unitWord(const QString& tag, const QString& unit) {
    const QString language = tag.section(u'-', 0, 0).toLower();
    for (const UnitWord& one : kUnitWords)
        if (unit == QLatin1String(one.unit) && language == QLatin1String(one.language))
            return QString::fromUtf8(one.word);
    return unit;
}

} // namespace

LanguageSettings LanguageSettings::fromJson(const Json& project) {
    LanguageSettings settings;
    if (!project.is_object()) return settings;
    const auto field = [&](const char* key) -> Json {
        const auto found = project.find(key);
        return found == project.end() ? Json() : *found;
    };
    if (const QStringList tags = toStrings(field("languages")); !tags.isEmpty()) settings.languages = tags;
    settings.fallback = toStrings(field("fallback"));
    if (const QString font = toQString(field("font")); !font.isEmpty()) settings.font = font;
    settings.variable = toQString(field("languageVariable"));
    if (const Json units = field("units"); units.is_object())
        for (const auto& [tag, pairs] : units.items())
            if (pairs.is_object())
                for (const auto& [unit, shown] : pairs.items())
                    settings.units[QString::fromStdString(tag)][QString::fromStdString(unit)] = toQString(shown);
    return settings;
}

QStringList LanguageSettings::chain(const QString& tag) const {
    QStringList out;
    const auto add = [&](const QString& one) {
        for (const QString& other : out)
            if (other.compare(one, Qt::CaseInsensitive) == 0) return;
        out += one;
    };
    for (QString one = tag; !one.isEmpty(); one = one.contains(u'-') ? one.left(one.lastIndexOf(u'-')) : QString())
        add(one);
    const QString base = tag.section(u'-', 0, 0);
    for (const QString& other : languages)
        if (other.section(u'-', 0, 0).compare(base, Qt::CaseInsensitive) == 0) add(other);
    for (const QString& other : fallback) add(other);
    if (!languages.isEmpty()) add(languages.front());
    return out;
}

UnitView LanguageSettings::unitFor(const QString& tag, const QString& unit) const {
    QString shown;
    for (const QString& one : chain(tag).mid(0, 2)) {
        shown = units.value(one).value(unit);
        if (!shown.isEmpty()) break;
        if (one.compare(tag, Qt::CaseInsensitive) == 0 && !tag.contains(u'-')) break;
    }
    if (shown.isEmpty()) return {unitWord(tag, unit)};
    if (shown == unit) return {unit};
    for (const UnitPair& pair : kUnits) {
        const QString from = QString::fromUtf8(pair.from), to = QString::fromUtf8(pair.to);
        if (from == unit && to == shown) return {shown, pair.factor, pair.offset};
        if (to == unit && from == shown) return {shown, 1 / pair.factor, -pair.offset / pair.factor};
    }
    return {shown}; // another word for the same unit
}

QStringList LanguageSettings::fontFamilies(const QString& tag) const {
    QStringList out{font};
    const QLocale locale = localeOf(tag);
    const auto add = [&](const char* family) { out += QString::fromLatin1(family); };
    switch (locale.script()) {
    case QLocale::ArabicScript:
        add("Noto Sans Arabic");
        break;
    case QLocale::HebrewScript:
        add("Noto Sans Hebrew");
        break;
    case QLocale::ThaiScript:
        add("Noto Sans Thai");
        break;
    case QLocale::DevanagariScript:
        add("Noto Sans Devanagari");
        break;
    case QLocale::SimplifiedHanScript:
        add("Noto Sans CJK SC");
        break;
    case QLocale::TraditionalHanScript:
        add("Noto Sans CJK TC");
        break;
    case QLocale::JapaneseScript:
        add("Noto Sans CJK JP");
        break;
    case QLocale::KoreanScript:
        add("Noto Sans CJK KR");
        break;
    default:
        break;
    }
    // A language selector shows the names of all languages, so the other scripts follow.
    for (const char* family : {"Noto Sans Arabic", "Noto Sans CJK SC", "Noto Sans Hebrew", "Noto Sans Symbols2"})
        if (!out.contains(QString::fromLatin1(family))) add(family);
    return out;
}

QString LanguageSettings::tagOf(const Value& value) const {
    if (value.kind() == ValueKind::Text) {
        for (const QString& tag : languages)
            if (tag.compare(value.text(), Qt::CaseInsensitive) == 0) return tag;
        for (const QString& tag : languages)
            if (tag.section(u'-', 0, 0).compare(value.text().section(u'-', 0, 0), Qt::CaseInsensitive) == 0) return tag;
        return {};
    }
    if (value.isNone()) return {};
    const qint64 position = value.toInteger();
    return position >= 0 && position < languages.size() ? languages[position] : QString();
}

Value LanguageSettings::valueOf(const QString& tag, ValueKind kind) const {
    if (kind == ValueKind::Text) return Value::ofText(tag);
    const qsizetype position = languages.indexOf(tag);
    return position < 0 ? Value() : Value::ofInteger(position);
}

QLocale localeOf(const QString& tag) {
    if (tag.compare(kPseudoTag, Qt::CaseInsensitive) == 0) return QLocale(QStringLiteral("en"));
    QLocale locale(tag);
    // Arabic is written with two sets of digits; the tag chooses as BCP 47 says: ar-u-nu-latn, ar-u-nu-arab.
    if (const qsizetype digits = tag.indexOf(QStringLiteral("-u-nu-"), 0, Qt::CaseInsensitive); digits > 0) {
        locale = QLocale(tag.left(digits));
        const bool isLatin = tag.mid(digits + 6).startsWith(QStringLiteral("latn"), Qt::CaseInsensitive);
        if (locale.language() == QLocale::Arabic)
            locale = QLocale(QLocale::Arabic, isLatin ? QLocale::UnitedArabEmirates : QLocale::Egypt);
    }
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    return locale;
}

bool isRightToLeft(const QString& tag) { return localeOf(tag).textDirection() == Qt::RightToLeft; }

QString nativeName(const QString& tag) {
    if (tag.compare(kPseudoTag, Qt::CaseInsensitive) == 0) return pseudoText(QStringLiteral("Pseudo"));
    const QLocale locale(tag.section(QStringLiteral("-u-"), 0, 0));
    // Without a region Qt names the variant of the largest country ("American English").
    if (!tag.contains(u'-')) {
        if (locale.language() == QLocale::English) return QStringLiteral("English");
        if (locale.language() == QLocale::Spanish) return QStringLiteral("Español");
        if (locale.language() == QLocale::Portuguese) return QStringLiteral("Português");
    }
    QString name = locale.nativeLanguageName();
    if (name.isEmpty() || locale.language() == QLocale::C) return tag;
    name[0] = name[0].toUpper();
    return name;
}

QString pseudoText(const QString& text) {
    static const QString plain = QStringLiteral("aceinorstuyzACEINORSTUYZdglk");
    static const QString accented = QStringLiteral("àçéîñöřšťûýžÀÇÉÎÑÖŘŠŤÛÝŽďĝĺķ");
    QString out = QStringLiteral("[");
    int inPlaceholder = 0, letters = 0;
    for (const QChar c : text) {
        if (c == u'{') ++inPlaceholder;
        const qsizetype at = plain.indexOf(c);
        letters += !inPlaceholder;
        out += inPlaceholder || at < 0 ? c : accented[at];
        if (c == u'}' && inPlaceholder) --inPlaceholder;
    }
    const int extra = std::max(1, letters * 2 / 5);
    for (int i = 0; i < extra; ++i) out += i % 6 == 0 && i ? u' ' : u'·';
    return out + u']';
}

} // namespace plc::hmi
