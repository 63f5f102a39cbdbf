#include "hmi/texts/format.h"

#include "hmi/model/errors.h"

#include <QDateTime>
#include <QRegularExpression>
#include <QTimeZone>
#include <cmath>

namespace plc::hmi {

std::optional<NumberFormat> NumberFormat::parse(const QString& format) {
    static const QRegularExpression pattern(
        QStringLiteral("%([-+0' ]*)(\\d*)(?:\\.(\\d+))?([diuxXbfeEgGs])(?:(\\d+)\\.(\\d+))?"));
    const QRegularExpressionMatch match = pattern.match(format);
    if (!match.hasMatch()) return {};
    NumberFormat out;
    out.before = format.left(match.capturedStart()).replace(QStringLiteral("%%"), QStringLiteral("%"));
    out.after = format.mid(match.capturedEnd()).replace(QStringLiteral("%%"), QStringLiteral("%"));
    const QString flags = match.captured(1);
    out.zeros = flags.contains(u'0');
    out.sign = flags.contains(u'+');
    out.grouped = flags.contains(u'\'');
    out.left = flags.contains(u'-');
    out.width = std::min(match.captured(2).toInt(), 64);
    if (!match.captured(3).isEmpty()) out.precision = std::min(match.captured(3).toInt(), 17);
    out.conversion = match.captured(4).at(0).toLatin1();
    if (!match.captured(5).isEmpty()) {
        out.width = std::min(match.captured(5).toInt(), 64);
        out.precision = std::min(match.captured(6).toInt(), 17);
    }
    return out;
}

namespace {

QString pad(QString digits, const NumberFormat& format) {
    const auto missing = format.width - static_cast<int>(digits.size());
    if (missing <= 0) return digits;
    if (format.left) return digits + QString(missing, u' ');
    if (!format.zeros) return QString(missing, QChar(0x2007)) + digits; // a blank as wide as a digit
    const int signLength = !digits.isEmpty() && (digits[0] == u'-' || digits[0] == u'+') ? 1 : 0;
    return digits.insert(signLength, QString(missing, u'0'));
}

QString numberText(const Value& value, const NumberFormat& format, QLocale locale) {
    locale.setNumberOptions(format.grouped ? QLocale::DefaultNumberOptions : QLocale::OmitGroupSeparator);
    const bool whole = QByteArray("diuxXb").contains(format.conversion);
    QString digits;
    if (format.conversion == 'x' || format.conversion == 'X') {
        digits = QString::number(static_cast<quint64>(value.toInteger()), 16);
        if (format.conversion == 'X') digits = digits.toUpper();
    } else if (format.conversion == 'b') {
        digits = QString::number(static_cast<quint64>(value.toInteger()), 2);
    } else if (whole) {
        digits = value.kind() == ValueKind::Unsigned ? locale.toString(static_cast<quint64>(value.toInteger()))
                                                     : locale.toString(value.toInteger());
    } else {
        const double number = value.toNumber();
        if (std::isnan(number)) return QStringLiteral("NaN");
        if (std::isinf(number)) return number > 0 ? QStringLiteral("+∞") : QStringLiteral("−∞");
        const int precision = format.precision >= 0 ? format.precision : 6;
        digits = locale.toString(number, format.conversion, precision);
        // -0.04 shown with one digit is 0.0, not -0.0.
        if (digits == locale.negativeSign() + locale.toString(0.0, format.conversion, precision))
            digits = locale.toString(0.0, format.conversion, precision);
    }
    if (format.sign && value.toNumber() >= 0) digits.prepend(u'+');
    return pad(digits, format);
}

/// TRUE and FALSE as the operator says them.
QString truth(bool isTrue, const QLocale& locale) {
    const struct {
        QLocale::Language language;
        const char *yes, *no;
    } words[] = {{QLocale::German, "WAHR", "FALSCH"},      {QLocale::Danish, "SAND", "FALSK"},
                 {QLocale::Spanish, "VERDADERO", "FALSO"}, {QLocale::French, "VRAI", "FAUX"},
                 {QLocale::Arabic, "صحيح", "خطأ"},         {QLocale::Chinese, "真", "假"}};
    for (const auto& word : words)
        if (word.language == locale.language()) return QString::fromUtf8(isTrue ? word.yes : word.no);
    return isTrue ? QStringLiteral("TRUE") : QStringLiteral("FALSE");
}

QDateTime dateTimeOf(qint64 nanoseconds) {
    return QDateTime::fromMSecsSinceEpoch(static_cast<qint64>(std::floor(static_cast<double>(nanoseconds) / 1e6)),
                                          Qt::UTC);
}

} // namespace

QString formatDate(qint64 nanoseconds, const QLocale& locale) {
    QString format = locale.dateFormat(QLocale::ShortFormat);
    if (!format.contains(QStringLiteral("yyyy"))) format.replace(QStringLiteral("yy"), QStringLiteral("yyyy"));
    return locale.toString(dateTimeOf(nanoseconds).date(), format);
}

QString formatTime(qint64 nanoseconds, const QLocale& locale, bool seconds) {
    QString format = locale.timeFormat(QLocale::ShortFormat);
    if (seconds && !format.contains(u's')) {
        const qsizetype minutes = format.lastIndexOf(u'm');
        const QChar before = minutes > 1 ? format[minutes - 2] : QChar(u':');
        format.insert(minutes + 1, QString(before.isPunct() ? before : QChar(u':')) + QStringLiteral("ss"));
    }
    return locale.toString(dateTimeOf(nanoseconds).time(), format);
}

QString formatWeek(qint64 nanoseconds, const QLocale& locale) {
    const QDate date = dateTimeOf(nanoseconds).date();
    if (locale.firstDayOfWeek() == Qt::Monday) return locale.toString(date.weekNumber());
    // Elsewhere the week of 1 January is the first one.
    const int shift = (QDate(date.year(), 1, 1).dayOfWeek() - locale.firstDayOfWeek() + 7) % 7;
    return locale.toString((date.dayOfYear() - 1 + shift) / 7 + 1);
}

QString formatDuration(qint64 nanoseconds, const QLocale& locale) {
    const double seconds = static_cast<double>(nanoseconds) * 1e-9;
    const QString sign = seconds < 0 ? QStringLiteral("-") : QString();
    const double size = std::abs(seconds);
    if (size < 1 && nanoseconds % 1000000 == 0)
        return sign + locale.toString(size * 1000, 'f', 0) + QStringLiteral(" ms");
    if (size < 60) return sign + locale.toString(size, 'f', nanoseconds % 1000000000 ? 2 : 0) + QStringLiteral(" s");
    const qint64 whole = static_cast<qint64>(size);
    const QString inMinute = QString::number(whole % 60).rightJustified(2, u'0'),
                  minutes = QString::number(whole / 60 % 60);
    if (whole < 3600) return sign + minutes + QStringLiteral(" min ") + inMinute + QStringLiteral(" s");
    return sign + QString::number(whole / 3600) + QStringLiteral(" h ") + minutes.rightJustified(2, u'0') +
           QStringLiteral(" min ") + inMinute + QStringLiteral(" s");
}

QString formatValue(const Value& value, const QString& format, const QLocale& locale) {
    const std::optional<NumberFormat> parsed = NumberFormat::parse(format);
    switch (value.kind()) {
    case ValueKind::None:
        return QStringLiteral("– –");
    case ValueKind::Text:
        return parsed ? parsed->before + pad(value.text(), {{}, {}, 's', parsed->width}) + parsed->after : value.text();
    case ValueKind::Bool:
        return parsed && parsed->conversion == 'd' ? QString::number(value.toInteger()) : truth(value.toBool(), locale);
    case ValueKind::Time:
        if (parsed && parsed->conversion != 's')
            return parsed->before + numberText(value, *parsed, locale) + parsed->after;
        return formatDuration(value.toInteger(), locale);
    case ValueKind::Date:
        return formatDate(value.toInteger(), locale);
    case ValueKind::DateTime:
        return formatDate(value.toInteger(), locale) + u' ' + formatTime(value.toInteger(), locale, true);
    case ValueKind::TimeOfDay:
        return formatTime(value.toInteger(), locale, true);
    case ValueKind::Array: {
        QStringList items;
        for (const Value& item : value.items()) items += formatValue(item, format, locale);
        return items.join(QStringLiteral("; "));
    }
    case ValueKind::Integer:
    case ValueKind::Unsigned:
    case ValueKind::Real:
        break;
    }
    if (parsed && parsed->conversion != 's') return parsed->before + numberText(value, *parsed, locale) + parsed->after;
    NumberFormat plain;
    plain.conversion = value.kind() == ValueKind::Real ? 'g' : 'd';
    return numberText(value, plain, locale);
}

TextTemplate TextTemplate::parse(const QString& text) {
    TextTemplate out;
    QString literal;
    for (qsizetype i = 0; i < text.size(); ++i) {
        const QChar c = text[i];
        if ((c == u'{' || c == u'}') && i + 1 < text.size() && text[i + 1] == c) {
            literal += c;
            ++i;
            continue;
        }
        if (c != u'{') {
            literal += c;
            continue;
        }
        const qsizetype close = text.indexOf(u'}', i);
        if (close < 0) {
            out.error = errors::PlaceholderNotClosed(Verbatim("}"));
            literal += text.mid(i);
            break;
        }
        const QString inside = text.mid(i + 1, close - i - 1);
        Part part{
            {}, inside.section(u':', 0, 0).trimmed(), inside.contains(u':') ? inside.section(u':', 1) : QString()};
        if (!part.format.isEmpty() && !NumberFormat::parse(part.format))
            out.error = errors::TextFormatUnknown(toUtf8(part.format));
        if (!literal.isEmpty()) out.parts.push_back({literal, {}, {}});
        literal.clear();
        out.parts.push_back(part);
        i = close;
    }
    if (!literal.isEmpty()) out.parts.push_back({literal, {}, {}});
    return out;
}

QStringList TextTemplate::names() const {
    QStringList out;
    for (const Part& part : parts)
        if (!part.name.isEmpty() && !out.contains(part.name)) out += part.name;
    out.sort();
    return out;
}

QString TextTemplate::fill(const std::function<Value(const QString&)>& valueOf, const QLocale& locale) const {
    QString out;
    for (const Part& part : parts)
        out += part.name.isEmpty() ? part.text : formatValue(valueOf(part.name), part.format, locale);
    return out;
}

} // namespace plc::hmi
