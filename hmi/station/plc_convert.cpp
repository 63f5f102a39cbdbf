#include "hmi/station/plc_convert.h"

#include "hmi/model/errors.h"
#include "runtime/base/messages.h"
#include "runtime/base/text.h"

#include <cmath>

namespace plc::hmi {

using types::Family;
using types::TypeKind;

Value toPanel(const types::TypeTable& types, const types::Value& value) {
    if (!value.hasValue()) return Value::none({});
    if (const auto* items = std::get_if<std::vector<types::Value>>(&value.data)) {
        // Arrays of arrays and fields of structures are shown one after the other.
        std::vector<Value> out;
        for (const types::Value& item : *items) {
            Value inner = toPanel(types, item);
            if (inner.kind() == ValueKind::Array)
                out.insert(out.end(), inner.items().begin(), inner.items().end());
            else
                out.push_back(std::move(inner));
        }
        return Value::ofArray(std::move(out));
    }
    if (const auto* text = std::get_if<std::string>(&value.data))
        return Value::ofText(QString::fromStdString(types::utf8OfString(types.strings, *text)));
    if (const auto* wide = std::get_if<std::u16string>(&value.data))
        return Value::ofText(QString::fromStdString(utf16ToUtf8(*wide))); // whole characters only
    if (const auto* real = std::get_if<double>(&value.data)) return Value::ofReal(*real);
    const int64_t number = value.integer();
    switch (types.family(value.type)) {
    case Family::Bool:
        return Value::ofBool(number != 0);
    case Family::Bits:
    case Family::Unsigned:
        return number < 0 ? Value::ofUnsigned(static_cast<quint64>(number)) : Value::ofInteger(number);
    case Family::Duration:
        return Value::ofInstant(ValueKind::Time, number);
    case Family::Date:
        return Value::ofInstant(ValueKind::Date, number);
    case Family::TimeOfDay:
        return Value::ofInstant(ValueKind::TimeOfDay, number);
    case Family::DateTime:
        return Value::ofInstant(ValueKind::DateTime, number);
    case Family::Character:
        return Value::ofText(QString(QChar(static_cast<char16_t>(number))));
    case Family::Signed:
    case Family::Real:
    case Family::Other:
        return Value::ofInteger(number);
    }
    return {};
}

namespace {

ValueKind kindOf(const types::TypeTable& types, types::TypeId type) {
    if (types.isText(type)) return ValueKind::Text;
    if (types.isAggregate(type)) return ValueKind::Array;
    switch (types.family(type)) {
    case Family::Bool:
        return ValueKind::Bool;
    case Family::Bits:
    case Family::Unsigned:
        return ValueKind::Unsigned;
    case Family::Signed:
        return ValueKind::Integer;
    case Family::Real:
        return ValueKind::Real;
    case Family::Duration:
        return ValueKind::Time;
    case Family::Date:
        return ValueKind::Date;
    case Family::TimeOfDay:
        return ValueKind::TimeOfDay;
    case Family::DateTime:
        return ValueKind::DateTime;
    case Family::Character:
        return ValueKind::Text;
    case Family::Other:
        return ValueKind::None;
    }
    return ValueKind::None;
}

struct Range {
    double low, high;
};

std::optional<Range> rangeOf(const types::TypeTable& types, types::TypeId type) {
    if (types.kind(type) == TypeKind::Subrange)
        return Range{static_cast<double>(types[type].low), static_cast<double>(types[type].high)};
    const Family family = types.family(type);
    if (!types::isInteger(family)) return {};
    const auto [low, high] = types::TypeTable::integerRange(types.storageKind(type));
    return Range{static_cast<double>(low), static_cast<double>(high)};
}

Error notFitting(const Value& value, const types::Type& type) {
    return Error{errors::PanelValueDoesNotFit(value.toLiteral().toStdString(), type.name), {}};
}

} // namespace

ValueFacts factsOf(const types::TypeTable& types, types::TypeId type, bool isWritable) {
    ValueFacts facts;
    facts.kind = kindOf(types, type);
    facts.typeName = QString::fromStdString(types[type].name);
    facts.writable = isWritable;
    if (types.kind(type) == TypeKind::Enum) {
        for (const types::Enumerator& one : types[type].enumerators)
            facts.enumValues.push_back({QString::fromStdString(one.name), one.value});
    } else if (const std::optional<Range> range = rangeOf(types, type)) {
        facts.minimum = range->low;
        facts.maximum = range->high;
    }
    if (types.isText(type)) facts.textCapacity = static_cast<int>(types[type].capacity);
    for (const types::Dimension& dimension : types[type].dimensions)
        facts.arrayBounds.emplace_back(static_cast<int>(dimension.low), static_cast<int>(dimension.high));
    return facts;
}

Result<types::Value> toPlc(const types::TypeTable& types, types::TypeId type, const Value& value) {
    const types::Type& wanted = types[type];
    if (value.isNone()) return Error{errors::NoValueToWrite(), {}};
    if (types.isText(type)) {
        const QString text = value.kind() == ValueKind::Text ? value.text() : value.toLiteral();
        if (wanted.kind == TypeKind::Wstring) {
            if (static_cast<uint32_t>(text.size()) > wanted.capacity) return notFitting(value, wanted);
            return types::Value{type, text.toStdU16String()};
        }
        const std::optional<std::string> bytes = types::stringOfUtf8(types.strings, text.toStdString());
        if (!bytes) return Error{errors::CharactersNotInString(types::nameOf(types.strings)), {}};
        if (bytes->size() > wanted.capacity) return notFitting(value, wanted);
        return types::Value{type, *bytes};
    }
    switch (types.family(type)) {
    case Family::Bool:
        return types::Value{type, static_cast<int64_t>(value.toBool())};
    case Family::Real:
        return types::Value{type, types.storageKind(type) == TypeKind::Real
                                      ? static_cast<double>(static_cast<float>(value.toNumber()))
                                      : value.toNumber()};
    case Family::Bits:
    case Family::Signed:
    case Family::Unsigned: {
        if (value.kind() == ValueKind::Unsigned) return types::Value{type, static_cast<int64_t>(value.toInteger())};
        const double number = value.kind() == ValueKind::Integer ? static_cast<double>(value.toInteger())
                                                                 : std::nearbyint(value.toNumber());
        const std::optional<Range> range = rangeOf(types, type);
        if (!std::isfinite(number) || (range && (number < range->low || number > range->high)))
            return notFitting(value, wanted);
        return types::Value{type, value.kind() == ValueKind::Integer ? static_cast<int64_t>(value.toInteger())
                                                                     : static_cast<int64_t>(number)};
    }
    case Family::Duration:
        // A plain number is a number of seconds, as a panel shows times.
        if (value.isNumber()) return types::Value{type, static_cast<int64_t>(std::llround(value.toNumber() * 1e9))};
        return types::Value{type, static_cast<int64_t>(value.toInteger())};
    case Family::Date:
    case Family::TimeOfDay:
    case Family::DateTime:
        return types::Value{type, static_cast<int64_t>(value.toInteger())};
    case Family::Character:
        if (value.kind() == ValueKind::Text && value.text().size() == 1)
            return types::Value{type, static_cast<int64_t>(value.text()[0].unicode())};
        return notFitting(value, wanted);
    case Family::Other:
        break;
    }
    return Error{errors::NotWrittenFromPanel(wanted.name), {}};
}

} // namespace plc::hmi
