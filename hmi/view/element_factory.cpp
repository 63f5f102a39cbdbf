// Makes views by kind. elements.def names the kinds, so a kind without a view does not compile.
#include "hmi/view/alarm_statistics_view.h"
#include "hmi/view/alarm_views.h"
#include "hmi/view/analog_controls.h"
#include "hmi/view/arrays.h"
#include "hmi/view/basics.h"
#include "hmi/view/buttons.h"
#include "hmi/view/charts.h"
#include "hmi/view/containers.h"
#include "hmi/view/displays.h"
#include "hmi/view/entries.h"
#include "hmi/view/faceplate_view.h"
#include "hmi/view/meters.h"
#include "hmi/view/navigation_views.h"
#include "hmi/view/recipe_view.h"
#include "hmi/view/selectors.h"
#include "hmi/view/shapes.h"
#include "hmi/view/user_view.h"

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
