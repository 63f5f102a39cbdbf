// What the whole program is made of while it is checked: its symbols and the references to them. Free functions over
// the World of one check; one thread.
#pragma once
#include "runtime/compiler/sema/context.h"

namespace plc::sema {

SymbolId addSymbol(Gathered& gathered, SymbolKind kind, std::string_view name, std::string_view owner,
                   SourceRange range, std::string_view comment = {});
[[nodiscard]] bool isLibraryFile(const World& world, FileId file);
/// In `range` or just after it.
[[nodiscard]] bool hasSyntaxErrorAt(const World& world, SourceRange range);
void refer(const Check& check, SourceRange range, SymbolId symbol, bool isRead, bool isWrite);
/// Of a variable, for the advice about what is not used. A body's are taken over when it is done (noteUses).
void count(const Check& check, Variable& variable, bool isRead, bool isWrite);
tree::FunctionId newFunction(Gathered& gathered, std::string name, const Unit* unit);

} // namespace plc::sema
