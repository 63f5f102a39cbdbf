
#pragma once
#include "runtime/compiler/sema/context.h"

namespace plc::sema {

SymbolId addSymbol(World& world, SymbolKind kind, std::string_view name, std::string_view owner, SourceRange range,
                   std::string_view comment = {});
[[nodiscard]] bool isLibraryFile(const World& world, FileId file);
/// in it or just behind it
[[nodiscard]] bool hasSyntaxErrorAt(const World& world, SourceRange range);
void refer(World& world, SourceRange range, SymbolId symbol, bool isRead, bool isWrite);
tree::FunctionId newFunction(World& world, std::string name, const Unit* unit);

} // namespace plc::sema
