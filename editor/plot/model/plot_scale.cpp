#include "editor/plot/model/plot_scale.h"

#include <QLocale>

#include <algorithm>
#include <cmath>

namespace plc::plot {

namespace {

constexpr int64_t Second = 1'000'000'000, Minute = 60 * Second, Hour = 60 * Minute, Day = 24 * Hour;

int decimalsOf(double step) {
    if (step <= 0) return 0;
    return std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 15);
}

/// Division that rounds down.
int64_t floorDiv(int64_t a, int64_t b) { return a / b - (a % b != 0 && (a < 0) != (b < 0)); }

/// With the decimal sign of the studio's language; everything here is for reading, ST and CSV are written elsewhere.
QString localized(QString text) { return text.replace(QLatin1Char('.'), QLocale().decimalPoint()); }

QString trimmedZeros(QString text) {
    if (!text.contains(QLatin1Char('.')) || text.contains(QLatin1Char('e'))) return text;
    while (text.endsWith(QLatin1Char('0'))) text.chop(1);
    if (text.endsWith(QLatin1Char('.'))) text.chop(1);
    return text;
}

/// `time` in units of `unit`, exact, with `decimals` digits after the point.
QString fixedText(int64_t time, int64_t unit, int decimals) {
    const bool negative = time < 0;
    const uint64_t size = negative ? 0 - static_cast<uint64_t>(time) : static_cast<uint64_t>(time);
    const uint64_t whole = size / static_cast<uint64_t>(unit);
    uint64_t rest = size % static_cast<uint64_t>(unit), scale = static_cast<uint64_t>(unit);
    QString text = QString::number(whole);
    if (decimals > 0) {
        text += QLatin1Char('.');
        for (int i = 0; i < decimals; ++i) {
            scale /= 10;
            if (scale == 0) {
                text += QLatin1Char('0');
                continue;
            }
            text += QChar(QLatin1Char(static_cast<char>('0' + rest / scale)));
            rest %= scale;
        }
    }
    return negative ? QStringLiteral("−") + text : text;
}

QString clockText(int64_t time, bool hours, int decimals) {
    const QString sign = time < 0 ? QStringLiteral("−") : QString();
    const int64_t size = std::abs(time);
    const int64_t h = size / Hour, m = size % Hour / Minute, s = size % Minute;
    QString seconds = fixedText(s, Second, decimals);
    if (s < 10 * Second) seconds.prepend(QLatin1Char('0'));
    if (!hours) return sign + QStringLiteral("%1:%2").arg(size / Minute).arg(seconds);
    return sign + QStringLiteral("%1:%2:%3").arg(h).arg(m, 2, 10, QLatin1Char('0')).arg(seconds);
}

struct TimeStyle {
    enum class Form { Unit, MinuteSecond, HourMinuteSecond, DayHour } form = Form::Unit;
    int64_t unit = Second;
    int decimals = 0;
    QString name;
};

TimeStyle styleFor(int64_t furthest, int64_t step) {
    TimeStyle style;
    if (step >= Hour && furthest >= 2 * Day) return {TimeStyle::Form::DayHour, Hour, 0, QStringLiteral("d h:min")};
    const int below = step >= Second ? 0 : decimalsOf(static_cast<double>(step) / static_cast<double>(Second));
    if (furthest >= 2 * Hour || (furthest >= Hour && step >= Minute))
        return {TimeStyle::Form::HourMinuteSecond, Second, below, QStringLiteral("h:min:s")};
    if (furthest >= 10 * Minute || step >= Minute)
        return {TimeStyle::Form::MinuteSecond, Second, below, QStringLiteral("min:s")};
    if (furthest >= 2 * Second) return {TimeStyle::Form::Unit, Second, below, QStringLiteral("s")};
    if (furthest >= 2'000'000)
        return {TimeStyle::Form::Unit, 1'000'000, step >= 1'000'000 ? 0 : decimalsOf(static_cast<double>(step) / 1e6),
                QStringLiteral("ms")};
    return {TimeStyle::Form::Unit, 1'000, step >= 1'000 ? 0 : decimalsOf(static_cast<double>(step) / 1e3),
            QStringLiteral("µs")};
}

QString timeLabel(int64_t time, const TimeStyle& style) {
    switch (style.form) {
    case TimeStyle::Form::Unit:
        return localized(fixedText(time, style.unit, style.decimals));
    case TimeStyle::Form::MinuteSecond:
        return localized(clockText(time, false, style.decimals));
    case TimeStyle::Form::HourMinuteSecond:
        return localized(clockText(time, true, style.decimals));
    case TimeStyle::Form::DayHour:
        return QStringLiteral("%1 d %2:%3")
            .arg(floorDiv(time, Day))
            .arg((time - floorDiv(time, Day) * Day) / Hour)
            .arg((time - floorDiv(time, Hour) * Hour) / Minute, 2, 10, QLatin1Char('0'));
    }
    return {};
}

} // namespace

double roundStep(double step) {
    if (!(step > 0) || !std::isfinite(step)) return 1;
    const double power = std::pow(10.0, std::floor(std::log10(step)));
    for (double factor : {1.0, 2.0, 5.0})
        if (power * factor >= step * (1 - 1e-9)) return power * factor;
    return power * 10;
}

void roundLimits(double& low, double& high, int wantedTicks) {
    if (!(low <= high)) low = 0, high = 1;
    const double size = std::max(std::abs(low), std::abs(high));
    if (high - low <= size * 1e-9) {
        const double room = size > 0 ? size * 0.1 : 1;
        low -= room;
        high += room;
    }
    const double step = roundStep((high - low) / std::max(1, wantedTicks));
    low = std::floor(low / step + 1e-9) * step;
    high = std::ceil(high / step - 1e-9) * step;
}

