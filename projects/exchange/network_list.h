// LD and FBD as TwinCAT and CODESYS V3 store them, a list of networks in an archive of objects, as the body of a
// PLCopen diagram, which the reader of diagrams knows. Function, any thread.
#pragma once
#include "projects/exchange/report.h"
#include "projects/exchange/xml.h"

#include <string>
#include <vector>

namespace plc::exchange {

/// One thing of the list that the diagram does not have: its type, or what it is.
struct NetworkRemark {
    pugi::xml_node node;
    Remark remark;
};

struct NetworkList {
    pugi::xml_document document;
    std::vector<NetworkRemark> remarks;
    [[nodiscard]] pugi::xml_node body() const { return document.document_element(); } // <LD> or <FBD>; none: no list
};

/// `archive` holds the list somewhere below it: an <NWL> of TwinCAT.
[[nodiscard]] NetworkList readNetworkList(pugi::xml_node archive);

} // namespace plc::exchange
