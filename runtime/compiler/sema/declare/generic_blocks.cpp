#include "runtime/compiler/sema/declare/generic_blocks.h"

#include "runtime/compiler/sema/declare/declare.h"
#include "runtime/compiler/sema/names/lookup.h"
#include "runtime/compiler/sema/types/type_specs.h"

#include <algorithm>

namespace plc::sema {

using syntax::TypeSpecKind;

namespace {

constexpr size_t kMostGenericBlocks = 10000; // of one program: a block that names itself with another value has no end

/// The parser marks the section; it is a VAR CONSTANT otherwise.
bool isGenericSection(const syntax::VarSection& section) {
    return std::any_of(section.pragmas.begin(), section.pragmas.end(),
                       [](const syntax::Pragma& pragma) { return !pragma.isAttribute && pragma.key == "VAR_GENERIC"; });
}

bool isGeneric(const Unit& unit) {
    return unit.pou && unit.kind == UnitKind::Block &&
           std::any_of(unit.pou->sections.begin(), unit.pou->sections.end(),
                       [](const syntax::VarSection* section) { return isGenericSection(*section); });
}

size_t countOfConstants(const syntax::Pou& pou) {
    size_t count = 0;
    for (const syntax::VarSection* section : pou.sections)
        if (isGenericSection(*section))
            for (const syntax::VarDecl* declaration : section->declarations) count += declaration->names.size();
    return count;
}

using Values = std::vector<int64_t>;

std::string withValues(std::string_view name, const Values& values) {
    std::string out(name);
    for (size_t i = 0; i < values.size(); ++i) out += (i == 0 ? "<" : ", ") + std::to_string(values[i]);
    return out + ">";
}

/// A path's last name with its values: Collections.List<8>.
syntax::Path pathWithValues(Arena& arena, syntax::Path path, const Values& values) {
    path.back().text = *arena.make<std::string>(withValues(path.back().text, values));
    return path;
}

std::optional<Values> valuesOf(const Check& check, const syntax::TypeSpec& spec, const Scope& scope) {
    Values out;
    for (const syntax::Bounds& each : spec.bounds) {
        const auto value = constantInteger(check, each.low, scope);
        if (!value) return std::nullopt;
        out.push_back(*value);
    }
    return out;
}

const syntax::Expr* literal(Arena& arena, int64_t value, SourceRange range) {
    auto* number = arena.make<syntax::Expr>();
    number->kind = syntax::ExprKind::Literal;
    number->op = lex::TokenKind::IntegerLiteral;
    number->range = range;
    number->text = *arena.make<std::string>(std::to_string(value).substr(value < 0));
    if (value >= 0) return number;
    auto* minus = arena.make<syntax::Expr>();
    minus->kind = syntax::ExprKind::Unary;
    minus->op = lex::TokenKind::Minus;
    minus->range = range;
    minus->base = number;
    minus->height = 2;
    return minus;
}

/// The section with one declaration for each constant, whose initial value is the one given.
syntax::VarSection* filled(Arena& arena, const syntax::VarSection& section, const Values& values, size_t& next) {
    auto* out = arena.make<syntax::VarSection>(section);
    out->declarations.clear();
    for (const syntax::VarDecl* declaration : section.declarations)
        for (const syntax::Name& name : declaration->names) {
            auto* made = arena.make<syntax::VarDecl>(*declaration);
            made->names = {name};
            made->initial = const_cast<syntax::Expr*>(literal(arena, values[next++], name.range));
            out->declarations.push_back(made);
        }
    return out;
}

/// What is found at a place of the text is the same thing whatever the values are.
void shareSymbols(Unit& made, const Unit& generic) {
    made.symbol = generic.symbol;
    const auto forBoth = [](auto& a, const auto& b, const auto& use) {
        auto other = b.begin();
        for (auto& each : a) {
            if (other == b.end()) return;
            use(each, *other++);
        }
    };
    forBoth(made.variables, generic.variables, [](Variable& a, const Variable& b) { a.symbol = b.symbol; });
    forBoth(made.properties, generic.properties, [](Property* a, const Property* b) { a->symbol = b->symbol; });
    forBoth(made.methods, generic.methods, [](Unit* a, const Unit* b) { shareSymbols(*a, *b); });
    forBoth(made.actions, generic.actions, [](Unit* a, const Unit* b) { shareSymbols(*a, *b); });
}

void make(WorldBuilder& world, Unit& generic, const Values& values) {
    auto* pou = world.arena.make<syntax::Pou>(*generic.pou);
    pou->name.text = *world.arena.make<std::string>(withValues(generic.pou->name.text, values));
    size_t next = 0;
    for (syntax::VarSection*& section : pou->sections)
        if (isGenericSection(*section)) section = filled(world.arena, *section, values, next);
    Unit* made = declareUnit(world, *pou, *generic.space, *generic.file);
    if (const auto usings = world.unitUsings.find(&generic); usings != world.unitUsings.end()) {
        std::vector<Space*> same = usings->second;
        world.unitUsings[made] = std::move(same);
    }
    shareSymbols(*made, generic);
}

class Finder {
public:
    explicit Finder(WorldBuilder& world) : m_world(world) {}

