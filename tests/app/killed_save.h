// The process that the test of killed saves ends: main() runs it instead of the tests when STEPWISE_SAVE_FOLDER is set.
#pragma once
#include <QString>

namespace plc::app {

/// Saves each kind of file of a project in `folder` in two forms in turn, until it is killed; "ready" on the standard
/// output when both forms of each lie in `folder`/expected. Returns 1 when a file cannot be saved.
int saveWithoutEnd(const QString& folder);

} // namespace plc::app
