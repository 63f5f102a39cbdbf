// A connection to a served controller for the command line: each question waits for its answer. Owned by the command,
// belongs to the thread that made it; an application object must exist.
#pragma once
#include "editor/remote/remote_controller.h"

#include <chrono>

namespace plc::cli {

class Attached {
public:
    [[nodiscard]] Result<void> attach(editor::RemoteController::Address address);
    [[nodiscard]] Result<remote::Json> ask(remote::Json request);
    /// The whole recording that the controller has in memory, as a file would hold it.
    [[nodiscard]] Result<QByteArray> fetchRecording();
    /// The code of the file that `--code` names.
    [[nodiscard]] static Result<QString> readCode(const std::string& path);
    /// Turns the event loop meanwhile; ends early by Ctrl+C.
    void wait(std::chrono::nanoseconds time);

private:
    editor::RemoteController m_controller;
};

} // namespace plc::cli
