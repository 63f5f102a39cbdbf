// What the start page writes on the cards of the examples, in the language of the studio: the title as in their
// project.json, and one sentence about each. GUI thread.
#pragma once
#include <QString>

namespace plc::app {

/// A title that is none of an example comes back as it is.
[[nodiscard]] QString exampleTitle(const QString& title);
/// What the example of this title shows; empty for a project that is none of them.
[[nodiscard]] QString exampleSummary(const QString& title);

} // namespace plc::app
