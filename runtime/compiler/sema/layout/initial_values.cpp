// Initial values: what is constant becomes bytes, the rest (references, FB_Init, expressions over variables) becomes
// code.
#include "runtime/compiler/sema/layout/initial_values.h"

#include "runtime/compiler/sema/calls/calls.h"
#include "runtime/compiler/sema/context.h"
#include "runtime/compiler/sema/layout/units.h"
#include "runtime/compiler/sema/names/lookup.h"
#include "runtime/compiler/sema/names/names.h"
#include "runtime/compiler/sema/names/places.h"
#include "runtime/compiler/sema/names/unknown_base.h"
#include "runtime/compiler/sema/program/analyze.h"
#include "runtime/compiler/sema/statements/statements.h"
#include "runtime/compiler/sema/types/conversions.h"
#include "runtime/compiler/sema/types/type_specs.h"
#include "runtime/compiler/sema/values/expressions.h"

#include "runtime/base/text.h"

namespace plc::sema {

using syntax::ExprKind;

static tree::FunctionId initialiserOf(const Check& check, TypeId type);

namespace {

// FB_Init is CODESYS's constructor, kept because whole libraries hang on it. find and not key: this runs with a const
// World, and if nobody wrote the name it is nowhere.
Unit* initMethodOf(const World& world, TypeId type) {
    Unit* unit = world.unitOf(type);
    if (!unit || unit->kind != UnitKind::Block) return nullptr;
    return findMember(*unit, world.names.find("FB_Init")).unit;
}

// The sink is its own: the messages of an expression that turns out not to be constant come when its code is made, and
// would be there twice.
/// Runs an expression without knowing yet whether it is constant; what it says counts only if it is, or is wrong.
struct Trial {
    Trial(const Check& check, const Scope& scope)
        : gathered(check.gathered), checker(check, scope, sink, gathered.arena),
          references(gathered.references.size()) {
        checker.isInitialiser = true;
    }
    void keep() {
        for (diagnostics::Diagnostic& diagnostic : sink.take()) gathered.sink.add(std::move(diagnostic));
    }
    void drop() { gathered.references.resize(references); }
    Gathered& gathered;
    diagnostics::Sink sink;
    Context checker;
    size_t references;
};

} // namespace

namespace {
/// before + made * times, as far as it can be counted: repetitions in repetitions grow without bounds.
uint64_t sumWithin(uint64_t before, uint64_t made, int64_t times) {
    // Far beyond every array, far below an overflow of the next product.
    constexpr uint64_t most = uint64_t(1) << 40;
    if (times <= 0) return before;
    if (made > most / static_cast<uint64_t>(times)) return most;
    return std::min(most, before + made * static_cast<uint64_t>(times));
}
} // namespace

bool needsConstruction(const World& world, TypeId type) {
    const TypeKind kind = world.types.kind(type);
    // Recursive over element types, which are bounded by kMaximumNesting.
    if (kind == TypeKind::Array) return needsConstruction(world, world.types[type].element);
    if (kind != TypeKind::Block && kind != TypeKind::Struct && kind != TypeKind::Union) return false;
    const auto it = world.typeInitials.find(type);
    return (it != world.typeInitials.end() && !it->second.dynamics.empty()) || initMethodOf(world, type);
}

void writeConstant(const World& world, InitialValue& out, TypeId type, uint32_t offset, int16_t bit,
                   const types::Value& value) {
    const uint32_t size = bit >= 0 ? 1 : world.types[type].size;
    // A type that was reported as wrong may have any size; nothing is written outside of the bytes there are.
    if (uint64_t(offset) + size > out.bytes.size()) return;
    types::writeValue(world.types, type, value, std::span(out.bytes).subspan(offset, size), bit);
}

namespace {

/// An initial value written at one place of an image, which has a type. What is wrong is reported, the rest is written.
class Writing {
public:
    Writing(const Check& check, InitialValue& out, TypeId type, uint32_t offset, const Scope& scope)
        : m_check(check), m_out(out), m_type(type), m_kind(check.world.types.kind(type)), m_offset(offset),
          m_scope(scope) {}

