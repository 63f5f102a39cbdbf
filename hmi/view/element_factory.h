// Makes the view of an element by its kind: what a scene is given so that it shows panels. A function; main thread.
#pragma once
#include "hmi/view/scene/element_view.h"

namespace plc::hmi {

/// An unknown kind gets a placeholder.
std::unique_ptr<ElementView> makeElementView(const Element& element, PanelScene& scene);

} // namespace plc::hmi