    void visit(const syntax::TypeSpec* spec, const Scope& scope) {
        if (!spec) return;
        if (spec->kind == TypeSpecKind::Named && !spec->bounds.empty()) makeFor(*spec, scope);
        visit(spec->element, scope);
        visit(spec->extends, scope);
        for (const syntax::VarDecl* field : spec->fields) visit(field->type, scope);
    }
    void visit(const std::vector<syntax::VarSection*>& sections, const Scope& scope) {
        for (const syntax::VarSection* section : sections)
            for (const syntax::VarDecl* declaration : section->declarations) visit(declaration->type, scope);
    }

private:
    /// What is wrong with it is reported where the type is resolved.
    void makeFor(const syntax::TypeSpec& spec, const Scope& scope) {
        Unit* generic = lookupPath(m_world, scope, spec.path).entity.unit;
        if (!generic || !isGeneric(*generic) || m_count >= kMostGenericBlocks) return;
        diagnostics::Sink ignored;
        std::swap(ignored, m_world.sink);
        const auto values = valuesOf(m_world, spec, scope);
        std::swap(ignored, m_world.sink);
        if (!values || values->size() != countOfConstants(*generic->pou)) return;
        const NameId id = m_world.key(withValues(generic->pou->name.text, *values));
        if (generic->space->find(id)) return;
        make(m_world, *generic, *values);
        ++m_count;
    }

    WorldBuilder& m_world;
    size_t m_count = 0;
};

} // namespace

void declareGenericBlocks(WorldBuilder& world) {
    if (std::none_of(world.units.begin(), world.units.end(), [](const Unit& unit) { return isGeneric(unit); })) return;
    Finder finder(world);
    for (const Variable& variable : world.globals) finder.visit(variable.spec, variable.scope);
    for (const DeclaredType& type : world.declaredTypes) finder.visit(type.declaration->spec, type.scope);
    for (const Configuration& configuration : world.configurations) {
        const Scope scope{nullptr, configuration.space, configuration.file};
        finder.visit(configuration.declaration->sections, scope);
        for (const syntax::ResourceDecl* resource : configuration.declaration->resources)
            finder.visit(resource->sections, scope);
    }
    // By index: each block that is made may name others.
    for (size_t i = 0; i < world.units.size(); ++i) {
        Unit& unit = world.units[i];
        const Scope scope{&unit, unit.space, unit.file};
        if (unit.pou) finder.visit(unit.pou->result, scope);
        for (size_t k = 0; k < unit.variables.size(); ++k) finder.visit(unit.variables[k].spec, scope);
    }
}

std::optional<syntax::Path> pathOfGeneric(const Check& check, const syntax::TypeSpec& spec, const Scope& scope) {
    const SourceRange range = joined(spec.path.front().range, spec.path.back().range);
    const auto values = valuesOf(check, spec, scope);
    if (!values) return std::nullopt;
    const Unit* generic = lookupPath(check.world, scope, spec.path).entity.unit;
    if (!generic) return spec.path; // reported as a type that is not known
    const size_t wanted = isGeneric(*generic) ? countOfConstants(*generic->pou) : 0;
    if (values->size() > wanted) {
        check.emit(range, findings::TooManyArguments(generic->name, wanted));
        return std::nullopt;
    }
    if (values->size() < wanted) {
        check.emit(range, findings::MissingArgument(Verbatim("VAR_GENERIC CONSTANT"), generic->name));
        return std::nullopt;
    }
    return pathWithValues(check.gathered.arena, spec.path, *values);
}

bool isInGeneric(const Scope& scope) {
    const Unit* self = scope.unit ? scope.unit->self() : nullptr;
    return self && isGeneric(*self);
}

} // namespace plc::sema
