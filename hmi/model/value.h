// A value as the panel shows it: what a binding gave at one scan, or why it gave none.
// A value type without owner, any thread; the player converts PLC values into it.
#pragma once
#include <QString>
#include <optional>
#include <vector>

namespace plc::hmi {

enum class ValueKind { None, Bool, Integer, Unsigned, Real, Text, Time, Date, DateTime, TimeOfDay, Array };

class Value {
public:
    Value() = default;
    static Value none(QString reason);
    static Value ofBool(bool on);
    static Value ofInteger(qint64 number);
    static Value ofUnsigned(quint64 number);
    static Value ofReal(double number);
    static Value ofText(QString text);
    /// TIME, TIME_OF_DAY in nanoseconds; DATE, DATE_AND_TIME in nanoseconds since 1970.
    static Value ofInstant(ValueKind kind, qint64 nanoseconds);
    static Value ofArray(std::vector<Value> items);

    ValueKind kind() const { return m_kind; }
    bool isNone() const { return m_kind == ValueKind::None; }
    bool isNumber() const;
    /// The reason for which there is no value; text of a Text.
    const QString& text() const { return m_text; }
    bool toBool() const;
    double toNumber() const;
    qint64 toInteger() const;
    const std::vector<Value>& items() const { return m_items; }
    /// As an ST literal without type prefix ("TRUE", "1.5", "'abc'", "T#1s500ms"); used for writes and logs.
    QString toLiteral() const;

    bool operator==(const Value& other) const;

private:
    ValueKind m_kind = ValueKind::None;
    qint64 m_integer = 0;
    double m_real = 0;
    QString m_text;
    std::vector<Value> m_items;
};

/// What the checker knows of a bound variable; the element draws choices and limits from it.
struct ValueFacts {
    ValueKind kind = ValueKind::None;
    QString typeName;
    bool writable = false;
    std::optional<double> minimum, maximum;
    struct EnumValue {
        QString name;
        qint64 number = 0;
    };
    std::vector<EnumValue> enumValues;
    int textCapacity = 0;
    std::vector<std::pair<int, int>> arrayBounds;
};

} // namespace plc::hmi
