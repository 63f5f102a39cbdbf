// Instruction lists and charts become statements, at the level of the syntax tree: no names are resolved. Run on every file
// before it is checked: bodies keep their language and get St statements (`origin` leads back), units get the sections
// that hold the state. Functions without state; one file is lowered by one thread.
#pragma once
#include "runtime/compiler/parse/syntax.h"

namespace plc::lower {

/// Lowers every IL and SFC body of the file in place. Compiler variables have names that begin with `__`.
void lowerFile(syntax::SyntaxFile& file, diagnostics::Sink& sink);

} // namespace plc::lower
