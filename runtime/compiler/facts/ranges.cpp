#include "runtime/compiler/facts/ranges.h"

namespace plc::facts {

bool mayLeaveRange(const types::TypeTable& types, const tree::Expr& value, types::TypeId target) {
    const types::Type& range = types[target];
    if (range.kind != types::TypeKind::Subrange || !types::isInteger(types.family(target))) return false;
    if (range.low == INT64_MIN && range.high == INT64_MAX) return false; // an elementary type with a default of its own
    if (value.kind == tree::ExprKind::Load) return value.place->type != target;
    if (value.kind != tree::ExprKind::Constant || !std::holds_alternative<int64_t>(value.value.data)) return true;
    return value.value.integer() < range.low || value.value.integer() > range.high;
}

} // namespace plc::facts
