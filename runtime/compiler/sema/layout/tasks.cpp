// TASKs: what their declarations say, the programs each runs with their connections, and what runs where nothing is
// configured.
#include "runtime/compiler/sema/layout/tasks.h"

#include "runtime/compiler/sema/context.h"
#include "runtime/compiler/sema/declare/configuration.h"
#include "runtime/compiler/sema/names/lookup.h"
#include "runtime/compiler/sema/names/names.h"
#include "runtime/compiler/sema/names/places.h"
#include "runtime/compiler/sema/program/analyze.h"
#include "runtime/compiler/sema/statements/statements.h"
#include "runtime/compiler/sema/types/conversions.h"
#include "runtime/compiler/sema/types/type_specs.h"
#include "runtime/compiler/sema/values/expressions.h"

#include "runtime/base/text.h"

namespace plc::sema {

namespace {

bool hasSimulation(const std::vector<syntax::Pragma>& pragmas) {
    return std::any_of(pragmas.begin(), pragmas.end(), [](const syntax::Pragma& p) {
        return p.isAttribute && equalsIgnoringCase(p.key, "simulation");
    });
}

// Everything of a task is constant: its times are known before the first scan.
/// Reads one TASK of a resource. Lives for that.
class TaskReader {
public:
    TaskReader(WorldBuilder& world, const Configuration& configuration, const syntax::TaskDecl& declared)
        : m_world(world), m_scope{nullptr, configuration.space, configuration.file}, m_declared(declared) {}

    image::Task read() {
        m_task.name = std::string(m_declared.name.text);
        m_task.declaration = m_declared.name.range;
        m_task.kind = image::TaskKind::Freewheeling;
        if (m_declared.priority) readPriority(*m_declared.priority);
        if (m_declared.interval) readInterval(*m_declared.interval);
        if (m_declared.single)
            readTrigger(*m_declared.single);
        else if (!m_declared.interval || m_isIntervalZero)
            tellFreewheeling();
        for (const syntax::Argument& argument : m_declared.others)
            if (argument.value) readOther(argument);
        return std::move(m_task);
    }

private:
    // INTERVAL := 10 is an error in the standard and milliseconds in the tools that accept it: it is read as those, so
    // that the rest of the project can be checked.
    /// A constant TIME; a number is told and read as milliseconds.
    std::optional<std::chrono::nanoseconds> duration(const syntax::Expr& e) {
        Context checker(m_world, m_scope, m_world.sink, m_world.arena);
        const TypeId time = types::TypeTable::of(TypeKind::Time);
        Operand value = expression(checker, e, time);
        if (value.isFlexible && std::holds_alternative<int64_t>(value.expr->value.data)) {
            const std::chrono::milliseconds read(
                std::clamp<int64_t>(value.expr->value.integer(), -1'000'000'000, 1'000'000'000));
            const std::string text = types::durationText(std::chrono::nanoseconds(read).count());
            m_world.emit(e.range, findings::NumberAsDuration(m_world.textOf(e.range), text))
                .fixes.push_back({fixes::Write(text), {{e.range, text}}});
            return read;
        }
        value = converted(checker, value, time);
        if (value.isUnknown()) return std::nullopt;
        if (!value.isConstant()) {
            m_world.emit(e.range, findings::NotConstant());
            return std::nullopt;
        }
        return std::chrono::nanoseconds(value.expr->value.integer());
    }

    void readPriority(const syntax::Expr& e) {
        // 0 is the most urgent (edition 2, 2.7.2). A million is kept free for what has no task.
        const auto priority = constantInteger(m_world, &e, m_scope);
        if (!priority) return;
        if (*priority < 0 || *priority > 1'000'000)
            m_world.emit(e.range,
                         findings::ConstantOutOfRange(std::to_string(*priority), Verbatim("PRIORITY (0..1000000)")));
        m_task.priority = static_cast<int32_t>(std::clamp<int64_t>(*priority, 0, 1'000'000));
    }

    void readInterval(const syntax::Expr& e) {
        const auto interval = duration(e);
        if (!interval) return;
        // INTERVAL := T#0s is written by converters for "as often as possible".
        m_isIntervalZero = interval->count() == 0;
        if (interval->count() < 0)
            m_world.emit(e.range, findings::ConstantOutOfRange(types::durationText(interval->count()),
                                                               Verbatim("INTERVAL (0..)")));
        if (interval->count() > 0) m_task.kind = image::TaskKind::Cyclic; // zero: as if there were none
        m_task.interval = std::max(*interval, std::chrono::nanoseconds(0));
    }

