// Texts with values in them: `{name:%.1f}` placeholders and the printf-like formats, written as the operator's
// language writes numbers, dates and units. Pure functions, any thread.
#pragma once
#include "hmi/texts/language.h"
#include "runtime/base/message.h"

#include <functional>

namespace plc::hmi {

/// "%[flags][width][.precision](d i u x X b f e g s)" with text around it; also "%f5.2" as some sources write it.
struct NumberFormat {
    QString before, after;
    char conversion = 'f';
    int width = 0, precision = -1;
    bool zeros = false, sign = false, grouped = false, left = false;

    static std::optional<NumberFormat> parse(const QString& format);
};

QString formatValue(const Value& value, const QString& format, const QLocale& locale);
/// Date and time of nanoseconds since 1970 in the language's order, with a year of four digits.
QString formatDate(qint64 nanoseconds, const QLocale& locale);
QString formatTime(qint64 nanoseconds, const QLocale& locale, bool seconds);
QString formatWeek(qint64 nanoseconds, const QLocale& locale);
/// "1 h 02 min 03 s", "1.25 s".
QString formatDuration(qint64 nanoseconds, const QLocale& locale);

/// A text cut at its placeholders; "{{" and "}}" stand for braces.
struct TextTemplate {
    struct Part {
        QString text; // literal text
        QString name; // or the placeholder's name
        QString format;
    };
    std::vector<Part> parts;
    Message error; // an open brace that is never closed, a bad format

    static TextTemplate parse(const QString& text);
    QStringList names() const;
    QString fill(const std::function<Value(const QString&)>& valueOf, const QLocale& locale) const;
};

} // namespace plc::hmi
