// What a picture's view shows for an expression: its value after the last scan. For the programs that make pictures;
// the thread of the window.
#pragma once
#include "editor/graph/graph_view.h"
#include "projects/session/session.h"

#include <QString>

#include <string>

namespace plc::pictures {

/// Empty when the expression has no value as seen from `instance`.
[[nodiscard]] editor::GraphValue onlineValue(session::Session& session, const QString& expression,
                                             const std::string& instance);

} // namespace plc::pictures
