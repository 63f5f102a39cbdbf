// The part of the panel check that concerns faceplates: arguments of placed ones, and bindings to parameters, each
// tried with what a placement gives or with a variable of the parameter's type. Functions; any thread.
#pragma once
#include "hmi/check/panel_check.h"

namespace plc::hmi {

/// The faceplates placed in a panel: the panel they name, the arguments they give.
std::vector<Finding> checkPlacements(const CheckInput& input, const NamedPanel& panel);
/// The bindings of a panel with parameters.
std::vector<Finding> checkParameterBindings(const CheckInput& input, const NamedPanel& panel);
/// What a panel with parameters gets wherever the project places it; for a look at it by itself, the first of them.
std::vector<Arguments> argumentsGiven(const CheckInput& input, const QString& faceplate);
/// The text at `property` of a view within a faceplate is made of a parameter, so that it differs by placement.
bool dependsOnArguments(const PanelScene& scene, const ElementView& view, const QString& property);

} // namespace plc::hmi