    /// FB_Init and what code must do for every instance come before what is written for this one.
    void construct(const std::vector<syntax::Argument>* constructor) {
        const bool hasInit = constructor && initMethodOf(m_check.world, m_type);
        if (hasInit || needsConstruction(m_check.world, m_type)) {
            DynamicInit dynamic = dynamicHere();
            dynamic.isConstruction = true;
            // m : Motor(number := 1) gives arguments to FB_Init if there is one, else initial values to members.
            dynamic.constructor = hasInit ? constructor : nullptr;
            m_out.dynamics.push_back(dynamic);
        }
        if (!constructor || hasInit) return;
        if (hasMembers())
            members(*constructor);
        else if (!constructor->empty())
            m_check.emit(constructor->front().range,
                         findings::NotAllowedHere(Verbatim("(…)"), phrases::In(m_check.world.nameOf(m_type))));
    }

    void value(const syntax::Expr& value, int16_t bit) {
        // By the form of the value first: the parser has already told lists from expressions.
        if (value.kind == ExprKind::StructInit) {
            if (hasMembers()) return members(value.arguments);
            m_check.emit(value.range, findings::TypeMismatch(Verbatim("(… := …)"), m_check.world.nameOf(m_type)));
        } else if (m_kind == TypeKind::Array && (value.kind == ExprKind::ArrayInit || value.kind == ExprKind::Repeat)) {
            elements(value);
        } else if (value.kind == ExprKind::ArrayInit) {
            m_check.emit(value.range, findings::TypeMismatch(Verbatim("[…]"), m_check.world.nameOf(m_type)));
        } else {
            expressionHere(value, bit);
        }
    }

private:
    [[nodiscard]] bool hasMembers() const {
        return m_kind == TypeKind::Block || m_kind == TypeKind::Struct || m_kind == TypeKind::Union;
    }

    [[nodiscard]] DynamicInit dynamicHere() const {
        DynamicInit dynamic;
        dynamic.offset = m_offset;
        dynamic.type = m_type;
        dynamic.scope = m_scope;
        return dynamic;
    }

    void members(const std::vector<syntax::Argument>& arguments) {
        // The missing base was reported; each member it might have had would be a message more.
        if (hasUnknownBase(m_check.world.unitOf(m_type))) return; // its members are not known
        for (const syntax::Argument& argument : arguments)
            if (argument.value) member(argument);
    }

    void member(const syntax::Argument& argument) {
        if (!argument.name.isValid()) {
            m_check.emit(argument.range,
                         findings::Expected(phrases::AMembersName(), m_check.world.textOf(argument.value->range)));
            return;
        }
        const SourceRange range = argument.name.range;
        const types::Field* known = fieldOf(m_check.world, m_type, argument.name.text);
        if (!known) {
            auto& diagnostic =
                m_check.emit(range, findings::UnknownMember(m_check.world.nameOf(m_type), argument.name.text));
            return suggest(m_check.gathered, diagnostic, range, argument.name.text, memberNames(m_check.world, m_type));
        }
        if (Unit* unit = m_check.world.unitOf(m_type))
            if (const Member found = findMember(*unit, m_check.world.names.find(argument.name.text)); found.variable)
                refer(m_check, range, found.variable->symbol, false, true);
        // A copy and not a reference:
        const types::Field field = *known; // the table of types may grow meanwhile
        // An in-out has no value before a call binds it.
        if (field.section == types::FieldSection::InOut) {
            m_check.emit(range, findings::NotAllowedHere(phrases::AnInOut(field.name), phrases::InAnInitialValue()));
            return;
        }
        initialise(m_check, m_out, field.bit >= 0 ? types::TypeTable::of(TypeKind::Bool) : field.type,
                   m_offset + field.offset, field.bit, argument.value, m_scope, nullptr);
    }

    void elements(const syntax::Expr& value) {
        m_element = m_check.world.types[m_type].element;
        m_size = m_check.world.types[m_element].size;
        // All dimensions in one row (table 15): [1, 2, 3, 4] fills ARRAY[0..1, 0..1] line by line.
        m_count = m_size ? m_check.world.types[m_type].size / m_size : 0;
        fill(value.arguments, value.range);
        if (m_index > m_count) m_check.emit(value.range, findings::TooManyInitialValues(m_index, m_count));
    }

    void fill(const std::vector<syntax::Argument>& arguments, SourceRange whole) {
        // ARRAY OF ARRAY: an inner list is one element. With several dimensions, inner brackets are only for the
        // reader.
        const bool isNested = m_check.world.types.kind(m_element) == TypeKind::Array;
        for (const syntax::Argument& argument : arguments) {
            const syntax::Expr* item = argument.value;
            if (!item) {
                // [1, , 3]: an element that is left out begins as its type does.
                ++m_index; // the default
            } else if (item->kind == ExprKind::Repeat || isConstantRepeat(*item)) {
                if (!repeat(*item, whole)) return;
            } else if (item->kind == ExprKind::ArrayInit && !isNested) {
                fill(item->arguments, whole);
            } else {
                if (m_index < m_count)
                    initialise(m_check, m_out, m_element, m_offset + static_cast<uint32_t>(m_index * m_size), -1, item,
                               m_scope, nullptr);
                ++m_index;
            }
        }
    }

