// The archive in which TwinCAT and CODESYS V3 store drawn bodies: <o t="Type"> objects with members by n="…", <v>
// values (texts in quotation marks), <l2> lists whose cet is the type of elements that say none, <n/> nothing.
// Functions on a parsed tree, any thread.
#pragma once
#include "projects/exchange/base/report.h"
#include "projects/exchange/base/xml.h"

#include <string>
#include <vector>

namespace plc::exchange {

/// One thing of an archive that has no place in what it becomes: its node, and what to say.
struct ArchiveRemark {
    pugi::xml_node node;
    Remark remark;
};

/// A body of PLCopen made from an archive; no body: the archive holds none of that kind.
struct ArchiveBody {
    pugi::xml_document document;
    std::vector<ArchiveRemark> remarks;
    std::vector<std::pair<std::string, std::string>> variables = {}; // that the body needs, with their types
    [[nodiscard]] pugi::xml_node body() const { return document.document_element(); }
};

namespace archive {

struct Element {
    pugi::xml_node node; // none: <n/>
    std::string type;
};

/// An empty node where the member is missing or nothing.
[[nodiscard]] pugi::xml_node memberOf(pugi::xml_node object, std::string_view name);
[[nodiscard]] std::string valueOf(pugi::xml_node object, std::string_view name); // without quotation marks
[[nodiscard]] bool isTrueIn(pugi::xml_node object, std::string_view name);
[[nodiscard]] std::vector<Element> elementsOf(pugi::xml_node list);
/// Of an object that holds its list in a member of that name, one level down: "Inputs" → InnerList.
[[nodiscard]] std::vector<Element> elementsIn(pugi::xml_node object, std::string_view name);
/// The first object of that type at or below `node`.
[[nodiscard]] pugi::xml_node objectOf(pugi::xml_node node, std::string_view type);
/// 12 of "12L"; 0 without a number.
[[nodiscard]] long long numberOf(pugi::xml_node object, std::string_view name);

} // namespace archive
} // namespace plc::exchange