    void readTrigger(const syntax::Expr& e) {
        Context checker(m_world, m_scope, m_world.sink, m_world.arena);
        // The trigger counts as a use of its variable.
        checker.isMuted = false;
        const Denoted denoted = denote(checker, e, Access::Read);
        const bool isBool =
            denoted.kind == Denoted::Kind::Place && m_world.types.storageKind(denoted.place->type) == TypeKind::Bool;
        const tree::Place* place = denoted.place;
        if (isBool && place->kind == tree::PlaceKind::Bit && place->base &&
            // SINGLE := word.3: the bit of a byte, which is all that the scheduler knows to look at.
            place->base->kind == tree::PlaceKind::Absolute) {
            m_task.kind = image::TaskKind::Event;
            m_task.trigger = image::Place{place->type, place->base->offset + static_cast<uint32_t>(place->bit) / 8,
                                          static_cast<int16_t>(place->bit % 8)};
        } else if (isBool && place->kind == tree::PlaceKind::Absolute) {
            m_task.kind = image::TaskKind::Event;
            m_task.trigger = image::Place{place->type, place->offset, place->bit};
            // A constant has no rising edge: the task is started by nothing, as it says.
        } else if (denoted.kind == Denoted::Kind::Value && denoted.value.isConstant() && !m_declared.interval) {
            m_task.kind = image::TaskKind::Freewheeling; // SINGLE := FALSE
        } else if (denoted.kind != Denoted::Kind::Nothing && denoted.kind != Denoted::Kind::Value) {
            m_world.emit(e.range, findings::ConditionNotBool(denoted.place ? m_world.nameOf(denoted.place->type)
                                                                           : std::string(m_world.textOf(e.range))));
        }
    }

    void readOther(const syntax::Argument& argument) {
        // WATCHDOG and SENSITIVITY are CODESYS's: a fault after so many scans in a row that took longer.
        if (equalsIgnoringCase(argument.name.text, "WATCHDOG")) {
            if (const auto limit = duration(*argument.value)) m_task.watchdog = *limit;
        } else if (equalsIgnoringCase(argument.name.text, "SENSITIVITY")) {
            if (const auto count = constantInteger(m_world, argument.value, m_scope))
                m_task.watchdogSensitivity = static_cast<uint32_t>(std::clamp<int64_t>(*count, 1, 1'000'000));
        } else {
            suggest(m_world,
                    m_world.emit(argument.name.range, findings::UnknownParameter(Verbatim("TASK"), argument.name.text)),
                    argument.name.range, argument.name.text,
                    {"INTERVAL", "SINGLE", "PRIORITY", "WATCHDOG", "SENSITIVITY"});
        }
    }

    void tellFreewheeling();

