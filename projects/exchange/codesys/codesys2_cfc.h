// Free function block diagrams (CFC) of CODESYS 2.3's text export as the body of a PLCopen diagram. Function, any
// thread.
#pragma once
#include "projects/exchange/codesys/codesys2_diagram.h"

namespace plc::exchange {

/// `text` begins with _CFC_BODY. False: it has something that is not known here; the document says nothing then.
[[nodiscard]] bool readCodesys2Cfc(std::string_view text, const PinsOfType& pinsOf, pugi::xml_document& document);

} // namespace plc::exchange
