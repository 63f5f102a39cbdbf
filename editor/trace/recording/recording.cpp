#include "editor/trace/recording/recording.h"

#include <algorithm>

namespace plc::trace {

std::optional<Position> nextOnChain(const std::vector<PositionRange>& chain, Position position) {
    for (const PositionRange& range : chain)
        if (position + 1 < range.end) return std::max(position + 1, range.begin);
    return std::nullopt;
}

std::optional<Position> previousOnChain(const std::vector<PositionRange>& chain, Position position) {
    for (size_t i = chain.size(); i-- > 0;)
        if (position > chain[i].begin) return std::min(position, chain[i].end) - 1;
    return std::nullopt;
}

ChannelType channelTypeOf(const expression::Expression& expression) {
    using history::ColumnKind;
    using types::TypeKind;
    ChannelType out;
    if (!expression.isValid()) return out;
    const types::TypeTable& table = expression.types();
    const types::Type* type = &table[expression.type()];
    out.name = type->name;
    if (type->kind == TypeKind::Enum)
        for (const types::Enumerator& e : type->enumerators) out.valueNames.emplace(e.value, e.name);
    while ((type->kind == TypeKind::Enum || type->kind == TypeKind::Subrange) && type->element.isValid())
        type = &table[type->element];
    switch (types::familyOf(type->kind)) {
    case types::Family::Bool:
        out.isBool = true;
        out.kind = ColumnKind::Bit;
        break;
    case types::Family::Bits:
    case types::Family::Signed:
    case types::Family::Unsigned:
        out.isInteger = true;
        out.kind = type->size <= 2
                       ? (type->size == 1 || types::familyOf(type->kind) == types::Family::Signed ? ColumnKind::Int16
                                                                                                  : ColumnKind::Int32)
                   : type->size == 4
                       ? (types::familyOf(type->kind) == types::Family::Signed ? ColumnKind::Int32 : ColumnKind::Double)
                   : types::familyOf(type->kind) == types::Family::Signed ? ColumnKind::Int64
                                                                          : ColumnKind::Uint64;
        break;
    case types::Family::Real:
        out.isSingle = type->size == 4;
        out.kind = out.isSingle ? ColumnKind::Float : ColumnKind::Double;
        break;
    case types::Family::Duration:
        out.isTime = true;
        out.kind = ColumnKind::Int64;
        break;
    case types::Family::Date:
    case types::Family::TimeOfDay:
    case types::Family::DateTime:
        out.isInteger = true;
        out.kind = ColumnKind::Int64;
        out.toText = [expression](int64_t value) {
            return types::toText(expression.types(), types::Value{expression.type(), value});
        };
        break;
    case types::Family::Character:
    case types::Family::Other:
        break;
    }
    return out;
}

} // namespace plc::trace
