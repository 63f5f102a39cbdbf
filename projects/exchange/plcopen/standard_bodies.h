// Bodies of IEC 61131-10 as those of PLCopen XML. What is wired there by numbers of connection points, unique in their
// network, is wired here by elements and pins, unique in the body; networks lie one below the other.
#pragma once
#include "projects/exchange/plcopen/standard_nodes.h"

namespace plc::exchange {

/// `holder` has the BodyContents; each becomes a <body> of `element`.
void addBodies(StandardNodes& nodes, pugi::xml_node holder, pugi::xml_node element);
/// The text of one <BodyContent> or <PredicateContent> below `parent`, as <ST>, <IL>, <LD>, <FBD> or <SFC>.
void addBodyContent(StandardNodes& nodes, pugi::xml_node content, pugi::xml_node parent);

} // namespace plc::exchange
