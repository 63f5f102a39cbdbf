// The name of a property where a view reads it. It is looked up in elements.def while the view is compiled: a name that
// no kind has, or one of another type than is read, does not compile. A value; any thread.
#pragma once
#include "hmi/model/descriptor.h"

namespace plc::hmi {

/// As what a property is read.
enum class PropertyUse { Any, Number, Flag, Text, Color };

constexpr bool allows(PropertyUse use, PropertyType type) {
    switch (use) {
    case PropertyUse::Any:
        return true;
    case PropertyUse::Number:
        return type == PropertyType::Number || type == PropertyType::Integer;
    case PropertyUse::Flag:
        return type == PropertyType::Bool;
    case PropertyUse::Color:
        return type == PropertyType::Color;
    case PropertyUse::Text:
        return type != PropertyType::Number && type != PropertyType::Integer && type != PropertyType::Bool;
    }
    return false;
}

/// elements.def gives the property of this name to a kind, to all of them, or to the panel.
consteval bool isProperty(std::string_view key, PropertyUse use) {
    struct Row {
        std::string_view key;
        PropertyType type;
    };
    constexpr Row rows[] = {
#define HMI_PROPERTY(Kind, Key, Type, Default, Group, Title, Hint) {Key, PropertyType::Type},
#include "hmi/model/elements.def"
    };
    for (const Row& row : rows)
        if (row.key == key && allows(use, row.type)) return true;
    return false;
}

template <PropertyUse Use> class PropertyKey {
public:
    consteval PropertyKey(const char* key) : m_key(key) { // NOLINT: a literal is a key
        if (!isProperty(m_key, Use)) throw "elements.def has no property of this name that can be read so";
    }
    constexpr operator std::string_view() const { return m_key; } // NOLINT: and is read as one

private:
    std::string_view m_key;
};

} // namespace plc::hmi
