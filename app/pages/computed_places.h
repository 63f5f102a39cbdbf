// What a scan computed in one file, by place in the text as the editor has it: the controller may run an older one,
// of which the lines that were not edited still hold. A graph view's source of exact values. GUI thread.
#pragma once
#include "editor/debug/computed_scan.h"
#include "editor/graph/graph_view.h"

#include <functional>

namespace plc::app {

/// `text` and `instance` as they are when it is asked.
[[nodiscard]] editor::ComputedSource computedPlaces(editor::ComputedScan& scan, const QString& file,
                                                    std::function<std::string()> text,
                                                    std::function<QString()> instance);

} // namespace plc::app
