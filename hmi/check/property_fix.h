// Corrections of single properties, for findings whose remedy needs no decision: a value or a name in its place, in the
// rows of a list, too. Pure functions; any thread.
#pragma once
#include "hmi/model/descriptor.h"
#include "hmi/model/edit.h"

namespace plc::hmi {

/// Gives the property at `place` ("max", "states[2].color") another value.
Edit valueAt(const Panel& panel, const ElementId& element, const QString& place, const Json& value);
/// Gives it another name; nothing if there is one of that name.
Edit nameAt(const Panel& panel, const ElementId& element, const QString& place, const std::string& name);
/// A value that was written as another type but can only mean one thing: "true", "12", 7 for a text.
std::optional<Json> asType(PropertyType type, const Json& value);
/// All in one edit. Those in rows of the same list are made into one new list.
Edit together(const Panel& panel, const std::vector<Edit>& fixes);

} // namespace plc::hmi
