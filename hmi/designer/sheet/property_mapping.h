// Between the properties of panels and the studio's property grid: descriptors and values, both ways. Also used for the
// rows of records. Pure functions over the context; main thread.
#pragma once
#include "editor/kit/inputs/property_grid.h"
#include "hmi/designer/context/design_context.h"

namespace plc::hmi {

/// The grid's rows for a property: rectangles and sizes have several, names none.
/// In a panel with parameters, numbers may be given as "$limit". Colours are shown as in the panel's `theme`.
std::vector<kit::PropertyDescriptor> gridRows(const PropertyDescriptor& property, const DesignContext& context,
                                              const std::string& prefix = {}, bool hasParameters = false,
                                              const QString& theme = {});
/// A row for each parameter of the panel that the element places ("arguments.valve").
std::vector<kit::PropertyDescriptor> argumentRows(const PropertyDescriptor& property, const Element& element,
                                                  const DesignContext& context);
/// The parameter of a row of the element's arguments; none for other rows.
std::optional<Parameter> parameterOf(const Element& element, const QString& gridId, const DesignContext& context);
/// The value as the grid shows it; `id` is that of a grid row ("rect.x").
QVariant gridValue(const PropertyDescriptor& property, const Json& value, const QString& id,
                   const DesignContext& context);
/// The property's new value after a row was edited. Texts come back as typed: the caller gives them their key.
Json fromGrid(const PropertyDescriptor& property, const Json& present, const QString& id, const QVariant& edited);
/// "rect.x" → "rect".
std::string propertyOf(const QString& gridId);
/// A sentence for "2 entries", "none".
QString summaryOf(const PropertyDescriptor& property, const Json& value);
/// What the property is for, as a tool tip: type of a binding, limits.
QString toolTipOf(const PropertyDescriptor& property);

} // namespace plc::hmi
