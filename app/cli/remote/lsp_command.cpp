#include "app/cli/remote/commands.h"

#include "app/cli/kit/errors.h"
#include "app/cli/remote/attached.h"
#include "app/cli/remote/live_controller.h"
#include "projects/language_server/server.h"
#include "projects/protocol/connection.h"
#include "runtime/platform/streams.h"

namespace plc::cli {

namespace {

bool cancels(std::string_view message, const lsp::Json& id) {
    if (message.find("$/cancelRequest") == std::string_view::npos) return false;
    const auto incoming = protocol::readIncoming(message);
    const auto* note = std::get_if<protocol::Incoming>(&incoming);
    const lsp::Json* named = note && note->method == "$/cancelRequest" ? protocol::find(note->params, "id") : nullptr;
    return named && *named == id;
}

/// Of the controller that --attach names; none: it names none.
Result<std::shared_ptr<lsp::LiveValues>> liveValues(const Arguments& arguments) {
    const auto url = arguments.value("--attach");
    if (!url) return std::shared_ptr<lsp::LiveValues>();
    const auto file = arguments.value("--code");
    if (!file) return Error{errors::AttachNeedsCode(), {}};
    const auto code = Attached::readCode(*file);
    if (!code) return code.error();
    needApplication();
    return std::shared_ptr<lsp::LiveValues>(std::make_shared<LiveController>(editor::RemoteController::Address{
        .url = QUrl(QString::fromStdString(*url)),
        .code = *code,
        .trustFile = QString::fromStdString(arguments.value("--certificate").value_or("")),
        .name = QStringLiteral("language server")}));
}

int serveEditor(const Arguments& arguments) {
    platform::ignoreLostReaders();
    const auto values = liveValues(arguments);
    if (!values) return wrongUse(values.error());
    protocol::Connection connection(protocol::Framing::Heads, platform::kStandardInput, platform::kStandardOutput);
    lsp::Server server([&](const lsp::Json& message) { connection.send(protocol::toText(message)); },
                       {arguments.values("--library"), *values});
    server.isCancelled = [&](const lsp::Json& id) {
        return connection.isWaiting([&](std::string_view message) { return cancels(message, id); });
    };
    using std::chrono::milliseconds;
    const auto idle = *values ? std::optional(milliseconds(250)) : std::nullopt;
    while (!server.isOver()) {
        const auto message = connection.next(server.hasWork() ? std::optional(milliseconds(0)) : idle);
        if (message)
            server.receive(*message);
        else if (!connection.isOpen())
            return kProgramWrong; // the editor is gone without a good-bye
        else
            server.work();
        server.refreshHints();
    }
    return server.exitCode();
}

} // namespace

Command lspCommand() {
    return {{"lsp",
             "[OPTIONS]",
             "Serves an editor with the Language Server Protocol on standard input and output.",
             {{"--library", "NAME",
               "a library for files outside projects, in addition to the standard library (repeatable)"},
              {"--attach", "URL", "values of this running controller (stepwise serve) as hints beside the lines"},
              {"--code", "FILE", "of --attach: the file attach-code of the controller's state folder"},
              {"--certificate", "FILE",
               "of --attach: a certificate (PEM) that is trusted in addition to those of the system"},
              {"--stdio", "", "as some editors want it said; there is no other way"}},
             "stepwise lsp"},
            serveEditor};
}

} // namespace plc::cli
