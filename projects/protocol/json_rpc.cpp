#include "projects/protocol/json_rpc.h"

#include "projects/protocol/errors.h"
#include "runtime/base/read_json.h"

namespace plc::protocol {

std::variant<Json, Failure> parseJson(std::string_view text) {
    JsonText<Json> json = readJson<Json>(text);
    if (!json.isGood()) return Failure{ErrorCode::ParseError, errors::NotJson(json.line)};
    return std::move(json.value);
}

namespace {

bool isId(const Json& id) { return id.is_string() || id.is_number_integer() || id.is_null(); }

} // namespace

std::variant<Incoming, Failure> readIncoming(std::string_view text) {
    std::variant<Json, Failure> parsed = parseJson(text);
    if (Failure* failure = std::get_if<Failure>(&parsed)) return std::move(*failure);
    Json& json = std::get<Json>(parsed);
    const Failure wrong{ErrorCode::InvalidRequest, errors::NotAMessage()};
    if (!json.is_object() || textAt(json, "jsonrpc") != "2.0") return wrong;
    Incoming incoming;
    if (json.contains("id")) {
        if (!isId(json["id"])) return wrong;
        incoming.id = json["id"];
    }
    if (!json.contains("method")) {
        if (!json.contains("id") || (!json.contains("result") && !json.contains("error"))) return wrong;
        incoming.kind = Incoming::Kind::Response;
        if (json.contains("result")) incoming.params = std::move(json["result"]);
        return incoming;
    }
    const std::optional<std::string> method = textAt(json, "method");
    if (!method) return wrong;
    incoming.kind = json.contains("id") ? Incoming::Kind::Request : Incoming::Kind::Notification;
    incoming.method = *method;
    if (json.contains("params")) {
        if (!json["params"].is_structured() && !json["params"].is_null()) return wrong;
        incoming.params = std::move(json["params"]);
    }
    return incoming;
}

Json reply(const Json& id, const Answer& answer) {
    Json out{{"jsonrpc", "2.0"}, {"id", id}};
    if (const Failure* failure = std::get_if<Failure>(&answer))
        out["error"] = {{"code", static_cast<int>(failure->code)}, {"message", failure->message.english()}};
    else
        out["result"] = std::get<Json>(answer);
    return out;
}

Json notification(std::string_view method, Json params) {
    return {{"jsonrpc", "2.0"}, {"method", method}, {"params", std::move(params)}};
}

std::string toText(const Json& message) { return message.dump(-1, ' ', false, Json::error_handler_t::replace); }

const Json* find(const Json& json, std::string_view path) {
    const Json* at = &json;
    while (!path.empty()) {
        const size_t dot = std::min(path.find('.'), path.size());
        if (!at->is_object()) return nullptr;
        const auto member = at->find(std::string(path.substr(0, dot)));
        if (member == at->end()) return nullptr;
        at = &*member;
        path.remove_prefix(std::min(dot + 1, path.size()));
    }
    return at;
}

std::optional<std::string> textAt(const Json& json, std::string_view path) {
    const Json* at = find(json, path);
    if (!at || !at->is_string()) return std::nullopt;
    return at->get<std::string>();
}

std::optional<int64_t> integerAt(const Json& json, std::string_view path) {
    const Json* at = find(json, path);
    if (!at || !at->is_number_integer()) return std::nullopt;
    if (at->is_number_unsigned() && at->get<uint64_t>() > static_cast<uint64_t>(INT64_MAX)) return std::nullopt;
    return at->get<int64_t>();
}

bool flagAt(const Json& json, std::string_view path, bool fallback) {
    const Json* at = find(json, path);
    return at && at->is_boolean() ? at->get<bool>() : fallback;
}

std::vector<std::string> textsAt(const Json& json, std::string_view path) {
    std::vector<std::string> out;
    const Json* at = find(json, path);
    if (!at || !at->is_array()) return out;
    for (const Json& each : *at)
        if (each.is_string()) out.push_back(each.get<std::string>());
    return out;
}

Failure wrongParameter(std::string_view method, std::string_view parameter) {
    return {ErrorCode::InvalidParams, errors::WrongParameter(method, parameter)};
}

} // namespace plc::protocol
