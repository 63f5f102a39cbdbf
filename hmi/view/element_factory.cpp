// elements.def names the kinds, so a kind without a view does not compile.
#include "hmi/view/element_factory.h"

#include "hmi/view/controls/analog_controls.h"
#include "hmi/view/controls/arrays.h"
#include "hmi/view/controls/buttons.h"
#include "hmi/view/controls/containers.h"
#include "hmi/view/controls/entries.h"
#include "hmi/view/controls/navigation_views.h"
#include "hmi/view/controls/selectors.h"
#include "hmi/view/controls/user_view.h"
#include "hmi/view/displays/basics.h"
#include "hmi/view/displays/charts.h"
#include "hmi/view/displays/displays.h"
#include "hmi/view/displays/meters.h"
#include "hmi/view/displays/shapes.h"
#include "hmi/view/lists/alarm_statistics_view.h"
#include "hmi/view/lists/alarm_views.h"
#include "hmi/view/lists/recipe_view.h"
#include "hmi/view/scene/faceplate_view.h"

namespace plc::hmi {

std::unique_ptr<ElementView> makeElementView(const Element& element, PanelScene& scene) {
    switch (element.kind()) {
    case ElementKind::Unknown:
        return std::make_unique<UnknownView>(element, scene);
#define HMI_ELEMENT(Kind, Key, Category, Title, Width, Height, Words)                                                  \
    case ElementKind::Kind:                                                                                            \
        return std::make_unique<Kind##View>(element, scene);
#include "hmi/model/elements.def"
    }
    return std::make_unique<UnknownView>(element, scene);
}

} // namespace plc::hmi
