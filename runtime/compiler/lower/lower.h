// Instruction lists and charts become statements, at the level of the syntax tree: no names are resolved. Run on every
// file before it is checked: bodies keep their language and get St statements (`origin` leads back to an instruction),
// units get the sections that hold the state. Functions without state; one file is lowered by one thread.
//
// What a chart leaves in its unit (hidden names begin with two underscores; n counts the unit's charts from 0):
//   <step>                SFC_STEP: X, T; on and off tell that it was activated or left in this scan
//   __chart<n>            TRUE once the initial steps were activated
//   __fired<n>            ARRAY OF BOOL: transition k of the text (from 0) was taken in this scan
//   __action_<name>       SFC_ACTION: Q is the action's control
//   __timed_<name>_<k>    the timers of SD and SL associations
// What an instruction list leaves: __il<k>, the current result of a line (its declaration's range is that line; every
// line of programs and blocks, in functions only where it is used twice; a constant needs none), and __at_<label>_<k>,
// the current result at a label.
#pragma once
#include "runtime/compiler/parse/syntax.h"

namespace plc::lower {

/// Every: each line's current result is kept in a variable whose declaration stands at that line, for online values.
enum class Keep : uint8_t { Needed, Every };

/// Lowers every IL and SFC body of the file in place. `results`: of programs and blocks; functions keep what they need.
/// Declarations before `first` are those of another tree and have been lowered.
void lowerFile(syntax::SyntaxFile& file, diagnostics::Sink& sink, Keep results = Keep::Every, size_t first = 0);

} // namespace plc::lower
