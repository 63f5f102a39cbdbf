// A property's name in code that reads or writes it by hand: "padding"_number. It is looked up in elements.def while
// the code is compiled; a name that no kind has, or one of another type than is read, does not compile. Any thread.
#pragma once
#include "hmi/model/property_key.h"

namespace plc::hmi {

template <PropertyUse Use> consteval std::string_view checkedKey(const char* key, size_t length) {
    const std::string_view name(key, length);
    if (!isProperty(name, Use)) throw "elements.def has no property of this name that can be read so";
    return name;
}

consteval std::string_view operator""_text(const char* key, size_t length) {
    return checkedKey<PropertyUse::Text>(key, length);
}
consteval std::string_view operator""_number(const char* key, size_t length) {
    return checkedKey<PropertyUse::Number>(key, length);
}
consteval std::string_view operator""_flag(const char* key, size_t length) {
    return checkedKey<PropertyUse::Flag>(key, length);
}
/// Of a list or an object, or where its type does not matter.
consteval std::string_view operator""_field(const char* key, size_t length) {
    return checkedKey<PropertyUse::Any>(key, length);
}

} // namespace plc::hmi
