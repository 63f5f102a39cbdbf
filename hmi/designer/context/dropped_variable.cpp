#include "hmi/designer/context/dropped_variable.h"

#include "hmi/model/faceplate.h"
#include "hmi/model/property_literals.h"
#include "hmi/station/plc_convert.h"

#include <algorithm>

namespace plc::hmi {

QString structureType(const QString& path, const PanelVariables& variables) {
    const std::optional<TypedExpression> known = variables.typed(path);
    if (!known) return {};
    const types::TypeKind kind = known->types->kind(known->type);
    if (kind != types::TypeKind::Struct && kind != types::TypeKind::Block) return {};
    const QStringList names = typeNamesOf(*known);
    return names.isEmpty() ? QString() : names.front();
}

namespace {

/// "Opened" of "Plant.valve.Opened" and of "$valve.Opened"; "valve" of "$valve", as a name is no binding.
QString lastNameOf(const QString& path) {
    const QString name = path.section(u'.', -1);
    return name.startsWith(u'$') ? name.mid(1) : name;
}

Element madeFor(ElementKind kind, const char* property, const QString& path) {
    Element element = Element::make(kind, QString(), QRectF(QPointF(), descriptorOf(kind).size));
    element.set(property, toUtf8(path));
    return element;
}

/// A table of an array of structures: a column per member that is a single value.
Element tableFor(const QString& path, const types::TypeTable& types, const types::Type& array) {
    Element table = Element::make(ElementKind::ArrayTable, QString(),
                                  QRectF(QPointF(), descriptorOf(ElementKind::ArrayTable).size));
    Json columns = Json::array();
    for (const types::Field& field : types[array.element].fields) {
        if (types.isAggregate(field.type) || field.isPrivate || columns.size() >= 8) continue;
        Json column = Json::object();
        column["title"] = field.name;
        column["value"] = toUtf8(path) + "[#]." + field.name;
        if (types.family(field.type) == types::Family::Real) column["format"] = "%.2f";
        columns.push_back(std::move(column));
    }
    table.set("columns"_field, columns);
    return table;
}

std::optional<Element> arrayElementFor(const QString& path, const TypedExpression& known, const ValueFacts& facts) {
    if (facts.arrayBounds.empty()) return {};
    const types::TypeTable& types = *known.types;
    const types::Type& array = types[known.type];
    const auto [first, last] = facts.arrayBounds.front();
    if (types.kind(array.element) == types::TypeKind::Struct || types.kind(array.element) == types::TypeKind::Block) {
        Element table = tableFor(path, types, array);
        table.set("first"_field, first);
        table.set("count"_field, last - first + 1);
        return table;
    }
    if (types.family(array.element) == types::Family::Bool || facts.arrayBounds.size() > 1) {
        Element grid = madeFor(ElementKind::CellGrid, "value", path);
        const int count = last - first + 1;
        const bool isTable = facts.arrayBounds.size() > 1;
        const int columns = isTable ? facts.arrayBounds[1].second - facts.arrayBounds[1].first + 1
                                    : std::min(count, count <= 10 ? count : 10);
        grid.set("columns"_field, columns);
        grid.set("rows"_field, isTable ? count : (count + columns - 1) / columns);
        grid.set("first"_field, first);
        return grid;
    }
    Element chart = madeFor(ElementKind::BarChart, "value", path);
    chart.set("first"_field, first);
    return chart;
}

} // namespace

std::optional<Element> faceplateFor(const QString& path, const PanelVariables& variables, const QString& inPanel) {
    const std::optional<TypedExpression> known = variables.typed(path);
    if (!known) return {};
    const QStringList names = typeNamesOf(*known);
    const PanelProject& project = variables.context().project();
    for (const NamedPanel& one : project.panels) {
        if (one.name == inPanel || placesPanel(one.panel, inPanel, project.panelLookup())) continue;
        QString taker; // the one parameter that has to be given something
        int needed = 0;
        for (const Parameter& parameter : parametersOf(one.panel)) {
            if (!parameter.fallback.isEmpty() || parameter.isText()) continue;
            ++needed;
            if (names.contains(parameter.type, Qt::CaseInsensitive)) taker = parameter.name;
        }
        if (needed != 1 || taker.isEmpty()) continue;
        Element element = Element::make(ElementKind::Faceplate, QString(), QRectF(QPointF(), one.panel.size()));
        element.set("panel"_field, toUtf8(one.name));
        Json arguments = Json::object();
        arguments[toUtf8(taker)] = toUtf8(path);
        element.set("arguments"_field, std::move(arguments));
        element.set("name"_field, toUtf8(lastNameOf(path)));
        return element;
    }
    return {};
}

std::vector<Element> elementsForVariable(const QString& path, const PanelVariables& variables, bool operates) {
    const std::optional<TypedExpression> known = variables.typed(path);
    const ValueFacts facts = known ? factsOf(*known->types, known->type, known->isPlace) : ValueFacts();
    const QString name = lastNameOf(path);
    Element element = madeFor(ElementKind::NumericDisplay, "value", path);
    switch (facts.kind) {
    case ValueKind::Bool:
        element = operates ? madeFor(ElementKind::Switch, "target", path) : madeFor(ElementKind::Lamp, "value", path);
        break;
    case ValueKind::Integer:
    case ValueKind::Unsigned:
        if (!facts.enumValues.empty()) {
            element = operates ? madeFor(ElementKind::ComboBox, "target", path)
                               : madeFor(ElementKind::MultiState, "value", path);
            break;
        }
        element = operates ? madeFor(ElementKind::NumericEntry, "target", path) : element;
        element.set("format"_field, "%d");
        break;
    case ValueKind::Real:
        element = operates ? madeFor(ElementKind::NumericEntry, "target", path) : element;
        break;
    case ValueKind::Text:
        element = operates ? madeFor(ElementKind::TextEntry, "target", path) : element;
        if (!operates) element.set("rect"_field, rectToJson(QRectF(0, 0, 200, 40)));
        break;
    case ValueKind::Time:
        if (operates) {
            element = madeFor(ElementKind::NumericEntry, "target", path);
            element.set("unit"_field, "s");
        } else {
            element.set("format"_field, "");
        }
        break;
    case ValueKind::Date:
    case ValueKind::DateTime:
    case ValueKind::TimeOfDay:
        element = madeFor(ElementKind::DateTime, "value", path);
        break;
    case ValueKind::Array:
        if (auto array = arrayElementFor(path, *known, facts)) element = std::move(*array);
        break;
    case ValueKind::None:
        break;
    }
    element.set("name"_field, toUtf8(name));
    return {element};
}

} // namespace plc::hmi
