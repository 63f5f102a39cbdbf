// What the editor holds: opened, changed, closed, saved; and the diagnostics that go back.
#include "projects/language_server/server.h"
#include "projects/protocol/errors.h"

#include <filesystem>

namespace plc::lsp {

using diagnostics::Diagnostic;
using diagnostics::Severity;
using protocol::ErrorCode;

namespace {

int severityNumber(Severity severity) {
    switch (severity) {
    case Severity::Error:
        return 1;
    case Severity::Warning:
        return 2;
    case Severity::Info:
        break;
    }
    return 3;
}

bool isUnnecessary(diagnostics::Kind kind) {
    return kind == diagnostics::Kind::UnusedVariable || kind == diagnostics::Kind::UnreachableCode;
}

/// Several programs that nothing runs are an error when one of them shall run; here they are only written.
Severity shownSeverity(const Diagnostic& diagnostic) {
    return diagnostic.kind == diagnostics::Kind::SeveralPrograms ? Severity::Warning : diagnostic.severity;
}

Json toJson(Desk& desk, FileId file, const Diagnostic& diagnostic) {
    const SourceRange range = diagnostic.range.file.isValid() ? diagnostic.range : SourceRange{file, 0, 0};
    Json out{{"range", desk.places(file).range(range.begin, range.end)},
             {"severity", severityNumber(shownSeverity(diagnostic))},
             {"code", diagnostics::codeOf(diagnostic.kind)},
             {"source", "stepwise"},
             {"message", diagnostic.message.english()}};
    if (isUnnecessary(diagnostic.kind)) out["tags"] = {1};
    Json related = Json::array();
    for (const diagnostics::Related& each : diagnostic.related)
        if (each.range.file.isValid())
            related.push_back({{"location", desk.location(each.range)}, {"message", each.note.english()}});
    if (!related.empty()) out["relatedInformation"] = std::move(related);
    return out;
}

} // namespace

// ---------------------------------------------------------------- texts

Desk& Server::deskFor(const std::string& path) {
    const std::string folder = projectFolderOf(path);
    if (!folder.empty()) {
        const auto known = m_desks.find(folder);
        if (known != m_desks.end() && known->second->owns(path)) return *known->second;
        if (known == m_desks.end()) {
            auto desk = Desk::ofFolder(folder);
            if (!desk) show(desk.error());
            if (desk && (*desk)->owns(path)) return *(m_desks[folder] = std::move(*desk));
        }
    }
    std::unique_ptr<Desk>& desk = m_desks[path];
    if (!desk) desk = Desk::ofFile(path, m_settings.libraries);
    return *desk;
}

void Server::show(const Error& error) {
    m_send(protocol::notification("window/showMessage", {{"type", 1}, {"message", error.english()}}));
}

void Server::settle(Document& document) { document.desk->setText(document.path, document.places->text()); }

void Server::didOpen(const Json& parameters) {
    const auto uri = protocol::textAt(parameters, "textDocument.uri");
    auto text = protocol::textAt(parameters, "textDocument.text");
    if (!uri || !text) return;
    Document& document = m_documents[*uri];
    document.path = pathOfUri(*uri).value_or(*uri); // a text without a file is known by its URI
    document.version = protocol::integerAt(parameters, "textDocument.version").value_or(0);
    document.places = std::make_unique<Places>(std::move(*text));
    document.desk = &deskFor(document.path);
    settle(document);
    dropUnused(); // what it was opened from before
}

bool Server::change(Document& document, const Json& change) {
    const auto text = protocol::textAt(change, "text");
    if (!text) return false;
    if (!change.contains("range")) {
        document.places = std::make_unique<Places>(*text);
        return true;
    }
    const auto start = positionAt(change, "range.start"), end = positionAt(change, "range.end");
    if (!start || !end) return false;
    const uint32_t from = document.places->offsetOf(*start), to = document.places->offsetOf(*end);
    if (to < from) return false;
    std::string next = document.places->text();
    next.replace(from, to - from, *text);
    document.places = std::make_unique<Places>(std::move(next));
    return true;
}

void Server::didChange(const Json& parameters) {
    const auto uri = protocol::textAt(parameters, "textDocument.uri");
    const auto it = uri ? m_documents.find(*uri) : m_documents.end();
    const Json* changes = protocol::find(parameters, "contentChanges");
    if (it == m_documents.end() || !changes || !changes->is_array()) return;
    Document& document = it->second;
    document.version = protocol::integerAt(parameters, "textDocument.version").value_or(document.version);
    for (const Json& each : *changes)
        if (!change(document, each)) show({protocol::errors::NoSuchRange(*uri), {}});
    settle(document);
}

void Server::didClose(const Json& parameters) {
    const auto uri = protocol::textAt(parameters, "textDocument.uri");
    const auto it = uri ? m_documents.find(*uri) : m_documents.end();
    if (it == m_documents.end()) return;
    it->second.desk->release(it->second.path);
    m_documents.erase(it);
    for (auto& [other, document] : m_documents) settle(document); // the same file may be open under another URI
    dropUnused();
}

void Server::dropUnused() {
    std::erase_if(m_desks, [this](const auto& each) {
        const bool isUsed = std::any_of(m_documents.begin(), m_documents.end(),
                                        [&](const auto& entry) { return entry.second.desk == each.second.get(); });
        if (!isUsed) withdraw(*each.second);
        return !isUsed;
    });
}

void Server::didSave(const Json& parameters) { didChangeWatchedFiles(parameters); }

/// Files came, went or changed; and so may what is a project.
void Server::didChangeWatchedFiles(const Json&) {
    for (const auto& [name, desk] : m_desks)
        if (auto done = desk->reread(); !done) show(done.error());
    for (auto& [uri, document] : m_documents) {
        Desk& desk = deskFor(document.path);
        if (&desk == document.desk) continue;
        document.desk->release(document.path);
        document.desk = &desk;
        settle(document);
    }
    dropUnused();
}

// ---------------------------------------------------------------- diagnostics

/// A question may have brought the analysis up to date already: what counts is what was sent.
bool Server::isReported(const Desk& desk) const {
    const auto it = m_reported.find(&desk);
    return it != m_reported.end() && it->second.revision == desk.revision();
}

bool Server::hasWork() const {
    return std::any_of(m_desks.begin(), m_desks.end(), [&](const auto& each) { return !isReported(*each.second); });
}

void Server::work() {
    for (const auto& [name, desk] : m_desks) {
        if (!isReported(*desk)) publish(*desk);
        desk->forgetBefore();
    }
}

void Server::publish(const std::string& path, Json diagnostics) {
    Json parameters{{"uri", uriOfPath(path)}};
    for (const auto& [known, document] : m_documents) // as the client writes it
        if (document.path == path) {
            parameters["uri"] = known;
            parameters["version"] = document.version;
        }
    parameters["diagnostics"] = std::move(diagnostics);
    m_send(protocol::notification("textDocument/publishDiagnostics", std::move(parameters)));
}

void Server::publish(Desk& desk) {
    std::map<std::string, Json> byPath;
    const std::vector<FileId> own = desk.ownFiles();
    m_reported[&desk].revision = desk.revision();
    std::set<std::string>& reported = m_reported[&desk].paths;
    if (own.empty()) return;
    for (const FileId file : own) byPath[desk.pathOf(file)] = Json::array();
    for (const Diagnostic& diagnostic : desk.model().diagnostics()) {
        const FileId file = diagnostic.range.file.isValid() ? diagnostic.range.file : own.front();
        if (const auto it = byPath.find(desk.pathOf(file)); it != byPath.end())
            it->second.push_back(toJson(desk, file, diagnostic));
    }
    for (const std::string& path : reported) // a file that is gone
        if (!byPath.contains(path)) byPath[path] = Json::array();
    reported.clear();
    for (auto& [path, list] : byPath) {
        const std::string text = protocol::toText(list);
        std::string& sent = m_published[path];
        const bool isOpen = std::any_of(m_documents.begin(), m_documents.end(),
                                        [&, &p = path](const auto& each) { return each.second.path == p; });
        if (!list.empty()) reported.insert(path);
        if (sent == text && !isOpen) continue;
        if (sent.empty() && list.empty() && !isOpen) continue;
        sent = text;
        publish(path, std::move(list));
    }
}

void Server::withdraw(Desk& desk) {
    for (const std::string& path : m_reported[&desk].paths) {
        publish(path, Json::array());
        m_published.erase(path);
    }
    m_reported.erase(&desk);
}

// ---------------------------------------------------------------- places

Server::SpotOf Server::documentAt(const Json& parameters) {
    const auto uri = protocol::textAt(parameters, "textDocument.uri");
    if (!uri) return protocol::wrongParameter("The request", "textDocument.uri");
    const auto it = m_documents.find(*uri);
    if (it == m_documents.end()) return Failure{ErrorCode::InvalidParams, protocol::errors::NotOpen(*uri)};
    Spot spot{&it->second, it->second.desk, {}, 0};
    const auto file = spot.desk->fileOf(spot.document->path);
    if (!file) return Failure{ErrorCode::InternalError, protocol::errors::NotOpen(*uri)};
    spot.file = *file;
    return spot;
}

Server::SpotOf Server::spotAt(const Json& parameters) {
    SpotOf found = documentAt(parameters);
    if (std::holds_alternative<Failure>(found)) return found;
    const auto position = positionAt(parameters, "position");
    if (!position) return protocol::wrongParameter("The request", "position");
    Spot& spot = std::get<Spot>(found);
    spot.offset = spot.document->places->offsetOf(*position);
    return found;
}

Json Server::workspaceEdit(Desk& desk, const std::vector<analysis::FileEdits>& edits) {
    Json changes = Json::object();
    for (const analysis::FileEdits& each : edits) {
        Json list = Json::array();
        for (const diagnostics::TextEdit& edit : each.edits)
            list.push_back(
                {{"range", desk.places(each.file).range(edit.range.begin, edit.range.end)}, {"newText", edit.text}});
        changes[uriOfPath(desk.pathOf(each.file))] = std::move(list);
    }
    return {{"changes", std::move(changes)}};
}

} // namespace plc::lsp
