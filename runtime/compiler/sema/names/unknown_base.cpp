#include "runtime/compiler/sema/names/unknown_base.h"

#include <algorithm>

namespace plc::sema {

bool hasUnknownBase(const Unit* unit) {
    for (; unit; unit = unit->base) {
        if (!unit->pou) return false;
        if (unit->kind == UnitKind::Block && !unit->base && !unit->pou->extends.empty()) return true;
        if (unit->kind == UnitKind::Interface)
            return unit->interfaces.size() < unit->pou->extends.size() ||
                   std::any_of(unit->interfaces.begin(), unit->interfaces.end(), hasUnknownBase);
    }
    return false;
}

} // namespace plc::sema
