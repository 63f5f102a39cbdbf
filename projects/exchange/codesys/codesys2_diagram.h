// Ladders and function blocks of CODESYS 2.3's text export as the body of a PLCopen diagram. Function, any thread.
#pragma once
#include "projects/exchange/base/xml.h"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace plc::exchange {

/// Names of a block's pins in their order: the export counts them only. VAR_IN_OUT stand behind the inputs.
struct BlockPins {
    std::vector<std::string> inputs, outputs;
};
/// The pins of a type that is written in any case; none: the type is not known.
using PinsOfType = std::function<std::optional<BlockPins>(const std::string& type)>;

/// The pins of a standard block.
[[nodiscard]] std::optional<BlockPins> standardPins(const std::string& type);
/// Of every FUNCTION_BLOCK that is declared in `text`, by folded name.
void gatherBlockPins(std::string_view text, std::map<std::string, BlockPins>& out);

/// `text` begins with _LD_BODY or _FBD_BODY. False: it has something that is not known here; the document says nothing.
[[nodiscard]] bool readCodesys2Diagram(std::string_view text, const PinsOfType& pinsOf, pugi::xml_document& document);

} // namespace plc::exchange
