#include "runtime/controller/fitting.h"
#include "runtime/base/messages.h"

#include "runtime/base/text.h"

#include <cmath>

namespace plc::controller {

using types::Family;
using types::Type;
using types::TypeId;
using types::TypeKind;
using types::TypeTable;
using types::Value;

namespace {

Error doesNotFit(const TypeTable& types, const Value& value, TypeId type) {
    Value plain = value;
    const bool known =
        types::isElementary(types.kind(value.type)) && value.type.index() <= static_cast<size_t>(TypeKind::Wchar);
    std::string shown;
    if (known || std::holds_alternative<std::string>(plain.data))
        shown = types::toText(types, plain);
    else if (std::holds_alternative<int64_t>(plain.data))
        shown = std::to_string(plain.integer());
    else if (std::holds_alternative<double>(plain.data))
        shown = shortestReal(plain.real());
    return Error{shown.empty() ? errors::ThisValueDoesNotFitType(types[type].name)
                               : errors::ValueDoesNotFitType(shown, types[type].name),
                 {}};
}

bool isTimeLike(Family f) {
    return f == Family::Duration || f == Family::Date || f == Family::TimeOfDay || f == Family::DateTime;
}

/// The family the value says it has; Other when its type is none or declared (then its shape alone counts).
Family claimed(const TypeTable& types, const Value& value) {
    if (!value.type.isValid() || value.type.index() > static_cast<size_t>(TypeKind::Wchar)) return Family::Other;
    return types.family(value.type);
}

Result<Value> integerInto(const TypeTable& types, const Value& value, int64_t number, bool isUnsignedBig, TypeId type) {
    const TypeKind kind = types.storageKind(type);
    const Family family = types::familyOf(kind);
    if (family == Family::Bool) {
        if (number != 0 && number != 1) return doesNotFit(types, value, type);
        return Value{type, number};
    }
    if (family == Family::Real) {
        const double real =
            isUnsignedBig ? static_cast<double>(static_cast<uint64_t>(number)) : static_cast<double>(number);
        return Value{type, kind == TypeKind::Real ? static_cast<double>(static_cast<float>(real)) : real};
    }
    if (isTimeLike(family)) return Value{type, number};
    const auto [low, high] = TypeTable::integerRange(kind);
    const bool fits = isUnsignedBig ? static_cast<uint64_t>(number) <= high
                      : number < 0  ? number >= low
                                    : static_cast<uint64_t>(number) <= high;
    // A negative number into a bit string or unsigned of 64 bits would change its meaning.
    if (!fits) return doesNotFit(types, value, type);
    const Type& t = types[type];
    if (t.kind == TypeKind::Subrange && (number < t.low || number > t.high))
        return Error{errors::ValueOutOfRange(number, t.low, t.high), {}};
    return Value{type, number};
}

/// A text of one character.
std::optional<Value> characterInto(const TypeTable& types, const Value& value, TypeId type) {
    const bool wide = types.storageKind(type) == TypeKind::Wchar;
    if (const auto* text = std::get_if<std::string>(&value.data)) {
        if (!wide && text->size() == 1) return Value{type, int64_t{static_cast<unsigned char>(text->front())}};
        const std::u16string same = types::wideOfString(types.strings, *text);
        if (wide && same.size() == 1) return Value{type, int64_t{same.front()}};
    }
    if (const auto* text = std::get_if<std::u16string>(&value.data); text && text->size() == 1) {
        if (wide) return Value{type, int64_t{text->front()}};
        if (const auto byte = types::characterOfWide(types.strings, text->front())) return Value{type, int64_t{*byte}};
    }
    return std::nullopt;
}

Result<Value> textInto(const TypeTable& types, const Value& value, TypeId type) {
    const Type& t = types[type];
    const bool wide = t.kind == TypeKind::Wstring;
    Value out{type, {}};
    size_t length = 0;
    if (const auto* narrow = std::get_if<std::string>(&value.data)) {
        length = narrow->size();
        if (wide) {
            std::u16string same = types::wideOfString(types.strings, *narrow);
            length = same.size();
            out.data = std::move(same);
        } else {
            out.data = *narrow;
        }
    } else if (const auto* text = std::get_if<std::u16string>(&value.data)) {
        length = text->size();
        if (wide) {
            out.data = *text;
        } else {
            bool isWhole = true;
            std::string bytes = types::stringOfWide(types.strings, *text, isWhole);
            if (!isWhole) return Error{errors::CharacterDoesNotFit(), {}};
            length = bytes.size();
            out.data = std::move(bytes);
        }
    } else {
        return doesNotFit(types, value, type);
    }
    if (length > t.capacity) return Error{errors::TextTooLong(length, t.capacity), {}};
    return out;
}

Result<Value> partsInto(const TypeTable& types, const Value& value, TypeId type) {
    const auto* parts = std::get_if<std::vector<Value>>(&value.data);
    if (!parts) return doesNotFit(types, value, type);
    const Type& t = types[type];
    std::vector<Value> out;
    const auto add = [&](const Value& part, TypeId partType) -> Result<void> {
        if (!part.hasValue()) { // left alone
            out.push_back(part);
            return {};
        }
        Result<Value> inner = fitted(types, part, partType);
        if (!inner) return inner.error();
        out.push_back(std::move(*inner));
        return {};
    };
    size_t count = t.fields.size();
    if (t.kind == TypeKind::Array) {
        count = 1;
        for (const types::Dimension& d : t.dimensions) count *= d.count();
    }
    if (parts->size() != count) return Error{errors::PartCount(t.name, count, parts->size()), {}};
    for (size_t i = 0; i < parts->size(); ++i)
        if (Result<void> good = add((*parts)[i], t.kind == TypeKind::Array ? t.element : t.fields[i].type); !good)
            return good.error();
    return Value{type, std::move(out)};
}

} // namespace

Result<Value> fitted(const TypeTable& types, const Value& value, TypeId type) {
    if (!value.hasValue()) return Error{errors::NoValueToWrite(), {}};
    const TypeKind kind = types.storageKind(type);
    if (types.isAggregate(type)) return partsInto(types, value, type);
    if (kind == TypeKind::String || kind == TypeKind::Wstring) return textInto(types, value, type);
    const Family target = types::familyOf(kind);
    if (kind == TypeKind::Pointer || kind == TypeKind::Reference || kind == TypeKind::Interface) {
        const bool isNull = std::holds_alternative<int64_t>(value.data) && value.integer() == 0;
        if (isNull) return Value{type, int64_t(0)};
        return Error{errors::OnlyNullWritten(), {}};
    }
    if (target == Family::Character) {
        if (auto character = characterInto(types, value, type)) return *character;
    }
    const Family source = claimed(types, value);
    const bool sourceIsTime = isTimeLike(source);
    if ((sourceIsTime || (isTimeLike(target) && source != Family::Other)) && source != target)
        return doesNotFit(types, value, type);
    if (const auto* number = std::get_if<int64_t>(&value.data)) {
        const bool isUnsignedBig = *number < 0 && (source == Family::Unsigned || source == Family::Bits);
        return integerInto(types, value, *number, isUnsignedBig, type);
    }
    if (const auto* real = std::get_if<double>(&value.data)) {
        if (target == Family::Real) {
            if (kind == TypeKind::Lreal) return Value{type, *real};
            const double single = static_cast<double>(static_cast<float>(*real));
            if (std::isinf(single) && !std::isinf(*real)) return doesNotFit(types, value, type);
            return Value{type, single};
        }
        if (target == Family::Bool || isTimeLike(target) || std::nearbyint(*real) != *real || std::fabs(*real) > 9.2e18)
            return doesNotFit(types, value, type);
        return integerInto(types, value, static_cast<int64_t>(*real), false, type);
    }
    return doesNotFit(types, value, type);
}

} // namespace plc::controller
