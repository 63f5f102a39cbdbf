// Where names come from and where they are used: hover, definition, references, highlights, rename.
#include "projects/language_server/server.h"
#include "projects/protocol/errors.h"

namespace plc::lsp {

using protocol::ErrorCode;

Answer Server::hover(const Json& parameters) {
    const SpotOf found = spotAt(parameters);
    if (const Failure* failure = std::get_if<Failure>(&found)) return *failure;
    const Spot& spot = std::get<Spot>(found);
    const auto hover = spot.model().hover(spot.file, spot.offset);
    if (!hover) return Json(nullptr);
    std::string text = "```iecst\n" + hover->declaration + "\n```";
    if (!hover->comment.empty()) text += "\n\n" + hover->comment;
    return Json{{"contents", {{"kind", "markdown"}, {"value", std::move(text)}}},
                {"range", spot.desk->places(spot.file).range(hover->range.begin, hover->range.end)}};
}

Answer Server::definition(const Json& parameters) {
    const SpotOf found = spotAt(parameters);
    if (const Failure* failure = std::get_if<Failure>(&found)) return *failure;
    const Spot& spot = std::get<Spot>(found);
    const auto range = spot.model().definition(spot.file, spot.offset);
    if (!range) return Json(nullptr);
    return spot.desk->location(*range);
}

Answer Server::references(const Json& parameters) {
    const SpotOf found = spotAt(parameters);
    if (const Failure* failure = std::get_if<Failure>(&found)) return *failure;
    const Spot& spot = std::get<Spot>(found);
    const bool withDeclaration = protocol::flagAt(parameters, "context.includeDeclaration", true);
    Json out = Json::array();
    for (const analysis::Use& use : spot.model().uses(spot.file, spot.offset))
        if (withDeclaration || !use.isDeclaration) out.push_back(spot.desk->location(use.range));
    return out;
}

Answer Server::highlights(const Json& parameters) {
    constexpr int kText = 1, kRead = 2, kWrite = 3;
    const SpotOf found = spotAt(parameters);
    if (const Failure* failure = std::get_if<Failure>(&found)) return *failure;
    const Spot& spot = std::get<Spot>(found);
    Json out = Json::array();
    for (const analysis::Use& use : spot.model().uses(spot.file, spot.offset)) {
        if (use.range.file != spot.file) continue;
        out.push_back({{"range", spot.desk->places(spot.file).range(use.range.begin, use.range.end)},
                       {"kind", use.isWrite  ? kWrite
                                : use.isRead ? kRead
                                             : kText}});
    }
    return out;
}

Answer Server::prepareRename(const Json& parameters) {
    const SpotOf found = spotAt(parameters);
    if (const Failure* failure = std::get_if<Failure>(&found)) return *failure;
    const Spot& spot = std::get<Spot>(found);
    SourceRange range;
    const auto id = spot.model().symbolAt(spot.file, spot.offset, &range);
    if (!id) return Failure{ErrorCode::RequestFailed, protocol::errors::NothingToRenameHere()};
    const std::string& name = spot.model().symbol(*id).name;
    if (const auto possible = spot.model().rename(spot.file, spot.offset, name); !possible)
        return Failure{ErrorCode::RequestFailed, possible.error().message};
    return Json{{"range", spot.desk->places(spot.file).range(range.begin, range.end)}, {"placeholder", name}};
}

Answer Server::rename(const Json& parameters) {
    const SpotOf found = spotAt(parameters);
    if (const Failure* failure = std::get_if<Failure>(&found)) return *failure;
    const Spot& spot = std::get<Spot>(found);
    const auto name = protocol::textAt(parameters, "newName");
    if (!name) return protocol::wrongParameter("textDocument/rename", "newName");
    const auto edits = spot.model().rename(spot.file, spot.offset, *name);
    if (!edits) return Failure{ErrorCode::RequestFailed, edits.error().message};
    return workspaceEdit(*spot.desk, *edits);
}

} // namespace plc::lsp
