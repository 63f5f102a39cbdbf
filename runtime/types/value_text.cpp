#include "runtime/base/text.h"
#include "runtime/types/value.h"
#include "runtime/types/wide_text.h"

#include <cmath>
#include <cstdio>

namespace plc::types {
namespace {

const Enumerator* enumeratorOf(const Type& type, int64_t value) {
    for (const Enumerator& enumerator : type.enumerators)
        if (enumerator.value == value) return &enumerator;
    return nullptr;
}

std::string basedText(TypeKind kind, int64_t value, NumberFormat format) {
    const unsigned bits = std::max(8u, bitsOf(kind));
    const uint64_t word =
        bits >= 64 ? static_cast<uint64_t>(value) : static_cast<uint64_t>(value) & ((uint64_t(1) << bits) - 1);
    std::string text = format == NumberFormat::Hex ? "16#" : "2#";
    const unsigned step = format == NumberFormat::Hex ? 4 : 1;
    for (unsigned at = bits; at > 0; at -= step)
        text += "0123456789ABCDEF"[(word >> (at - step)) & (format == NumberFormat::Hex ? 15 : 1)];
    return text;
}

std::string integerText(TypeKind kind, int64_t value, NumberFormat format) {
    const bool isUnsigned64 = kind == TypeKind::Ulint || kind == TypeKind::Lword;
    constexpr int64_t most = INT64_MAX / 1'000'000; // milliseconds that a duration holds
    if (format == NumberFormat::Time && value <= most && value >= -most && !(isUnsigned64 && value < 0))
        return durationText(value * 1'000'000);
    if (format == NumberFormat::Hex || format == NumberFormat::Binary) return basedText(kind, value, format);
    return isUnsigned64 ? std::to_string(static_cast<uint64_t>(value)) : std::to_string(value);
}

std::string offsetText(const TypeTable& types, TypeId type, int64_t offset) {
    if (types.referenceText) {
        std::string path = types.referenceText(type, offset);
        if (!path.empty()) return path;
    }
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "16#%08llX", static_cast<unsigned long long>(offset));
    return buffer;
}

std::string quoted(const std::u32string& text, char quote) {
    std::string out(1, quote);
    for (const char32_t c : text) {
        if (c == static_cast<char32_t>(quote) || c == '$') {
            out += '$';
            out += static_cast<char>(c);
        } else if (c == '\n') {
            out += "$N";
        } else if (c == '\r') {
            out += "$R";
        } else if (c == '\t') {
            out += "$T";
        } else if (c == '\f') {
            out += "$P";
        } else if (c < 0x20 || c == 0x7F || c >= kRawByte) {
            char buffer[8];
            std::snprintf(buffer, sizeof buffer, quote == '"' ? "$%04X" : "$%02X",
                          static_cast<unsigned>(c >= kRawByte ? c - kRawByte : c));
            out += buffer;
        } else {
            appendUtf8(out, c);
        }
    }
    return out + quote;
}

std::string jsonString(std::string_view utf8) {
    std::string out = "\"";
    for (const char c : utf8) {
        if (c == '"' || c == '\\') {
            out += '\\';
            out += c;
        } else if (static_cast<unsigned char>(c) < 0x20) {
            char buffer[8];
            std::snprintf(buffer, sizeof buffer, "\\u%04x", static_cast<unsigned>(c));
            out += buffer;
        } else {
            out += c;
        }
    }
    return out + '"';
}

/// CHAR, WCHAR.
std::u32string characterText(const TypeTable& types, TypeKind kind, int64_t code) {
    if (code == 0) return {};
    const auto unit = static_cast<char16_t>(code);
    if (kind == TypeKind::Wchar) return charactersOfWide({&unit, 1});
    const auto byte = static_cast<char>(code);
    return charactersOf(types.strings, {&byte, 1});
}
std::string utf8Of(const std::u32string& text) {
    std::string out;
    for (const char32_t c : text) {
        const char32_t shown = c >= kRawByte ? c - kRawByte : c;
        appendUtf8(out, isHalfOfPair(shown) ? 0xFFFD : shown);
    }
    return out;
}

/// Text of a scalar that both forms show alike (times, dates, enumerators): empty when it is none of them.
std::string namedText(const TypeTable& types, TypeId type, int64_t value) {
    for (TypeId id = type; types.kind(id) == TypeKind::Enum || types.kind(id) == TypeKind::Subrange;
         id = types[id].element)
        if (const Enumerator* enumerator = enumeratorOf(types[id], value)) return enumerator->name;
    switch (types.storageKind(type)) {
    case TypeKind::Time:
        return durationText(value);
    case TypeKind::Ltime:
        return durationText(value, true);
    case TypeKind::Date:
        return dateText(value);
    case TypeKind::Ldate:
        return dateText(value, true);
    case TypeKind::Tod:
        return timeOfDayText(value);
    case TypeKind::Ltod:
        return timeOfDayText(value, true);
    case TypeKind::Dt:
        return dateTimeText(value);
    case TypeKind::Ldt:
        return dateTimeText(value, true);
    default:
        return {};
    }
}

bool isReferenceLike(TypeKind kind) {
    return kind == TypeKind::Pointer || kind == TypeKind::Reference || kind == TypeKind::Interface ||
           kind == TypeKind::Null || kind == TypeKind::OpenArray;
}

std::string realLiteral(TypeKind kind, double value) {
    return kind == TypeKind::Real ? shortestReal(static_cast<float>(value)) : shortestReal(value);
}

std::string scalarText(const TypeTable& types, TypeId type, int64_t value, NumberFormat format) {
    const TypeKind kind = types.storageKind(type);
    if (kind == TypeKind::Bool) return value ? "TRUE" : "FALSE";
    if (isReferenceLike(kind)) return value ? offsetText(types, type, value) : "NULL";
    if (kind == TypeKind::Char || kind == TypeKind::Wchar)
        return quoted(characterText(types, kind, value), kind == TypeKind::Char ? '\'' : '"');
    std::string text = namedText(types, type, value);
    return text.empty() ? integerText(kind, value, format) : text;
}

std::string scalarJson(const TypeTable& types, TypeId type, int64_t value) {
    const TypeKind kind = types.storageKind(type);
    if (kind == TypeKind::Bool) return value ? "true" : "false";
    if (isReferenceLike(kind)) return value ? jsonString(offsetText(types, type, value)) : "null";
    if (kind == TypeKind::Char || kind == TypeKind::Wchar) return jsonString(utf8Of(characterText(types, kind, value)));
    const std::string text = namedText(types, type, value);
    if (!text.empty()) return jsonString(text);
    const std::string number = integerText(kind, value, NumberFormat::Decimal);
    constexpr int64_t exact = int64_t(1) << 53;
    const bool isUnsigned64 = kind == TypeKind::Ulint || kind == TypeKind::Lword;
    const bool fits =
        isUnsigned64 ? static_cast<uint64_t>(value) <= static_cast<uint64_t>(exact) : value >= -exact && value <= exact;
    return fits ? number : jsonString(number);
}

std::string arrayJson(const TypeTable& types, const Type& type, const std::vector<Value>& elements, size_t dimension,
                      size_t& next) {
    std::string out = "[";
    const uint64_t count = dimension < type.dimensions.size() ? type.dimensions[dimension].count() : elements.size();
    for (uint64_t i = 0; i < count && next < elements.size(); ++i) {
        if (i) out += ",";
        out += dimension + 1 < type.dimensions.size() ? arrayJson(types, type, elements, dimension + 1, next)
                                                      : toJson(types, elements[next++]);
    }
    return out + "]";
}

} // namespace

