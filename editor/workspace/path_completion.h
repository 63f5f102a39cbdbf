// Completion of a variable's path or an expression outside the program's text: watch, trace, time slider, panels. GUI
// thread; the workspace must outlive the source.
#pragma once
#include "editor/kit/inputs/expression_edit.h"

namespace plc::editor {

class Workspace;

[[nodiscard]] kit::CompletionSource pathCompletions(const Workspace& workspace);

} // namespace plc::editor
