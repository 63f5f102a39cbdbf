// Units whose base is not known (a missing library, a misspelt name). What they inherit cannot be told, so nobody is
// reported for using it: one message at EXTENDS instead of one at each use.
#include "runtime/compiler/sema/names/unknown_base.h"

#include <unordered_set>

namespace plc::sema {
namespace {

/// Interfaces can be reached on very many ways: each is looked at once.
bool reachesUnknown(const Unit& interface, std::unordered_set<const Unit*>& seen) {
    if (!seen.insert(&interface).second || !interface.pou) return false;
    // Fewer were resolved than written.
    if (interface.interfaces.size() < interface.pou->extends.size()) return true;
    for (const Unit* base : interface.interfaces)
        if (base && reachesUnknown(*base, seen)) return true;
    return false;
}

} // namespace

bool hasUnknownBase(const Unit* unit) {
    for (; unit; unit = unit->base) {
        if (!unit->pou) return false;
        if (unit->kind == UnitKind::Block && !unit->base && !unit->pou->extends.empty()) return true;
        if (unit->kind == UnitKind::Interface) {
            std::unordered_set<const Unit*> seen;
            return reachesUnknown(*unit, seen);
        }
    }
    return false;
}

} // namespace plc::sema
