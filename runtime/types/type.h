// IEC types as the whole system sees them: size, layout, members. Owned by a TypeTable; immutable once the table is
// finished, so any thread may read. A value of any type is plain bytes in the image (D1).
#pragma once
#include "runtime/base/ids.h"
#include "runtime/base/source.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace plc::types {

using TypeId = Id<struct TypeTag>;

enum class TypeKind : uint8_t {
#define PLC_ELEMENTARY(Name, Spelling, Bytes, Family) Name,
#include "runtime/types/elementary.def"
    String,    // capacity + 1 bytes, zero-terminated; what they are says the table
    Wstring,   // capacity + 1 UTF-16 words, zero-terminated
    Enum,      // stored as `element` (INT unless a base type is named)
    Subrange,  // stored as `element`, values low..high
    Array,     // dimensions, elements row by row
    OpenArray, // ARRAY[*]: only as IN_OUT; handed over as a reference with its bounds
    Struct,
    Union,
    Block,     // instance of a FUNCTION_BLOCK, PROGRAM or (for its frame) METHOD owner
    Interface, // offset of a block instance, 0 = null; 8 bytes
    Pointer,   // POINTER TO / REF_TO: offset into the image, 0 = null; 8 bytes
    Reference, // REFERENCE TO: as Pointer, dereferenced by itself
    Null,      // the type of NULL
    Void,      // no result
    Unknown,   // after an error; converts to and from everything in silence
};

enum class Family : uint8_t {
    Bool,
    Bits,
    Signed,
    Unsigned,
    Real,
    Duration,
    Date,
    TimeOfDay,
    DateTime,
    Character,
    Other
};

enum class FieldSection : uint8_t { Member, Input, Output, InOut, Local, Static, External, Step };

struct Field {
    std::string name;
    TypeId type;
    uint32_t offset = 0; // from the begin of the structure or instance; InOut: of the 8-byte offset it holds
    FieldSection section = FieldSection::Member;
    bool retain = false;
    bool persistent = false;
    bool constant = false;
    bool isPrivate = false;           // {attribute 'hide'} or compiler-made: not listed in watches
    std::vector<std::string> aliases; // {attribute 'alias' := 'a, b'}
    SourceRange declaration;
    std::string comment;    // the comment behind or above the declaration
    int16_t bit = -1;       // BIT member of a structure: bit 0..7 of the byte at offset
    bool isLocated = false; // has an address in its structure: offset and bit are given
};

struct Enumerator {
    std::string name;
    int64_t value = 0;
    SourceRange declaration;
    std::string comment;
};

struct Dimension {
    int64_t low = 0;
    int64_t high = -1;
    [[nodiscard]] uint64_t count() const { return high < low ? 0 : static_cast<uint64_t>(high - low) + 1; }
};

struct Type {
    TypeKind kind = TypeKind::Unknown;
    std::string name;  // as declared or spelled: "INT", "STRING(20)", "ARRAY[1..3] OF INT", "Motor"
    std::string space; // namespace of a declared type, "" = none
    uint32_t size = 0; // bytes
    uint32_t align = 1;
    TypeId element;                      // Array/OpenArray element, Pointer/Reference target, Enum/Subrange base
    int64_t low = 0, high = 0;           // Subrange
    uint32_t capacity = 0;               // String, Wstring: characters
    std::vector<Dimension> dimensions;   // Array; OpenArray: count only
    std::vector<Field> fields;           // Struct, Union, Block (base's fields first)
    std::vector<Enumerator> enumerators; // Enum
    bool qualifiedOnly = false;          // Enum: values need the type's name
    bool isStrict = false;               // Enum: no numbers, no calculation
    TypeId base;                         // EXTENDS of Struct, Block, Interface
    std::vector<TypeId> interfaces;      // IMPLEMENTS of Block; EXTENDS of Interface
    uint32_t blockNumber = 0; // Block with methods: the word at offset 0 of each instance holds it (≥ 1); 0 = none
    std::vector<std::byte> initial; // a fresh value, `size` bytes; empty = all zero
    SourceRange declaration;
    std::string comment; // doc comment above the declaration

    [[nodiscard]] const Field* findField(std::string_view fieldName) const; // without case; aliases count
};

[[nodiscard]] Family familyOf(TypeKind kind);
[[nodiscard]] constexpr bool isElementary(TypeKind kind) { return kind <= TypeKind::Wchar; }
[[nodiscard]] std::string_view spelling(TypeKind kind); // of an elementary type; "" else
[[nodiscard]] inline bool isInteger(Family f) {
    return f == Family::Signed || f == Family::Unsigned || f == Family::Bits;
}
/// The number of value bits (1 for BOOL).
[[nodiscard]] unsigned bitsOf(TypeKind kind);

} // namespace plc::types
