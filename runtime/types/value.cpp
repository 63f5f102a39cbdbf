#include "runtime/types/value.h"

#include "runtime/base/assert.h"
#include "runtime/types/conversion.h"

#include <cstring>

namespace plc::types {
namespace {

/// How a scalar lies in memory.
enum class Shape : uint8_t { None, Integer, Single, Double, Text, WideText, Elements, Fields };

Shape shapeOf(TypeKind kind) {
    switch (kind) {
    case TypeKind::Real:
        return Shape::Single;
    case TypeKind::Lreal:
        return Shape::Double;
    case TypeKind::String:
        return Shape::Text;
    case TypeKind::Wstring:
        return Shape::WideText;
    case TypeKind::Array:
        return Shape::Elements;
    case TypeKind::Struct:
    case TypeKind::Union:
    case TypeKind::Block:
        return Shape::Fields;
    case TypeKind::Void:
    case TypeKind::Unknown:
        return Shape::None;
    default:
        return Shape::Integer;
    }
}

/// What is kept of an integer of `kind` in 64 bits; pointers, interfaces and bounds are offsets.
TypeKind integerKind(TypeKind kind) {
    if (kind == TypeKind::Enum || kind == TypeKind::Subrange || isElementary(kind)) return kind;
    return TypeKind::Ulint;
}

uint64_t readWord(std::span<const std::byte> bytes, size_t size) {
    uint64_t word = 0;
    std::memcpy(&word, bytes.data(), size);
    return word;
}

bool isSlot(const TypeTable& types, const Field& field) {
    return field.section == FieldSection::InOut || types.kind(field.type) == TypeKind::OpenArray;
}

uint64_t elementCount(const Type& type) {
    uint64_t count = 1;
    for (const Dimension& dimension : type.dimensions) count *= dimension.count();
    return count;
}

std::string readText(std::span<const std::byte> bytes, uint32_t capacity) {
    const char* begin = reinterpret_cast<const char*>(bytes.data());
    return {begin, strnlen(begin, capacity)};
}

std::u16string readWideText(std::span<const std::byte> bytes, uint32_t capacity) {
    std::u16string text;
    for (uint32_t i = 0; i < capacity; ++i) {
        char16_t c = 0;
        std::memcpy(&c, bytes.data() + 2 * i, 2);
        if (c == 0) break;
        text += c;
    }
    return text;
}

} // namespace

Value readValue(const TypeTable& types, TypeId type, std::span<const std::byte> bytes, int bit) {
    if (bit >= 0) {
        PLC_ASSERT(!bytes.empty() && bit < 8, return {});
        return {type, static_cast<int64_t>((static_cast<uint8_t>(bytes[0]) >> bit) & 1)};
    }
    const TypeId storage = types.storage(type);
    const Type& layout = types[storage];
    PLC_ASSERT(bytes.size() >= layout.size, return {});
    switch (shapeOf(layout.kind)) {
    case Shape::None:
        return {};
    case Shape::Integer: {
        if (layout.kind == TypeKind::OpenArray) return {type, static_cast<int64_t>(readWord(bytes, 8))};
        const auto word = static_cast<int64_t>(readWord(bytes, layout.size));
        return {type, layout.kind == TypeKind::Bool ? int64_t(word != 0) : wrapInteger(integerKind(layout.kind), word)};
    }
    case Shape::Single: {
        float number = 0;
        std::memcpy(&number, bytes.data(), sizeof number);
        return {type, static_cast<double>(number)};
    }
    case Shape::Double: {
        double number = 0;
        std::memcpy(&number, bytes.data(), sizeof number);
        return {type, number};
    }
    case Shape::Text:
        return {type, readText(bytes, layout.capacity)};
    case Shape::WideText:
        return {type, readWideText(bytes, layout.capacity)};
    case Shape::Elements: {
        std::vector<Value> elements;
        const uint64_t count = elementCount(layout);
        const uint32_t size = types[layout.element].size;
        elements.reserve(count);
        for (uint64_t i = 0; i < count; ++i)
            elements.push_back(readValue(types, layout.element, bytes.subspan(i * size, size)));
        return {type, std::move(elements)};
    }
    case Shape::Fields: {
        std::vector<Value> fields;
        fields.reserve(layout.fields.size());
        for (const Field& field : layout.fields) {
            if (isSlot(types, field))
                fields.push_back(
                    {TypeTable::of(TypeKind::Null), static_cast<int64_t>(readWord(bytes.subspan(field.offset, 8), 8))});
            else
                fields.push_back(readValue(types, field.type, bytes.subspan(field.offset), field.bit));
        }
        return {type, std::move(fields)};
    }
    }
    return {};
}

void writeValue(const TypeTable& types, TypeId type, const Value& value, std::span<std::byte> bytes, int bit) {
    if (!value.hasValue()) return;
    if (bit >= 0) {
        PLC_ASSERT(!bytes.empty() && bit < 8, return );
        const auto mask = static_cast<std::byte>(1u << bit);
        bytes[0] = value.isTrue() ? bytes[0] | mask : bytes[0] & ~mask;
        return;
    }
    const Type& layout = types[types.storage(type)];
    PLC_ASSERT(bytes.size() >= layout.size, return );
    switch (shapeOf(layout.kind)) {
    case Shape::None:
        return;
    case Shape::Integer: {
        PLC_ASSERT(std::holds_alternative<int64_t>(value.data), return );
        const int64_t word = layout.kind == TypeKind::Bool ? int64_t(value.isTrue()) : value.integer();
        std::memcpy(bytes.data(), &word, std::min<size_t>(layout.size, 8));
        return;
    }
    case Shape::Single: {
        PLC_ASSERT(std::holds_alternative<double>(value.data), return );
        const auto number = static_cast<float>(value.real());
        std::memcpy(bytes.data(), &number, sizeof number);
        return;
    }
    case Shape::Double: {
        PLC_ASSERT(std::holds_alternative<double>(value.data), return );
        const double number = value.real();
        std::memcpy(bytes.data(), &number, sizeof number);
        return;
    }
    case Shape::Text: {
        PLC_ASSERT(std::holds_alternative<std::string>(value.data), return );
        const auto& text = std::get<std::string>(value.data);
        const size_t length = std::min<size_t>(text.size(), layout.capacity);
        std::memcpy(bytes.data(), text.data(), length);
        bytes[length] = std::byte{0};
        return;
    }
    case Shape::WideText: {
        PLC_ASSERT(std::holds_alternative<std::u16string>(value.data), return );
        const auto& text = std::get<std::u16string>(value.data);
        const size_t length = std::min<size_t>(text.size(), layout.capacity);
        std::memcpy(bytes.data(), text.data(), 2 * length);
        std::memset(bytes.data() + 2 * length, 0, 2);
        return;
    }
    case Shape::Elements: {
        PLC_ASSERT(std::holds_alternative<std::vector<Value>>(value.data), return );
        const auto& elements = std::get<std::vector<Value>>(value.data);
        const uint32_t size = types[layout.element].size;
        const uint64_t count = std::min<uint64_t>(elements.size(), elementCount(layout));
        for (uint64_t i = 0; i < count; ++i)
            writeValue(types, layout.element, elements[i], bytes.subspan(i * size, size));
        return;
    }
    case Shape::Fields: {
        PLC_ASSERT(std::holds_alternative<std::vector<Value>>(value.data), return );
        const auto& fields = std::get<std::vector<Value>>(value.data);
        const size_t count = std::min(fields.size(), layout.fields.size());
        for (size_t i = 0; i < count; ++i) {
            const Field& field = layout.fields[i];
            if (!isSlot(types, field)) writeValue(types, field.type, fields[i], bytes.subspan(field.offset), field.bit);
        }
        return;
    }
    }
}

Value initialValue(const TypeTable& types, TypeId type) {
    const Type& layout = types[type];
    std::vector<std::byte> bytes(layout.size);
    if (!layout.initial.empty())
        std::memcpy(bytes.data(), layout.initial.data(), std::min<size_t>(bytes.size(), layout.initial.size()));
    return readValue(types, type, bytes);
}

} // namespace plc::types
