// Run ▸ Build a Native Program…: what `stepwise build` does, from the window, in a process of its own. GUI thread.
#pragma once
#include <QString>

#include <functional>

class QWidget;

namespace plc::app {

/// Asks for machine and file and builds the project in `folder`, which `save` has written first; what there is to say
/// afterwards, "" when nothing was built.
[[nodiscard]] QString buildNativeProgram(QWidget* window, const QString& folder, const std::function<void()>& save);

} // namespace plc::app
