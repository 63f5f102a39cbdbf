// Scalar conversions with the semantics of D11, used by the constant folder, the expression evaluator and (as the
// reference for generated code) tests: wrap between integers, REAL → integer nearest even and saturating, TIME in ms…
#pragma once
#include "runtime/types/value.h"

namespace plc::types {

/// How a conversion may be used without being written.
enum class Implicit : uint8_t {
    Same,      // nothing to do
    Widening,  // silent
    Narrowing, // allowed with a warning (P2004)
    Forbidden, // an error
};
/// Implicit conversion of a value of `from` assigned to `to` (widening silent; narrowing numbers and REAL→integer,
/// integer↔bits of other width, INT→enum a warning, as in CODESYS; BOOL ↔ number forbidden but literals 0/1).
[[nodiscard]] Implicit implicitConversion(const TypeTable& types, TypeId from, TypeId to);

/// X_TO_Y of table 22 and CODESYS for every pair of elementary types, strings included. `ok` becomes false (ENO) when
/// the text or value has no meaning in `to`; the result then is 0 or ''.
[[nodiscard]] Value convert(const TypeTable& types, const Value& value, TypeId to, bool* ok = nullptr);
/// Nanoseconds that one count of the number stands for in a conversion: TIME and TOD count milliseconds, DATE and DT
/// seconds, the long forms nanoseconds.
[[nodiscard]] int64_t nanosecondsOf(TypeKind kind);
/// TRUNC: towards zero, saturating, NaN gives 0.
[[nodiscard]] Value truncate(const TypeTable& types, const Value& value, TypeId to);
/// Wraps to the width and sign of an integer kind.
[[nodiscard]] int64_t wrapInteger(TypeKind kind, int64_t value);
/// Nearest, ties to even, saturating to the kind's range, NaN → 0.
[[nodiscard]] int64_t roundToInteger(TypeKind kind, double value);
/// REAL_TO_TIME and its like: counts of the type's unit (ms, s, ns), rounded and saturating; dates begin their day.
[[nodiscard]] int64_t timeFromReal(TypeKind kind, double value);

} // namespace plc::types
