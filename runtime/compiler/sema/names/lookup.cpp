// Name lookup: own unit, its bases, the namespace and those around it, USING, the project, then the libraries.
#include "runtime/compiler/sema/names/lookup.h"

#include "runtime/compiler/sema/context.h"

#include "runtime/base/text.h"

namespace plc::sema {
static Member findInInterfaces(Unit& first, NameId id);
static bool hasWanted(const Found& found, bool wantsType);
static Found lookupUsed(const std::vector<Space*>& used, NameId id, bool wantsType);

/// Interfaces may be reached on many ways; each is searched once.
Member findInInterfaces(Unit& first, NameId id) {
    // Depth first and in the order of EXTENDS. Diamonds of interfaces doubled the ways with each level, so what was
    // seen is not searched again.
    std::vector<Unit*> open{&first}, seen{&first};
    while (!open.empty()) {
        Unit& unit = *open.back();
        open.pop_back();
        if (const auto it = unit.members.find(id); it != unit.members.end()) return it->second;
        for (auto at = unit.interfaces.rbegin(); at != unit.interfaces.rend(); ++at) {
            if (std::find(seen.begin(), seen.end(), *at) != seen.end()) continue;
            seen.push_back(*at);
            open.push_back(*at);
        }
    }
    return {};
}

// The unit's own before its base's: overriding and hiding are the same look-up.
Member findMember(Unit& unit, NameId id) {
    if (unit.kind == UnitKind::Interface) return findInInterfaces(unit, id);
    for (Unit* at = &unit; at; at = at->base) {
        if (const auto it = at->members.find(id); it != at->members.end()) return it->second;
        // Only blocks and programs inherit members; a method's base would be the one it overrides.
        if (!at->isInstanced()) break;
    }
    return {};
}

// A name may be a variable, a unit and a type at once; who asks chooses by what is written around it (a call, a type, a
// value).
Found lookupIn(Space& space, NameId id) {
    Found found;
    if (const auto* entities = space.find(id)) {
        const Entity* variable = nullptr;
        std::vector<std::string> owners;
        for (const Entity& entity : *entities) {
            if (entity.variable) {
                owners.push_back(entity.variable->list ? entity.variable->list->name : space.qualified);
                if (!variable) variable = &entity;
            }
            if (entity.variable && !found.entity.variable) found.entity.variable = entity.variable;
            if (entity.unit && !found.entity.unit) found.entity.unit = entity.unit;
            if (entity.type && !found.entity.type) found.entity.type = entity.type;
        }
        // Two lists with the same global: GVL1.x or GVL2.x has to be said. With a unit of that name the call is meant.
        if (owners.size() > 1 && !found.entity.unit && !found.entity.type) found.ambiguous = std::move(owners);
    }
    if (const auto it = space.enumerators.find(id); it != space.enumerators.end()) found.enumerators = it->second;
    if (const auto it = space.lists.find(id); it != space.lists.end()) found.list = it->second;
    if (const auto it = space.spaces.find(id); it != space.spaces.end()) found.space = it->second;
    return found;
}

// x : Motor must not stop at a variable called motor: where a type is wanted, only types end the search.
bool hasWanted(const Found& f, bool wantsType) {
    return wantsType ? f.entity.type || (f.entity.unit && f.entity.unit->type.isValid()) || f.space : !f.isNothing();
}

/// Namespaces named by USING are equals: what two of them have must be written with its namespace (ed. 3, 6.9).
///   ok:    USING A; USING B; … x := A.F();      wrong: USING A; USING B; … x := F(); where both have F  (P2024)
Found lookupUsed(const std::vector<Space*>& used, NameId id, bool wantsType) {
    Found first;
    std::vector<std::string> where;
    bool onlyEnumerators = true; // which the type wanted can tell apart
    for (Space* space : used) {
        Found next = lookupIn(*space, id);
        if (!hasWanted(next, wantsType) || std::find(where.begin(), where.end(), space->qualified) != where.end())
            continue;
        where.push_back(space->qualified);
        onlyEnumerators = onlyEnumerators && !next.enumerators.empty() && !next.entity.variable && !next.entity.unit &&
                          !next.entity.type && !next.list && !next.space;
        if (where.size() == 1)
            first = std::move(next);
        else
            first.enumerators.insert(first.enumerators.end(), next.enumerators.begin(), next.enumerators.end());
    }
    if (where.size() > 1 && !onlyEnumerators) first.ambiguous = std::move(where);
    return first;
}

/// What a name means, from the inside out: the unit, the blocks around it, what it uses (USING), its namespaces, the
/// file's USINGs, the top, and last the libraries, so that a new name in a library never changes what a program means.
Found lookup(const World& world, const Scope& scope, NameId id, bool wantsType) {
    if (!id.isValid()) return {};
    Found found;
    const auto isEnough = [&](const Found& f) { return hasWanted(f, wantsType); };
    const auto enumeratorsIn = [&](Unit& unit) {
        const auto it = unit.enumerators.find(id);
        if (it != unit.enumerators.end() && found.enumerators.empty()) found.enumerators = it->second;
    };
    // From inside out: the method's own, the block's, its bases'. The first that has anything ends the search (edition
    // 3, 6.6.5): an inner name hides, it does not overload.
    if (scope.unit && !wantsType) {
        found.member = findMember(*scope.unit, id);
        enumeratorsIn(*scope.unit);
        Unit* self = scope.unit->self();
        for (Unit* owner = scope.unit->owner; owner && !found.member; owner = owner->owner) {
            found.member = findMember(*owner, id);
            enumeratorsIn(*owner);
        }
        for (Unit* base = self; base && found.enumerators.empty(); base = base->base) enumeratorsIn(*base);
        if (!found.isNothing()) return found;
    }
    for (const Unit* unit = scope.unit; unit; unit = unit->owner) {
        const auto used = world.unitUsings.find(unit);
        if (used == world.unitUsings.end()) continue;
        found = lookupUsed(used->second, id, wantsType);
        if (isEnough(found)) return found;
    }
    // The top is the last of the enclosing namespaces, unless the scope is in a library, whose spaces end elsewhere.
    bool searchedTop = false;
    for (Space* space = scope.space; space; space = space->parent) {
        searchedTop = searchedTop || space == &world.top;
        found = lookupIn(*space, id);
        if (isEnough(found)) return found;
        found = lookupUsed(space->usings, id, wantsType);
        if (isEnough(found)) return found;
    }
    if (const auto it = world.fileUsings.find(scope.file); it != world.fileUsings.end()) {
        found = lookupUsed(it->second, id, wantsType);
        if (isEnough(found)) return found;
    }
    if (!searchedTop) {
        found = lookupIn(world.top, id);
        if (isEnough(found)) return found;
    }
    std::vector<std::string> where;
    Found first;
    for (Space* library : world.libraries) {
        Found next = lookupIn(*library, id);
        if (!isEnough(next)) continue;
        where.push_back(library->name);
        if (where.size() == 1) first = std::move(next);
    }
    if (where.size() > 1) first.ambiguous = std::move(where);
    return first;
}

Found lookupPath(const World& world, const Scope& scope, const syntax::Path& path) {
    if (path.empty()) return {};
    Found found = lookup(world, scope, world.names.find(path.front().text), true);
    for (size_t i = 1; i < path.size(); ++i) {
        if (!found.space) return {};
        found = lookupIn(*found.space, world.names.find(path[i].text));
    }
    return found;
}

/// What a namespace has, in no order: for suggestions.
void addNames(const World& world, const Space& space, std::vector<std::string>& out) {
    for (const auto& [id, entities] : space.entities)
        for (const Entity& entity : entities)
            out.push_back(entity.variable ? entity.variable->name
                          : entity.unit   ? entity.unit->name
                                          : entity.type->name);
    for (const auto& [id, refs] : space.enumerators)
        out.push_back(world.types[refs.front().type->type].enumerators[refs.front().index].name);
    for (const auto& [id, list] : space.lists)
        if (!list->name.empty()) out.push_back(list->name);
    for (const auto& [id, child] : space.spaces) out.push_back(child->name);
}

// Thousands of names in a large project: it is asked at an unknown name only, and maySuggest ends that.
std::vector<std::string> visibleNames(const World& world, const Scope& scope) {
    std::vector<std::string> out;
    const auto addUnit = [&](const Unit& unit) {
        for (const Variable& variable : unit.variables) out.push_back(variable.name);
        for (const Unit* method : unit.methods)
            if (method->kind == UnitKind::Method) out.push_back(method->name);
        for (const Unit* action : unit.actions) out.push_back(action->name);
        for (const Property* property : unit.properties) out.push_back(property->name);
        for (const auto& [id, refs] : unit.enumerators)
            out.push_back(world.types[refs.front().type->type].enumerators[refs.front().index].name);
    };
    for (Unit* unit = scope.unit; unit; unit = unit->owner)
        for (Unit* base = unit; base; base = base->base) addUnit(*base);
    const auto addSpaces = [&](const std::vector<Space*>& spaces) {
        for (const Space* space : spaces) addNames(world, *space, out);
    };
    for (const Unit* unit = scope.unit; unit; unit = unit->owner)
        if (const auto it = world.unitUsings.find(unit); it != world.unitUsings.end()) addSpaces(it->second);
    for (Space* space = scope.space; space; space = space->parent) {
        addNames(world, *space, out);
        addSpaces(space->usings);
    }
    if (const auto it = world.fileUsings.find(scope.file); it != world.fileUsings.end()) addSpaces(it->second);
    addSpaces(world.libraries);
    for (const library::Signature& signature : library::signatures()) out.emplace_back(signature.name);
    return out;
}

std::vector<std::string> memberNames(const World& world, TypeId type) {
    std::vector<std::string> out;
    for (const types::Field& field : world.types[type].fields)
        if (!field.isPrivate) out.push_back(field.name);
    for (Unit* unit = world.unitOf(type); unit; unit = unit->base) {
        for (const auto& [id, member] : unit->members) {
            if (member.variable) out.push_back(member.variable->name);
            if (member.unit) out.push_back(member.unit->name);
            if (member.property) out.push_back(member.property->name);
        }
        for (const Unit* interface : unit->interfaces)
            for (const Unit* method : interface->methods) out.push_back(method->name);
    }
    for (const types::Enumerator& enumerator : world.types[type].enumerators) out.push_back(enumerator.name);
    return out;
}

static void offerNearest(diagnostics::Diagnostic& diagnostic, SourceRange range, std::string_view name,
                         const std::vector<std::string>& candidates) {
    if (const std::optional<std::string> near = nearestName(name, candidates))
        diagnostic.fixes.push_back({fixes::DidYouMean(*near), {{range, *near}}});
}

bool maySuggest(const Context& context) {
    return context.isExpression || context.gathered.suggestions <= kMaximumSuggestions;
}

/// The near name costs a look at every name in sight: a text full of unknown names stops asking for it.
void suggest(Gathered& gathered, diagnostics::Diagnostic& diagnostic, SourceRange range, std::string_view name,
             const std::vector<std::string>& candidates) {
    if (name.size() < 3) return; // everything is near to it
    if (++gathered.suggestions <= kMaximumSuggestions) offerNearest(diagnostic, range, name, candidates);
}

void suggest(Context& context, diagnostics::Diagnostic& diagnostic, SourceRange range, std::string_view name,
             const std::vector<std::string>& candidates) {
    if (!context.isExpression) return suggest(context.gathered, diagnostic, range, name, candidates);
    if (name.size() >= 3) offerNearest(diagnostic, range, name, candidates);
}

} // namespace plc::sema
