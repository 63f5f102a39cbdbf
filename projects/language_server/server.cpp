#include "projects/language_server/server.h"

#include "projects/protocol/errors.h"

namespace plc::lsp {

using protocol::ErrorCode;
using protocol::Incoming;

Server::Server(Send send, Settings settings) : m_send(std::move(send)), m_settings(std::move(settings)) {}
Server::~Server() = default;

Server::Method Server::methodOf(std::string_view name) {
    static const std::map<std::string_view, Method> methods = {
        {"shutdown", &Server::shutdown},
        {"textDocument/hover", &Server::hover},
        {"textDocument/definition", &Server::definition},
        {"textDocument/declaration", &Server::definition},
        {"textDocument/references", &Server::references},
        {"textDocument/documentHighlight", &Server::highlights},
        {"textDocument/prepareRename", &Server::prepareRename},
        {"textDocument/rename", &Server::rename},
        {"textDocument/completion", &Server::completion},
        {"completionItem/resolve", &Server::resolveCompletion},
        {"textDocument/signatureHelp", &Server::signatureHelp},
        {"textDocument/formatting", &Server::formatting},
        {"textDocument/rangeFormatting", &Server::formatting},
        {"textDocument/codeAction", &Server::codeActions},
        {"textDocument/documentSymbol", &Server::documentSymbols},
        {"workspace/symbol", &Server::workspaceSymbols},
        {"textDocument/foldingRange", &Server::foldingRanges},
        {"textDocument/semanticTokens/full", &Server::semanticTokens},
        {"textDocument/inlineValue", &Server::inlineValues},
        {"textDocument/inlayHint", &Server::inlayHints},
    };
    const auto it = methods.find(name);
    return it == methods.end() ? nullptr : it->second;
}

Server::Note Server::noteOf(std::string_view name) {
    static const std::map<std::string_view, Note> notes = {
        {"initialized", &Server::initialized},
        {"textDocument/didOpen", &Server::didOpen},
        {"textDocument/didChange", &Server::didChange},
        {"textDocument/didClose", &Server::didClose},
        {"textDocument/didSave", &Server::didSave},
        {"workspace/didChangeWatchedFiles", &Server::didChangeWatchedFiles},
    };
    const auto it = notes.find(name);
    return it == notes.end() ? nullptr : it->second;
}

void Server::receive(const Result<std::string>& message) {
    if (!message) {
        m_send(protocol::reply(nullptr, Failure{ErrorCode::ParseError, message.error().message}));
        return;
    }
    const std::variant<Incoming, Failure> incoming = protocol::readIncoming(*message);
    if (const Failure* failure = std::get_if<Failure>(&incoming))
        m_send(protocol::reply(nullptr, *failure));
    else
        take(std::get<Incoming>(incoming));
}

void Server::take(const Incoming& message) {
    switch (message.kind) {
    case Incoming::Kind::Request:
        m_send(protocol::reply(message.id, answer(message)));
        return;
    case Incoming::Kind::Notification:
        if (message.method == "exit") return exit(message.params);
        if (const Note note = noteOf(message.method); note && m_isInitialised && !m_isShutDown)
            (this->*note)(message.params);
        return;
    case Incoming::Kind::Response: // of what was registered; a client that cannot does without
        return;
    }
}

Answer Server::answer(const Incoming& request) {
    if (m_isShutDown) return Failure{ErrorCode::InvalidRequest, protocol::errors::IsShutDown()};
    if (request.method == "initialize") return initialize(request.params);
    if (!m_isInitialised) return Failure{ErrorCode::ServerNotInitialized, protocol::errors::NotInitialised()};
    const Method method = methodOf(request.method);
    if (!method) return Failure{ErrorCode::MethodNotFound, protocol::errors::NoSuchMethod(request.method)};
    if (isCancelled && isCancelled(request.id))
        return Failure{ErrorCode::RequestCancelled, protocol::errors::RequestCancelled()};
    return (this->*method)(request.params);
}

Answer Server::initialize(const Json& parameters) {
    if (m_isInitialised) return Failure{ErrorCode::InvalidRequest, protocol::errors::InitialisedTwice()};
    m_isInitialised = true;
    m_takesSnippets =
        protocol::flagAt(parameters, "capabilities.textDocument.completion.completionItem.snippetSupport");
    m_watchesFiles = protocol::flagAt(parameters, "capabilities.workspace.didChangeWatchedFiles.dynamicRegistration");
    m_refreshesHints = protocol::flagAt(parameters, "capabilities.workspace.inlayHint.refreshSupport");
    for (std::string& library : protocol::textsAt(parameters, "initializationOptions.libraries"))
        m_settings.libraries.push_back(std::move(library));
    Json sync{{"openClose", true}, {"change", 2}, {"save", Json::object()}};
    Json can{{"positionEncoding", "utf-16"}, {"textDocumentSync", std::move(sync)}};
    can["completionProvider"] = {{"triggerCharacters", {"."}}, {"resolveProvider", true}};
    can["signatureHelpProvider"] = {{"triggerCharacters", {"(", ","}}};
    for (const char* provider : {"hoverProvider", "definitionProvider", "declarationProvider", "referencesProvider",
                                 "documentHighlightProvider", "documentSymbolProvider", "workspaceSymbolProvider",
                                 "documentFormattingProvider", "documentRangeFormattingProvider",
                                 "foldingRangeProvider", "inlineValueProvider"})
        can[provider] = true;
    if (m_settings.values) can["inlayHintProvider"] = true;
    can["renameProvider"] = {{"prepareProvider", true}};
    can["codeActionProvider"] = {{"codeActionKinds", {"quickfix"}}};
    can["semanticTokensProvider"] = {{"legend", semanticLegend()}, {"full", true}};
    return Json{{"capabilities", std::move(can)}, {"serverInfo", {{"name", "stepwise"}, {"version", "0.1.0"}}}};
}

void Server::initialized(const Json&) {
    if (!m_watchesFiles) return;
    Json watchers = Json::array();
    for (const char* glob : {"**/*.st", "**/project.json", "**/hmi/*.json", "**/traces/*.json"})
        watchers.push_back({{"globPattern", glob}});
    Json registration{{"id", "files"},
                      {"method", "workspace/didChangeWatchedFiles"},
                      {"registerOptions", {{"watchers", std::move(watchers)}}}};
    Json request{{"jsonrpc", "2.0"}, {"id", "register"}, {"method", "client/registerCapability"}};
    request["params"]["registrations"] = Json::array({std::move(registration)});
    m_send(request);
}

Answer Server::shutdown(const Json&) {
    m_isShutDown = true;
    return Json(nullptr);
}

void Server::exit(const Json&) { m_isOver = true; }

} // namespace plc::lsp
