// Values of a served controller for the language server: a thread of its own attaches, asks for what is wanted several
// times a second, and attaches again when the line is lost. Owned by the command; an application object must exist.
#pragma once
#include "editor/remote/remote_controller.h"
#include "projects/language_server/live_values.h"

#include <map>
#include <mutex>
#include <thread>

namespace plc::cli {

class LiveController final : public lsp::LiveValues {
public:
    explicit LiveController(editor::RemoteController::Address address);
    void want(std::vector<std::string> expressions) override;
    [[nodiscard]] std::optional<std::string> valueOf(const std::string& expression) const override;
    [[nodiscard]] uint64_t revision() const override;

private:
    void follow(const std::stop_token& stop);
    [[nodiscard]] std::vector<std::string> wanted() const;
    void know(std::map<std::string, std::string> values);
    const editor::RemoteController::Address m_address;
    mutable std::mutex m_mutex;
    std::vector<std::string> m_wanted;
    std::map<std::string, std::string> m_values;
    uint64_t m_revision = 0;
    std::jthread m_thread; // last: it uses the others
};

} // namespace plc::cli
