#include "hmi/model/descriptor.h"

#include <QCoreApplication>
#include <cstdlib>
#include <map>

namespace plc::hmi {

std::vector<std::string_view> PropertyDescriptor::choices() const {
    std::vector<std::string_view> out;
    for (size_t from = 0; from <= hint.size();) {
        const size_t bar = std::min(hint.find('|', from), hint.size());
        out.push_back(hint.substr(from, bar - from));
        from = bar + 1;
    }
    return out;
}

std::optional<std::pair<double, double>> PropertyDescriptor::range() const {
    const size_t dots = hint.find("..");
    if (dots == std::string_view::npos || (type != PropertyType::Number && type != PropertyType::Integer)) return {};
    return std::pair{std::atof(std::string(hint.substr(0, dots)).c_str()),
                     std::atof(std::string(hint.substr(dots + 2)).c_str())};
}

const PropertyDescriptor* ElementDescriptor::property(std::string_view name) const {
    for (const PropertyDescriptor& one : properties)
        if (one.key == name) return &one;
    return nullptr;
}

std::optional<size_t> ElementDescriptor::rank(std::string_view name) const {
    for (size_t i = 0; i < properties.size(); ++i)
        if (properties[i].key == name) return i;
    return {};
}

namespace {

struct Tables {
    std::vector<ElementDescriptor> elements;
    ElementDescriptor unknown{ElementKind::Unknown,
                              "",
                              ElementCategory::Basics,
                              QT_TRANSLATE_NOOP("Hmi", "Unknown element"),
                              {100, 60},
                              "",
                              {}};
    ElementDescriptor panel{
        ElementKind::Unknown, "panel", ElementCategory::Basics, QT_TRANSLATE_NOOP("Hmi", "Panel"), {1024, 600}, "", {}};
    ElementDescriptor alarm{
        ElementKind::Unknown, "alarm", ElementCategory::Alarms, QT_TRANSLATE_NOOP("Hmi", "Alarm"), {0, 0}, "", {}};
    ElementDescriptor alarmClass{ElementKind::Unknown,
                                 "class",
                                 ElementCategory::Alarms,
                                 QT_TRANSLATE_NOOP("Hmi", "Alarm class"),
                                 {0, 0},
                                 "",
                                 {}};
    std::map<std::string_view, std::vector<PropertyDescriptor>> records;
};

// One row of elements.def: the kind's name is text here, so that Common and Panel stand in the same list.
struct PropertyRow {
    std::string_view kind;
    PropertyDescriptor property;
};

std::vector<PropertyRow> propertyRows() {
    return {
#define HMI_PROPERTY(Kind, Key, Type, Default, Group, Title, Hint)                                                     \
    {#Kind, {Key, PropertyType::Type, Json::parse(Default), PropertyGroup::Group, Title, Hint}},
#include "hmi/model/elements.def"
    };
}

Tables makeTables() {
    Tables tables;
    const std::pair<std::string_view, ElementDescriptor> kinds[] = {
#define HMI_ELEMENT(Kind, Key, Category, Title, Width, Height, Words)                                                  \
    {#Kind, {ElementKind::Kind, Key, ElementCategory::Category, Title, {Width, Height}, Words, {}}},
#include "hmi/model/elements.def"
    };
    std::vector<PropertyRow> rows = propertyRows();
    for (PropertyRow& row : rows) row.property.limits = row.property.range();
    for (const PropertyRow& row : rows) {
        if (row.kind == "Panel") tables.panel.properties.push_back(row.property);
        if (row.kind == "Alarm") tables.alarm.properties.push_back(row.property);
        if (row.kind == "AlarmClass") tables.alarmClass.properties.push_back(row.property);
        if (row.kind == "Common") tables.unknown.properties.push_back(row.property);
    }
    for (const auto& [name, descriptor] : kinds) {
        ElementDescriptor element = descriptor;
        element.properties = tables.unknown.properties;
        for (const PropertyRow& row : rows)
            if (row.kind == name) element.properties.push_back(row.property);
        tables.elements.push_back(std::move(element));
    }
    const std::pair<std::string_view, PropertyDescriptor> fields[] = {
#define HMI_RECORD(Record, Key, Type, Default, Title, Hint)                                                            \
    {Record, {Key, PropertyType::Type, Json::parse(Default), PropertyGroup::Value, Title, Hint}},
#include "hmi/model/elements.def"
    };
    for (const auto& [record, field] : fields) {
        tables.records[record].push_back(field);
        tables.records[record].back().limits = field.range();
    }
    return tables;
}

const Tables& tables() {
    static const Tables all = makeTables();
    return all;
}

} // namespace

const std::vector<ElementDescriptor>& elementDescriptors() { return tables().elements; }

const ElementDescriptor& descriptorOf(ElementKind kind) {
    if (kind == ElementKind::Unknown) return tables().unknown;
    return tables().elements[static_cast<size_t>(kind) - 1];
}

const ElementDescriptor& panelDescriptor() { return tables().panel; }
const ElementDescriptor& alarmDescriptor() { return tables().alarm; }
const ElementDescriptor& alarmClassDescriptor() { return tables().alarmClass; }

ElementKind kindOf(std::string_view key) {
    for (const ElementDescriptor& one : tables().elements)
        if (one.key == key) return one.kind;
    return ElementKind::Unknown;
}

const std::vector<PropertyDescriptor>& recordFields(std::string_view record) {
    static const std::vector<PropertyDescriptor> none;
    const auto found = tables().records.find(record);
    return found == tables().records.end() ? none : found->second;
}

QString titleOf(ElementCategory category) {
    switch (category) {
    case ElementCategory::Shapes:
        return QCoreApplication::translate("Hmi", "Shapes");
    case ElementCategory::Basics:
        return QCoreApplication::translate("Hmi", "Text and pictures");
    case ElementCategory::Symbols:
        return QCoreApplication::translate("Hmi", "Symbols");
    case ElementCategory::Controls:
        return QCoreApplication::translate("Hmi", "Operation");
    case ElementCategory::Displays:
        return QCoreApplication::translate("Hmi", "Display");
    case ElementCategory::Charts:
        return QCoreApplication::translate("Hmi", "Arrays and charts");
    case ElementCategory::Alarms:
        return QCoreApplication::translate("Hmi", "Alarms");
    case ElementCategory::Containers:
        return QCoreApplication::translate("Hmi", "Containers");
    }
    return {};
}

QString titleOf(PropertyGroup group) {
    switch (group) {
    case PropertyGroup::Geometry:
        return QCoreApplication::translate("Hmi", "Geometry");
    case PropertyGroup::Look:
        return QCoreApplication::translate("Hmi", "Appearance");
    case PropertyGroup::Text:
        return QCoreApplication::translate("Hmi", "Text");
    case PropertyGroup::Value:
        return QCoreApplication::translate("Hmi", "Value");
    case PropertyGroup::Behaviour:
        return QCoreApplication::translate("Hmi", "Behaviour");
    case PropertyGroup::Condition:
        return QCoreApplication::translate("Hmi", "Condition");
    case PropertyGroup::Motion:
        return QCoreApplication::translate("Hmi", "Motion");
    }
    return {};
}

} // namespace plc::hmi
