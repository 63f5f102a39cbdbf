// What kinds of elements there are and which properties each has, read from elements.def. The file, the property
// sheet, undo, the checks and the palette go over these tables. Immutable, made once, any thread.
#pragma once
#include "hmi/model/json.h"

#include <QSize>
#include <string_view>
#include <vector>

namespace plc::hmi {

enum class ElementKind {
    Unknown,
#define HMI_ELEMENT(Kind, Key, Category, Title, Width, Height, Words) Kind,
#include "hmi/model/elements.def"
};

enum class ElementCategory { Shapes, Basics, Symbols, Controls, Displays, Charts, Alarms, Containers };

enum class PropertyType {
    Name,    // an id; not edited as a property
    Element, // the id of another element
    Rect,    // [x, y, width, height]
    Size,    // [width, height]
    Points,  // [[x, y], …] as fractions of the rectangle
    Bool,
    Integer,
    Number,
    Choice,
    Symbol,
    Color, // "#rrggbb" or the name of a role of the theme
    String,
    Text,     // shown to people: "@key" of the text table, else the text itself
    TextList, // the part before ".0", ".1"… of keys
    File,
    Panel,
    Expression, // ST, read
    Target,     // ST, a variable that is written
    Bindings,   // {"name": "expression"}
    Arguments,  // the same, by the parameters of the panel that the element places; texts as they are
    Records,    // list of objects, each as HMI_RECORD says
};

enum class PropertyGroup { Geometry, Look, Text, Value, Behaviour, Condition, Motion };

struct PropertyDescriptor {
    std::string_view key;
    PropertyType type;
    Json fallback;
    PropertyGroup group;
    const char* title; // for translation in the context "Hmi"
    std::string_view hint;
    /// range(), worked out once: numbers are read for every repaint.
    std::optional<std::pair<double, double>> limits = {};

    std::vector<std::string_view> choices() const;
    /// Smallest and largest value of a number "a..b"; none where the hint says nothing.
    std::optional<std::pair<double, double>> range() const;
    bool isOptional() const { return hint == "optional"; }
};

struct ElementDescriptor {
    ElementKind kind;
    std::string_view key;
    ElementCategory category;
    const char* title;
    QSize size;
    const char* words;
    /// The common ones first, in the order of the file.
    std::vector<PropertyDescriptor> properties;

    const PropertyDescriptor* property(std::string_view key) const;
    /// Place in the canonical order, or none for an unknown field.
    std::optional<size_t> rank(std::string_view key) const;
};

/// All kinds in the order of elements.def, without Unknown.
const std::vector<ElementDescriptor>& elementDescriptors();
/// The descriptor of an element kind; for an unknown one that with the common properties only.
const ElementDescriptor& descriptorOf(ElementKind kind);
const ElementDescriptor& panelDescriptor();
const ElementDescriptor& alarmDescriptor();
const ElementDescriptor& alarmClassDescriptor();
ElementKind kindOf(std::string_view key);
const std::vector<PropertyDescriptor>& recordFields(std::string_view record);
QString titleOf(ElementCategory category);
QString titleOf(PropertyGroup group);

} // namespace plc::hmi
