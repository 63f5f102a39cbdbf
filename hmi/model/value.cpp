#include "hmi/model/value.h"

#include <QDateTime>
#include <QLocale>
#include <cmath>

namespace plc::hmi {

Value Value::none(QString reason) {
    Value value;
    value.m_text = std::move(reason);
    return value;
}

Value Value::ofBool(bool on) {
    Value value;
    value.m_kind = ValueKind::Bool;
    value.m_integer = on;
    return value;
}

Value Value::ofInteger(qint64 number) {
    Value value;
    value.m_kind = ValueKind::Integer;
    value.m_integer = number;
    return value;
}

Value Value::ofUnsigned(quint64 number) {
    Value value;
    value.m_kind = ValueKind::Unsigned;
    value.m_integer = static_cast<qint64>(number);
    return value;
}

Value Value::ofReal(double number) {
    Value value;
    value.m_kind = ValueKind::Real;
    value.m_real = number;
    return value;
}

Value Value::ofText(QString text) {
    Value value;
    value.m_kind = ValueKind::Text;
    value.m_text = std::move(text);
    return value;
}

Value Value::ofInstant(ValueKind kind, qint64 nanoseconds) {
    Value value;
    value.m_kind = kind;
    value.m_integer = nanoseconds;
    return value;
}

Value Value::ofArray(std::vector<Value> items) {
    Value value;
    value.m_kind = ValueKind::Array;
    value.m_items = std::move(items);
    return value;
}

bool Value::isNumber() const {
    return m_kind == ValueKind::Integer || m_kind == ValueKind::Unsigned || m_kind == ValueKind::Real;
}

bool Value::toBool() const {
    switch (m_kind) {
    case ValueKind::None:
        return false;
    case ValueKind::Real:
        return m_real != 0;
    case ValueKind::Text:
        return !m_text.isEmpty();
    case ValueKind::Array:
        return !m_items.empty();
    case ValueKind::Bool:
    case ValueKind::Integer:
    case ValueKind::Unsigned:
    case ValueKind::Time:
    case ValueKind::Date:
    case ValueKind::DateTime:
    case ValueKind::TimeOfDay:
        return m_integer != 0;
    }
    return false;
}

double Value::toNumber() const {
    switch (m_kind) {
    case ValueKind::None:
        return 0;
    case ValueKind::Real:
        return m_real;
    case ValueKind::Text:
        return m_text.toDouble();
    case ValueKind::Array:
        return 0;
    case ValueKind::Unsigned:
        return static_cast<double>(static_cast<quint64>(m_integer));
    case ValueKind::Time:
        return static_cast<double>(m_integer) * 1e-9;
    case ValueKind::Bool:
    case ValueKind::Integer:
    case ValueKind::Date:
    case ValueKind::DateTime:
    case ValueKind::TimeOfDay:
        return static_cast<double>(m_integer);
    }
    return 0;
}

qint64 Value::toInteger() const {
    if (m_kind == ValueKind::Real) {
        if (!std::isfinite(m_real) || std::abs(m_real) > 9e18) return 0;
        return std::llrint(m_real);
    }
    if (m_kind == ValueKind::Text) return m_text.toLongLong();
    return m_integer;
}

namespace {

QString timeLiteral(qint64 nanoseconds) {
    QString out = nanoseconds < 0 ? QStringLiteral("T#-") : QStringLiteral("T#");
    quint64 rest = nanoseconds < 0 ? quint64(0) - static_cast<quint64>(nanoseconds) : static_cast<quint64>(nanoseconds);
    const struct {
        const char* unit;
        quint64 length;
    } parts[] = {{"d", 86400000000000ull}, {"h", 3600000000000ull}, {"m", 60000000000ull}, {"s", 1000000000ull},
                 {"ms", 1000000ull},       {"us", 1000ull},         {"ns", 1ull}};
    bool any = false;
    for (const auto& part : parts) {
        if (rest < part.length) continue;
        out += QString::number(rest / part.length) + QLatin1String(part.unit);
        rest %= part.length;
        any = true;
    }
    return any ? out : out + QStringLiteral("0s");
}

QString quoted(const QString& text) {
    QString out = QStringLiteral("'");
    for (const QChar c : text) {
        if (c == u'\'' || c == u'$') out += u'$';
        if (c == u'\n')
            out += QStringLiteral("$L");
        else if (c == u'\r')
            out += QStringLiteral("$R");
        else if (c == u'\t')
            out += QStringLiteral("$T");
        else
            out += c;
    }
    return out + u'\'';
}

} // namespace

QString Value::toLiteral() const {
    constexpr qint64 second = 1000000000, day = 86400 * second;
    const auto date = [&](qint64 ns) {
        return QDateTime::fromSecsSinceEpoch(ns / second, Qt::UTC).toString(QStringLiteral("yyyy-MM-dd"));
    };
    const auto clock = [&](qint64 ns) {
        const qint64 inDay = ((ns % day) + day) % day;
        const QTime time = QTime::fromMSecsSinceStartOfDay(static_cast<int>(inDay / 1000000));
        return time.toString(time.msec() ? QStringLiteral("HH:mm:ss.zzz") : QStringLiteral("HH:mm:ss"));
    };
    switch (m_kind) {
    case ValueKind::None:
        return {};
    case ValueKind::Bool:
        return m_integer ? QStringLiteral("TRUE") : QStringLiteral("FALSE");
    case ValueKind::Integer:
        return QString::number(m_integer);
    case ValueKind::Unsigned:
        return QString::number(static_cast<quint64>(m_integer));
    case ValueKind::Real: {
        QString text = QString::number(m_real, 'g', QLocale::FloatingPointShortest);
        if (!text.contains(u'.') && !text.contains(u'e') && std::isfinite(m_real)) text += QStringLiteral(".0");
        return text;
    }
    case ValueKind::Text:
        return quoted(m_text);
    case ValueKind::Time:
        return timeLiteral(m_integer);
    case ValueKind::Date:
        return QStringLiteral("D#") + date(m_integer);
    case ValueKind::DateTime:
        return QStringLiteral("DT#") + date(m_integer) + u'-' + clock(m_integer);
    case ValueKind::TimeOfDay:
        return QStringLiteral("TOD#") + clock(m_integer);
    case ValueKind::Array: {
        QStringList items;
        for (const Value& item : m_items) items += item.toLiteral();
        return u'[' + items.join(QStringLiteral(", ")) + u']';
    }
    }
    return {};
}

bool Value::operator==(const Value& other) const {
    if (m_kind != other.m_kind || m_integer != other.m_integer || m_text != other.m_text) return false;
    if (m_real != other.m_real && !(std::isnan(m_real) && std::isnan(other.m_real))) return false;
    return m_items == other.m_items;
}

} // namespace plc::hmi
