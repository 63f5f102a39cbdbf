// XML of other tools, read so that nothing in it can harm: no document types or entities of its own, bounded size,
// depth and number of elements, any of the usual encodings. Names are compared without their prefix. Functions and a
// document that owns its tree; any thread.
#pragma once
#include "projects/storage/text_encoding.h"
#include "runtime/base/result.h"

#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <unordered_map>

namespace plc::exchange {

using projects::DecodedText;
using projects::Encoding;

struct XmlLimits {
    size_t bytes = size_t{512} * 1024 * 1024;
    int depth = 200; // whoever walks the tree may recurse
};

class XmlFile {
public:
    /// `place` is the path as shown in errors, which carry the line too.
    /// `codePage`: of a file that neither is in Unicode nor says what it is in.
    [[nodiscard]] static Result<XmlFile> parse(std::string_view bytes, const std::string& place,
                                               std::optional<Encoding> codePage = {}, const XmlLimits& limits = {});
    /// An empty document in place of `other`, to be filled; `setLine` tells where in `other` a node of it comes from.
    [[nodiscard]] static XmlFile madeFrom(const XmlFile& other);
    [[nodiscard]] pugi::xml_document& document() { return *m_document; }
    void setLine(pugi::xml_node node, int line) { m_lines[node.hash_value()] = line; }
    [[nodiscard]] pugi::xml_node root() const { return m_document->document_element(); }
    [[nodiscard]] int lineOf(pugi::xml_node node) const;
    [[nodiscard]] const std::string& place() const { return m_place; }
    [[nodiscard]] Encoding encoding() const { return m_encoding; }
    [[nodiscard]] bool isEncodingGuessed() const { return m_isEncodingGuessed; }

private:
    std::unique_ptr<pugi::xml_document> m_document = std::make_unique<pugi::xml_document>();
    std::string m_place;
    std::vector<size_t> m_lineBegins;
    std::unordered_map<size_t, int> m_lines; // of a document that was made, by node
    Encoding m_encoding = Encoding::Utf8;
    bool m_isEncodingGuessed = false;
};

/// XML of another tool, by the first bytes: no source of ours.
[[nodiscard]] bool looksLikeXml(std::string_view bytes);
/// The element's name without its prefix.
[[nodiscard]] std::string_view localName(pugi::xml_node node);
[[nodiscard]] bool is(pugi::xml_node node, std::string_view name);
/// The first child element of that name, or an empty node.
[[nodiscard]] pugi::xml_node childOf(pugi::xml_node node, std::string_view name);
/// A way of names: "condition/connectionPointIn".
[[nodiscard]] pugi::xml_node descendantOf(pugi::xml_node node, std::string_view path);
/// The first <data> of an element's addData whose name ends so: "/plcopenxml/method".
[[nodiscard]] pugi::xml_node dataOf(pugi::xml_node element, std::string_view ending);
[[nodiscard]] std::string attribute(pugi::xml_node node, const char* name);
[[nodiscard]] bool isTrue(pugi::xml_node node, const char* name); // "true", "TRUE", "1"
/// All text below the node; paragraphs of XHTML become lines. Line ends are \n.
[[nodiscard]] std::string textOf(pugi::xml_node node);
/// The node written as XML, without indentation added.
[[nodiscard]] std::string toXml(pugi::xml_node node);
[[nodiscard]] std::string trimmed(std::string_view text);
/// Without blank lines before and after; blanks at the end of the last line go, those before the first word stay.
[[nodiscard]] std::string trimmedLines(std::string_view text);
/// CRLF and CR become LF.
[[nodiscard]] std::string withUnixLines(std::string_view text);

} // namespace plc::exchange
