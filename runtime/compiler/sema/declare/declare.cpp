// First pass: every name of every file gets its entity; nothing is resolved yet, so order does not matter.
#include "runtime/compiler/sema/declare/declare.h"

#include "runtime/compiler/sema/context.h"
#include "runtime/compiler/sema/declare/declare_types.h"
#include "runtime/compiler/sema/declare/tests.h"
#include "runtime/compiler/sema/names/lookup.h"
#include "runtime/compiler/sema/program/analyze.h"

#include "runtime/base/text.h"

namespace plc::sema {

using syntax::SectionKind;

static Space& childSpace(WorldBuilder& world, Space& parent, std::string_view name);
static void declare(WorldBuilder& world, const syntax::Decl& decl, Space& space, const syntax::SyntaxFile& file);
static Unit* declareMethod(WorldBuilder& world, const syntax::Pou& pou, Unit& owner, std::string_view name,
                           UnitKind kind);
static void declareMembers(WorldBuilder& world, Unit& unit);
static void declareImplicitEno(WorldBuilder& world, Unit& unit);
static Variable& addVariable(WorldBuilder& world, Unit& unit, Variable variable,
                             const std::vector<syntax::Pragma>* pragmas);
static void declareVariables(WorldBuilder& world, Unit& unit, const std::vector<syntax::VarSection*>& sections);

namespace {

bool isNamed(const syntax::TypeSpec* spec, std::string_view type) {
    return spec && spec->kind == syntax::TypeSpecKind::Named && spec->path.size() == 1 &&
           equalsIgnoringCase(spec->path[0].text, type);
}

// Steps of a chart are variables of the type SFC_STEP by the time they get here (lower).
bool isStepOfChart(const Variable* variable) { return variable && isNamed(variable->spec, "SFC_STEP"); }

std::string pathText(const syntax::Path& path) {
    std::string text;
    for (const syntax::Name& name : path) text += (text.empty() ? "" : ".") + std::string(name.text);
    return text;
}

// CODESYS names a list of globals by its file; an ST file with VAR_GLOBAL gets its name in the same way.
std::string_view stemOf(std::string_view path) {
    if (const size_t slash = path.find_last_of("/\\"); slash != std::string_view::npos) path.remove_prefix(slash + 1);
    if (const size_t dot = path.find('.'); dot != std::string_view::npos) path = path.substr(0, dot);
    return path;
}

// 'a, b' in one attribute: libraries keep old names of pins in this way.
std::vector<std::string> aliasesOf(const std::vector<syntax::Pragma>& pragmas) {
    std::vector<std::string> out;
    for (const syntax::Pragma& pragma : pragmas) {
        if (!pragma.isAttribute || !equalsIgnoringCase(pragma.key, "alias")) continue;
        std::string word;
        for (const char c : std::string(pragma.value) + ",") {
            if (c == ',') {
                if (!word.empty()) out.push_back(std::exchange(word, {}));
            } else if (c != ' ' && c != '\'' && c != '\t') {
                word += c;
            }
        }
    }
    return out;
}

SymbolKind symbolKindOf(UnitKind kind) {
    switch (kind) {
    case UnitKind::Program:
        return SymbolKind::Program;
    case UnitKind::Function:
        return SymbolKind::Function;
    case UnitKind::Block:
        return SymbolKind::FunctionBlock;
    case UnitKind::Interface:
        return SymbolKind::Interface;
    case UnitKind::Method:
    case UnitKind::PropertyGet:
    case UnitKind::PropertySet:
        return SymbolKind::Method;
    case UnitKind::Action:
        return SymbolKind::Action;
    }
    return SymbolKind::Function;
}

types::FieldSection sectionOf(SectionKind kind) {
    switch (kind) {
    case SectionKind::Input:
        return types::FieldSection::Input;
    case SectionKind::Output:
        return types::FieldSection::Output;
    case SectionKind::InOut:
        return types::FieldSection::InOut;
    case SectionKind::External:
        return types::FieldSection::External;
    case SectionKind::Stat:
        return types::FieldSection::Static;
    default:
        return types::FieldSection::Local;
    }
}

} // namespace

Space& childSpace(WorldBuilder& world, Space& parent, std::string_view name) {
    // A namespace may be opened in many files; it is one (edition 3, 6.9).
    Space*& child = parent.spaces[world.key(name)];
    if (!child) {
        child = &world.spaces.emplace_back();
        child->name = std::string(name);
        child->qualified = parent.qualified.empty() ? child->name : parent.qualified + "." + child->name;
        child->parent = &parent;
        addSymbol(world, SymbolKind::Namespace, name, parent.qualified, {});
    }
    return *child;
}

// Files come in the order of the build: the program's first, then the libraries, so that numbers of its units stay the
// same when a library grows.
void declareFile(WorldBuilder& world, const syntax::SyntaxFile& file) {
    // By the file's number, with gaps: a text of the library may be given without a file.
    if (file.file.isValid()) {
        if (world.fileOf.size() <= file.file.index()) world.fileOf.resize(file.file.index() + 1);
        world.fileOf[file.file.index()] = &file;
    }
    Space* space = &world.top;
    // What a library declares is in a space of its own, which look-up asks last.
    if (!file.library.empty()) {
        space = &childSpace(world, world.top, file.library);
        if (!space->isLibrary) {
            space->isLibrary = true;
            world.libraries.push_back(space);
        }
    }
    for (const syntax::Decl* decl : file.declarations) declare(world, *decl, *space, file);
}

void declare(WorldBuilder& world, const syntax::Decl& decl, Space& space, const syntax::SyntaxFile& file) {
    switch (decl.kind) {
    case syntax::DeclKind::Pou:
        if (decl.pou) declareUnit(world, *decl.pou, space, file);
        return;
    case syntax::DeclKind::Type:
        if (decl.type) declareType(world, *decl.type, space, file);
        return;
    case syntax::DeclKind::Globals:
        if (decl.globals)
            declareGlobals(world, *decl.globals, space, file,
                           decl.globals->name.empty() ? stemOf(world.sources[file.file].path()) : decl.globals->name);
        return;
    case syntax::DeclKind::Configuration:
        if (decl.configuration) world.configurations.push_back({decl.configuration, &file, &space});
        return;
    case syntax::DeclKind::Test:
        if (decl.test) declareTest(world, *decl.test, space, file);
        return;
    case syntax::DeclKind::Namespace: {
        if (!decl.space) return;
        Space* inner = &space;
        // NAMESPACE a.b.c.… of a generated text: qualified names would grow with the square of the depth.
        if (decl.space->path.size() > kMaximumBases) // each has the names of those around it in its own
            return (void)world.emit(joined(decl.space->path.front().range, decl.space->path.back().range),
                                    findings::NestedTooDeep());
        for (const syntax::Name& name : decl.space->path) inner = &childSpace(world, *inner, name.text);
        for (const syntax::Decl* child : decl.space->declarations) {
            if (child->kind == syntax::DeclKind::Using) {
                for (const syntax::Path& path : child->usings) inner->usingPaths.push_back(&path);
            } else {
                declare(world, *child, *inner, file);
            }
        }
        return;
    }
    case syntax::DeclKind::Using:
        return; // resolveUsings
    }
}

///   ok:    NAMESPACE Here … END_NAMESPACE USING Here;      wrong: USING Nowhere;  (P3026)
void resolveUsings(WorldBuilder& world) {
    const auto resolve = [&](Space& from, const syntax::Path& path) -> Space* {
        // As with names: the innermost namespace in which the path is found.
        for (Space* start = &from; start; start = start->parent) {
            Space* found = start;
            for (const syntax::Name& name : path) {
                const auto it = found->spaces.find(world.key(name.text));
                found = it == found->spaces.end() ? nullptr : it->second;
                if (!found) break;
            }
            if (found) return found;
        }
        std::vector<std::string> candidates;
        for (const Space& space : world.spaces) candidates.push_back(space.qualified);
        const SourceRange range = joined(path.front().range, path.back().range);
        suggest(world, world.emit(range, findings::UnknownUsing(pathText(path))), range, pathText(path), candidates);
        return nullptr;
    };
    for (Space& space : world.spaces)
        for (const syntax::Path* path : space.usingPaths)
            if (!path->empty())
                if (Space* used = resolve(space, *path)) space.usings.push_back(used);
    for (Unit& unit : world.units) {
        if (!unit.pou) continue;
        for (const syntax::Path& path : unit.pou->usings)
            if (!path.empty())
                if (Space* used = resolve(*unit.space, path)) world.unitUsings[&unit].push_back(used);
    }
    // USING at the top of a file holds for that file only.
    for (const syntax::SyntaxFile* file : world.fileOf) {
        if (!file) continue;
        for (const syntax::Decl* decl : file->declarations) {
            if (decl->kind != syntax::DeclKind::Using) continue;
            for (const syntax::Path& path : decl->usings)
                if (!path.empty())
                    if (Space* used = resolve(world.top, path)) world.fileUsings[file].push_back(used);
        }
    }
}

///   wrong: FUNCTION F … END_FUNCTION FUNCTION f … END_FUNCTION  (P3001)
Unit* declareUnit(WorldBuilder& world, const syntax::Pou& pou, Space& space, const syntax::SyntaxFile& file) {
    Unit& unit = world.units.emplace_back();
    switch (pou.kind) {
    case syntax::PouKind::Program:
        unit.kind = UnitKind::Program;
        break;
    case syntax::PouKind::FunctionBlock:
        unit.kind = UnitKind::Block;
        break;
    case syntax::PouKind::Interface:
        unit.kind = UnitKind::Interface;
        break;
    default:
        unit.kind = UnitKind::Function;
        break;
    }
    unit.name = std::string(pou.name.text);
    unit.qualified = unit.name;
    unit.id = world.key(pou.name.text);
    unit.pou = &pou;
    unit.file = &file;
    unit.range = pou.name.range;
    unit.space = &space;
    unit.access = pou.access;
    unit.isAbstract = pou.isAbstract;
    unit.isFinal = pou.isFinal;
    // {attribute 'simulation'}: a model of the plant, which runs after the programs that it serves.
    unit.isSimulation = hasAttribute(pou.pragmas, "simulation");
    unit.symbol = addSymbol(world, symbolKindOf(unit.kind), unit.name, space.qualified, unit.range, pou.comment);
    if (pou.name.isValid()) {
        // A second unit of the same name is declared all the same, so that its own text is checked; look-up finds the
        // first.
        std::vector<Entity>& entities = space.entities[unit.id];
        for (const Entity& other : entities) {
            if (!other.unit && !other.type) continue;
            auto& diagnostic = world.emit(unit.range, findings::DuplicateName(unit.name));
            diagnostic.related.push_back(
                {other.unit ? other.unit->range : other.type->declaration->name.range, notes::FirstDeclaredHere()});
            break;
        }
        entities.push_back({nullptr, &unit, nullptr});
    }
    // The type exists before anything is known about it: variables of it may be declared in any order.
    if (unit.isInstanced() || unit.kind == UnitKind::Interface) {
        unit.type =
            world.types.declare(unit.kind == UnitKind::Interface ? TypeKind::Interface : TypeKind::Block, unit.name);
        types::Type& type = world.types.edit(unit.type);
        type.space = space.qualified;
        type.declaration = unit.range;
        type.comment = std::string(pou.comment);
        world.unitsByType[unit.type] = &unit;
        world.symbols[unit.symbol.index()].type = unit.type;
    }
    if (unit.isCode()) unit.function = newFunction(world, unit.name, &unit);
    declareMembers(world, unit);
    return &unit;
}

Unit* declareMethod(WorldBuilder& world, const syntax::Pou& pou, Unit& owner, std::string_view name, UnitKind kind) {
    Unit& unit = world.units.emplace_back();
    unit.kind = kind;
    unit.name = std::string(name);
    unit.qualified = owner.name + "." + unit.name;
    unit.id = world.key(unit.name);
    unit.pou = &pou;
    unit.file = owner.file;
    unit.range = pou.name.range;
    unit.space = owner.space;
    unit.owner = &owner;
    unit.access = pou.access;
    // A method's prototype in an interface has no body by definition.
    unit.isAbstract = pou.isAbstract || owner.kind == UnitKind::Interface;
    unit.isFinal = pou.isFinal;
    unit.isOverride = pou.isOverride;
    unit.function = newFunction(world, unit.qualified, &unit);
    // Accessors get their variable and symbol from the property, see declareMembers.
    if (kind == UnitKind::Method) {
        unit.symbol = addSymbol(world, SymbolKind::Method, unit.name, owner.name, unit.range, pou.comment);
        declareMembers(world, unit);
    }
    owner.methods.push_back(&unit);
    return &unit;
}

///   wrong: VAR lamp : BOOL; END_VAR … ACTION lamp: … END_ACTION  (P4017, advice: steps and calls mean the ACTION)
void declareMembers(WorldBuilder& world, Unit& unit) {
    const syntax::Pou& pou = *unit.pou;
    declareVariables(world, unit, pou.sections);
    if (!unit.isInstanced() && unit.kind != UnitKind::Interface && pou.result && unit.kind != UnitKind::PropertyGet) {
        // The function's name is a variable inside of it (2.5.1.1).
        Variable result;
        result.name = unit.name;
        result.id = unit.id;
        result.spec = pou.result;
        result.range = unit.range;
        result.kind = SectionKind::Output;
        result.isResult = true;
        result.symbol = unit.symbol;
        unit.resultVariable = &addVariable(world, unit, std::move(result), nullptr);
    }
    declareImplicitEno(world, unit);
    const auto taken = [&](const syntax::Name& name) {
        const auto it = unit.members.find(
            world.key(name.text)); // a variable may share its name: a call or an access from outside means the other
        if (it == unit.members.end() || (!it->second.unit && !it->second.property)) return false;
        world.emit(name.range, findings::DuplicateName(name.text));
        return true;
    };
    for (const syntax::Pou* method : pou.methods) {
        if (!method->name.isValid()) continue;
        // It is declared although the name is taken, so that its body is checked; only the name leads to the first.
        const bool twice = taken(method->name);
        Unit* made = declareMethod(world, *method, unit, method->name.text, UnitKind::Method);
        if (!twice) unit.members[made->id].unit = made;
    }
    for (const syntax::Property* declared : pou.properties) {
        if (!declared->name.isValid()) continue;
        const bool twice = taken(declared->name);
        Property& property = world.properties.emplace_back();
        property.name = std::string(declared->name.text);
        property.id = world.key(declared->name.text);
        property.declaration = declared;
        property.owner = &unit;
        property.symbol =
            addSymbol(world, SymbolKind::Property, property.name, unit.name, declared->name.range, declared->comment);
        for (const bool isSet : {false, true}) {
            const syntax::Pou* accessor = isSet ? declared->set : declared->get;
            if (!accessor) continue;
            Unit* made = declareMethod(world, *accessor, unit, property.name + (isSet ? ".set" : ".get"),
                                       isSet ? UnitKind::PropertySet : UnitKind::PropertyGet);
            made->property = &property;
            made->symbol = property.symbol;
            made->range = declared->name.range;
            // What is written at the property holds for both accessors unless one says something else.
            if (made->access == syntax::Access::Default) made->access = declared->access;
            made->isAbstract = made->isAbstract || declared->isAbstract;
            made->isFinal = made->isFinal || declared->isFinal;
            made->isOverride = made->isOverride || declared->isOverride;
            (isSet ? property.set : property.get) = made;
            Variable value; // GET: the result; SET: the value assigned
            value.name = property.name;
            value.id = property.id;
            value.spec = declared->type;
            value.range = declared->name.range;
            value.kind = isSet ? SectionKind::Input : SectionKind::Output;
            value.isResult = !isSet;
            value.symbol = property.symbol;
            Variable& added = addVariable(world, *made, std::move(value), nullptr);
            if (!isSet) made->resultVariable = &added;
            declareMembers(world, *made);
        }
        unit.properties.push_back(&property);
        if (!twice) unit.members[property.id].property = &property;
    }
    for (const syntax::ActionDecl* action : pou.actions) {
        if (!action->name.isValid()) continue;
        const auto known = unit.members.find(world.key(action->name.text));
        const Variable* namesake = known == unit.members.end() ? nullptr : known->second.variable;
        if (known != unit.members.end() && !isStepOfChart(namesake)) {
            const bool isBool = namesake && isNamed(namesake->spec, "BOOL"); // some charts have both
            auto& diagnostic = world.emit(action->name.range, isBool ? findings::ActionAndVariable(action->name.text)
                                                                     : findings::DuplicateName(action->name.text));
            if (namesake) diagnostic.related.push_back({namesake->range, notes::TheVariable()});
            if (!isBool) continue;
        }
        // An action is code without variables of its own: self() is the unit around it, whose instance it works on.
        Unit& made = world.units.emplace_back();
        made.kind = UnitKind::Action;
        made.name = std::string(action->name.text);
        made.qualified = unit.name + "." + made.name;
        made.id = world.key(action->name.text);
        made.action = action;
        made.file = unit.file;
        made.range = action->name.range;
        made.space = unit.space;
        made.owner = &unit;
        made.function = newFunction(world, made.qualified, &made);
        made.symbol = addSymbol(world, SymbolKind::Action, made.name, unit.name, made.range);
        declareVariables(world, made, action->sections);
        unit.actions.push_back(&made);
        unit.members[made.id].unit = &made; // an action may share its name with a step of the chart
    }
}

/// A unit that writes ENO without declaring it has it as an output, TRUE at the begin of each call (edition
/// 2, 2.5.1.2).
void declareImplicitEno(WorldBuilder& world, Unit& unit) {
    const bool canHave =
        unit.kind == UnitKind::Function || unit.kind == UnitKind::Method || unit.kind == UnitKind::Block;
    if (!canHave || !unit.file || !unit.pou->body.range.file.isValid() || unit.members.count(world.key("ENO"))) return;
    // The tokens of the body are read, not its tree: this happens before anything is resolved, and a text without ENO
    // (most) costs one comparison for each identifier.
    const SourceRange body = unit.pou->body.range;
    const std::string_view text = world.sources[unit.file->file].text();
    const auto& tokens = unit.file->tokens.tokens;
    auto at = std::lower_bound(tokens.begin(), tokens.end(), body.begin,
                               [](const lex::Token& token, uint32_t begin) { return token.begin < begin; });
    bool found = false;
    for (; at != tokens.end() && at->begin < body.end && !found; ++at) {
        if (at->kind != lex::TokenKind::Identifier || at->end - at->begin != 3 || (text[at->begin] | 0x20) != 'e')
            continue;
        // f(ENO => ok) names the callee's ENO and x.ENO a member: neither is a variable of this unit.
        const bool isArgument = at + 1 != tokens.end() && (at + 1)->kind == lex::TokenKind::Output;
        const bool isMember = at != tokens.begin() && (at - 1)->kind == lex::TokenKind::Dot;
        found = !isArgument && !isMember && equalsIgnoringCase(text.substr(at->begin, 3), "ENO");
    }
    if (!found) return;
    // As if "ENO : BOOL := TRUE" were written: everything behind sees an ordinary output.
    auto* boolean = world.arena.make<syntax::TypeSpec>();
    boolean->kind = syntax::TypeSpecKind::Named;
    boolean->path.push_back({"BOOL", unit.range});
    boolean->range = unit.range;
    auto* yes = world.arena.make<syntax::Expr>();
    yes->kind = syntax::ExprKind::Literal;
    yes->op = lex::TokenKind::True;
    yes->range = unit.range;
    auto* declaration = world.arena.make<syntax::VarDecl>();
    declaration->type = boolean;
    declaration->initial = yes;
    Variable eno;
    eno.name = "ENO";
    eno.id = world.key("ENO");
    eno.declaration = declaration;
    eno.spec = boolean;
    eno.range = unit.range;
    eno.kind = SectionKind::Output;
    eno.symbol = unit.symbol;
    addVariable(world, unit, std::move(eno), nullptr);
    unit.hasImplicitEno = true;
}

///   wrong: VAR x : INT; X : BOOL; END_VAR  (P3001)
Variable& addVariable(WorldBuilder& world, Unit& unit, Variable variable, const std::vector<syntax::Pragma>* pragmas) {
    variable.owner = &unit;
    variable.space = unit.space;
    variable.scope = {&unit, unit.space, unit.file};
    // A deque: references to variables stay good while others are added.
    unit.variables.push_back(std::move(variable));
    Variable& added = unit.variables.back();
    Member& member = unit.members[added.id];
    if (member) {
        const SourceRange first = member.variable ? member.variable->range
                                  : member.unit   ? member.unit->range
                                                  : SourceRange{};
        auto& diagnostic = world.emit(added.range, findings::DuplicateName(added.name));
        // What a lowering has added has no place to show.
        if (first.file.isValid()) diagnostic.related.push_back({first, notes::FirstDeclaredHere()});
    } else {
        member.variable = &added;
    }
    if (pragmas)
        for (const std::string& alias : aliasesOf(*pragmas))
            // try_emplace: a declared name is never hidden by somebody's alias.
            unit.members.try_emplace(world.key(alias)).first->second.variable = &added;
    return added;
}

void declareVariables(WorldBuilder& world, Unit& unit, const std::vector<syntax::VarSection*>& sections) {
    const Scope scope{&unit, unit.space, unit.file};
    for (const syntax::VarSection* section : sections) {
        if (section->kind == SectionKind::Access && unit.kind == UnitKind::Program)
            continue; // other names, made with the layout
        for (const syntax::VarDecl* declaration : section->declarations) {
            declareInlineEnums(world, declaration->type, scope, unit.enumerators);
            for (const syntax::Name& name : declaration->names) {
                if (!name.isValid()) continue;
                Variable variable;
                variable.name = std::string(name.text);
                variable.id = world.key(name.text);
                variable.declaration = declaration;
                variable.section = section;
                variable.spec = declaration->type;
                variable.range = name.range;
                variable.kind = section->kind;
                // a CONSTANT parameter has the caller's value, but cannot be written
                variable.isConstant = section->constant && section->kind != SectionKind::Input &&
                                      section->kind != SectionKind::InOut && section->kind != SectionKind::Output;
                variable.isLocated = !declaration->address.empty();
                variable.symbol = addSymbol(world, section->constant ? SymbolKind::Constant : SymbolKind::Variable,
                                            name.text, unit.qualified, name.range, declaration->comment);
                Symbol& symbol = world.symbols[variable.symbol.index()];
                symbol.section = sectionOf(section->kind);
                symbol.isConstant = section->constant;
                symbol.path = symbol.name;
                addVariable(world, unit, std::move(variable), &declaration->pragmas);
            }
        }
    }
}

} // namespace plc::sema
