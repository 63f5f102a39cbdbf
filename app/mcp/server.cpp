#include "app/mcp/server.h"

#include "projects/analysis/library_reference.h"
#include "projects/protocol/errors.h"
#include "runtime/base/text.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include <algorithm>
#include <sstream>

namespace plc::mcp {

namespace errors = protocol::errors;
using protocol::Answer;
using protocol::ErrorCode;
using protocol::Failure;
using protocol::Incoming;

namespace {

constexpr const char* kVersion = "2025-06-18";
const std::vector<Field> kLookUp{
    {"words", FieldType::Text, "--", "what to look for, for example \"valve\" or \"TON\"", true}};

Json textContent(std::string text) { return {{"type", "text"}, {"text", std::move(text)}}; }

Json result(Json content, bool isError) { return {{"content", std::move(content)}, {"isError", isError}}; }

Json failed(const Message& message) { return result(Json::array({textContent(message.english())}), true); }

/// What a command says about its pictures, without the folder that exists only while it runs.
std::string withoutFolder(std::string text, const QString& folder) {
    const std::string prefix = folder.toStdString() + "/";
    for (size_t at = text.find(prefix); at != std::string::npos; at = text.find(prefix, at))
        text.erase(at, prefix.size());
    return text;
}

/// The pictures in a folder, by name.
Json pictures(const QString& folder) {
    constexpr int kMost = 20;
    Json out = Json::array();
    for (const QString& name : QDir(folder).entryList({"*.png"}, QDir::Files, QDir::Name).mid(0, kMost)) {
        QFile file(folder + "/" + name);
        if (!file.open(QIODevice::ReadOnly)) continue;
        out.push_back(textContent(name.toStdString()));
        out.push_back(
            {{"type", "image"}, {"data", file.readAll().toBase64().toStdString()}, {"mimeType", "image/png"}});
    }
    return out;
}

} // namespace

Server::Server(Send send, ServerSettings settings)
    : m_send(std::move(send)), m_settings(std::move(settings)), m_live(m_settings.allowsWrites) {}

void Server::receive(const Result<std::string>& message) {
    if (!message) {
        m_send(protocol::reply(nullptr, Failure{ErrorCode::ParseError, message.error().message}));
        return;
    }
    const std::variant<Incoming, Failure> incoming = protocol::readIncoming(*message);
    if (const Failure* failure = std::get_if<Failure>(&incoming)) {
        m_send(protocol::reply(nullptr, *failure));
        return;
    }
    const Incoming& request = std::get<Incoming>(incoming);
    if (request.kind == Incoming::Kind::Request) m_send(protocol::reply(request.id, answer(request)));
}

Answer Server::answer(const Incoming& request) {
    if (request.method == "initialize") return initialize(request.params);
    if (request.method == "ping") return Json::object();
    if (request.method == "tools/list") return list();
    if (request.method == "tools/call") return call(request.params);
    return Failure{ErrorCode::MethodNotFound, errors::NoSuchMethod(request.method)};
}

Answer Server::initialize(const Json& parameters) const {
    const std::string wanted = protocol::textAt(parameters, "protocolVersion").value_or(kVersion);
    const bool isKnown = wanted == "2024-11-05" || wanted == "2025-03-26" || wanted == kVersion;
    return Json{{"protocolVersion", isKnown ? wanted : kVersion},
                {"capabilities", {{"tools", Json::object()}}},
                {"serverInfo", {{"name", "stepwise"}, {"version", "0.1.0"}}},
                {"instructions", errors::McpInstructions().english()}};
}

Json Server::list() const {
    Json all = Json::array();
    const auto add = [&](std::string_view name, std::string_view description, const std::vector<Field>& fields,
                         bool reads) {
        all.push_back({{"name", name},
                       {"description", description},
                       {"inputSchema", inputSchema(fields)},
                       {"annotations", {{"readOnlyHint", reads}}}});
    };
    for (const Tool& tool : tools()) add(tool.name, tool.description, tool.fields, true);
    add("library", errors::LookUpHelp().english(), kLookUp, true);
    for (const LiveTool& tool : liveTools()) add(tool.name, tool.description, tool.fields, !tool.writes);
    return {{"tools", std::move(all)}};
}

Answer Server::call(const Json& parameters) {
    const auto name = protocol::textAt(parameters, "name");
    if (!name) return protocol::wrongParameter("tools/call", "name");
    static const Json kNone = Json::object();
    const Json* given = protocol::find(parameters, "arguments");
    const Json& arguments = given && !given->is_null() ? *given : kNone;
    for (const Tool& tool : tools())
        if (tool.name == *name) return run(tool, arguments);
    if (*name == "library") {
        if (auto good = checkArguments(*name, kLookUp, arguments); !good) return failed(good.error().message);
        return result(Json::array({textContent(lookUp(arguments["words"].get<std::string>()))}), false);
    }
    for (const LiveTool& tool : liveTools()) {
        if (tool.name != *name) continue;
        if (auto good = checkArguments(*name, tool.fields, arguments); !good) return failed(good.error().message);
        const auto text = m_live.call(*name, arguments);
        return result(Json::array({textContent(text ? *text : text.error().english())}), !text);
    }
    return Failure{ErrorCode::InvalidParams, errors::NoSuchTool(*name)};
}

Json Server::run(const Tool& tool, const Json& arguments) const {
    constexpr int kWrongUse = 2;
    auto words = wordsOf(tool, arguments);
    if (!words) return failed(words.error().message);
    QTemporaryDir folder;
    if (tool.picture != Picture::None && !folder.isValid()) return failed(errors::NoRoomForPictures());
    if (tool.picture == Picture::File) words->push_back("--picture=" + folder.filePath("chart.png").toStdString());
    if (tool.picture == Picture::Folder) words->push_back("--pictures=" + folder.path().toStdString());
    const ProgramRun done = runProgram(m_settings.program, *words, m_settings.limits);
    if (!done.hasStarted) return failed(errors::ProgramNotStarted(m_settings.program));
    Json content = Json::array();
    if (done.isTimedOut)
        content.push_back(textContent(errors::TookTooLong(m_settings.limits.time.count() / 1000).english()));
    if (!done.out.empty()) content.push_back(textContent(withoutFolder(done.out, folder.path())));
    if (!done.err.empty() && done.exitCode != 0) content.push_back(textContent(withoutFolder(done.err, folder.path())));
    if (done.isCut) content.push_back(textContent(errors::OutputCut(m_settings.limits.output).english()));
    if (tool.picture != Picture::None)
        for (Json& each : pictures(folder.path())) content.push_back(std::move(each));
    if (content.empty()) content.push_back(textContent(errors::NothingToSay().english()));
    return result(std::move(content), done.isTimedOut || done.exitCode < 0 || done.exitCode >= kWrongUse);
}

std::string lookUp(const std::string& words) {
    constexpr size_t kMost = 12;
    std::vector<std::string> wanted;
    std::istringstream in(foldCase(words));
    for (std::string word; in >> word;) wanted.push_back(word);
    std::vector<std::pair<bool, std::string>> found; // named so, text
    for (const analysis::ReferencePage& page : analysis::libraryReference()) {
        std::istringstream lines(page.markdown);
        std::string entry, title;
        const auto close = [&] {
            const std::string folded = foldCase(entry), name = foldCase(title);
            const auto isIn = [](const std::string& text) {
                return [&text](const std::string& word) { return text.find(word) != std::string::npos; };
            };
            if (!title.empty() && !wanted.empty() && std::all_of(wanted.begin(), wanted.end(), isIn(folded)))
                found.emplace_back(!std::any_of(wanted.begin(), wanted.end(), isIn(name)),
                                   page.fileName + "\n" + entry);
            entry.clear();
        };
        for (std::string line; std::getline(lines, line);) {
            if (line.starts_with("## ") || line.starts_with("### ")) {
                close();
                title = line;
            }
            entry += line + "\n";
        }
        close();
    }
    if (found.empty()) return errors::NothingFound(words).english();
    std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::string out;
    for (size_t i = 0; i < found.size() && i < kMost; ++i) out += found[i].second + "\n";
    if (found.size() > kMost) out += errors::MoreFound(found.size() - kMost).english() + "\n";
    return out;
}

} // namespace plc::mcp
