// A number as ST writes it, for people: "40.5" is "40,5" where they write it so. A pure function, any thread.
#pragma once
#include <QLocale>
#include <QString>

namespace plc::hmi {

/// Other literals stay as they are.
inline QString localNumber(const QString& literal, const QLocale& locale) {
    bool isNumber = false;
    QLocale::c().toDouble(literal, &isNumber);
    QString out = literal;
    return isNumber ? out.replace(u'.', locale.decimalPoint()) : out;
}

} // namespace plc::hmi
