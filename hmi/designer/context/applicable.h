// Which properties say something at present: a button that writes has no language tag. And which of them a variable is
// bound to that is dropped on an element. Pure functions, any thread.
#pragma once
#include "hmi/model/panel.h"

namespace plc::hmi {

/// False for a property that has no effect with what else the element says.
[[nodiscard]] bool isApplicable(const Element& element, std::string_view property);
/// What an element is about, in the order in which a dropped variable is offered to it; empty for frames and texts.
[[nodiscard]] std::vector<const PropertyDescriptor*> mainBindings(const Element& element);

} // namespace plc::hmi