std::vector<PlotTick> numberTicks(double low, double high, int most) {
    std::vector<PlotTick> ticks;
    if (!(high > low) || !std::isfinite(high - low)) return ticks;
    const double step = roundStep((high - low) / std::max(1, most));
    const double size = std::max(std::abs(low), std::abs(high));
    const bool scientific = size >= 1e7 || size < 1e-4;
    const int decimals = decimalsOf(step);
    const int digits = std::clamp(static_cast<int>(std::ceil(std::log10(size / step))) + 1, 2, 16);
    for (double k = std::ceil(low / step - 1e-9); k * step <= high + step * 1e-9; ++k) {
        const double value = k == 0 ? 0 : k * step; // no minus zero
        QString label =
            scientific && value != 0 ? QString::number(value, 'g', digits) : QString::number(value, 'f', decimals);
        if (label.startsWith(QLatin1Char('-'))) label.replace(0, 1, QStringLiteral("−"));
        ticks.push_back({value, localized(label)});
        if (ticks.size() > 200) break;
    }
    return ticks;
}

int64_t roundTimeStep(int64_t step) {
    if (step <= 1) return 1;
    if (step <= 5 * Second) {
        int64_t power = 1;
        while (power * 10 <= step) power *= 10;
        for (int64_t factor : {1, 2, 5})
            if (power * factor >= step) return power * factor;
        return power * 10;
    }
    for (int64_t candidate : {10 * Second, 15 * Second, 30 * Second, Minute,   2 * Minute, 5 * Minute, 10 * Minute,
                              15 * Minute, 30 * Minute, Hour,        2 * Hour, 3 * Hour,   6 * Hour,   12 * Hour,
                              Day,         2 * Day,     7 * Day,     14 * Day, 30 * Day,   91 * Day,   365 * Day})
        if (candidate >= step) return candidate;
    return (step / (365 * Day) + 1) * 365 * Day;
}

TimeTicks timeTicks(int64_t from, int64_t to, int64_t origin, int most) {
    TimeTicks result;
    if (to <= from) return result;
    from -= origin;
    to -= origin;
    result.step = roundTimeStep((to - from + std::max(1, most) - 1) / std::max(1, most));
    const TimeStyle style = styleFor(std::max(std::abs(from), std::abs(to)), result.step);
    result.unit = style.name;
    for (int64_t time = -floorDiv(-from, result.step) * result.step; time <= to; time += result.step) {
        result.ticks.emplace_back(time + origin, timeLabel(time, style));
        if (result.ticks.size() > 400) break;
    }
    return result;
}

QString widestTimeLabel(int64_t from, int64_t to, int64_t origin, int64_t step) {
    const TimeStyle style =
        styleFor(std::max(std::abs(from - origin), std::abs(to - origin)), std::max<int64_t>(1, step));
    const QString a = timeLabel(from - origin, style), b = timeLabel(to - origin, style);
    return a.size() > b.size() ? a : b;
}

QString valueText(double value, int digits) {
    if (std::isnan(value)) return QStringLiteral("–");
    if (std::isinf(value)) return value > 0 ? QStringLiteral("∞") : QStringLiteral("−∞");
    const double size = std::abs(value);
    QString text;
    if (size != 0 && (size >= 1e9 || size < 1e-4)) {
        text = QString::number(value, 'g', digits);
    } else {
        const int power = size > 0 ? static_cast<int>(std::floor(std::log10(size))) : 0;
        text = trimmedZeros(QString::number(value, 'f', std::clamp(digits - 1 - power, 0, 12)));
    }
    if (text == QLatin1String("-0")) text = QStringLiteral("0");
    if (text.startsWith(QLatin1Char('-'))) text.replace(0, 1, QStringLiteral("−"));
    return localized(text);
}

QString durationText(int64_t time) {
    const QString sign = time < 0 ? QStringLiteral("−") : QString();
    const double size = std::abs(static_cast<double>(time));
    if (time == 0) return QStringLiteral("0 s");
    if (size < 1e3) return sign + QStringLiteral("%1 ns").arg(size);
    if (size < 1e6) return sign + valueText(size / 1e3, 6) + QStringLiteral(" µs");
    if (size < 1e9) return sign + valueText(size / 1e6, 6) + QStringLiteral(" ms");
    if (size < 120e9) return sign + valueText(size / 1e9, 7) + QStringLiteral(" s");
    const int64_t whole = std::abs(time);
    if (size < 7200e9)
        return sign + QStringLiteral("%1 min %2 s")
                          .arg(whole / Minute)
                          .arg(valueText(static_cast<double>(whole % Minute) / 1e9, 6));
    return sign + QStringLiteral("%1 h %2 min %3 s")
                      .arg(whole / Hour)
                      .arg(whole % Hour / Minute)
                      .arg(valueText(static_cast<double>(whole % Minute) / 1e9, 5));
}

QString momentText(int64_t time) {
    if (std::abs(time) < 10 * Minute) return localized(trimmedZeros(fixedText(time, Second, 9))) + QStringLiteral(" s");
    return localized(trimmedZeros(clockText(time, std::abs(time) >= Hour, 9)));
}

QString frequencyText(int64_t period) {
    if (period == 0) return QStringLiteral("–");
    const double hertz = 1e9 / std::abs(static_cast<double>(period));
    if (hertz >= 1e6) return valueText(hertz / 1e6, 5) + QStringLiteral(" MHz");
    if (hertz >= 1e3) return valueText(hertz / 1e3, 5) + QStringLiteral(" kHz");
    if (hertz >= 1) return valueText(hertz, 5) + QStringLiteral(" Hz");
    return valueText(hertz * 1e3, 5) + QStringLiteral(" mHz");
}

} // namespace plc::plot
