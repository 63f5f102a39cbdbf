#include "runtime/types/type_table.h"

#include "runtime/base/text.h"

#include <algorithm>
#include <cstring>

namespace plc::types {

const Field* Type::findField(std::string_view fieldName) const {
    for (const Field& field : fields) {
        if (equalsIgnoringCase(field.name, fieldName)) return &field;
        for (const std::string& alias : field.aliases)
            if (equalsIgnoringCase(alias, fieldName)) return &field;
    }
    return nullptr;
}

Family familyOf(TypeKind kind) {
    switch (kind) {
#define PLC_ELEMENTARY(Name, Spelling, Bytes, FamilyName)                                                              \
    case TypeKind::Name:                                                                                               \
        return Family::FamilyName;
#include "runtime/types/elementary.def"
    default:
        return Family::Other;
    }
}

std::string_view spelling(TypeKind kind) {
    switch (kind) {
#define PLC_ELEMENTARY(Name, Spelling, Bytes, FamilyName)                                                              \
    case TypeKind::Name:                                                                                               \
        return Spelling;
#include "runtime/types/elementary.def"
    default:
        return {};
    }
}

namespace {
uint32_t bytesOf(TypeKind kind) {
    switch (kind) {
#define PLC_ELEMENTARY(Name, Spelling, Bytes, FamilyName)                                                              \
    case TypeKind::Name:                                                                                               \
        return Bytes;
#include "runtime/types/elementary.def"
    default:
        return 0;
    }
}
/// Bytes of one value: what all data of a program may take together. A type that needs more has no size.
constexpr uint64_t kMaximumSize = uint64_t(256) << 20;

uint64_t aligned(uint64_t offset, uint32_t align) { return (offset + align - 1) / align * align; }
} // namespace

unsigned bitsOf(TypeKind kind) { return kind == TypeKind::Bool ? 1 : bytesOf(kind) * 8; }

TypeTable::TypeTable() {
    for (uint32_t k = 0; k <= static_cast<uint32_t>(TypeKind::Unknown); ++k) {
        const auto kind = static_cast<TypeKind>(k);
        Type type;
        type.kind = isElementary(kind) || kind >= TypeKind::Null ? kind : TypeKind::Unknown;
        type.name = isElementary(kind)       ? std::string(spelling(kind))
                    : kind == TypeKind::Null ? "NULL"
                    : kind == TypeKind::Void ? "(no value)"
                                             : "(unknown)";
        type.size = bytesOf(kind);
        if (kind == TypeKind::Null) type.size = 8;
        type.align = std::max(1u, type.size);
        m_types.push_back(std::move(type));
    }
}

TypeId TypeTable::add(Type type) {
    m_types.push_back(std::move(type));
    return TypeId(m_types.size() - 1);
}

TypeId TypeTable::shared(const std::string& key, Type type) {
    if (const auto it = m_shared.find(key); it != m_shared.end()) return it->second;
    return m_shared[key] = add(std::move(type));
}

TypeId TypeTable::string(uint32_t capacity) {
    Type t;
    t.kind = TypeKind::String;
    t.capacity = capacity;
    t.size = capacity + 1;
    t.name = capacity == 80 ? "STRING" : "STRING(" + std::to_string(capacity) + ")";
    return shared(t.name, t);
}

TypeId TypeTable::wstring(uint32_t capacity) {
    Type t;
    t.kind = TypeKind::Wstring;
    t.capacity = capacity;
    t.size = (capacity + 1) * 2;
    t.align = 2;
    t.name = capacity == 80 ? "WSTRING" : "WSTRING(" + std::to_string(capacity) + ")";
    return shared(t.name, t);
}

TypeId TypeTable::array(std::vector<Dimension> dimensions, TypeId element) {
    Type t;
    t.kind = TypeKind::Array;
    t.element = element;
    t.name = "ARRAY[";
    for (size_t i = 0; i < dimensions.size(); ++i)
        t.name += (i ? ", " : "") + std::to_string(dimensions[i].low) + ".." + std::to_string(dimensions[i].high);
    t.name += "] OF " + (*this)[element].name;
    t.dimensions = std::move(dimensions);
    const std::string key = t.name + "#" + std::to_string(element.value);
    const TypeId id = shared(key, std::move(t));
    if (m_types[id.index()].size == 0) layoutArray(id);
    return id;
}

void TypeTable::layoutArray(TypeId id) {
    Type& t = m_types[id.index()];
    const Type& element = (*this)[t.element];
    uint64_t count = 1;
    for (const Dimension& d : t.dimensions) // each factor is below 2^32: no product wraps
        count = std::min(count, kMaximumSize + 1) * std::min(d.count(), kMaximumSize + 1);
    const uint64_t needed = std::min(count, kMaximumSize + 1) * element.size;
    t.size = needed <= kMaximumSize ? static_cast<uint32_t>(needed) : 0;
    t.align = element.align;
    t.initial.clear();
    if (t.size == 0) return;
    if (!element.initial.empty()) {
        t.initial.resize(t.size);
        for (uint64_t i = 0; i < count && (i + 1) * element.size <= t.size; ++i)
            std::memcpy(t.initial.data() + i * element.size, element.initial.data(), element.size);
    }
}

TypeId TypeTable::openArray(size_t rank, TypeId element) {
    Type t;
    t.kind = TypeKind::OpenArray;
    t.element = element;
    t.dimensions.resize(rank);
    t.size = static_cast<uint32_t>(8 + 16 * rank);
    t.align = 8;
    t.name = "ARRAY[*";
    for (size_t i = 1; i < rank; ++i) t.name += ", *";
    t.name += "] OF " + (*this)[element].name;
    const std::string key = t.name + "#" + std::to_string(element.value);
    return shared(key, std::move(t));
}

TypeId TypeTable::pointer(TypeId target) {
    Type t;
    t.kind = TypeKind::Pointer;
    t.element = target;
    t.size = t.align = 8;
    t.name = "POINTER TO " + (*this)[target].name;
    return shared("P#" + std::to_string(target.value), std::move(t));
}

TypeId TypeTable::reference(TypeId target) {
    Type t;
    t.kind = TypeKind::Reference;
    t.element = target;
    t.size = t.align = 8;
    t.name = "REFERENCE TO " + (*this)[target].name;
    return shared("R#" + std::to_string(target.value), std::move(t));
}

TypeId TypeTable::subrange(TypeId base, int64_t low, int64_t high) {
    Type t;
    t.kind = TypeKind::Subrange;
    t.element = base;
    t.low = low;
    t.high = high;
    t.size = (*this)[base].size;
    t.align = (*this)[base].align;
    t.name = (*this)[base].name + "(" + std::to_string(low) + ".." + std::to_string(high) + ")";
    if (low > 0 || high < 0) { // a subrange starts at its lower bound when 0 is outside it
        t.initial.resize(t.size);
        std::memcpy(t.initial.data(), &low, t.size);
    }
    const std::string key = t.name + "#" + std::to_string(base.value);
    return shared(key, std::move(t));
}

TypeId TypeTable::declare(TypeKind kind, std::string name) {
    Type t;
    t.kind = kind;
    t.name = std::move(name);
    if (kind == TypeKind::Interface) t.size = t.align = 8;
    return add(std::move(t));
}

TypeId TypeTable::storage(TypeId id) const {
    for (int guard = 0; guard < 64; ++guard) {
        const Type& type = (*this)[id];
        if (type.kind != TypeKind::Enum && type.kind != TypeKind::Subrange) break;
        id = type.element;
    }
    return id;
}

bool TypeTable::isAggregate(TypeId id) const {
    const TypeKind k = kind(id);
    return k == TypeKind::Array || k == TypeKind::Struct || k == TypeKind::Union || k == TypeKind::Block;
}

bool TypeTable::isText(TypeId id) const { return kind(id) == TypeKind::String || kind(id) == TypeKind::Wstring; }

bool TypeTable::isDerivedFrom(TypeId type, TypeId base) const {
    std::vector<TypeId> interfaces; // each once, however many ways lead to it
    for (int guard = 0; type.isValid() && guard < 1000; ++guard, type = (*this)[type].base) {
        if (type == base) return true;
        for (const TypeId interface : (*this)[type].interfaces)
            if (std::find(interfaces.begin(), interfaces.end(), interface) == interfaces.end())
                interfaces.push_back(interface);
    }
    for (size_t i = 0; i < interfaces.size(); ++i) {
        if (interfaces[i] == base) return true;
        for (const TypeId interface : (*this)[interfaces[i]].interfaces)
            if (std::find(interfaces.begin(), interfaces.end(), interface) == interfaces.end())
                interfaces.push_back(interface);
    }
    return false;
}

bool TypeTable::implements(TypeId block, TypeId interface) const { return isDerivedFrom(block, interface); }

void TypeTable::layoutFields(TypeId id, uint32_t start) {
    Type& t = m_types[id.index()];
    const bool isUnion = t.kind == TypeKind::Union;
    uint64_t offset = start; // of fields that have kMaximumSize at most: the sum does not wrap
    t.align = std::max(1u, start ? 8u : 1u);
    uint64_t end = start;
    int nextBit = 0;
    bool isPacked = false;
    for (const Field& field : t.fields) {
        if (!field.isLocated) continue;
        isPacked = true;
        end = std::max<uint64_t>(end, uint64_t(field.offset) + (field.bit >= 0 ? 1 : (*this)[field.type].size));
        if (!isUnion) offset = end;
    }
    for (Field& field : t.fields) {
        const Type& type = (*this)[field.type];
        const bool slot = field.section == FieldSection::InOut && type.kind != TypeKind::OpenArray;
        const uint32_t size = slot ? 8 : type.size;
        const uint32_t align = slot ? 8 : isPacked ? 1 : std::max(1u, type.align);
        if (field.isLocated) continue;
        if (field.bit >= 0) { // BIT members share bytes in order
            if (nextBit == 0) offset += 1;
            field.offset = static_cast<uint32_t>(offset - 1);
            field.bit = static_cast<int16_t>(nextBit);
            nextBit = (nextBit + 1) % 8;
            end = std::max(end, offset);
            continue;
        }
        nextBit = 0;
        offset = isUnion ? start : aligned(offset, align);
        field.offset = static_cast<uint32_t>(offset);
        offset += size;
        end = std::max(end, offset);
        t.align = std::max(t.align, align);
    }
    const uint64_t needed = aligned(std::max<uint64_t>(end, 1), t.align);
    t.size = needed <= kMaximumSize ? static_cast<uint32_t>(needed) : 0;
    t.initial.clear();
    if (t.size == 0) {
        for (Field& field : t.fields) field.offset = 0;
        return;
    }
    const auto place = [&](const Field& field) {
        const Type& type = (*this)[field.type];
        if (field.section == FieldSection::InOut || field.bit >= 0 || type.initial.empty()) return;
        if (t.initial.empty()) t.initial.resize(t.size);
        std::memcpy(t.initial.data() + field.offset, type.initial.data(), type.size);
    };
    for (const Field& field : t.fields) {
        place(field);
        if (isUnion) break;
    }
}

std::pair<int64_t, uint64_t> TypeTable::integerRange(TypeKind kind) {
    const unsigned bits = bitsOf(kind);
    if (familyOf(kind) == Family::Signed || familyOf(kind) == Family::Duration) {
        const uint64_t high = bits == 64 ? static_cast<uint64_t>(INT64_MAX) : (uint64_t(1) << (bits - 1)) - 1;
        return {-static_cast<int64_t>(high) - 1, high};
    }
    return {0, bits == 64 ? UINT64_MAX : (uint64_t(1) << bits) - 1};
}

} // namespace plc::types
