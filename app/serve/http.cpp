#include "app/serve/http.h"

#include <QUrl>

namespace plc::serve {

namespace {

bool isToken(QByteArrayView text) {
    for (const char c : text)
        if (!(c > ' ' && c < 127) || std::strchr("()<>@,;:\\\"/[]?={}", c)) return false;
    return !text.isEmpty();
}

const char* reason(int status) {
    switch (status) {
    case 200:
        return "OK";
    case 302:
        return "Found";
    case 400:
        return "Bad Request";
    case 403:
        return "Forbidden";
    case 404:
        return "Not Found";
    case 405:
        return "Method Not Allowed";
    case 408:
        return "Request Timeout";
    case 431:
        return "Request Header Fields Too Large";
    default:
        return "Service Unavailable";
    }
}

bool takeField(HttpRequest& request, QByteArrayView line) {
    const qsizetype colon = line.indexOf(':');
    if (colon <= 0 || !isToken(line.first(colon))) return false;
    const QByteArrayView value = line.sliced(colon + 1).trimmed();
    for (const char c : value)
        if (static_cast<unsigned char>(c) < ' ' && c != '\t') return false;
    request.fields.emplace_back(line.first(colon).toByteArray().toLower(), value.toByteArray());
    return true;
}

bool takeLine(HttpRequest& request, QByteArrayView line) {
    const qsizetype first = line.indexOf(' '), last = line.lastIndexOf(' ');
    if (first <= 0 || last <= first || !line.sliced(last + 1).startsWith("HTTP/1.")) return false;
    request.method = line.first(first).toByteArray();
    const QByteArray target = line.sliced(first + 1, last - first - 1).toByteArray();
    if (!isToken(request.method) || !target.startsWith('/')) return false;
    for (const char c : target)
        if (static_cast<unsigned char>(c) <= ' ') return false;
    const qsizetype mark = target.indexOf('?');
    request.path = QByteArray::fromPercentEncoding(mark < 0 ? target : target.left(mark));
    if (mark >= 0) request.query = target.mid(mark + 1);
    return !request.path.contains('\0');
}

} // namespace

QByteArray HttpRequest::field(QByteArrayView name) const {
    for (const auto& [key, value] : fields)
        if (key == name) return value;
    return {};
}

bool HttpRequest::isWebSocket() const { return field("upgrade").toLower() == "websocket"; }

bool HttpRequest::isSameOrigin() const {
    const QByteArray origin = field("origin");
    if (origin.isEmpty()) return true; // no browser: nobody's rights are borrowed
    const QUrl url(QString::fromUtf8(origin), QUrl::StrictMode);
    const QUrl host(QStringLiteral("x://") + QString::fromUtf8(field("host")), QUrl::StrictMode);
    const int usual = url.scheme() == QStringLiteral("https") ? 443 : 80;
    return url.isValid() && host.isValid() && !host.host().isEmpty() && url.host() == host.host() &&
           url.port(usual) == host.port(usual);
}

HttpHead parseHead(QByteArrayView bytes) {
    HttpHead out;
    const qsizetype end = bytes.indexOf("\r\n\r\n");
    if (end < 0) {
        if (bytes.size() >= kLargestHead) out.state = HeadState::Bad;
        return out;
    }
    out.state = HeadState::Bad;
    constexpr size_t kMostFields = 64;
    QByteArrayView rest = bytes.first(end);
    bool isFirst = true;
    while (!rest.isEmpty()) {
        qsizetype length = rest.indexOf("\r\n");
        if (length < 0) length = rest.size();
        const QByteArrayView line = rest.first(length);
        rest = rest.sliced(std::min(rest.size(), length + 2));
        if (isFirst ? !takeLine(out.request, line) : !takeField(out.request, line)) return out;
        if (out.request.fields.size() > kMostFields) return out;
        isFirst = false;
    }
    if (isFirst) return out;
    out.state = HeadState::Complete;
    return out;
}

QByteArray toBytes(const HttpAnswer& answer, bool withBody) {
    QByteArray out = "HTTP/1.1 " + QByteArray::number(answer.status) + ' ' + reason(answer.status) + "\r\n";
    out += "Content-Type: " + answer.type + "\r\n";
    out += "Content-Length: " + QByteArray::number(answer.body.size()) + "\r\n";
    if (!answer.location.isEmpty()) out += "Location: " + answer.location + "\r\n";
    out += "Connection: close\r\nCache-Control: no-store\r\nX-Content-Type-Options: nosniff\r\n"
           "X-Frame-Options: SAMEORIGIN\r\nReferrer-Policy: no-referrer\r\n"
           "Content-Security-Policy: default-src 'self'; img-src 'self' blob: data:; style-src 'self' 'unsafe-inline'; "
           "connect-src 'self' ws: wss:\r\n\r\n";
    return withBody ? out + answer.body : out;
}

} // namespace plc::serve
