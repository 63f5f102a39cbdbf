// What makes an SVG file a danger to whoever draws it: shapes that multiply through references, endless nesting, dashes
// without number, other files. Found by reading it, before Qt gets it. Pure functions, any thread.
#pragma once
#include "hmi/model/errors.h"

#include <QByteArray>

namespace plc::hmi {

inline constexpr int kMostShapes = 100000, kDeepestShapes = 64, kMostDashes = 100000;

/// Nothing, or why the picture is not drawn. `name` is what the message calls it.
[[nodiscard]] Message svgComplaint(const QByteArray& svg, const QString& name);

} // namespace plc::hmi
