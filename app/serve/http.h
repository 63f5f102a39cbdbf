// The little of HTTP/1.1 that the server speaks: the head of a GET, without a body, parsed from bytes that anybody may
// have sent; and an answer as bytes. Values and functions, any thread.
#pragma once
#include <QByteArray>
#include <QByteArrayView>
#include <QString>

#include <optional>
#include <utility>
#include <vector>

namespace plc::serve {

inline constexpr qsizetype kLargestHead = 8192;

struct HttpRequest {
    QByteArray method, path, query;                        // the path decoded, without the query
    std::vector<std::pair<QByteArray, QByteArray>> fields; // names in lower case
    QByteArray field(QByteArrayView name) const;
    bool isWebSocket() const;
    /// A page of another site must not speak for its reader here.
    bool isSameOrigin() const;
};

enum class HeadState { Incomplete, Complete, Bad };
struct HttpHead {
    HeadState state = HeadState::Incomplete;
    HttpRequest request;
};
[[nodiscard]] HttpHead parseHead(QByteArrayView bytes);

struct HttpAnswer {
    int status = 200;
    QByteArray type = "text/plain; charset=utf-8", body;
    QByteArray location; // of a redirection
};
/// `withBody`: not for HEAD. The connection is closed behind it.
[[nodiscard]] QByteArray toBytes(const HttpAnswer& answer, bool withBody = true);

} // namespace plc::serve
