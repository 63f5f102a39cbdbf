#include "projects/exchange/base/xml.h"

#include "runtime/base/chars.h"
#include "runtime/base/messages.h"

#include <algorithm>
#include <cstring>
#include <sstream>

namespace plc::exchange {

namespace {

/// Where elements are nested too deeply or a document type is declared; npos: nowhere. Comments and CDATA are skipped.
struct Harm {
    size_t at = std::string_view::npos;
    Message message;
    [[nodiscard]] bool isFound() const { return at != std::string_view::npos; }
};

Harm findHarm(std::string_view text, const XmlLimits& limits) {
    int depth = 0;
    for (size_t at = text.find('<'); at != std::string_view::npos; at = text.find('<', at)) {
        const std::string_view rest = text.substr(at);
        const auto skip = [&](std::string_view end) {
            const size_t found = text.find(end, at);
            at = found == std::string_view::npos ? text.size() : found + end.size();
        };
        if (rest.starts_with("<!--")) {
            skip("-->");
        } else if (rest.starts_with("<![CDATA[")) {
            skip("]]>");
        } else if (rest.starts_with("<!")) {
            return {at, errors::XmlDocumentType()};
        } else if (rest.starts_with("<?")) {
            skip("?>");
        } else {
            const bool closes = rest.starts_with("</");
            char quote = 0;
            const size_t begin = at;
            for (++at; at < text.size() && (quote != 0 || text[at] != '>'); ++at)
                if (quote != 0 ? text[at] == quote : text[at] == '"' || text[at] == '\'') quote = quote ? 0 : text[at];
            const bool isEmpty = at > begin && text[std::min(at, text.size()) - 1] == '/';
            if (closes)
                --depth;
            else if (!isEmpty && ++depth > limits.depth)
                return {begin, errors::XmlTooDeep()};
        }
    }
    return {};
}

/// The encoding that the declaration names.
std::string declaredEncoding(std::string_view text) {
    if (!text.starts_with("<?xml")) return {};
    const std::string_view head = text.substr(0, text.find("?>"));
    const size_t at = head.find("encoding");
    if (at == std::string_view::npos) return {};
    const size_t open = head.find_first_of("\"'", at);
    if (open == std::string_view::npos) return {};
    std::string name(head.substr(open + 1, head.find(head[open], open + 1) - open - 1));
    return name;
}

void appendText(pugi::xml_node node, std::string& out) {
    bool firstParagraph = true;
    for (const pugi::xml_node child : node.children()) {
        if (child.type() == pugi::node_pcdata || child.type() == pugi::node_cdata) {
            out += child.value();
        } else if (child.type() == pugi::node_element) {
            const bool isParagraph = is(child, "p") || is(child, "br");
            if (isParagraph && !firstParagraph) out += '\n';
            appendText(child, out);
            if (isParagraph) firstParagraph = false;
        }
    }
}

/// Blanks between paragraphs are the file's indentation, no text.
bool hasParagraphs(pugi::xml_node node) {
    for (const pugi::xml_node child : node.children())
        if (is(child, "p")) return true;
    return false;
}

void appendParagraphs(pugi::xml_node node, std::string& out) {
    bool first = true;
    for (const pugi::xml_node child : node.children()) {
        if (!is(child, "p")) continue;
        if (!first) out += '\n';
        appendText(child, out);
        first = false;
    }
}

} // namespace

Result<XmlFile> XmlFile::parse(std::string_view bytes, const std::string& place, std::optional<Encoding> codePage,
                               const XmlLimits& limits) {
    XmlFile file;
    file.m_place = place;
    if (bytes.size() > limits.bytes) return Error{errors::XmlTooLarge(), place};
    const auto declared = projects::encodingNamed(declaredEncoding(bytes));
    const DecodedText decoded =
        projects::decodeText(bytes, declared && projects::isCodePage(*declared) ? declared : codePage);
    file.m_encoding = decoded.encoding;
    file.m_isEncodingGuessed = decoded.isGuessed;
    const std::string& text = decoded.text;
    const auto lineAt = [&](size_t at) {
        return std::to_string(
            1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(std::min(at, text.size())), '\n'));
    };
    if (const std::string encoding = declaredEncoding(text); !encoding.empty() && !projects::encodingNamed(encoding))
        return Error{errors::XmlEncodingUnknown(encoding), place};
    if (const Harm harm = findHarm(text, limits); harm.isFound())
        return Error{harm.message, place + ":" + lineAt(harm.at)};
    const pugi::xml_parse_result result = file.m_document->load_buffer(
        text.data(), text.size(),
        pugi::parse_cdata | pugi::parse_escapes | pugi::parse_eol | pugi::parse_wconv_attribute, pugi::encoding_utf8);
    if (!result)
        return Error{errors::XmlNotWellFormed(std::string(result.description())),
                     place + ":" + lineAt(static_cast<size_t>(std::max<ptrdiff_t>(result.offset, 0)))};
    if (!file.m_document->document_element()) return Error{errors::XmlEmpty(), place};
    for (size_t at = 0; at != std::string::npos; at = text.find('\n', at), at += at != std::string::npos)
        file.m_lineBegins.push_back(at);
    return file;
}

