// The Model Context Protocol: an assistant calls what the command line can do. Reads and simulates; only a controller
// that runs inside the server can be written to, and only with the person's leave. It knows no pipe. One thread.
#pragma once
#include "app/mcp/live.h"
#include "app/mcp/program_run.h"

#include <functional>

namespace plc::mcp {

struct ServerSettings {
    std::string program; // this program's path
    bool allowsWrites = false;
    RunLimits limits;
};

class Server {
public:
    using Send = std::function<void(const Json& message)>;
    Server(Send send, ServerSettings settings);
    void receive(const Result<std::string>& message);

private:
    [[nodiscard]] protocol::Answer answer(const protocol::Incoming& request);
    [[nodiscard]] protocol::Answer initialize(const Json& parameters) const;
    [[nodiscard]] Json list() const;
    [[nodiscard]] protocol::Answer call(const Json& parameters);
    [[nodiscard]] Json run(const Tool& tool, const Json& arguments) const;
    Send m_send;
    ServerSettings m_settings;
    Live m_live;
};

/// Entries of the libraries' reference that speak of all the words: heading and text.
[[nodiscard]] std::string lookUp(const std::string& words);

} // namespace plc::mcp
