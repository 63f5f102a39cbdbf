// The titles of the examples in the language of the studio: what their project.json calls them, translated. GUI thread.
#pragma once
#include <QString>

namespace plc::app {

/// A title that is none of an example comes back as it is.
[[nodiscard]] QString exampleTitle(const QString& title);

} // namespace plc::app