    /// cCount(0): written as a call of a constant.
    [[nodiscard]] bool isConstantRepeat(const syntax::Expr& item) {
        if (item.kind != ExprKind::Call || !item.base ||
            (item.base->kind != ExprKind::NameRef && item.base->kind != ExprKind::Member))
            return false;
        // 3(0) and cCount(0) look the same; a call of a function looks so as well. What the name denotes decides.
        Trial trial(m_check, m_scope);
        trial.checker.isMuted = true;
        const Denoted denoted = denote(trial.checker, *item.base, Access::Read);
        // Whether it is a repetition is all that was asked: the real look comes later.
        trial.drop();
        return denoted.kind == Denoted::Kind::Value && denoted.value.isConstant() &&
               std::holds_alternative<int64_t>(denoted.value.expr->value.data);
    }

    /// False: more needs code than can be.
    bool repeat(const syntax::Expr& item, SourceRange whole) {
        const auto times = constantInteger(m_check, item.base, m_scope);
        if (!times || *times < 0) return true;
        if (item.arguments.empty() || (item.arguments.size() == 1 && !item.arguments[0].value)) { // 5(): the default
            m_index = sumWithin(m_index, 1, *times);
            return true;
        }
        for (int64_t i = 0; i < *times; ++i) {
            // What is repeated may itself be a list, so the first round is made to find out how many elements it has.
            const uint64_t before = m_index;
            const size_t dynamics = m_out.dynamics.size();
            fill(item.arguments, whole);
            const uint64_t made = m_index - before;
            if (made == 0) return true;
            // Each element that is no constant costs code: a million of them is a mistake, not a wish.
            if (m_out.dynamics.size() > kMaximumInitialisedByCode) {
                m_check.emit(whole, findings::NotConstant());
                return false;
            }
            if (i == 0 && m_out.dynamics.size() == dynamics && before + made <= m_count) {
                copyOn(before, made, *times);
                return true;
            }
            if (m_index > m_count) { // reported at the end; no need to go on
                m_index = sumWithin(before, made, *times);
                return true;
            }
        }
        return true;
    }

    /// What is constant is checked once and its bytes are copied: a list may say a million times the same.
    void copyOn(uint64_t before, uint64_t made, int64_t times) {
        const uint64_t total = sumWithin(0, made, times);
        const auto at = [&](uint64_t index) {
            return m_out.bytes.begin() + static_cast<std::ptrdiff_t>(m_offset + index * m_size);
        };
        for (uint64_t k = made; k < total && before + k < m_count; ++k)
            std::copy_n(at(before + k % made), m_size, at(before + k));
        m_index = before + total;
    }

    void expressionHere(const syntax::Expr& value, int16_t bit) {
        Trial trial(m_check, m_scope);
        DynamicInit dynamic = dynamicHere();
        dynamic.bit = bit;
        dynamic.value = &value;
        if (m_kind == TypeKind::Reference) {
            trial.drop();
            dynamic.isReference = true;
            m_out.dynamics.push_back(dynamic);
            return;
        }
        const Operand operand = converted(trial.checker, expression(trial.checker, value, m_type), m_type);
        // Unknown was wrong and its message counts; constant is done here.
        if (operand.isUnknown() || operand.isConstant()) {
            trial.keep();
            if (operand.isConstant()) writeConstant(m_check.world, m_out, m_type, m_offset, bit, operand.expr->value);
            return;
        }
        trial.drop(); // it is checked again where its code is made
        m_out.dynamics.push_back(dynamic);
    }

