// CONFIGURATION: globals, program instances, VAR_CONFIG and VAR_ACCESS.
#include "runtime/compiler/sema/declare/configuration.h"

#include "runtime/compiler/sema/context.h"
#include "runtime/compiler/sema/declare/declare.h"
#include "runtime/compiler/sema/layout/addresses.h"
#include "runtime/compiler/sema/layout/initial_values.h"
#include "runtime/compiler/sema/layout/layout.h"
#include "runtime/compiler/sema/names/lookup.h"
#include "runtime/compiler/sema/program/analyze.h"
#include "runtime/compiler/sema/types/type_specs.h"

#include "runtime/base/text.h"

#include <set>

namespace plc::sema {

using syntax::SectionKind;

static void addAccess(WorldBuilder& world, const syntax::VarDecl& declaration, const image::Place& place,
                      std::string list);
static void accessAddress(WorldBuilder& world, const syntax::VarDecl& declaration, const Scope& scope);
static void accessPrograms(WorldBuilder& world);

void forEachResource(const World& world,
                     const std::function<void(const Configuration&, const syntax::ResourceDecl&)>& visit) {
    for (const Configuration& configuration : world.configurations)
        for (const syntax::ResourceDecl* resource : configuration.declaration->resources)
            visit(configuration, *resource);
}

// Names of one RESOURCE are seen everywhere as long as no other has the same; only then do they need R1. before them.
// Most configurations have one RESOURCE and never see the difference.
/// The folded names of a RESOURCE's globals, or of its program instances.
static std::set<NameId> namesOf(WorldBuilder& world, const syntax::ResourceDecl& resource, bool ofPrograms) {
    std::set<NameId> out;
    if (ofPrograms)
        for (const syntax::ProgramInstance* each : resource.programs) out.insert(world.key(each->name.text));
    else
        for (const syntax::VarSection* section : resource.sections)
            if (section->kind == SectionKind::Global)
                for (const syntax::VarDecl* declaration : section->declarations)
                    for (const syntax::Name& name : declaration->names) out.insert(world.key(name.text));
    return out;
}

/// Whether another RESOURCE has one of these names: both then belong to their resource, R1.g and R2.g.
static bool isInAnother(WorldBuilder& world, const Configuration& configuration, const syntax::ResourceDecl& resource,
                        bool ofPrograms, const std::set<NameId>& names) {
    for (const syntax::ResourceDecl* other : configuration.declaration->resources) {
        if (other == &resource) continue;
        const std::set<NameId> theirs = namesOf(world, *other, ofPrograms);
        if (std::any_of(names.begin(), names.end(), [&](NameId id) { return theirs.count(id) != 0; })) return true;
    }
    return false;
}

// What VAR_EXTERNAL refers to. A name that several RESOURCEs have is that of the RESOURCE which runs the program, as
// far as only one does (edition 2, 2.7.1).
Variable* globalOf(WorldBuilder& world, const Variable& external) {
    Scope outside = external.scope;
    outside.unit = nullptr;
    const Found found = lookup(world, outside, external.id);
    if (found.ambiguous.empty()) return found.entity.variable;
    std::set<const syntax::ResourceDecl*> resources; // that run the program
    const Unit* program = external.owner ? external.owner->self() : nullptr;
    for (const Instance& instance : world.instances)
        if (instance.variable->program == program && instance.resource) resources.insert(instance.resource);
    for (const GlobalsList& list : world.lists)
        if (resources.size() == 1 && equalsIgnoringCase(list.name, (*resources.begin())->name.text))
            if (const auto it = list.variables.find(external.id); it != list.variables.end()) return it->second;
    world.emit(external.range, findings::AmbiguousName(external.name, found.ambiguous));
    return found.entity.variable;
}

void declareConfigurations(WorldBuilder& world) {
    // VAR in a CONFIGURATION or RESOURCE is not in the standard but in the wild; it means VAR_GLOBAL.
    const auto sections = [&](const std::vector<syntax::VarSection*>& list, const Configuration& configuration,
                              std::string_view name) {
        for (syntax::VarSection* section : list) {
            if (section->kind != SectionKind::Global && section->kind != SectionKind::Var) continue;
            auto* globalList = world.arena.make<syntax::GlobalList>();
            globalList->section = section;
            declareGlobals(world, *globalList, *configuration.space, *configuration.file, name);
        }
    };
    for (const Configuration& configuration : world.configurations)
        sections(configuration.declaration->sections, configuration, {});
    forEachResource(world, [&](const Configuration& configuration, const syntax::ResourceDecl& resource) {
        const bool isShared = isInAnother(world, configuration, resource, false, namesOf(world, resource, false));
        sections(resource.sections, configuration, isShared ? resource.name.text : std::string_view());
        if (isShared || !isInAnother(world, configuration, resource, true, namesOf(world, resource, true))) return;
        // A list without variables: the name alone makes R1.A possible.
        auto* none = world.arena.make<syntax::GlobalList>(); // R1.A names an instance, also where R1 has no globals
        none->section = world.arena.make<syntax::VarSection>();
        none->section->kind = SectionKind::Global;
        declareGlobals(world, *none, *configuration.space, *configuration.file, resource.name.text);
    });

    const auto addInstance = [&](Unit& unit, std::string name, const syntax::ProgramInstance* declaration,
                                 const syntax::ResourceDecl* resource, Scope scope, std::string_view resourceName) {
        Variable& variable = world.globals.emplace_back();
        variable.name = std::move(name);
        variable.id = world.key(variable.name);
        variable.range = declaration ? declaration->name.range : unit.range;
        variable.kind = SectionKind::Global;
        variable.scope = scope;
        variable.space = &world.top;
        variable.type = unit.type;
        variable.typeProgress = Progress::Done;
        variable.isProgramInstance = true;
        variable.program = &unit;
        variable.symbol =
            declaration ? addSymbol(world, SymbolKind::Variable, variable.name, {}, variable.range) : unit.symbol;
        if (declaration) {
            world.symbols[variable.symbol.index()].type = unit.type;
            world.symbols[variable.symbol.index()].path =
                (resourceName.empty() ? "" : std::string(resourceName) + ".") + variable.name;
            if (std::any_of(world.instances.begin(), world.instances.end(), [&](const Instance& other) {
                    return other.variable->id == variable.id && (other.resource == resource || resourceName.empty());
                }))
                world.emit(variable.range, findings::DuplicateName(variable.name));
            if (!equalsIgnoringCase(variable.name, unit.name))
                world.top.entities[variable.id].push_back({&variable, nullptr, nullptr});
        }
        // With one instance the program's name means it (Main.x); with a second one it would be ambiguous.
        ++unit.instanceCount;
        unit.instance = unit.instanceCount == 1 ? &variable : nullptr;
        world.instances.push_back({&variable, declaration, resource, scope, 0, std::string(resourceName)});
    };
    forEachResource(world, [&](const Configuration& configuration, const syntax::ResourceDecl& resource) {
        const Scope scope{nullptr, configuration.space, configuration.file};
        for (const syntax::ProgramInstance* declared : resource.programs) {
            if (declared->type.empty()) continue;
            const SourceRange range = joined(declared->type.front().range, declared->type.back().range);
            Unit* unit = lookupPath(world, scope, declared->type).entity.unit;
            if (!unit || unit->kind != UnitKind::Program) {
                std::vector<std::string> candidates;
                for (const Unit& other : world.units)
                    if (other.kind == UnitKind::Program) candidates.push_back(other.name);
                suggest(world, world.emit(range, findings::UnknownType(world.textOf(range))), range,
                        world.textOf(range), candidates);
                continue;
            }
            refer(world, range, unit->symbol, true, false);
            const bool isShared = isInAnother(world, configuration, resource, true, {world.key(declared->name.text)});
            addInstance(*unit, std::string(declared->name.text), declared, &resource, scope,
                        isShared ? resource.name.text : std::string_view());
        }
    });
    for (Unit& unit : world.units)
        if (unit.kind == UnitKind::Program && !unit.isLibrary() && unit.instanceCount == 0)
            addInstance(unit, unit.name, nullptr, nullptr, {nullptr, &world.top, unit.file}, {});
}

void addAccess(WorldBuilder& world, const syntax::VarDecl& declaration, const image::Place& place, std::string list) {
    for (const syntax::Name& name : declaration.names) {
        image::Root& root = world.program->layout.roots.emplace_back();
        root.name = std::string(name.text);
        root.list = list;
        root.type = place.type;
        root.offset = place.offset;
        root.bit = place.bit;
        root.constant = declaration.isReadOnly;
        root.declaration = name.range;
        // A second name for the same bytes: shown in no list, recorded and saved only once.
        root.isHidden = true;
    }
}

/// VAR_ACCESS valve : R1.%QX0.1 : BOOL READ_ONLY;
void accessAddress(WorldBuilder& world, const syntax::VarDecl& declaration, const Scope& scope) {
    const auto address = addressIn(world, declaration.address);
    if (!address || address->isOpen) {
        world.emit(declaration.addressRange, findings::AddressOutOfRange(declaration.address, addressAreas()));
        return;
    }
    const TypeId own = types::TypeTable::of(address->kind),
                 type = declaration.type ? resolveSpec(world, declaration.type, scope) : own;
    if (world.types.kind(type) == TypeKind::Unknown) return;
    const bool isBit = world.types.storageKind(type) == TypeKind::Bool;
    if (isBit != (address->kind == TypeKind::Bool) || (!isBit && world.types[type].size != world.types[own].size)) {
        world.emit(declaration.type->range, findings::TypeMismatch(world.nameOf(own), world.nameOf(type)));
        return;
    }
    addAccess(world, declaration,
              {type, areaOf(world, address->area).begin + address->byte, isBit ? address->bit : int16_t(-1)}, {});
}

// After the layout: a path such as motor.speed is found in the finished image.
/// VAR_ACCESS of a PROGRAM: names below each of its instances, `i1.level`.
void accessPrograms(WorldBuilder& world) {
    for (const Instance& instance : world.instances) {
        const Unit& unit = *instance.variable->program;
        for (const syntax::VarSection* section : unit.pou->sections) {
            if (section->kind != SectionKind::Access) continue;
            for (const syntax::VarDecl* declaration : section->declarations) {
                std::string text = instance.variable->name;
                for (const syntax::Name& name : declaration->configPath) text += "." + std::string(name.text);
                if (!declaration->address.empty())
                    accessAddress(world, *declaration, {nullptr, unit.space, unit.file});
                else if (const auto found = world.program->layout.find(text))
                    addAccess(world, *declaration, *found, instance.variable->name);
                else
                    world.emit(declaration->range, findings::ConfigTarget(text));
            }
        }
    }
}

/// VAR_CONFIG: addresses and initial values of variables inside instances; VAR_ACCESS: other names for them.
///   ok:    VAR_CONFIG I.x : INT := 5; END_VAR      wrong: VAR_CONFIG I.missing : INT := 5; END_VAR  (P3028)
///          VAR_CONFIG I.x AT %QW* : INT; END_VAR  (P3029)
void applyVarConfig(WorldBuilder& world) {
    const auto apply = [&](const syntax::VarSection& section, const Configuration& configuration,
                           const syntax::ResourceDecl* resource) {
        const Scope scope{nullptr, configuration.space, configuration.file};
        for (const syntax::VarDecl* declaration : section.declarations) {
            syntax::Path path = declaration->configPath;
            if (section.kind == SectionKind::Access && !declaration->address.empty()) {
                accessAddress(world, *declaration, scope);
                continue;
            }
            if (path.empty()) continue;
            const SourceRange range = joined(path.front().range, path.back().range);
            // Paths may begin with the configuration's and the resource's name (2.7.1); the image has neither.
            const auto dropFirst = [&](const syntax::Name& name) {
                if (path.size() > 1 && name.isValid() && equalsIgnoringCase(path.front().text, name.text))
                    path.erase(path.begin());
            };
            dropFirst(configuration.declaration->name);
            for (const syntax::ResourceDecl* each : configuration.declaration->resources)
                if (!resource || each == resource) dropFirst(each->name);
            std::string text;
            for (const syntax::Name& name : path) text += (text.empty() ? "" : ".") + std::string(name.text);
            const auto found = world.program->layout.find(text);
            if (!found) {
                world.emit(range, findings::ConfigTarget(text));
                continue;
            }
            const TypeId type = declaration->type ? resolveSpec(world, declaration->type, scope) : found->type;
            if (!sameType(world, type, found->type)) {
                world.emit(declaration->type->range,
                           findings::TypeMismatch(world.nameOf(found->type), world.nameOf(type)));
                continue;
            }
            if (section.kind == SectionKind::Access) {
                addAccess(world, *declaration, *found, {});
                continue;
            }
            // The copy runs with the task of the instance that holds the variable, before its inputs or after its
            // outputs.
            uint32_t rootIndex = 0;
            for (const Instance& instance : world.instances)
                if (found->offset >= instance.variable->offset &&
                    found->offset < instance.variable->offset + world.types[instance.variable->type].size)
                    rootIndex = instance.root;
            if (!declaration->address.empty()) {
                const auto address = addressIn(world, declaration->address);
                if (!address || address->isOpen) {
                    world.emit(declaration->addressRange.file.isValid() ? declaration->addressRange : range,
                               findings::AddressMissing(text));
                } else {
                    const image::AreaRange area = areaOf(world, address->area);
                    Copy copy;
                    copy.data = *found;
                    copy.address = {found->type, area.begin + address->byte,
                                    world.types.storageKind(found->type) == TypeKind::Bool ? address->bit
                                                                                           : int16_t(-1)};
                    copy.isInput = address->area == image::Area::Input;
                    copy.root = rootIndex;
                    world.copies.push_back(copy);
                    // Memory has no direction; whoever wrote last must win, so it is copied in before and out after the
                    // program.
                    if (address->area == image::Area::Memory) { // both ways
                        copy.isInput = true;
                        world.copies.push_back(copy);
                    }
                    const NameId last = world.key(path.back().text);
                    for (Located& open : world.openAddresses)
                        if (open.variable->id == last) open.isCompleted = true;
                }
            }
            if (declaration->initial) {
                InitialValue initial;
                // The value of VAR_CONFIG is written over that of the declaration: members it does not name keep
                // theirs.
                initial.bytes.assign(world.image.begin() + found->offset,
                                     world.image.begin() + found->offset + std::max(1u, world.types[found->type].size));
                initialise(world, initial, found->type, 0, -1, declaration->initial, scope, nullptr);
                std::copy(initial.bytes.begin(), initial.bytes.end(), world.image.begin() + found->offset);
                for (DynamicInit dynamic : initial.dynamics) {
                    dynamic.offset += found->offset;
                    world.programInits.push_back(dynamic);
                }
            }
        }
    };
    for (const Configuration& configuration : world.configurations) {
        for (const syntax::VarSection* section : configuration.declaration->sections)
            if (section->kind == SectionKind::Config || section->kind == SectionKind::Access)
                apply(*section, configuration, nullptr);
        for (const syntax::ResourceDecl* resource : configuration.declaration->resources)
            for (const syntax::VarSection* section : resource->sections)
                if (section->kind == SectionKind::Config || section->kind == SectionKind::Access)
                    apply(*section, configuration, resource);
    }
    accessPrograms(world);
    for (const Located& open : world.openAddresses) {
        // AT %Q* without an address from anywhere is only a warning: the program runs, nothing is connected.
        if (open.isCompleted || isLibraryFile(world, open.variable->range.file)) continue;
        const SourceRange range = open.variable->declaration->addressRange.file.isValid()
                                      ? open.variable->declaration->addressRange
                                      : open.variable->range;
        world.emit(range, findings::AddressMissing(open.variable->name)).severity = diagnostics::Severity::Warning;
    }
}

} // namespace plc::sema
