// A controller that runs in real time inside the server, for an assistant to watch. Writing to it needs the leave of
// the person who started the server. Owned by the server; its thread, the scan thread is the session's own.
#pragma once
#include "app/mcp/tools.h"
#include "projects/session/session.h"

#include <memory>

namespace plc::mcp {

struct LiveTool {
    std::string_view name, description;
    std::vector<Field> fields;
    bool writes = false;
};
[[nodiscard]] const std::vector<LiveTool>& liveTools();

class Live {
public:
    explicit Live(bool allowsWrites) : m_allowsWrites(allowsWrites) {}
    /// The text for the assistant; arguments were checked.
    [[nodiscard]] Result<std::string> call(std::string_view tool, const Json& arguments);

private:
    [[nodiscard]] Result<std::string> start(const Json& arguments);
    [[nodiscard]] Result<std::string> values(const Json& arguments);
    [[nodiscard]] Result<std::string> write(const Json& arguments, bool isForce);
    [[nodiscard]] Result<std::string> stop();
    bool m_allowsWrites;
    std::string m_name;
    std::unique_ptr<session::Session> m_session;
};

} // namespace plc::mcp
