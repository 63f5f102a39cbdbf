// First pass, of types and lists of globals: enumerations, structures, aliases, VAR_GLOBAL.
#include "runtime/compiler/sema/declare/declare_types.h"

#include "runtime/compiler/sema/context.h"
#include "runtime/compiler/sema/declare/declare.h"
#include "runtime/compiler/sema/program/analyze.h"

#include "runtime/base/text.h"

namespace plc::sema {

using syntax::SectionKind;

static EnumType* declareEnum(WorldBuilder& world, const syntax::TypeSpec& spec, std::string name, const Scope& scope,
                             std::unordered_map<NameId, std::vector<EnumeratorRef>>& table,
                             const std::vector<syntax::Pragma>* attributes);

bool hasAttribute(const std::vector<syntax::Pragma>& pragmas, std::string_view key) {
    return std::any_of(pragmas.begin(), pragmas.end(),
                       [&](const syntax::Pragma& p) { return p.isAttribute && equalsIgnoringCase(p.key, key); });
}

// x : (Off, On) declares enumerators where the variable is declared; they have to be known before any body.
void declareInlineEnums(WorldBuilder& world, const syntax::TypeSpec* spec, const Scope& scope,
                        std::unordered_map<NameId, std::vector<EnumeratorRef>>& table) {
    // ARRAY OF ARRAY OF …: as deep as types may be.
    for (int depth = 0; spec && depth < 32; spec = spec->element, ++depth) {
        if (spec->kind == syntax::TypeSpecKind::Enum) {
            declareEnum(world, *spec, "enumeration", scope, table, nullptr);
            return;
        }
        for (const syntax::VarDecl* field : spec->fields) declareInlineEnums(world, field->type, scope, table);
    }
}

void declareGlobals(WorldBuilder& world, const syntax::GlobalList& declared, Space& space,
                    const syntax::SyntaxFile& file, std::string_view name) {
    if (!declared.section) return;
    const NameId id = world.key(name);
    // Several VAR_GLOBAL sections of one file are one list: they have one name.
    GlobalsList*& list = space.lists[id];
    if (!list) {
        list = &world.lists.emplace_back();
        list->name = std::string(name);
        list->id = id;
        list->space = &space;
        if (!name.empty()) addSymbol(world, SymbolKind::GlobalList, name, space.qualified, {}, declared.comment);
    }
    // {attribute 'qualified_only'}: GVL.x is the only name of x.
    const bool qualifiedOnly = hasAttribute(declared.section->pragmas, "qualified_only");
    const Scope scope{nullptr, &space, &file};
    for (const syntax::VarDecl* declaration : declared.section->declarations) {
        declareInlineEnums(world, declaration->type, scope, space.enumerators);
        for (const syntax::Name& varName : declaration->names) {
            if (!varName.isValid()) continue;
            Variable& variable = world.globals.emplace_back();
            variable.name = std::string(varName.text);
            variable.id = world.key(varName.text);
            variable.declaration = declaration;
            variable.section = declared.section;
            variable.spec = declaration->type;
            variable.range = varName.range;
            variable.kind = SectionKind::Global;
            variable.scope = scope;
            variable.list = list;
            variable.space = &space;
            variable.isConstant = declared.section->constant;
            variable.isLocated = !declaration->address.empty();
            variable.symbol = addSymbol(world, variable.isConstant ? SymbolKind::Constant : SymbolKind::Variable,
                                        varName.text, list->name, varName.range, declaration->comment);
            // symbols grows with each declaration: the reference is taken after addSymbol and not kept.
            Symbol& symbol = world.symbols[variable.symbol.index()];
            symbol.isConstant = variable.isConstant;
            symbol.path = list->name.empty() ? variable.name : list->name + "." + variable.name;
            if (Variable*& first = list->variables[variable.id]) {
                world.emit(variable.range, findings::DuplicateName(variable.name))
                    .related.push_back({first->range, notes::FirstDeclaredHere()});
            } else {
                first = &variable;
                if (!qualifiedOnly) space.entities[variable.id].push_back({&variable, nullptr, nullptr});
            }
        }
    }
}

///   ok:    TYPE E : (A, B, C); END_TYPE      wrong: TYPE E : (A, B, A); END_TYPE  (P3001)
EnumType* declareEnum(WorldBuilder& world, const syntax::TypeSpec& spec, std::string name, const Scope& scope,
                      std::unordered_map<NameId, std::vector<EnumeratorRef>>& table,
                      const std::vector<syntax::Pragma>* attributes) {
    const bool qualifiedOnly = attributes && hasAttribute(*attributes, "qualified_only");
    EnumType& made = world.enums.emplace_back();
    made.spec = &spec;
    made.scope = scope;
    made.name = name;
    made.type = world.types.declare(TypeKind::Enum, name);
    types::Type& type = world.types.edit(made.type);
    // Until completeEnum has read the type that is written; its values may need constants declared later.
    type.element = types::TypeTable::of(TypeKind::Int);
    type.size = type.align = 2;
    // Size and base type are guesses that every ordinary enumeration keeps.
    type.qualifiedOnly = qualifiedOnly;
    type.isStrict = attributes && hasAttribute(*attributes, "strict");
    made.isTextNamed = attributes && hasAttribute(*attributes, "to_string");
    world.enumsByType[made.type] = &made;
    world.enumsBySpec[&spec] = &made;
    for (uint32_t i = 0; i < spec.enumerators.size(); ++i) {
        const syntax::EnumeratorDecl& declared = spec.enumerators[i];
        type.enumerators.push_back(
            {std::string(declared.name.text), 0, declared.name.range, std::string(declared.comment)});
        made.symbols.push_back(
            addSymbol(world, SymbolKind::Enumerator, declared.name.text, name, declared.name.range, declared.comment));
        world.symbols.back().type = made.type;
        // Twice the same enumerator: the first keeps its number, so later ones do not shift.
        if (!made.indices.try_emplace(world.key(declared.name.text), i).second)
            world.emit(declared.name.range, findings::DuplicateName(declared.name.text));
        if (!qualifiedOnly && declared.name.isValid()) table[world.key(declared.name.text)].push_back({&made, i});
    }
    return &made;
}

TypeId declareStruct(WorldBuilder& world, const syntax::TypeSpec& spec, std::string name, const Scope& scope) {
    StructType& made = world.structs.emplace_back();
    made.spec = &spec;
    made.scope = scope;
    made.name = name;
    // The fields come with completeStruct: their types may be declared further on.
    made.isUnion = spec.kind == syntax::TypeSpecKind::Union;
    made.type = world.types.declare(made.isUnion ? TypeKind::Union : TypeKind::Struct, std::move(name));
    world.structsByType[made.type] = &made;
    world.typesBySpec[&spec] = made.type;
    return made.type;
}

void declareType(WorldBuilder& world, const syntax::TypeDecl& declared, Space& space, const syntax::SyntaxFile& file) {
    if (!declared.name.isValid() || !declared.spec) return;
    DeclaredType& type = world.declaredTypes.emplace_back();
    type.name = std::string(declared.name.text);
    type.id = world.key(declared.name.text);
    type.declaration = &declared;
    type.scope = {nullptr, &space, &file};
    type.symbol = addSymbol(world, SymbolKind::Type, type.name, space.qualified, declared.name.range, declared.comment);
    std::vector<Entity>& entities = space.entities[type.id];
    // A type and a unit share one space of names, a variable may have the name of either.
    for (const Entity& other : entities) {
        if (!other.unit && !other.type) continue;
        world.emit(declared.name.range, findings::DuplicateName(type.name))
            .related.push_back(
                {other.unit ? other.unit->range : other.type->declaration->name.range, notes::FirstDeclaredHere()});
        break;
    }
    entities.push_back({nullptr, nullptr, &type});
    const syntax::TypeSpec& spec = *declared.spec;
    if (spec.kind == syntax::TypeSpecKind::Enum) {
        type.enumeration = declareEnum(world, spec, type.name, type.scope, space.enumerators, &declared.pragmas);
        type.enumeration->initial = declared.initial;
        type.type = type.enumeration->type;
        type.progress = Progress::Done;
    } else if (spec.kind == syntax::TypeSpecKind::Struct || spec.kind == syntax::TypeSpecKind::Union) {
        for (const syntax::VarDecl* field : spec.fields)
            declareInlineEnums(world, field->type, type.scope, space.enumerators);
        type.type = declareStruct(world, spec, type.name, type.scope);
        world.structs.back().initial = declared.initial;
        type.progress = Progress::Done;
    } else {
        declareInlineEnums(world, &spec, type.scope, space.enumerators);
    }
    if (type.type.isValid()) {
        types::Type& made = world.types.edit(type.type);
        made.space = space.qualified;
        made.declaration = declared.name.range;
        made.comment = std::string(declared.comment);
        world.symbols[type.symbol.index()].type = type.type;
    }
}

} // namespace plc::sema
