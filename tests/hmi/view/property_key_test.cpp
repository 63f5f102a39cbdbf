// Names of properties are checked while the views are compiled; here the same questions are asked of elements.def.
#include "hmi/model/property_key.h"

#include <gtest/gtest.h>

namespace plc::hmi {
namespace {

TEST(PropertyKey, KnowsTheNamesOfTheList) {
    static_assert(isProperty("fontSize", PropertyUse::Number));
    static_assert(!isProperty("fontsize", PropertyUse::Any), "a misspelt name");
    static_assert(!isProperty("", PropertyUse::Any));
    constexpr PropertyKey<PropertyUse::Number> size = "fontSize";
    EXPECT_EQ(std::string_view(size), "fontSize");
}

TEST(PropertyKey, ReadsNothingAsWhatItIsNot) {
    static_assert(!isProperty("fontSize", PropertyUse::Flag));
    static_assert(!isProperty("bold", PropertyUse::Number));
    static_assert(isProperty("bold", PropertyUse::Flag));
    static_assert(isProperty("fill", PropertyUse::Color));
    static_assert(!isProperty("unit", PropertyUse::Color));
    for (const ElementDescriptor& kind : elementDescriptors())
        for (const PropertyDescriptor& property : kind.properties) {
            const int uses = allows(PropertyUse::Number, property.type) + allows(PropertyUse::Flag, property.type) +
                             allows(PropertyUse::Text, property.type);
            EXPECT_EQ(uses, 1) << property.key << " is read in one way";
        }
}

} // namespace
} // namespace plc::hmi
