#include "runtime/compiler/sema/world.h"

#include "runtime/base/text.h"
#include "runtime/compiler/lex/token.h"

namespace plc::sema {

using diagnostics::Kind;

World::World(const SourceSet& theSources, const Options& theOptions)
    : sources(theSources), options(theOptions), program(std::make_shared<tree::Program>()),
      types(*(program->types = std::make_shared<types::TypeTable>())), arena(program->arena) {
    functions.emplace_back(); // 0 is reserved
    for (const uint32_t capacity : {80u, 255u}) {
        types.string(capacity);
        types.wstring(capacity);
    }
    types.string(1);
    types.wstring(1);
}

SymbolId World::addSymbol(SymbolKind kind, std::string_view name, std::string_view owner, SourceRange range,
                          std::string_view comment) {
    Symbol& symbol = symbols.emplace_back();
    symbol.kind = kind;
    symbol.name = std::string(name);
    symbol.owner = std::string(owner);
    symbol.declaration = range;
    symbol.comment = std::string(comment);
    return SymbolId(symbols.size() - 1);
}

bool World::isLibraryFile(FileId file) const {
    return file.isValid() && file.index() < fileOf.size() && fileOf[file.index()] &&
           !fileOf[file.index()]->library.empty();
}

bool World::hasSyntaxErrorAt(SourceRange range) const {
    return std::any_of(syntaxErrors.begin(), syntaxErrors.end(), [&](SourceRange at) {
        return at.file == range.file && at.begin >= range.begin && at.begin <= range.end + 2;
    });
}

void World::refer(SourceRange range, SymbolId symbol, bool isRead, bool isWrite) {
    if (frozen || !symbol.isValid() || !range.file.isValid() || isLibraryFile(range.file)) return;
    references.push_back({range, symbol, isWrite, isRead});
}

tree::FunctionId World::newFunction(std::string name, const Unit* unit) {
    tree::Function& function = functions.emplace_back();
    function.name = std::move(name);
    function.result = types::TypeTable::of(TypeKind::Void);
    if (unit) {
        function.library = unit->file ? unit->file->library : std::string();
        function.declaration = unit->range;
    }
    return tree::FunctionId(functions.size() - 1);
}

void World::build(std::vector<std::unique_ptr<syntax::SyntaxFile>>& files) {
    for (const auto& file : files) declareFile(*file);
    resolveUsings();
    for (size_t i = 0; i < units.size(); ++i) resolveBases(units[i]);
    markHeaders();
    declareConfigurations();
    for (DeclaredType& type : declaredTypes) completeType(resolveDeclared(type), type.declaration->name.range);
    for (EnumType& type : enums) completeEnum(type);
    for (size_t i = 0; i < units.size(); ++i) completeUnit(units[i], units[i].range);
    for (size_t i = 0; i < globals.size(); ++i) completeType(typeOf(globals[i]), globals[i].range);
    for (size_t i = 0; i < structs.size(); ++i) completeStruct(structs[i], {});
    for (size_t i = 0; i < types.count(); ++i) completeType(TypeId(i), {});
    checkConstants();
    assignSlots();
    for (size_t i = 0; i < units.size(); ++i) checkInheritance(units[i]);
    for (Variable& variable : globals)
        if (Unit* unit = unitOf(variable.type); unit && unit->isAbstract && unit->kind == UnitKind::Block)
            emit(variable.spec ? variable.spec->range : variable.range, findings::AbstractInstance(unit->name));
    for (Unit& unit : units)
        for (Variable& variable : unit.variables)
            if (Unit* of = variable.isInOut() ? nullptr : unitOf(variable.type);
                of && of->isAbstract && of->kind == UnitKind::Block)
                emit(variable.spec ? variable.spec->range : variable.range, findings::AbstractInstance(of->name));
    layoutGlobals();
    checkBodies();
    applyVarConfig();
    buildTasks();
    buildInitialiser();
    buildDispatch();
    checkUsage();
    checkTestNames();
    checkRecursion();
    finishLayout();
    program->functions.assign(std::make_move_iterator(functions.begin()), std::make_move_iterator(functions.end()));
    frozen = true;
}

/// What stands where nothing is analysed counts as used.
void World::useNamesIn(SourceRange range) {
    diagnostics::Sink ignored;
    const std::string_view text = textOf(range);
    for (const lex::Token& token : lex::tokenize(range.file, text, ignored).tokens)
        if (token.kind == lex::TokenKind::Identifier)
            options.usedElsewhere.insert("." + foldCase(text.substr(token.begin, token.end - token.begin)));
}

std::shared_ptr<const Analysis> analyze(const SourceSet& sources,
                                        std::vector<std::unique_ptr<syntax::SyntaxFile>> files,
                                        std::vector<diagnostics::Diagnostic> syntaxDiagnostics,
                                        const Options& options) {
    auto world = std::make_shared<World>(sources, options);
    for (diagnostics::Diagnostic& diagnostic : syntaxDiagnostics) {
        const Kind kind = diagnostic.kind;
        if (diagnostic.severity == diagnostics::Severity::Error) world->syntaxErrors.push_back(diagnostic.range);
        if (kind == Kind::StatementInStep) world->useNamesIn(diagnostic.range);
        world->sink.add(std::move(diagnostic));
    }
    world->build(files);
    auto analysis = std::make_shared<Analysis>();
    analysis->files = std::move(files);
    analysis->program = world->program;
    if (!options.wantProgram)
        for (tree::Function& function : analysis->program->functions) function.body.clear();
    analysis->symbols = std::move(world->symbols);
    // Of "a.b.c" the reference to c is the name alone.
    for (Reference& reference : world->references) {
        const std::string_view text = sources[reference.range.file].slice(reference.range);
        const std::string& name = analysis->symbols[reference.symbol.index()].name;
        if (text.size() <= name.size() || text[text.size() - name.size() - 1] != '.') continue;
        if (equalsIgnoringCase(text.substr(text.size() - name.size()), name))
            reference.range.begin = reference.range.end - static_cast<uint32_t>(name.size());
    }
    std::stable_sort(world->references.begin(), world->references.end(), [](const Reference& a, const Reference& b) {
        return std::tuple(a.range.file, a.range.begin, a.range.end) <
               std::tuple(b.range.file, b.range.begin, b.range.end);
    });
    analysis->references = std::move(world->references);
    world->sink.sort();
    analysis->diagnostics = world->sink.take();
    analysis->hasErrors =
        std::any_of(analysis->diagnostics.begin(), analysis->diagnostics.end(),
                    [](const diagnostics::Diagnostic& d) { return d.severity == diagnostics::Severity::Error; });
    analysis->scopes = world;
    return analysis;
}

} // namespace plc::sema
