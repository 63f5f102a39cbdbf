// What a variable, or a parameter of the panel, becomes that is dropped on it. Functions, GUI thread.
#pragma once
#include "hmi/designer/context/panel_variables.h"

#include <optional>

namespace plc::hmi {

/// The name of its type; empty for what has a single value, arrays and what is not known.
QString structureType(const QString& path, const PanelVariables& variables);
/// A faceplate of the project that needs nothing but this variable (and texts) and can stand in that panel, or none.
std::optional<Element> faceplateFor(const QString& path, const PanelVariables& variables, const QString& inPanel);
/// The element that fits a variable; `operates`: one that writes it, else one that shows it. The rectangle begins at
/// (0, 0).
std::vector<Element> elementsForVariable(const QString& path, const PanelVariables& variables, bool operates);

} // namespace plc::hmi
