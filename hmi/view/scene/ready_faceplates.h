// The faceplates that the studio brings along, for blocks of its libraries: "library/motor", "library/valve"… A project
// places them as they are or copies one to change it. Made once; any thread after that.
#pragma once
#include "hmi/model/faceplate.h"

namespace plc::hmi {

struct NamedPanel {
    QString name; // file name without ".panel.json"
    Panel panel;
};

/// By name.
const std::vector<NamedPanel>& readyFaceplates();
/// Finds among these panels, which must outlive the lookup, then among the ready ones.
PanelLookup lookupIn(const std::vector<NamedPanel>& panels);

} // namespace plc::hmi