    WorldBuilder& m_world;
    const Scope m_scope;
    const syntax::TaskDecl& m_declared;
    image::Task m_task;
    bool m_isIntervalZero = false;
};

/// A task that nothing starts runs in every scan, which SINGLE := FALSE says on purpose.
///   ok:    TASK Slow(INTERVAL := T#1s);  TASK Free(SINGLE := FALSE);     advice: TASK Slow(PRIORITY := 1);  (P3035)
void TaskReader::tellFreewheeling() {
    const SourceRange range = m_declared.interval ? m_declared.interval->range : m_declared.name.range;
    if (!range.file.isValid()) return; // a task without a name is told as that
    auto& diagnostic = m_world.emit(range, findings::FreewheelingTask(m_declared.name.text));
    if (m_declared.interval) {
        diagnostic.fixes.push_back({fixes::Write(Verbatim("T#10ms")), {{range, "T#10ms"}}});
        return;
    }
    const std::string_view text = m_world.sources[range.file].text();
    const size_t open = text.find('(', range.end);
    if (open == std::string_view::npos || open >= m_declared.range.end) return;
    const auto at = static_cast<uint32_t>(open + 1);
    // TASK Slow() needs no comma behind what is inserted.
    const bool isEmpty = text.find_first_not_of(" \t\r\n", at) == text.find(')', at);
    for (const std::string_view start : {"INTERVAL := T#10ms", "SINGLE := FALSE"})
        diagnostic.fixes.push_back(
            {fixes::Insert(std::string(start)), {{{range.file, at, at}, std::string(start) + (isEmpty ? "" : ", ")}}});
}

// Two functions for an instance (NAME.IN and NAME.OUT), because the task calls them around the body and debugging shows
// them as no part of it.
/// Assigns inputs before a program's body, outputs behind it.
void connect(WorldBuilder& world, Instance& instance, image::TaskProgram& entry) {
    Unit& unit = *instance.variable->program;
    const Scope scope = instance.scope;
    const auto build = [&](bool isInput) -> uint32_t {
        // Copies come from VAR_CONFIG: variables that got their address only there (configuration.cpp).
        const bool copies = std::any_of(world.copies.begin(), world.copies.end(),
                                        [&](const Copy& c) { return c.root == instance.root && c.isInput == isInput; });
        const bool connects = instance.declaration && !instance.declaration->connections.empty();
        // 0 is no function: nothing is called.
        if (!copies && !connects) return 0;
        const tree::FunctionId id = newFunction(world, instance.variable->name + (isInput ? ".IN" : ".OUT"), nullptr);
        tree::Function& function = world.functions[id.index()];
        Context checker(world, scope, world.sink, world.arena);
        checker.function = &function;
        checker.functionId = id;
        // The process image first, then the connections, which may read what was copied.
        for (const Copy& copy : world.copies) {
            if (copy.root != instance.root || copy.isInput != isInput) continue;
            tree::Place* data = absolutePlace(checker, copy.data.offset, copy.data.type, copy.data.bit, {});
            tree::Place* address = absolutePlace(checker, copy.address.offset, copy.data.type, copy.address.bit, {});
            function.body.push_back(isInput ? assignStmt(checker, data, load(checker, address, {}).expr, {})
                                            : assignStmt(checker, address, load(checker, data, {}).expr, {}));
        }
        if (!connects) return function.body.empty() ? 0 : id.value;
        for (const syntax::Argument& argument : instance.declaration->connections) {
            if (!argument.name.isValid() || !argument.value) continue;
            const bool isOutput = argument.kind == syntax::ArgumentKind::Output;
            if (isOutput == isInput) continue;
            const Member member = findMember(unit, world.key(argument.name.text));
            if (!member.variable) {
                suggest(world,
                        world.emit(argument.name.range, findings::UnknownParameter(unit.name, argument.name.text)),
                        argument.name.range, argument.name.text, memberNames(world, unit.type));
                continue;
            }
            Variable& parameter = *member.variable;
            refer(world, argument.name.range, parameter.symbol, isOutput, !isOutput);
            const TypeId type = typeOf(world, parameter);
            // From outside, so that an input that only the task sets is not reported as never written.
            ++parameter.writes;
            if (parameter.isInOut()) {
                tree::Place* target = place(checker, *argument.value, Access::ReadWrite);
                if (!target) continue;
                if (!sameType(world, target->type, type) || !hasAddress(target)) {
                    world.emit(argument.value->range, findings::InOutNeedsVariable(parameter.name, world.nameOf(type)));
                    continue;
                }
                tree::Place* slot = world.arena.make<tree::Place>();
                slot->kind = tree::PlaceKind::InOutSlot;
                slot->type = type;
                slot->base = absolutePlace(checker, instance.variable->offset, unit.type, -1, argument.range);
                slot->offset = parameter.offset;
                tree::Stmt* bind = newStmt(checker, tree::StmtKind::Bind, {});
                bind->place = slot;
                bind->target = target;
                function.body.push_back(bind);
                continue;
            }
            tree::Place* field =
                parameter.storage == Storage::Absolute
                    ? absolutePlace(checker, parameter.offset, type, parameter.bit, argument.range)
                    : absolutePlace(checker, instance.variable->offset + parameter.offset, type, -1, argument.range);
            // PROGRAM A WITH T : P(speed := %ID4) with speed : REAL: the register holds the bits of a REAL.
            // an address of the type's size takes the value as it is: %IX0.0 for a BOOL, %IW2 for an INT
            const auto raw = [&](tree::Place* place) {
                if (argument.value->kind != syntax::ExprKind::Address) return false;
                const types::Type &x = world.types[place->type], &y = world.types[type];
                return x.size == y.size && types::isElementary(world.types.storageKind(type)) &&
                       world.types.family(type) != types::Family::Bool;
            };
            if (!isOutput) {
                Operand value = expression(checker, *argument.value, type);
                if (value.isUnknown()) continue;
                if (value.expr->kind == tree::ExprKind::Load && raw(value.expr->place))
                    value.expr->place->type = value.expr->type = type;
                value = converted(checker, value, type);
                if (!value.isUnknown()) function.body.push_back(assignStmt(checker, field, value.expr, {}));
            } else {
                const Denoted target = sema::target(checker, *argument.value);
                if (target.kind == Denoted::Kind::Place && raw(target.place)) target.place->type = type;
                assignTo(checker, target, load(checker, field, argument.value->range), {}, function.body, true);
            }
        }
        return function.body.empty() ? 0 : id.value;
    };
    entry.connectIn = build(true);
    entry.connectOut = build(false);
}

/// A TASK that was declared, and where.
// Tasks are found by name within their RESOURCE: two resources may each have a Fast.
struct DeclaredTask {
    image::Task task;
    const syntax::ResourceDecl* resource = nullptr;
    NameId id;
};

/// Task names are unique within a resource (edition 2, 2.7.2).
///   wrong: TASK Fast(INTERVAL := T#10ms); TASK Fast(INTERVAL := T#20ms);  (P3012)
std::vector<DeclaredTask> declaredTasks(WorldBuilder& world) {
    std::vector<DeclaredTask> tasks;
    forEachResource(world, [&](const Configuration& configuration, const syntax::ResourceDecl& resource) {
        for (const syntax::TaskDecl* declared : resource.tasks) {
            const NameId id = world.key(declared->name.text);
            if (std::any_of(tasks.begin(), tasks.end(),
                            [&](const DeclaredTask& d) { return d.id == id && d.resource == &resource; })) {
                world.emit(declared->name.range, findings::DuplicateTask(declared->name.text));
                continue;
            }
            addSymbol(world, SymbolKind::Task, declared->name.text, {}, declared->name.range);
            tasks.push_back({TaskReader(world, configuration, *declared).read(), &resource, id});
        }
    });
    return tasks;
}

/// What a task calls for an instance.
image::TaskProgram entryOf(WorldBuilder& world, Instance& instance) {
    image::TaskProgram entry;
    entry.root = instance.root;
    entry.function = instance.variable->program->function.value;
    connect(world, instance, entry);
    return entry;
}

/// The tasks of the program while its instances are dealt out to them.
class TaskBook {
public:
    explicit TaskBook(WorldBuilder& world)
        : m_world(world), m_declared(declaredTasks(world)), m_simulations(m_declared.size()) {
        m_free.name = "Free";
        m_simulation.name = "Simulation";
        // Behind every priority that can be written: what has no task runs when nothing else has to.
        for (image::Task* task : {&m_free, &m_simulation}) {
            task->kind = image::TaskKind::Freewheeling;
            task->priority = 1'000'000;
        }
        // The model of the plant runs in a copy of the task of what it simulates, after it and with its interval.
        for (size_t i = 0; i < m_declared.size(); ++i) m_simulations[i] = m_declared[i].task;
    }

