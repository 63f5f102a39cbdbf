// The keyword that a section of variables begins with: VAR, VAR_INPUT … A pure function, any thread.
#pragma once
#include "runtime/compiler/parse/syntax.h"

#include <string_view>

namespace plc::syntax {

[[nodiscard]] std::string_view keywordOf(SectionKind kind);

} // namespace plc::syntax
