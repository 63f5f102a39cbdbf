// Parts of an export that need nothing of its state: configurations, folders, texts of declarations. Functions, any
// thread.
#pragma once
#include "projects/exchange/plcopen/xml_writer.h"

#include <string>
#include <vector>

namespace plc::exchange {

/// The same unit has the same id in every export.
[[nodiscard]] std::string idOf(const std::string& name);
void addFolder(pugi::xml_node structure, const std::string& folder, const std::vector<std::string>& units);
void writeConfiguration(pugi::xml_node configurations, const syntax::ConfigurationDecl& decl, const XmlWriter& writer);
/// TYPE … END_TYPE of one declaration, with what is above the block in front of its first.
[[nodiscard]] std::string textOfType(const syntax::SyntaxFile& tree, const SourceView& view,
                                     const syntax::TypeDecl& type);
/// {gvl NAME} is the list's name in the file.
[[nodiscard]] std::string withoutListName(std::string text);
/// Comments above steps and transitions and in actions are kept; others of a chart have no place.
void noteCommentsOutside(const syntax::SfcBody& chart, const XmlWriter& writer, const std::string& unit);

} // namespace plc::exchange