    /// The programs that a CONFIGURATION names, each to its task, without one to a free task.
    void addConfigured() {
        for (Instance& instance : m_world.instances) {
            if (!instance.declaration) continue;
            const bool simulates =
                instance.variable->program->isSimulation || hasSimulation(instance.declaration->pragmas);
            m_world.program->layout.roots[instance.root].isSimulation = simulates;
            // A CONFIGURATION that only places models does not take away the default task.
            m_isConfigured = m_isConfigured || !simulates;
            const syntax::Name& name = instance.declaration->task;
            for (const syntax::Argument& block : instance.declaration->blockTasks) addBlock(instance, block, simulates);
            if (!name.isValid()) {
                (simulates ? m_simulation : m_free).programs.push_back(entryOf(m_world, instance));
                continue;
            }
            if (image::Task* task = taskOf(instance, name, simulates))
                task->programs.push_back(entryOf(m_world, instance));
        }
    }

    /// Without a CONFIGURATION: Main, MAIN, PLC_PRG or the only program, every 10 ms.
    void addDefault() {
        std::vector<Instance*> byDefault;
        for (Instance& instance : m_world.instances) {
            if (instance.declaration) continue;
            if (instance.variable->program->isSimulation)
                m_simulation.programs.push_back(entryOf(m_world, instance));
            else
                byDefault.push_back(&instance);
        }
        if (m_isConfigured) return;
        if (!byDefault.empty()) return addMain(byDefault);
        // A project of libraries alone needs no program; one with files of its own is asked for one, not scolded.
        if (m_simulation.programs.empty() &&
            std::any_of(m_world.fileOf.begin(), m_world.fileOf.end(),
                        [](const syntax::SyntaxFile* f) { return f && f->library.empty(); }))
            m_world.emit({}, findings::NoProgram()).severity = diagnostics::Severity::Info;
    }

