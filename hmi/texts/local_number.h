// A number as ST writes it, for people: "40.5" is "40,5" where they write it so, in the digits of the language as
// every other number on a panel. A pure function, any thread.
#pragma once
#include <QLocale>
#include <QString>

namespace plc::hmi {

/// Other literals stay as they are.
inline QString localNumber(const QString& literal, const QLocale& locale) {
    bool isNumber = false;
    QLocale::c().toDouble(literal, &isNumber);
    if (!isNumber) return literal;
    QString out;
    for (const QChar c : literal) {
        if (c >= u'0' && c <= u'9')
            out += QChar(static_cast<char16_t>(locale.zeroDigit().at(0).unicode() + (c.unicode() - u'0')));
        else
            out += c == u'.' ? locale.decimalPoint() : QString(c);
    }
    return out;
}

} // namespace plc::hmi
