// What a block or structure becomes that is dropped on a panel: it has no single value to show. Functions, GUI thread.
#pragma once
#include "hmi/designer/context/design_context.h"

#include <optional>

namespace plc::hmi {

/// The name of its type; empty for what has a single value, arrays and what is not known.
QString structureType(const QString& path, const DesignContext& context);
/// A faceplate of the project that needs nothing but this variable (and texts), or none.
std::optional<Element> faceplateFor(const QString& path, const DesignContext& context);

} // namespace plc::hmi
