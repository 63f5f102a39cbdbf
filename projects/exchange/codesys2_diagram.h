// Ladders and function blocks of CODESYS 2.3's text export as the body of a PLCopen diagram. Function, any thread.
#pragma once
#include "projects/exchange/xml.h"

#include <string_view>

namespace plc::exchange {

/// `text` begins with _LD_BODY or _FBD_BODY. False: it has something that is not known here; the document says nothing.
[[nodiscard]] bool readCodesys2Diagram(std::string_view text, pugi::xml_document& document);

} // namespace plc::exchange
