// What the parts of the reader of IEC 61131-10 share: the nodes of the document in PLCopen XML that it makes, each with
// the line it came from. One per file that is read.
#pragma once
#include "projects/exchange/base/report.h"
#include "projects/exchange/base/xml.h"

#include <set>

namespace plc::exchange {

class StandardNodes {
public:
    StandardNodes(const XmlFile& from, XmlFile& to, Report& report) : m_from(from), m_to(to), m_report(report) {}

    [[nodiscard]] pugi::xml_node add(pugi::xml_node parent, const char* name, pugi::xml_node source);
    /// An element with a text in it.
    void addText(pugi::xml_node parent, const char* name, pugi::xml_node source, const std::string& text);
    static void set(pugi::xml_node node, const char* name, const std::string& value);
    /// The same attribute of the same name; nothing where the source has none.
    static void take(pugi::xml_node node, const char* name, pugi::xml_node source);
    void addDocumentation(pugi::xml_node to, pugi::xml_node source);
    /// An element of the file that has no counterpart. The same one is reported once.
    void leaveOut(pugi::xml_node source, const std::string& what);

private:
    const XmlFile& m_from;
    XmlFile& m_to;
    Report& m_report;
    std::set<std::string> m_leftOut;
};

/// The local part of xsi:type: "Contact" of "ppx:Contact".
[[nodiscard]] std::string schemaType(pugi::xml_node node);

} // namespace plc::exchange
