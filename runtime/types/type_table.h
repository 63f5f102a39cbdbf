// All types of one program, by id. Elementary types have fixed ids (their TypeKind); arrays, strings, pointers are
// shared by structure. Owned by the compiled program; built by one thread, then read by any.
#pragma once
#include "runtime/types/string_code.h"
#include "runtime/types/type.h"

#include <deque>
#include <functional>
#include <map>
#include <optional>

namespace plc::types {

class TypeTable {
public:
    TypeTable();
    [[nodiscard]] const Type& operator[](TypeId id) const {
        return m_types[id.isValid() ? id.index() : static_cast<size_t>(TypeKind::Unknown)];
    }
    [[nodiscard]] Type& edit(TypeId id) { return m_types[id.index()]; } // while building
    [[nodiscard]] size_t count() const { return m_types.size(); }

    [[nodiscard]] static TypeId of(TypeKind elementary) {
        return TypeId(static_cast<uint32_t>(elementary));
    } // also Null, Void, Unknown
    TypeId string(uint32_t capacity);
    TypeId wstring(uint32_t capacity);
    TypeId array(std::vector<Dimension> dimensions, TypeId element);
    TypeId openArray(size_t rank, TypeId element);
    TypeId pointer(TypeId target);
    TypeId reference(TypeId target);
    TypeId subrange(TypeId base, int64_t low, int64_t high);
    /// A new type with its own identity (enum, struct, union, block, interface); fill it through edit().
    TypeId declare(TypeKind kind, std::string name);

    /// The type that stores it: enum and subrange → their base, else itself.
    [[nodiscard]] TypeId storage(TypeId id) const;
    [[nodiscard]] TypeKind kind(TypeId id) const { return (*this)[id].kind; }
    [[nodiscard]] TypeKind storageKind(TypeId id) const { return (*this)[storage(id)].kind; }
    [[nodiscard]] Family family(TypeId id) const { return familyOf(storageKind(id)); }
    [[nodiscard]] bool isAggregate(TypeId id) const;                  // array, struct, union, block
    [[nodiscard]] bool isText(TypeId id) const;                       // STRING, WSTRING
    [[nodiscard]] bool isDerivedFrom(TypeId type, TypeId base) const; // EXTENDS/IMPLEMENTS chain, itself included
    [[nodiscard]] bool implements(TypeId block, TypeId interface) const;
    /// Lays a struct's fields out from `start` by natural alignment, sets size and align, and composes `initial`. One
    /// with a located field is packed: the located stay where they are, the others follow behind the last of them.
    void layoutFields(TypeId id, uint32_t start = 0);
    /// Recomputes size, align and initial of an array after its element was completed.
    void layoutArray(TypeId id);
    /// "MIN..MAX" of an integer kind.
    [[nodiscard]] static std::pair<int64_t, uint64_t> integerRange(TypeKind kind);

    /// What the bytes of a STRING are; set before others read the table.
    StringCode strings = StringCode::Latin1;
    /// How a pointer, reference or interface that is not null is shown: the path of what it points to, "" when it has
    /// none. Set once, when the program stands, before others read the table.
    std::function<std::string(TypeId type, int64_t offset)> referenceText;

private:
    TypeId add(Type type);
    TypeId shared(const std::string& key, Type type);
    std::deque<Type> m_types;
    std::map<std::string, TypeId> m_shared;
};

} // namespace plc::types