std::string toText(const TypeTable& types, const Value& value, NumberFormat format) {
    if (const auto* number = std::get_if<int64_t>(&value.data)) return scalarText(types, value.type, *number, format);
    if (const auto* real = std::get_if<double>(&value.data)) return realLiteral(types.storageKind(value.type), *real);
    if (const auto* text = std::get_if<std::string>(&value.data))
        return quoted(charactersOf(types.strings, *text), '\'');
    if (const auto* wide = std::get_if<std::u16string>(&value.data)) return quoted(charactersOfWide(*wide), '"');
    const auto* parts = std::get_if<std::vector<Value>>(&value.data);
    if (!parts) return "(no value)";
    const Type& type = types[value.type];
    std::string out;
    if (type.kind == TypeKind::Array) {
        for (const Value& part : *parts) out += (out.empty() ? "" : ", ") + toText(types, part, format);
        return "[" + out + "]";
    }
    for (size_t i = 0; i < parts->size() && i < type.fields.size(); ++i)
        if (!type.fields[i].isPrivate)
            out += (out.empty() ? "" : ", ") + type.fields[i].name + " := " + toText(types, (*parts)[i], format);
    return "(" + out + ")";
}

std::string toJson(const TypeTable& types, const Value& value) {
    if (const auto* number = std::get_if<int64_t>(&value.data)) return scalarJson(types, value.type, *number);
    if (const auto* real = std::get_if<double>(&value.data)) {
        const std::string text = realLiteral(types.storageKind(value.type), *real);
        return std::isfinite(*real) ? text : jsonString(text);
    }
    if (const auto* text = std::get_if<std::string>(&value.data)) return jsonString(utf8OfString(types.strings, *text));
    if (const auto* wide = std::get_if<std::u16string>(&value.data)) return jsonString(utf16ToUtf8(*wide));
    const auto* parts = std::get_if<std::vector<Value>>(&value.data);
    if (!parts) return "null";
    const Type& type = types[value.type];
    if (type.kind == TypeKind::Array) {
        size_t next = 0;
        return arrayJson(types, type, *parts, 0, next);
    }
    std::string out;
    for (size_t i = 0; i < parts->size() && i < type.fields.size(); ++i)
        if (!type.fields[i].isPrivate)
            out += (out.empty() ? "" : ",") + jsonString(type.fields[i].name) + ":" + toJson(types, (*parts)[i]);
    return "{" + out + "}";
}

} // namespace plc::types