    const Check& m_check;
    InitialValue& m_out;
    TypeId m_type;
    TypeKind m_kind;
    uint32_t m_offset;
    const Scope& m_scope;
    // of an array
    TypeId m_element;
    uint32_t m_size = 0;  // of an element
    uint64_t m_count = 0; // elements there are
    uint64_t m_index = 0; // the next one
};

} // namespace

/// An initial value at a place of its type.
///   ok:    a : ARRAY[1..3] OF INT := [1, 2(0)]; p : Point := (x := 1);
///   wrong: a : ARRAY[1..2] OF INT := [1, 2, 3];  (P3031)   p : Point := (z := 1);  (P2002)
void initialise(const Check& check, InitialValue& out, TypeId type, uint32_t offset, int16_t bit,
                const syntax::Expr* value, const Scope& scope, const std::vector<syntax::Argument>* constructor) {
    if (check.world.types.kind(type) == TypeKind::Unknown) return;
    Writing writing(check, out, type, offset, scope);
    writing.construct(constructor);
    if (value) writing.value(*value, bit);
}

namespace {
const syntax::TypeSpec* innermost(const syntax::TypeSpec* spec) {
    while (spec && spec->kind == syntax::TypeSpecKind::Array && spec->element) spec = spec->element;
    return spec;
}
} // namespace

bool hasConstructor(const syntax::TypeSpec* spec) {
    const syntax::TypeSpec* inner = innermost(spec);
    return inner && (!inner->constructor.empty() || !inner->constructors.empty());
}

namespace {
/// The elements of an array get the bytes of the first.
void repeatBytes(InitialValue& out, uint32_t offset, uint32_t size, uint32_t count) {
    if (uint64_t(offset) + uint64_t(size) * count > out.bytes.size()) return;
    const auto first = out.bytes.begin() + static_cast<std::ptrdiff_t>(offset);
    for (uint32_t i = 1; i < count; ++i)
        std::copy_n(first, size, first + static_cast<std::ptrdiff_t>(uint64_t(i) * size));
}
} // namespace

/// With what is written behind the type: `m : Motor(number := 1)`, for every element of an array of them, or for each
/// its own.
void initialiseDeclared(const Check& check, InitialValue& out, TypeId type, uint32_t offset, int16_t bit,
                        const syntax::Expr* value, const Scope& scope, const syntax::TypeSpec* spec) {
    if (!hasConstructor(spec)) return initialise(check, out, type, offset, bit, value, scope, nullptr);
    const syntax::TypeSpec* inner = innermost(spec);
    if (check.world.types.kind(type) != TypeKind::Array) {
        if (!inner->constructors.empty())
            check.emit(spec->range, findings::NotAllowedHere(Verbatim("[(…)]"), phrases::In(check.world.nameOf(type))));
        return initialise(check, out, type, offset, bit, value, scope,
                          inner->constructor.empty() ? nullptr : &inner->constructor);
    }
    TypeId element = type;
    while (check.world.types.kind(element) == TypeKind::Array) element = check.world.types[element].element;
    const uint32_t size = check.world.types[element].size, count = size ? check.world.types[type].size / size : 0;
    if (inner->constructors.size() > count)
        check.emit(spec->range, findings::TooManyInitialValues(inner->constructors.size(), count));
    // Equal arguments for all: a loop instead of a call for each, so that code does not grow with the array.
    if (initMethodOf(check.world, element) && inner->constructors.empty()) { // one loop for all of them
        DynamicInit dynamic;
        dynamic.offset = offset;
        dynamic.type = type;
        dynamic.isConstruction = true;
        dynamic.constructor = &inner->constructor;
        dynamic.scope = scope;
        out.dynamics.push_back(dynamic);
    } else {
        for (uint32_t i = 0; i < count; ++i) {
            const auto* constructor = inner->constructors.empty()      ? &inner->constructor
                                      : i < inner->constructors.size() ? &inner->constructors[i]
                                                                       : nullptr;
            const size_t dynamics = out.dynamics.size();
            initialise(check, out, element, offset + i * size, -1, nullptr, scope, constructor);
            // Without code and with one list for all, the bytes of the first element are those of every other.
            const bool areEqual = inner->constructors.empty() && out.dynamics.size() == dynamics;
            if (out.dynamics.size() > kMaximumInitialisedByCode) {
                check.emit(spec->range, findings::NotConstant());
                break;
            }
            if (!areEqual) continue;
            repeatBytes(out, offset, size, count);
            break;
        }
    }
    if (value)
        check.emit(value->range,
                   findings::NotAllowedHere(phrases::AnInitialValue(), phrases::InADeclarationWithFbInit()));
}

/// The initial value of a declared variable at `offset` of `out`.
void setInitial(WorldBuilder& world, InitialValue& out, Variable& variable, uint32_t offset) {
    const syntax::Expr* initial = variable.declaration ? variable.declaration->initial : nullptr;
    initialiseDeclared(world, out, variable.type, offset, -1, initial, variable.scope, variable.spec);
}

namespace {

void construct(Context& checker, tree::Place* place, const std::vector<syntax::Argument>* constructor,
               std::vector<tree::Stmt*>& out);

/// A loop for each dimension instead of a call for each element: the code does not grow with the array.
void constructArray(Context& checker, tree::Place* place, const std::vector<syntax::Argument>* constructor,
                    std::vector<tree::Stmt*>& out) {
    const types::Type& type = checker.world.types[place->type];
    const TypeId lint = types::TypeTable::of(TypeKind::Lint);
    tree::Place* element = checker.arena.make<tree::Place>();
    element->kind = tree::PlaceKind::Index;
    element->type = type.element;
    element->range = place->range;
    element->base = place;
    std::vector<tree::Stmt*>* into = &out;
    for (const types::Dimension& dimension : type.dimensions) {
        tree::Place* counter = localPlace(checker, newLocal(checker, "i", lint), lint, place->range);
        tree::Stmt* loop = newStmt(checker, tree::StmtKind::For, {});
        loop->place = counter;
        loop->operandType = lint;
        loop->a = constant(checker, {lint, dimension.low}, place->range).expr;
        loop->b = constant(checker, {lint, dimension.high}, place->range).expr;
        loop->c = constant(checker, {lint, int64_t(1)}, place->range).expr;
        element->indices.push_back(load(checker, counter, place->range).expr);
        into->push_back(loop);
        into = &loop->body;
    }
    construct(checker, element, constructor, *into);
}

void callInit(Context& checker, tree::Place* place, Unit& method, const std::vector<syntax::Argument>* constructor,
              bool isLast, std::vector<tree::Stmt*>& out) {
    syntax::Expr call;
    call.kind = syntax::ExprKind::Call;
    call.range = place->range;
    // CODESYS's FB_Init has these two, and nobody writes them at the declaration: TRUE at the first start, FALSE
    // because this is no online change.
    static constexpr std::string_view kImplicit[] = {"bInitRetains", "bInCopyCode"};
    completeUnit(checker, method, place->range);
    std::vector<const Variable*> own;
    syntax::Expr yes, no;
    yes.kind = no.kind = syntax::ExprKind::Literal;
    yes.op = lex::TokenKind::True;
    no.op = lex::TokenKind::False;
    yes.range = no.range = place->range;
    for (const Variable* parameter : method.parameters) {
        const auto* implicit = std::find_if(std::begin(kImplicit), std::end(kImplicit), [&](std::string_view name) {
            return equalsIgnoringCase(name, parameter->name);
        });
        if (implicit == std::end(kImplicit)) {
            own.push_back(parameter);
            continue;
        }
        syntax::Argument argument;
        argument.kind = syntax::ArgumentKind::Input;
        argument.name = {*implicit, place->range};
        argument.value = implicit == std::begin(kImplicit) ? &yes : &no;
        argument.range = place->range;
        call.arguments.push_back(argument);
    }
    size_t next = 0;
    if (constructor) {
        for (syntax::Argument argument : *constructor) {
            if (argument.kind == syntax::ArgumentKind::Positional) {
                if (next >= own.size()) {
                    // Bases take from the arguments what they know; only the block's own FB_Init may complain about the
                    // rest.
                    if (isLast) checker.emit(argument.range, findings::TooManyArguments(method.name, own.size()));
                    break;
                }
                argument.kind = syntax::ArgumentKind::Input;
                argument.name = {own[next++]->name, argument.range};
            } else if (!isLast && std::none_of(own.begin(), own.end(), [&](const Variable* v) {
                           return equalsIgnoringCase(v->name, argument.name.text);
                       })) {
                continue;
            }
            call.arguments.push_back(argument);
        }
    }
    Denoted callee;
    callee.kind = Denoted::Kind::Unit;
    callee.unit = &method;
    callee.instance = place;
    // Directly, without dispatch: a base's FB_Init must not end in that of the derived block.
    callee.isSuper = true;
    syntax::Expr base;
    base.kind = syntax::ExprKind::NameRef;
    base.range = place->range;
    call.base = &base;
    const Operand value = callUnit(checker, callee, call);
    if (!value.expr) return;
    tree::Stmt* evaluate = newStmt(checker, tree::StmtKind::Evaluate, {});
    evaluate->a = value.expr;
    out.push_back(evaluate);
}

void construct(Context& checker, tree::Place* place, const std::vector<syntax::Argument>* constructor,
               std::vector<tree::Stmt*>& out) {
    if (checker.world.types.kind(place->type) == TypeKind::Array)
        return constructArray(checker, place, constructor, out);
    takeAddress(checker, place);
    // First what the type itself needs (inner blocks, references), since FB_Init may already use it.
    if (const tree::FunctionId init = initialiserOf(checker, place->type); init.isValid()) {
        tree::Expr* call = checker.arena.make<tree::Expr>();
        call->kind = tree::ExprKind::Call;
        call->type = types::TypeTable::of(TypeKind::Void);
        call->range = place->range;
        call->call = checker.arena.make<tree::Call>();
        call->call->callee = init;
        call->call->instance = place;
        tree::Stmt* evaluate = newStmt(checker, tree::StmtKind::Evaluate, {});
        evaluate->a = call;
        out.push_back(evaluate);
    }
    std::vector<Unit*> chain; // FB_Init of the bases first
    const NameId id = checker.world.names.find("FB_Init");
    for (Unit* unit = checker.world.unitOf(place->type); unit; unit = unit->base)
        if (const auto it = unit->members.find(id); it != unit->members.end() && it->second.unit)
            chain.push_back(it->second.unit);
    for (size_t i = chain.size(); i-- > 0;) callInit(checker, place, *chain[i], constructor, i == 0, out);
}

} // namespace

void emitDynamics(Context& checker, const std::vector<DynamicInit>& dynamics,
                  const std::function<tree::Place*(const DynamicInit&)>& placeOf, std::vector<tree::Stmt*>& out) {
    // Each value is seen from where it was written: a block's declaration, not the program that has the block.
    const Scope outer = checker.scope;
    for (const DynamicInit& dynamic : dynamics) {
        tree::Place* place = placeOf(dynamic);
        checker.scope = dynamic.scope;
        if (dynamic.value) place->range = dynamic.value->range;
        if (dynamic.isConstruction) {
            construct(checker, place, dynamic.constructor, out);
        } else if (dynamic.isReference) {
            bindReference(checker, place, *dynamic.value, {}, out);
        } else {
            const Operand value = converted(checker, expression(checker, *dynamic.value, dynamic.type), dynamic.type);
            if (!value.isUnknown()) out.push_back(assignStmt(checker, place, value.expr, {}));
        }
    }
    checker.scope = outer;
}

/// Made when it is first needed, and once for a type: most types have nothing that bytes cannot say.
tree::FunctionId initialiserOf(const Check& check, TypeId type) {
    Gathered& gathered = check.gathered;
    if (const auto it = gathered.initialisers.find(type); it != gathered.initialisers.end()) return it->second;
    const auto initial = check.world.typeInitials.find(type);
    if (initial == check.world.typeInitials.end() || initial->second.dynamics.empty())
        return gathered.initialisers[type] = {};
    const tree::FunctionId id = newFunction(gathered, check.world.nameOf(type) + ".INIT", check.world.unitOf(type));
    gathered.initialisers[type] = id;
    tree::Function& function = gathered.functions[id.index()];
    function.instanceType = type;
    Context checker(check, {check.world.unitOf(type), nullptr, nullptr}, gathered.sink, gathered.arena);
    checker.function = &function;
    checker.functionId = id;
    // A copy: making the code may complete other types, and the table of them moves.
    const std::vector<DynamicInit> dynamics = initial->second.dynamics;
    emitDynamics(
        checker, dynamics,
        [&](const DynamicInit& dynamic) {
            tree::Place* place =
                absolutePlace(checker, dynamic.offset, dynamic.type, dynamic.bit, check.world.types[type].declaration);
            // Offsets are those within the type, so one function initialises every instance.
            place->kind = tree::PlaceKind::Instance;
            return place;
        },
        function.body);
    return id;
}

void buildInitialiser(WorldBuilder& world) {
    // Most programs have none: they begin with their bytes alone, which is a copy.
    if (world.programInits.empty()) return;
    const tree::FunctionId id = newFunction(world, "INIT", nullptr);
    tree::Function& function = world.functions[id.index()];
    Context checker(world, {nullptr, &world.top, nullptr}, world.sink, world.arena);
    checker.function = &function;
    checker.functionId = id;
    emitDynamics(
        checker, world.programInits,
        [&](const DynamicInit& dynamic) {
            return absolutePlace(checker, dynamic.offset, dynamic.type, dynamic.bit,
                                 world.types[dynamic.type].declaration);
        },
        function.body);
    world.program->initializer = id;
}

} // namespace plc::sema
