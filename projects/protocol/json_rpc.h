// JSON-RPC 2.0 as the Language Server Protocol and the Model Context Protocol speak it: what a client sent, read
// strictly, and what goes back. Values and functions, any thread.
#pragma once
#include "runtime/base/result.h"

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

namespace plc::protocol {

using Json = nlohmann::ordered_json;

enum class ErrorCode : int {
    ParseError = -32700,
    InvalidRequest = -32600,
    MethodNotFound = -32601,
    InvalidParams = -32602,
    InternalError = -32603,
    ServerNotInitialized = -32002,
    RequestFailed = -32803,
    ContentModified = -32801,
    RequestCancelled = -32800
};
struct Failure {
    ErrorCode code = ErrorCode::InternalError;
    Message message;
};
/// What a request gets.
using Answer = std::variant<Json, Failure>;

struct Incoming {
    enum class Kind : uint8_t { Request, Notification, Response };
    Kind kind = Kind::Notification;
    Json id;
    std::string method; // of a response empty
    Json params;        // of a response its result
};

/// JSON of the depth that people write, else why it is none.
[[nodiscard]] std::variant<Json, Failure> parseJson(std::string_view text);
/// A message of JSON-RPC; a Failure keeps no id: the message has none that could be trusted.
[[nodiscard]] std::variant<Incoming, Failure> readIncoming(std::string_view text);

[[nodiscard]] Json reply(const Json& id, const Answer& answer);
[[nodiscard]] Json notification(std::string_view method, Json params);
/// Text that is not UTF-8 gets replacement characters; it never fails.
[[nodiscard]] std::string toText(const Json& message);

// --- parameters, whatever a client put there: "textDocument.uri"
[[nodiscard]] const Json* find(const Json& json, std::string_view path);
[[nodiscard]] std::optional<std::string> textAt(const Json& json, std::string_view path);
[[nodiscard]] std::optional<int64_t> integerAt(const Json& json, std::string_view path);
[[nodiscard]] bool flagAt(const Json& json, std::string_view path, bool fallback = false);
/// The texts of a list; what else is in it is left out.
[[nodiscard]] std::vector<std::string> textsAt(const Json& json, std::string_view path);
[[nodiscard]] Failure wrongParameter(std::string_view method, std::string_view parameter);

} // namespace plc::protocol
