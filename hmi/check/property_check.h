// What the properties of a panel's elements say that cannot be meant: names and types that elements.def does not know,
// colours, limits, groups, pictures, formats. The part of the panel check that needs no texts. Pure function over its
// input, main thread (pictures).
#pragma once
#include "hmi/check/panel_check.h"
#include "hmi/model/walk.h"

namespace plc::hmi {

/// A finding without file and language; `property` as the problem list shows it.
struct PropertyFinding {
    FindingKind kind{};
    bool isError = false;
    ElementId element;
    QString property;
    Message message;
    Edit fix = {};
};

std::vector<PropertyFinding> checkProperties(const CheckInput& input, const Panel& panel);

/// The type that a binding must have, which for some properties depends on what else the element says.
std::string_view wantedType(const Properties& element, const Found& binding);

} // namespace plc::hmi
