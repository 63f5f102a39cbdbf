#include "app/cli/command.h"

#include "projects/language_server/server.h"
#include "projects/protocol/connection.h"

#include <csignal>
#include <unistd.h>

namespace plc::cli {

namespace {

bool cancels(std::string_view message, const lsp::Json& id) {
    if (message.find("$/cancelRequest") == std::string_view::npos) return false;
    const auto incoming = protocol::readIncoming(message);
    const auto* note = std::get_if<protocol::Incoming>(&incoming);
    const lsp::Json* named = note && note->method == "$/cancelRequest" ? protocol::find(note->params, "id") : nullptr;
    return named && *named == id;
}

int serveEditor(const Arguments& arguments) {
    std::signal(SIGPIPE, SIG_IGN);
    protocol::Connection connection(protocol::Framing::Heads, STDIN_FILENO, STDOUT_FILENO);
    lsp::Server server([&](const lsp::Json& message) { connection.send(protocol::toText(message)); },
                       {arguments.values("--library")});
    server.isCancelled = [&](const lsp::Json& id) {
        return connection.isWaiting([&](std::string_view message) { return cancels(message, id); });
    };
    using std::chrono::milliseconds;
    while (!server.isOver()) {
        const auto message = connection.next(server.hasWork() ? std::optional(milliseconds(0)) : std::nullopt);
        if (message)
            server.receive(*message);
        else if (!connection.isOpen())
            return kProgramWrong; // the editor is gone without a good-bye
        else
            server.work();
    }
    return server.exitCode();
}

} // namespace

Command lspCommand() {
    return {{"lsp",
             "[OPTIONS]",
             "Serves an editor by the Language Server Protocol on standard input and output.",
             {{"--library", "NAME", "a library that files outside of projects use, besides the standard (repeatable)"},
              {"--stdio", "", "as some editors want it said; there is no other way"}},
             "stepwise lsp"},
            serveEditor};
}

} // namespace plc::cli
