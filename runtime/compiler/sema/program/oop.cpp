// EXTENDS, IMPLEMENTS, overriding, access, and the slots of dispatched methods (one per method name, program-wide).
#include "runtime/compiler/sema/program/oop.h"

#include "runtime/compiler/sema/context.h"
#include "runtime/compiler/sema/declare/generic_blocks.h"
#include "runtime/compiler/sema/layout/units.h"
#include "runtime/compiler/sema/names/lookup.h"
#include "runtime/compiler/sema/program/analyze.h"
#include "runtime/compiler/sema/types/type_specs.h"

#include "runtime/base/text.h"

namespace plc::sema {

// Copied once its base is resolved: look-up then finds both accessors in one property.
/// A property that a block overrides by one accessor has the other one of its base.
static void inheritAccessors(Unit& unit) {
    for (Property* own : unit.properties)
        for (const Property* inherited : unit.base->properties) {
            if (inherited->id != own->id) continue;
            if (!own->get) own->get = inherited->get;
            if (!own->set) own->set = inherited->set;
        }
}

/// EXTENDS and IMPLEMENTS of a unit, its bases first: whoever asks for a member may rely on the whole chain.
///   ok:    FUNCTION_BLOCK B EXTENDS A      wrong: FUNCTION_BLOCK A EXTENDS A  (P3003)
void resolveBases(WorldBuilder& world, Unit& unit) {
    if (unit.baseProgress != Progress::Open) return;
    unit.baseProgress = Progress::Working;
    // Bases are resolved by recursion; the depth is bounded before the C++ stack is.
    const Waiting wait(world.waiting, kMaximumWaiting / kMaximumBases);
    const auto resolve = [&](const syntax::Path& path, bool wantsInterface) -> Unit* {
        if (path.empty()) return nullptr;
        const SourceRange range = joined(path.front().range, path.back().range);
        // Not seen from inside the unit: a member of the same name as the base must not be found.
        Scope outside{nullptr, unit.space, unit.file};
        const Found found = lookupPath(world, outside, path);
        std::string text;
        for (const syntax::Name& name : path) text += (text.empty() ? "" : ".") + std::string(name.text);
        Unit* base = found.entity.unit;
        if (!base) {
            std::vector<std::string> candidates;
            for (const Unit& other : world.units)
                if (other.kind == (wantsInterface ? UnitKind::Interface : UnitKind::Block))
                    candidates.push_back(other.name);
            suggest(world, world.emit(range, findings::UnknownType(text)), range, text, candidates);
            return nullptr;
        }
        refer(world, path.back().range, base->symbol, true, false);
        if (base->kind != (wantsInterface ? UnitKind::Interface : UnitKind::Block)) {
            world.emit(range, findings::NotExtendable(base->name, unit.name));
            return nullptr;
        }
        if (base->isFinal) {
            world.emit(range, findings::FinalExtended(base->name));
            return nullptr;
        }
        if (!wait.isTooDeep) resolveBases(world, *base);
        // A extends B extends A: the one that closes the circle has no base, the others keep theirs.
        if (base->baseProgress == Progress::Working) {
            world.emit(range, findings::TypeCycle(unit.name));
            return nullptr;
        }
        // Open: it was not resolved because too many wait already.
        if (base->baseProgress == Progress::Open || base->level >= kMaximumBases) {
            world.emit(range, findings::NestedTooDeep());
            return nullptr;
        }
        unit.level = std::max(unit.level, base->level + 1);
        return base;
    };
    if (unit.pou && !unit.owner) {
        if (unit.kind == UnitKind::Interface) {
            for (const syntax::Path& path : unit.pou->extends)
                if (Unit* base = resolve(path, true)) unit.interfaces.push_back(base);
        } else if (unit.kind == UnitKind::Block) {
            for (const syntax::Path& path : unit.pou->extends) {
                // Base<100>: the values are seen from the unit itself, whose own constants they may be.
                const bool hasValues =
                    unit.pou->result && !unit.pou->result->bounds.empty() && &path == &unit.pou->extends.front();
                const auto generic = hasValues ? pathOfGeneric(world, *unit.pou->result, {&unit, unit.space, unit.file})
                                               : std::optional(path);
                Unit* base = generic ? resolve(*generic, false) : nullptr;
                if (!base) continue;
                // Blocks have one base; several are interfaces' privilege (6.6.7).
                if (unit.base)
                    world.emit(joined(path.front().range, path.back().range),
                               findings::NotExtendable(base->name, unit.name));
                else
                    unit.base = base;
            }
            if (unit.base) {
                unit.base->isExtended = true;
                inheritAccessors(unit);
            }
        } else if (!unit.pou->extends.empty() && !unit.pou->extends.front().empty()) {
            world.emit(unit.pou->extends.front().front().range,
                       findings::NotAllowedHere(Verbatim("EXTENDS"), unit.kind == UnitKind::Program
                                                                         ? phrases::InAProgram()
                                                                         : phrases::InAFunction()));
        }
        for (const syntax::Path& path : unit.pou->implements)
            if (Unit* interface = resolve(path, true)) unit.interfaces.push_back(interface);
        if (unit.type.isValid()) {
            types::Type& type = world.types.edit(unit.type);
            if (unit.base) type.base = unit.base->type;
            for (const Unit* interface : unit.interfaces) type.interfaces.push_back(interface->type);
        }
    }
    unit.baseProgress = Progress::Done;
}

bool isAccessible(syntax::Access access, const Unit* owner, const Scope& from) {
    if (access == syntax::Access::Default || access == syntax::Access::Public || !owner) return true;
    const Unit* self = from.unit ? from.unit->self() : nullptr;
    switch (access) {
    case syntax::Access::Private:
        return self == owner;
    case syntax::Access::Protected:
        for (const Unit* at = self; at; at = at->base)
            if (at == owner) return true;
        return false;
    // INTERNAL is visible in its namespace (edition 3, 6.6.5).
    case syntax::Access::Internal:
        return from.space == owner->space;
    default:
        return true;
    }
}

namespace {

// Names of parameters do not count: the call binds by those of the declared type, the override may call them otherwise.
std::vector<std::pair<types::TypeId, syntax::SectionKind>> shapeOf(WorldBuilder& world, Unit& unit) {
    std::vector<std::pair<types::TypeId, syntax::SectionKind>> out;
    collectParameters(world, unit);
    for (Variable* parameter : unit.parameters) out.emplace_back(typeOf(world, *parameter), parameter->kind);
    return out;
}

bool sameShape(WorldBuilder& world, Unit& a, Unit& b) {
    const auto x = shapeOf(world, a), y = shapeOf(world, b);
    if (x.size() != y.size()) return false;
    for (size_t i = 0; i < x.size(); ++i)
        if (x[i].second != y[i].second || !sameType(world, x[i].first, y[i].first)) return false;
    const auto result = [&](Unit& unit) {
        return unit.resultVariable ? typeOf(world, *unit.resultVariable) : types::TypeTable::of(TypeKind::Void);
    };
    return sameType(world, result(a), result(b));
}

void collectInterfaces(WorldBuilder& world, Unit& unit, std::vector<Unit*>& out) {
    resolveBases(world, unit);
    for (Unit* interface : unit.interfaces) {
        // Diamonds: each interface once, or the ways double with each level.
        if (std::find(out.begin(), out.end(), interface) != out.end()) continue;
        out.push_back(interface);
        collectInterfaces(world, *interface, out);
    }
}

/// FB_init is called for its own block with its own parameters, never in place of its base's.
bool isInitializer(const Unit& method) { return equalsIgnoringCase(method.name, "FB_init"); }

/// Methods by name, the unit's own before its bases'.
Unit* methodNamed(Unit& unit, NameId id) {
    for (Unit* at = &unit; at; at = at->base)
        for (Unit* method : at->methods)
            if (method->id == id) return method;
    return nullptr;
}

} // namespace

namespace {

/// The names behind IMPLEMENTS, as far as they are there.
SourceRange implementsRange(const Unit& unit) {
    SourceRange range;
    for (const syntax::Path& path : unit.pou->implements) {
        if (path.empty()) continue;
        const SourceRange here = joined(path.front().range, path.back().range);
        range = range.file.isValid() ? joined(range, here) : here;
    }
    return range.file.isValid() ? range : unit.range;
}

} // namespace

namespace {

/// The fix that writes a property of an interface, with the accessors it wants, before END_FUNCTION_BLOCK.
void addProperty(const World& world, const Unit& unit, const Property& property, diagnostics::Diagnostic& diagnostic) {
    constexpr std::string_view end = "END_FUNCTION_BLOCK";
    const std::string_view whole = world.textOf(unit.pou->range);
    if (!unit.pou->hasEnd || whole.size() <= end.size() ||
        !equalsIgnoringCase(whole.substr(whole.size() - end.size()), end))
        return;
    if (std::any_of(unit.properties.begin(), unit.properties.end(),
                    [&](const Property* own) { return own->id == property.id; }))
        return; // one accessor is there
    // The interface's own text, so that types and comments come out as written there.
    std::string text = "PROPERTY " + property.name + " : " + world.nameOf(property.type) + "\n";
    if (property.get) text += "GET\n;\nEND_GET\n";
    if (property.set) text += "SET\n;\nEND_SET\n";
    const auto place = unit.pou->range.end - static_cast<uint32_t>(end.size());
    diagnostic.fixes.push_back(
        {fixes::AddProperty(property.name), {{{unit.range.file, place, place}, text + "END_PROPERTY\n"}}});
}

} // namespace

/// What a block takes over is kept (edition 3, 6.6.5 to 6.6.7).
///   wrong: FUNCTION_BLOCK B IMPLEMENTS I  without the METHOD M of I (P3014)
///          METHOD M : REAL  where the base has METHOD M : INT (P3015)   METHOD OVERRIDE N  where no base has N (P3034)
void checkInheritance(WorldBuilder& world, Unit& unit) {
    for (Unit* method : unit.methods) {
        Unit* overridden = unit.base ? methodNamed(*unit.base, method->id) : nullptr;
        if (overridden) {
            // From here on calls of it are dispatched; prepareCall reads this, so it must run before the bodies.
            overridden->isOverridden = true;
            if (overridden->isFinal)
                world.emit(method->range, findings::FinalExtended(overridden->qualified));
            else if (!isInitializer(*method) && !sameShape(world, *method, *overridden))
                world.emit(method->range, findings::OverrideDiffers(method->name))
                    .related.push_back({overridden->range, notes::OverriddenHere()});
        } else if (method->isOverride) {
            std::vector<std::string> candidates;
            for (Unit* at = unit.base; at; at = at->base)
                for (const Unit* other : at->methods) candidates.push_back(other->name);
            suggest(world, world.emit(method->range, findings::OverridesNothing(method->name)), method->range,
                    method->name, candidates);
        }
        if (method->isAbstract && unit.kind == UnitKind::Block && !unit.isAbstract)
            world.emit(method->range,
                       findings::NotAllowedHere(Verbatim("ABSTRACT"), phrases::InNotAbstract(unit.name)));
    }
    if (unit.kind != UnitKind::Block) return;
    std::vector<Unit*> interfaces;
    for (Unit* at = &unit; at; at = at->base) collectInterfaces(world, *at, interfaces);
    // An abstract block may leave methods to those that extend it.
    if (unit.isAbstract) return;
    for (Unit* interface : interfaces) {
        for (Unit* wanted : interface->methods) {
            Unit* made = methodNamed(unit, wanted->id);
            const SourceRange at = implementsRange(unit);
            if (!made || made->isAbstract) {
                const Property* property = wanted->property;
                // A missing property lacks two accessors; one message is enough.
                if (property && wanted == property->set && property->get && !methodNamed(unit, property->get->id))
                    continue; // told with GET
                auto& diagnostic =
                    world.emit(at, findings::NotInterfaceImplemented(
                                       unit.name, property ? property->name : wanted->name, interface->name));
                if (property && !made) addProperty(world, unit, *property, diagnostic);
                if (!made && wanted->kind == UnitKind::Method && unit.pou->hasEnd && unit.pou->range.file.isValid()) {
                    std::string text =
                        "METHOD " + wanted->name +
                        (wanted->pou->result ? " : " + std::string(world.textOf(wanted->pou->result->range))
                                             : std::string()) +
                        "\n";
                    for (const syntax::VarSection* section : wanted->pou->sections)
                        text += std::string(world.textOf(section->range)) + "\n";
                    text += ";\nEND_METHOD\n";
                    const std::string_view whole = world.textOf(unit.pou->range);
                    const std::string_view end = "END_FUNCTION_BLOCK";
                    if (whole.size() > end.size()) {
                        const auto place = unit.pou->range.end - static_cast<uint32_t>(end.size());
                        if (equalsIgnoringCase(whole.substr(whole.size() - end.size()), end))
                            diagnostic.fixes.push_back(
                                {fixes::AddMethod(wanted->name), {{{unit.range.file, place, place}, text}}});
                    }
                }
            } else if (!sameShape(world, *made, *wanted)) {
                world.emit(made->range, findings::OverrideDiffers(made->name))
                    .related.push_back({wanted->range, notes::DeclaredHere()});
            }
        }
    }
    // an abstract method of a base must be there
    for (Unit* at = unit.base; at; at = at->base)
        for (Unit* wanted : at->methods)
            if (wanted->isAbstract && methodNamed(unit, wanted->id) == wanted)
                world.emit(unit.range, findings::NotInterfaceImplemented(unit.name, wanted->name, at->name));
}

// One number for a method's name, program-wide: a row of the table is as long as there are names, and finding a method
// through any interface is one look-up. Programs have few enough blocks for that.
void assignSlots(WorldBuilder& world) {
    std::unordered_map<NameId, uint32_t> slots;
    // The body of a block is called like a method, by a name that nobody can write.
    const NameId body = world.key("()");
    const auto slotOf = [&](NameId id) {
        const auto [it, isNew] = slots.try_emplace(id, static_cast<uint32_t>(slots.size()));
        if (isNew) world.slotNames.push_back(id);
        return it->second;
    };
    for (Unit& unit : world.units) {
        if (unit.owner && (unit.kind == UnitKind::Method || unit.kind == UnitKind::PropertyGet ||
                           unit.kind == UnitKind::PropertySet)) {
            unit.slot = slotOf(unit.id);
            world.functions[unit.function.index()].methodSlot = unit.slot;
        } else if (unit.kind == UnitKind::Block && unit.hasHeader) {
            unit.slot = slotOf(body);
            world.functions[unit.function.index()].methodSlot = unit.slot;
            if (unit.isExtended) unit.isOverridden = true;
        }
    }
}

// Rows by block number, columns by slot; what is not filled is a method that the block does not have.
void buildDispatch(WorldBuilder& world) {
    uint32_t blocks = 0;
    for (const Unit& unit : world.units)
        if (unit.isInstanced()) blocks = std::max(blocks, world.types[unit.type].blockNumber);
    world.program->dispatch.assign(blocks + 1, {});
    for (Unit& unit : world.units) {
        if (!unit.isInstanced() || !unit.hasHeader) continue;
        // From the block to its bases: the first that has the method wins.
        std::vector<tree::FunctionId>& row = world.program->dispatch[world.types[unit.type].blockNumber];
        row.assign(world.slotNames.size(), tree::FunctionId());
        for (Unit* at = &unit; at; at = at->base) {
            for (Unit* method : at->methods)
                if (!row[method->slot].isValid() && !method->isAbstract) row[method->slot] = method->function;
            if (at->slot != Id<int>::kNone && !row[at->slot].isValid()) row[at->slot] = at->function;
        }
    }
}

} // namespace plc::sema
