// CONFIGURATION: globals, tasks, program instances and their connections; what runs where there is none.
#include "runtime/compiler/sema/checker.h"

#include "runtime/base/text.h"

namespace plc::sema {

using diagnostics::Kind;
using syntax::SectionKind;

namespace {

bool hasSimulation(const std::vector<syntax::Pragma>& pragmas) {
    return std::any_of(pragmas.begin(), pragmas.end(), [](const syntax::Pragma& p) {
        return p.isAttribute && equalsIgnoringCase(p.key, "simulation");
    });
}

void forEachResource(const std::vector<World::Configuration>& configurations,
                     const std::function<void(const World::Configuration&, const syntax::ResourceDecl&)>& visit) {
    for (const World::Configuration& configuration : configurations)
        for (const syntax::ResourceDecl* resource : configuration.declaration->resources)
            visit(configuration, *resource);
}

} // namespace

void World::declareConfigurations() {
    const auto sections = [&](const std::vector<syntax::VarSection*>& list, const Configuration& configuration) {
        for (syntax::VarSection* section : list) {
            if (section->kind != SectionKind::Global && section->kind != SectionKind::Var) continue;
            auto* globalList = arena.make<syntax::GlobalList>();
            globalList->section = section;
            declareGlobals(*globalList, *configuration.space, *configuration.file, {});
        }
    };
    for (const Configuration& configuration : configurations)
        sections(configuration.declaration->sections, configuration);
    forEachResource(configurations, [&](const Configuration& configuration, const syntax::ResourceDecl& resource) {
        sections(resource.sections, configuration);
    });

    const auto addInstance = [&](Unit& unit, std::string name, const syntax::ProgramInstance* declaration,
                                 const syntax::ResourceDecl* resource, Scope scope) {
        Variable& variable = globals.emplace_back();
        variable.name = std::move(name);
        variable.id = key(variable.name);
        variable.range = declaration ? declaration->name.range : unit.range;
        variable.kind = SectionKind::Global;
        variable.scope = scope;
        variable.space = &top;
        variable.type = unit.type;
        variable.typeProgress = Progress::Done;
        variable.isProgramInstance = true;
        variable.program = &unit;
        variable.symbol =
            declaration ? addSymbol(SymbolKind::Variable, variable.name, {}, variable.range) : unit.symbol;
        if (declaration) {
            symbols[variable.symbol.index()].type = unit.type;
            symbols[variable.symbol.index()].path = variable.name;
            if (const auto* known = top.find(variable.id);
                known && std::any_of(known->begin(), known->end(),
                                     [](const Entity& e) { return e.variable && e.variable->isProgramInstance; }))
                emit(variable.range, Kind::DuplicateName, {variable.name});
            if (!equalsIgnoringCase(variable.name, unit.name))
                top.entities[variable.id].push_back({&variable, nullptr, nullptr});
        }
        ++unit.instanceCount;
        unit.instance = unit.instanceCount == 1 ? &variable : nullptr;
        instances.push_back({&variable, declaration, resource, scope, 0});
    };
    forEachResource(configurations, [&](const Configuration& configuration, const syntax::ResourceDecl& resource) {
        const Scope scope{nullptr, configuration.space, configuration.file};
        for (const syntax::ProgramInstance* declared : resource.programs) {
            if (declared->type.empty()) continue;
            const SourceRange range = joined(declared->type.front().range, declared->type.back().range);
            Unit* unit = lookupPath(scope, declared->type).entity.unit;
            if (!unit || unit->kind != UnitKind::Program) {
                std::vector<std::string> candidates;
                for (const Unit& other : units)
                    if (other.kind == UnitKind::Program) candidates.push_back(other.name);
                suggest(emit(range, Kind::UnknownType, {std::string(textOf(range))}), range, textOf(range), candidates);
                continue;
            }
            refer(range, unit->symbol, true, false);
            addInstance(*unit, std::string(declared->name.text), declared, &resource, scope);
        }
    });
    for (Unit& unit : units)
        if (unit.kind == UnitKind::Program && !unit.isLibrary() && unit.instanceCount == 0)
            addInstance(unit, unit.name, nullptr, nullptr, {nullptr, &top, unit.file});
}

namespace {

/// Assigns inputs before a program's body, outputs behind it.
void connect(World& world, World::Instance& instance, image::TaskProgram& entry) {
    Unit& unit = *instance.variable->program;
    const Scope scope = instance.scope;
    const auto build = [&](bool isInput) -> uint32_t {
        const bool copies = std::any_of(world.copies.begin(), world.copies.end(), [&](const World::Copy& c) {
            return c.root == instance.root && c.isInput == isInput;
        });
        const bool connects = instance.declaration && !instance.declaration->connections.empty();
        if (!copies && !connects) return 0;
        const tree::FunctionId id = world.newFunction(instance.variable->name + (isInput ? ".IN" : ".OUT"), nullptr);
        tree::Function& function = world.functions[id.index()];
        Checker checker(world, scope, world.sink, world.arena);
        checker.function = &function;
        checker.functionId = id;
        for (const World::Copy& copy : world.copies) {
            if (copy.root != instance.root || copy.isInput != isInput) continue;
            tree::Place* data = checker.absolutePlace(copy.data.offset, copy.data.type, copy.data.bit, {});
            tree::Place* address = checker.absolutePlace(copy.address.offset, copy.data.type, copy.address.bit, {});
            function.body.push_back(isInput ? checker.assignStmt(data, checker.load(address, {}).expr, {})
                                            : checker.assignStmt(address, checker.load(data, {}).expr, {}));
        }
        if (!connects) return function.body.empty() ? 0 : id.value;
        for (const syntax::Argument& argument : instance.declaration->connections) {
            if (!argument.name.isValid() || !argument.value) continue;
            const bool isOutput = argument.kind == syntax::ArgumentKind::Output;
            if (isOutput == isInput) continue;
            const Member member = world.findMember(unit, world.key(argument.name.text));
            if (!member.variable) {
                world.suggest(world.emit(argument.name.range, Kind::UnknownParameter,
                                         {unit.name, std::string(argument.name.text)}),
                              argument.name.range, argument.name.text, world.memberNames(unit.type));
                continue;
            }
            Variable& parameter = *member.variable;
            world.refer(argument.name.range, parameter.symbol, isOutput, !isOutput);
            const TypeId type = world.typeOf(parameter);
            ++parameter.writes;
            if (parameter.isInOut()) {
                tree::Place* target = checker.place(*argument.value, Access::ReadWrite);
                if (!target) continue;
                if (!world.sameType(target->type, type) || !checker.hasAddress(target)) {
                    world.emit(argument.value->range, Kind::InOutNeedsVariable, {parameter.name, world.nameOf(type)});
                    continue;
                }
                tree::Place* slot = world.arena.make<tree::Place>();
                slot->kind = tree::PlaceKind::InOutSlot;
                slot->type = type;
                slot->base = checker.absolutePlace(instance.variable->offset, unit.type, -1, argument.range);
                slot->offset = parameter.offset;
                tree::Stmt* bind = checker.newStmt(tree::StmtKind::Bind, {});
                bind->place = slot;
                bind->target = target;
                function.body.push_back(bind);
                continue;
            }
            tree::Place* field =
                parameter.storage == Storage::Absolute
                    ? checker.absolutePlace(parameter.offset, type, parameter.bit, argument.range)
                    : checker.absolutePlace(instance.variable->offset + parameter.offset, type, -1, argument.range);
            // an address of the type's size takes the value as it is: %IX0.0 for a BOOL, %IW2 for an INT
            const auto raw = [&](tree::Place* place) {
                if (argument.value->kind != syntax::ExprKind::Address) return false;
                const types::Type &x = world.types[place->type], &y = world.types[type];
                return x.size == y.size && types::isElementary(world.types.storageKind(type)) &&
                       world.types.family(type) != types::Family::Bool;
            };
            if (!isOutput) {
                Operand value = checker.expression(*argument.value, type);
                if (value.isUnknown()) continue;
                if (value.expr->kind == tree::ExprKind::Load && raw(value.expr->place))
                    value.expr->place->type = value.expr->type = type;
                value = checker.converted(value, type);
                if (!value.isUnknown()) function.body.push_back(checker.assignStmt(field, value.expr, {}));
            } else {
                const Denoted target = checker.target(*argument.value);
                if (target.kind == Denoted::Kind::Place && raw(target.place)) target.place->type = type;
                checker.assignTo(target, checker.load(field, argument.value->range), {}, function.body, true);
            }
        }
        return function.body.empty() ? 0 : id.value;
    };
    entry.connectIn = build(true);
    entry.connectOut = build(false);
}

} // namespace

void World::addAccess(const syntax::VarDecl& declaration, const image::Place& place, std::string list) {
    for (const syntax::Name& name : declaration.names) {
        image::Root& root = program->layout.roots.emplace_back();
        root.name = std::string(name.text);
        root.list = list;
        root.type = place.type;
        root.offset = place.offset;
        root.bit = place.bit;
        root.constant = declaration.isReadOnly;
        root.declaration = name.range;
        root.isHidden = true;
    }
}

/// VAR_ACCESS valve : R1.%QX0.1 : BOOL READ_ONLY;
void World::accessAddress(const syntax::VarDecl& declaration, const Scope& scope) {
    const auto address = parseAddress(declaration.address);
    if (!address || address->isOpen) {
        emit(declaration.addressRange, Kind::AddressOutOfRange, {std::string(declaration.address), "%I, %Q or %M"});
        return;
    }
    const TypeId own = types::TypeTable::of(address->kind),
                 type = declaration.type ? resolveSpec(declaration.type, scope) : own;
    if (types.kind(type) == TypeKind::Unknown) return;
    const bool isBit = types.storageKind(type) == TypeKind::Bool;
    if (isBit != (address->kind == TypeKind::Bool) || (!isBit && types[type].size != types[own].size)) {
        emit(declaration.type->range, Kind::TypeMismatch, {nameOf(own), nameOf(type)});
        return;
    }
    addAccess(declaration, {type, areaOf(address->area).begin + address->byte, isBit ? address->bit : int16_t(-1)}, {});
}

/// VAR_ACCESS of a PROGRAM: names below each of its instances, `i1.level`.
void World::accessPrograms() {
    for (const Instance& instance : instances) {
        const Unit& unit = *instance.variable->program;
        for (const syntax::VarSection* section : unit.pou->sections) {
            if (section->kind != SectionKind::Access) continue;
            for (const syntax::VarDecl* declaration : section->declarations) {
                std::string text = instance.variable->name;
                for (const syntax::Name& name : declaration->configPath) text += "." + std::string(name.text);
                if (!declaration->address.empty())
                    accessAddress(*declaration, {nullptr, unit.space, unit.file});
                else if (const auto found = program->layout.find(text))
                    addAccess(*declaration, *found, instance.variable->name);
                else
                    emit(declaration->range, Kind::ConfigTarget, {text});
            }
        }
    }
}

/// VAR_CONFIG: addresses and initial values of variables inside instances; VAR_ACCESS: other names for them.
void World::applyVarConfig() {
    const auto apply = [&](const syntax::VarSection& section, const Configuration& configuration,
                           const syntax::ResourceDecl* resource) {
        const Scope scope{nullptr, configuration.space, configuration.file};
        for (const syntax::VarDecl* declaration : section.declarations) {
            syntax::Path path = declaration->configPath;
            if (section.kind == SectionKind::Access && !declaration->address.empty()) {
                accessAddress(*declaration, scope);
                continue;
            }
            if (path.empty()) continue;
            const SourceRange range = joined(path.front().range, path.back().range);
            const auto dropFirst = [&](const syntax::Name& name) {
                if (path.size() > 1 && name.isValid() && equalsIgnoringCase(path.front().text, name.text))
                    path.erase(path.begin());
            };
            dropFirst(configuration.declaration->name);
            for (const syntax::ResourceDecl* each : configuration.declaration->resources)
                if (!resource || each == resource) dropFirst(each->name);
            std::string text;
            for (const syntax::Name& name : path) text += (text.empty() ? "" : ".") + std::string(name.text);
            const auto found = program->layout.find(text);
            if (!found) {
                emit(range, Kind::ConfigTarget, {text});
                continue;
            }
            const TypeId type = declaration->type ? resolveSpec(declaration->type, scope) : found->type;
            if (!sameType(type, found->type)) {
                emit(declaration->type->range, Kind::TypeMismatch, {nameOf(found->type), nameOf(type)});
                continue;
            }
            if (section.kind == SectionKind::Access) {
                addAccess(*declaration, *found, {});
                continue;
            }
            uint32_t rootIndex = 0;
            for (const Instance& instance : instances)
                if (found->offset >= instance.variable->offset &&
                    found->offset < instance.variable->offset + types[instance.variable->type].size)
                    rootIndex = instance.root;
            if (!declaration->address.empty()) {
                const auto address = parseAddress(declaration->address);
                if (!address || address->isOpen) {
                    emit(declaration->addressRange.file.isValid() ? declaration->addressRange : range,
                         Kind::AddressMissing, {text});
                } else {
                    const image::AreaRange area = areaOf(address->area);
                    Copy copy;
                    copy.data = *found;
                    copy.address = {found->type, area.begin + address->byte,
                                    types.storageKind(found->type) == TypeKind::Bool ? address->bit : int16_t(-1)};
                    copy.isInput = address->area == image::Area::Input;
                    copy.root = rootIndex;
                    copies.push_back(copy);
                    if (address->area == image::Area::Memory) { // both ways
                        copy.isInput = true;
                        copies.push_back(copy);
                    }
                    const NameId last = key(path.back().text);
                    for (Located& open : openAddresses)
                        if (open.variable->id == last) open.isCompleted = true;
                }
            }
            if (declaration->initial) {
                InitialValue initial;
                initial.bytes.assign(image.begin() + found->offset,
                                     image.begin() + found->offset + std::max(1u, types[found->type].size));
                initialise(initial, found->type, 0, -1, declaration->initial, scope, nullptr);
                std::copy(initial.bytes.begin(), initial.bytes.end(), image.begin() + found->offset);
                for (DynamicInit dynamic : initial.dynamics) {
                    dynamic.offset += found->offset;
                    programInits.push_back(dynamic);
                }
            }
        }
    };
    for (const Configuration& configuration : configurations) {
        for (const syntax::VarSection* section : configuration.declaration->sections)
            if (section->kind == SectionKind::Config || section->kind == SectionKind::Access)
                apply(*section, configuration, nullptr);
        for (const syntax::ResourceDecl* resource : configuration.declaration->resources)
            for (const syntax::VarSection* section : resource->sections)
                if (section->kind == SectionKind::Config || section->kind == SectionKind::Access)
                    apply(*section, configuration, resource);
    }
    accessPrograms();
    for (const Located& open : openAddresses) {
        if (open.isCompleted || isLibraryFile(open.variable->range.file)) continue;
        const SourceRange range = open.variable->declaration->addressRange.file.isValid()
                                      ? open.variable->declaration->addressRange
                                      : open.variable->range;
        emit(range, Kind::AddressMissing, {open.variable->name}).severity = diagnostics::Severity::Warning;
    }
}

/// A task that nothing starts runs in every scan, which SINGLE := FALSE says on purpose.
///   ok:    TASK Slow(INTERVAL := T#1s);  TASK Free(SINGLE := FALSE);     advice: TASK Slow(PRIORITY := 1);  (P3035)
void World::tellFreewheeling(const syntax::TaskDecl& task) {
    const SourceRange range = task.interval ? task.interval->range : task.name.range;
    if (!range.file.isValid()) return; // a task without a name is told as that
    auto& diagnostic = emit(range, Kind::FreewheelingTask, {std::string(task.name.text)});
    if (task.interval) {
        diagnostic.fixes.push_back({"Write T#10ms", {{range, "T#10ms"}}});
        return;
    }
    const std::string_view text = sources[range.file].text();
    const size_t open = text.find('(', range.end);
    if (open == std::string_view::npos || open >= task.range.end) return;
    const auto at = static_cast<uint32_t>(open + 1);
    const bool isEmpty = text.find_first_not_of(" \t\r\n", at) == text.find(')', at);
    for (const std::string_view start : {"INTERVAL := T#10ms", "SINGLE := FALSE"})
        diagnostic.fixes.push_back(
            {"Insert " + std::string(start), {{{range.file, at, at}, std::string(start) + (isEmpty ? "" : ", ")}}});
}

void World::buildTasks() {
    struct Declared {
        image::Task task;
        const syntax::ResourceDecl* resource = nullptr;
        NameId id;
    };
    std::vector<Declared> tasks;
    forEachResource(configurations, [&](const Configuration& configuration, const syntax::ResourceDecl& resource) {
        const Scope scope{nullptr, configuration.space, configuration.file};
        for (const syntax::TaskDecl* declared : resource.tasks) {
            const NameId id = key(declared->name.text);
            if (std::any_of(tasks.begin(), tasks.end(),
                            [&](const Declared& d) { return d.id == id && d.resource == &resource; })) {
                emit(declared->name.range, Kind::DuplicateTask, {std::string(declared->name.text)});
                continue;
            }
            Declared& made = tasks.emplace_back();
            made.resource = &resource;
            made.id = id;
            made.task.name = std::string(declared->name.text);
            made.task.declaration = declared->name.range;
            made.task.kind = image::TaskKind::Freewheeling;
            addSymbol(SymbolKind::Task, declared->name.text, {}, declared->name.range);
            const auto duration = [&](const syntax::Expr& e) -> std::optional<std::chrono::nanoseconds> {
                Checker checker(*this, scope, sink, arena);
                const TypeId time = types::TypeTable::of(TypeKind::Time);
                Operand value = checker.expression(e, time);
                if (value.isFlexible && std::holds_alternative<int64_t>(value.expr->value.data)) {
                    const std::chrono::milliseconds read(
                        std::clamp<int64_t>(value.expr->value.integer(), -1'000'000'000, 1'000'000'000));
                    const std::string text = types::durationText(std::chrono::nanoseconds(read).count());
                    emit(e.range, Kind::NumberAsDuration, {std::string(textOf(e.range)), text})
                        .fixes.push_back({"Write " + text, {{e.range, text}}});
                    return read;
                }
                value = checker.converted(value, time);
                if (value.isUnknown()) return std::nullopt;
                if (!value.isConstant()) {
                    emit(e.range, Kind::NotConstant);
                    return std::nullopt;
                }
                return std::chrono::nanoseconds(value.expr->value.integer());
            };
            if (declared->priority)
                if (const auto priority = constantInteger(declared->priority, scope)) {
                    if (*priority < 0 || *priority > 1'000'000)
                        emit(declared->priority->range, Kind::ConstantOutOfRange,
                             {std::to_string(*priority), "PRIORITY (0..1000000)"});
                    made.task.priority = static_cast<int32_t>(std::clamp<int64_t>(*priority, 0, 1'000'000));
                }
            bool isZero = false;
            if (declared->interval)
                if (const auto interval = duration(*declared->interval)) { // zero: as if there were none
                    isZero = interval->count() == 0;
                    if (interval->count() < 0)
                        emit(declared->interval->range, Kind::ConstantOutOfRange,
                             {types::durationText(interval->count()), "INTERVAL (0..)"});
                    if (interval->count() > 0) made.task.kind = image::TaskKind::Cyclic;
                    made.task.interval = std::max(*interval, std::chrono::nanoseconds(0));
                }
            if (declared->single) {
                Checker checker(*this, scope, sink, arena);
                checker.isMuted = false;
                const Denoted denoted = checker.denote(*declared->single, Access::Read);
                const bool isBool =
                    denoted.kind == Denoted::Kind::Place && types.storageKind(denoted.place->type) == TypeKind::Bool;
                tree::Place* place = denoted.place;
                if (isBool && place->kind == tree::PlaceKind::Bit && place->base &&
                    place->base->kind == tree::PlaceKind::Absolute) {
                    made.task.kind = image::TaskKind::Event;
                    made.task.trigger =
                        image::Place{place->type, place->base->offset + static_cast<uint32_t>(place->bit) / 8,
                                     static_cast<int16_t>(place->bit % 8)};
                } else if (isBool && place->kind == tree::PlaceKind::Absolute) {
                    made.task.kind = image::TaskKind::Event;
                    made.task.trigger = image::Place{place->type, place->offset, place->bit};
                } else if (denoted.kind == Denoted::Kind::Value && denoted.value.isConstant() &&
                           !declared->interval) { // SINGLE := FALSE
                    made.task.kind = image::TaskKind::Freewheeling;
                } else if (denoted.kind != Denoted::Kind::Nothing && denoted.kind != Denoted::Kind::Value) {
                    emit(declared->single->range, Kind::ConditionNotBool,
                         {denoted.place ? nameOf(denoted.place->type) : std::string(textOf(declared->single->range))});
                }
            }
            if (!declared->single && (!declared->interval || isZero)) tellFreewheeling(*declared);
            for (const syntax::Argument& argument : declared->others) {
                if (!argument.value) continue;
                if (equalsIgnoringCase(argument.name.text, "WATCHDOG")) {
                    if (const auto limit = duration(*argument.value)) made.task.watchdog = *limit;
                } else if (equalsIgnoringCase(argument.name.text, "SENSITIVITY")) {
                    if (const auto count = constantInteger(argument.value, scope))
                        made.task.watchdogSensitivity =
                            static_cast<uint32_t>(std::clamp<int64_t>(*count, 1, 1'000'000));
                } else {
                    suggest(
                        emit(argument.name.range, Kind::UnknownParameter, {"TASK", std::string(argument.name.text)}),
                        argument.name.range, argument.name.text,
                        {"INTERVAL", "SINGLE", "PRIORITY", "WATCHDOG", "SENSITIVITY"});
                }
            }
        }
    });
    const auto entryOf = [&](Instance& instance) {
        image::TaskProgram entry;
        entry.root = instance.root;
        entry.function = instance.variable->program->function.value;
        connect(*this, instance, entry);
        return entry;
    };
    std::vector<image::Task> out(tasks.size());
    std::vector<image::Task> simulations(tasks.size());
    image::Task free, simulation;
    free.name = "Free";
    free.kind = image::TaskKind::Freewheeling;
    free.priority = 1'000'000;
    simulation.name = "Simulation";
    simulation.kind = image::TaskKind::Freewheeling;
    simulation.isSimulation = true;
    for (size_t i = 0; i < tasks.size(); ++i) out[i] = simulations[i] = tasks[i].task;
    bool isConfigured = false;
    for (Instance& instance : instances) {
        if (!instance.declaration) continue;
        const bool simulates = instance.variable->program->isSimulation || hasSimulation(instance.declaration->pragmas);
        program->layout.roots[instance.root].isSimulation = simulates;
        isConfigured = isConfigured || !simulates;
        if (!instance.declaration->task.isValid()) {
            (simulates ? simulation : free).programs.push_back(entryOf(instance));
            continue;
        }
        const NameId id = key(instance.declaration->task.text);
        const auto it = std::find_if(tasks.begin(), tasks.end(),
                                     [&](const Declared& d) { return d.id == id && d.resource == instance.resource; });
        if (it == tasks.end()) {
            std::vector<std::string> candidates;
            for (const Declared& each : tasks) candidates.push_back(each.task.name);
            suggest(emit(instance.declaration->task.range, Kind::UnknownTask,
                         {std::string(instance.declaration->task.text)}),
                    instance.declaration->task.range, instance.declaration->task.text, candidates);
            continue;
        }
        (simulates ? simulations : out)[static_cast<size_t>(it - tasks.begin())].programs.push_back(entryOf(instance));
    }
    // without a CONFIGURATION: Main, MAIN, PLC_PRG or the only program, every 10 ms
    std::vector<Instance*> byDefault;
    for (Instance& instance : instances) {
        if (instance.declaration) continue;
        if (instance.variable->program->isSimulation)
            simulation.programs.push_back(entryOf(instance));
        else
            byDefault.push_back(&instance);
    }
    if (!isConfigured && !byDefault.empty()) {
        Instance* chosen = byDefault.size() == 1 ? byDefault.front() : nullptr;
        for (const std::string_view name : {"PLC_PRG", "Main"})
            for (Instance* instance : byDefault)
                if (equalsIgnoringCase(instance->variable->name, name)) chosen = instance;
        if (chosen) {
            image::Task task;
            task.name = "Main";
            task.kind = image::TaskKind::Cyclic;
            task.declaration = chosen->variable->range;
            task.programs.push_back(entryOf(*chosen));
            out.push_back(std::move(task));
        } else {
            auto& diagnostic = emit(byDefault[1]->variable->range, Kind::SeveralPrograms);
            diagnostic.related.push_back({byDefault[0]->variable->range, "the first program"});
        }
    }
    if (instances.empty() || (!isConfigured && byDefault.empty() && simulation.programs.empty()))
        if (std::any_of(fileOf.begin(), fileOf.end(),
                        [](const syntax::SyntaxFile* f) { return f && f->library.empty(); }))
            emit({}, Kind::NoProgram).severity = diagnostics::Severity::Info;
    std::vector<image::Task>& all = program->tasks;
    for (image::Task& task : out) all.push_back(std::move(task));
    if (!free.programs.empty()) all.push_back(std::move(free));
    for (image::Task& task : simulations)
        if (!task.programs.empty()) {
            task.isSimulation = true;
            all.push_back(std::move(task));
        }
    if (!simulation.programs.empty()) all.push_back(std::move(simulation));
    std::stable_sort(all.begin(), all.end(),
                     [](const image::Task& a, const image::Task& b) { return a.priority < b.priority; });
}

} // namespace plc::sema