    /// All that runs, the most urgent first, simulations behind what they serve.
    std::vector<image::Task> take() {
        std::vector<image::Task> all;
        for (DeclaredTask& declared : m_declared) all.push_back(std::move(declared.task));
        if (m_main) all.push_back(std::move(*m_main));
        if (!m_free.programs.empty()) all.push_back(std::move(m_free));
        m_simulations.push_back(std::move(m_simulation));
        for (image::Task& task : m_simulations)
            if (!task.programs.empty()) {
                task.isSimulation = true;
                all.push_back(std::move(task));
            }
        // Equal priorities keep the order of the text (2.7.2).
        std::stable_sort(all.begin(), all.end(),
                         [](const image::Task& a, const image::Task& b) { return a.priority < b.priority; });
        return all;
    }

private:
    /// The task of an instance's RESOURCE; null: there is none, and it was reported.
    image::Task* taskOf(const Instance& instance, const syntax::Name& name, bool simulates) {
        const auto it = std::find_if(m_declared.begin(), m_declared.end(), [&](const DeclaredTask& d) {
            return d.id == m_world.key(name.text) && d.resource == instance.resource;
        });
        if (it != m_declared.end())
            return simulates ? &m_simulations[static_cast<size_t>(it - m_declared.begin())] : &it->task;
        std::vector<std::string> candidates;
        for (const DeclaredTask& each : m_declared) candidates.push_back(each.task.name);
        suggest(m_world, m_world.emit(name.range, findings::UnknownTask(name.text)), name.range, name.text, candidates);
        return nullptr;
    }

    /// PROGRAM A WITH T : P(fb WITH T2): the body of that block runs in a task of its own (edition 2, 2.7.2).
    ///   wrong: P(x WITH T2)  with x : INT (P3038)
    void addBlock(const Instance& instance, const syntax::Argument& block, bool simulates) {
        const Member member = findMember(*instance.variable->program, m_world.key(block.name.text));
        Variable* variable = member.variable;
        Unit* unit = variable ? m_world.unitOf(typeOf(m_world, *variable)) : nullptr;
        // Only what is in the program's instance has a place of its own that another task could call.
        if (!unit || unit->kind != UnitKind::Block || variable->storage != Storage::Instance || variable->isInOut())
            return (void)m_world.emit(block.name.range, findings::BlockTask(block.name.text));
        refer(m_world, block.name.range, variable->symbol, false, true);
        ++variable->reads;
        if (!block.value) return;
        image::Task* task = taskOf(instance, block.value->name, simulates);
        if (!task) return;
        image::Root& root =
            m_world.program->layout.roots.emplace_back(); // the place of the block, by a name of its own
        root.name = instance.variable->name + "." + variable->name;
        root.type = variable->type;
        root.offset = instance.variable->offset + variable->offset;
        root.declaration = block.name.range;
        root.isHidden = true;
        image::TaskProgram entry;
        entry.root = static_cast<uint32_t>(m_world.program->layout.roots.size() - 1);
        entry.function = unit->function.value;
        task->programs.push_back(entry);
    }

    void addMain(const std::vector<Instance*>& byDefault) {
        Instance* chosen = byDefault.size() == 1 ? byDefault.front() : nullptr;
        // The later name wins: a project with both was converted from CODESYS and then given a Main.
        for (const std::string_view name : {"PLC_PRG", "Main"})
            for (Instance* instance : byDefault)
                if (equalsIgnoringCase(instance->variable->name, name)) chosen = instance;
        if (!chosen) {
            auto& diagnostic = m_world.emit(byDefault[1]->variable->range, findings::SeveralPrograms());
            diagnostic.related.push_back({byDefault[0]->variable->range, notes::TheFirstProgram()});
            return;
        }
        m_main.emplace();
        m_main->name = "Main";
        // With the interval and priority that image::Task begins with.
        m_main->kind = image::TaskKind::Cyclic;
        m_main->declaration = chosen->variable->range;
        m_main->programs.push_back(entryOf(m_world, *chosen));
    }

    WorldBuilder& m_world;
    std::vector<DeclaredTask> m_declared;
    std::vector<image::Task> m_simulations; // of the declared tasks, for programs that simulate
    image::Task m_free, m_simulation;       // without a task
    std::optional<image::Task> m_main;
    bool m_isConfigured = false;
};

} // namespace

// First what is configured, then what runs by default: the second depends on whether the first names a program.
void buildTasks(WorldBuilder& world) {
    TaskBook book(world);
    book.addConfigured();
    book.addDefault();
    world.program->tasks = book.take();
}

} // namespace plc::sema
