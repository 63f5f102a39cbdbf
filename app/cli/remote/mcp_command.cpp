#include "app/cli/remote/commands.h"

#include "app/mcp/server.h"
#include "projects/protocol/connection.h"
#include "runtime/platform/processes.h"
#include "runtime/platform/streams.h"

namespace plc::cli {

namespace {

int serveAssistant(const Arguments& arguments) {
    platform::ignoreLostReaders();
    mcp::ServerSettings settings;
    settings.program = platform::ownProgram();
    settings.allowsWrites = arguments.has("--allow-writes");
    if (const auto text = arguments.value("--timeout")) {
        const auto time = parseDuration(*text);
        if (!time) return wrongUse(time.error());
        settings.limits.time = std::chrono::duration_cast<std::chrono::milliseconds>(*time);
    }
    protocol::Connection connection(protocol::Framing::Lines, platform::kStandardInput, platform::kStandardOutput);
    mcp::Server server([&](const mcp::Json& message) { connection.send(protocol::toText(message)); }, settings);
    for (;;) {
        const auto message = connection.next(std::nullopt);
        if (message)
            server.receive(*message);
        else if (!connection.isOpen())
            return kGood;
    }
}

} // namespace

Command mcpCommand() {
    return {
        {"mcp",
         "[OPTIONS]",
         "Serves an AI assistant with the Model Context Protocol on standard input and output; it reads and simulates.",
         {{"--allow-writes", "", "the assistant may write to the controller that it started with live_start"},
          {"--timeout", "2m", "the maximum duration of a call (default 2m)"}},
         "stepwise mcp"},
        serveAssistant};
}

} // namespace plc::cli
