// Run ▸ Build a Native Program…: what `stepwise build` does, from the window, in a process of its own. GUI thread.
#pragma once
namespace plc::app {

class MainWindow;
void buildNativeProgram(MainWindow& window);

} // namespace plc::app