bool looksLikeXml(std::string_view bytes) {
    const DecodedText head = projects::decodeText(bytes.substr(0, 512));
    return trimmed(head.text).starts_with("<");
}

XmlFile XmlFile::madeFrom(const XmlFile& other) {
    XmlFile file;
    file.m_place = other.m_place;
    file.m_encoding = other.m_encoding;
    file.m_isEncodingGuessed = other.m_isEncodingGuessed;
    return file;
}

int XmlFile::lineOf(pugi::xml_node node) const {
    if (const auto it = m_lines.find(node.hash_value()); it != m_lines.end()) return it->second;
    const ptrdiff_t offset = node.offset_debug();
    if (offset < 0) return 0;
    const auto it = std::upper_bound(m_lineBegins.begin(), m_lineBegins.end(), static_cast<size_t>(offset));
    return static_cast<int>(it - m_lineBegins.begin());
}

std::string_view localName(pugi::xml_node node) {
    const std::string_view name = node.name();
    const size_t colon = name.rfind(':');
    return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

bool is(pugi::xml_node node, std::string_view name) {
    return node.type() == pugi::node_element && localName(node) == name;
}

pugi::xml_node childOf(pugi::xml_node node, std::string_view name) {
    for (const pugi::xml_node child : node.children())
        if (is(child, name)) return child;
    return {};
}

pugi::xml_node descendantOf(pugi::xml_node node, std::string_view path) {
    while (node && !path.empty()) {
        const size_t slash = path.find('/');
        node = childOf(node, path.substr(0, slash));
        path = slash == std::string_view::npos ? std::string_view() : path.substr(slash + 1);
    }
    return node;
}

pugi::xml_node dataOf(pugi::xml_node element, std::string_view ending) {
    for (const pugi::xml_node data : childOf(element, "addData").children())
        if (std::string_view(data.attribute("name").value()).ends_with(ending)) return data;
    return {};
}

std::string attribute(pugi::xml_node node, const char* name) { return node.attribute(name).value(); }

bool isTrue(pugi::xml_node node, const char* name) {
    const std::string_view value = node.attribute(name).value();
    return value == "true" || value == "TRUE" || value == "True" || value == "1";
}

std::string textOf(pugi::xml_node node) {
    std::string out;
    pugi::xml_node inner = node;
    if (const pugi::xml_node xhtml = childOf(node, "xhtml")) inner = xhtml;
    if (hasParagraphs(inner))
        appendParagraphs(inner, out);
    else
        appendText(inner, out);
    return withUnixLines(out);
}

std::string toXml(pugi::xml_node node) {
    std::ostringstream out;
    node.print(out, "", pugi::format_raw | pugi::format_no_declaration);
    return out.str();
}

std::string trimmed(std::string_view text) { return std::string(plc::trimmed(text)); }

std::string trimmedLines(std::string_view text) {
    const size_t end = text.find_last_not_of(" \t\r\n");
    if (end == std::string_view::npos) return {};
    text = text.substr(0, end + 1);
    const size_t word = text.find_first_not_of(" \t\r\n");
    const size_t line = text.rfind('\n', word);
    return std::string(line == std::string_view::npos ? text : text.substr(line + 1));
}

std::string withUnixLines(std::string_view text) {
    std::string out;
    out.reserve(text.size());
    for (size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '\r') {
            out += text[i];
            continue;
        }
        out += '\n';
        if (i + 1 < text.size() && text[i + 1] == '\n') ++i;
    }
    return out;
}

} // namespace plc::exchange
