
#include "runtime/compiler/sema/program/analyze.h"

#include "runtime/compiler/sema/context.h"
#include "runtime/compiler/sema/declare/configuration.h"
#include "runtime/compiler/sema/declare/declare.h"
#include "runtime/compiler/sema/declare/generic_blocks.h"
#include "runtime/compiler/sema/declare/tests.h"
#include "runtime/compiler/sema/kept/last_check.h"
#include "runtime/compiler/sema/kept_bodies.h"
#include "runtime/compiler/sema/layout/initial_values.h"
#include "runtime/compiler/sema/layout/layout.h"
#include "runtime/compiler/sema/layout/tasks.h"
#include "runtime/compiler/sema/layout/units.h"
#include "runtime/compiler/sema/program/flow.h"
#include "runtime/compiler/sema/program/oop.h"
#include "runtime/compiler/sema/statements/bodies.h"
#include "runtime/compiler/sema/types/type_specs.h"
#include "runtime/compiler/sema/values/constants.h"

#include "runtime/base/text.h"
#include "runtime/compiler/lex/token.h"

namespace plc::sema {

using diagnostics::Kind;

using Files = std::vector<std::shared_ptr<const syntax::SyntaxFile>>;
static size_t build(WorldBuilder& world, const Files& files, const LastCheck* last, bool isKept);
static void useNamesIn(WorldBuilder& world, SourceRange range);
static void dropRepeated(std::vector<Reference>& references);

// The types of the program are those of the tree: both are filled here and read by everything behind.
WorldBuilder::WorldBuilder(const SourceSet& theSources, const Options& theOptions,
                           const std::shared_ptr<tree::Program>& theProgram)
    : World(theSources, theOptions, theProgram), Gathered(*theProgram->types, theProgram->arena), program(theProgram) {
    // Expressions of watches add no types (they run beside others), so the texts that they may need are made first.
    functions.emplace_back(); // 0 is reserved
    for (const uint32_t capacity : {80u, 255u}) {
        types.string(capacity);
        types.wstring(capacity);
    }
    types.string(1);
    types.wstring(1);
}

// Symbols are numbered in the order of declaration; references name them by number.
SymbolId addSymbol(Gathered& gathered, SymbolKind kind, std::string_view name, std::string_view owner,
                   SourceRange range, std::string_view comment) {
    Symbol& symbol = gathered.symbols.emplace_back();
    symbol.kind = kind;
    symbol.name = std::string(name);
    symbol.owner = std::string(owner);
    symbol.declaration = range;
    symbol.comment = std::string(comment);
    return SymbolId(gathered.symbols.size() - 1);
}

bool isLibraryFile(const World& world, FileId file) {
    return file.isValid() && file.index() < world.fileOf.size() && world.fileOf[file.index()] &&
           !world.fileOf[file.index()]->library.empty();
}

bool hasSyntaxErrorAt(const World& world, SourceRange range) {
    return std::any_of(world.syntaxErrors.begin(), world.syntaxErrors.end(), [&](SourceRange at) {
        // Two characters behind: the parser reports a missing semicolon at what follows it.
        return at.file == range.file && at.begin >= range.begin && at.begin <= range.end + 2;
    });
}

void refer(const Check& check, SourceRange range, SymbolId symbol, bool isRead, bool isWrite) {
    // References within libraries would be most of all references, and nobody renames there.
    if (!symbol.isValid() || !range.file.isValid() || isLibraryFile(check.world, range.file)) return;
    check.gathered.references.push_back({range, symbol, isWrite, isRead});
}

void count(const Check& check, Variable& variable, bool isRead, bool isWrite) {
    // Bodies are checked against a const World: their uses are notes, added up behind them.
    if (!check.builder) return (void)check.gathered.uses.push_back({variable.number, isRead, isWrite});
    variable.reads += isRead;
    variable.writes += isWrite;
}

tree::FunctionId newFunction(Gathered& gathered, std::string name, const Unit* unit) {
    // A body that makes a function (an initialiser of a type) has done something for others; see
    // kept/changed_bodies.cpp.
    ++gathered.completions;
    tree::Function& function = gathered.functions.emplace_back();
    function.name = std::move(name);
    function.result = types::TypeTable::of(TypeKind::Void);
    if (unit) {
        function.library = unit->file ? unit->file->library : std::string();
        function.declaration = unit->range;
    }
    return tree::FunctionId(gathered.functions.size() - 1);
}

/// The order of the phases. Names first, then types and units, each completed when something asks for it; then
/// addresses, which bodies refer to; then bodies; and what needs all of them last: tasks, dispatch, use, recursion.
/// Returns how many bodies it had to check.
size_t build(WorldBuilder& world, const Files& files, const LastCheck* last, bool isKept) {
    for (const auto& file : files) declareFile(world, *file);
    resolveUsings(world);
    declareGenericBlocks(world);
    // By index and not by iterator wherever the list may grow meanwhile.
    for (size_t i = 0; i < world.units.size(); ++i) resolveBases(world, world.units[i]);
    // Before any layout: whether a block has a number at offset 0 moves all its fields.
    markHeaders(world);
    // Program instances exist before types are completed, because VAR_EXTERNAL asks which RESOURCE runs the program.
    declareConfigurations(world);
    for (DeclaredType& type : world.declaredTypes)
        completeType(world, resolveDeclared(world, type), type.declaration->name.range);
    for (EnumType& type : world.enums) completeEnum(world, type);
    for (size_t i = 0; i < world.units.size(); ++i) completeUnit(world, world.units[i], world.units[i].range);
    for (size_t i = 0; i < world.globals.size(); ++i)
        completeType(world, typeOf(world, world.globals[i]), world.globals[i].range);
    for (size_t i = 0; i < world.structs.size(); ++i) completeStruct(world, world.structs[i]);
    for (size_t i = 0; i < world.types.count(); ++i) completeType(world, TypeId(i), {}); // grows while it runs
    // Also those that nobody names: each constant is checked once, in the order of the text.
    checkConstants(world);
    // After the units are complete and before bodies: calls need to know whether they are dispatched.
    assignSlots(world);
    for (size_t i = 0; i < world.units.size(); ++i) checkInheritance(world, world.units[i]);
    for (Variable& variable : world.globals)
        if (Unit* unit = world.unitOf(variable.type); unit && unit->isAbstract && unit->kind == UnitKind::Block)
            world.emit(variable.spec ? variable.spec->range : variable.range, findings::AbstractInstance(unit->name));
    for (Unit& unit : world.units)
        for (Variable& variable : unit.variables)
            if (Unit* of = variable.isInOut() ? nullptr : world.unitOf(variable.type);
                of && of->isAbstract && of->kind == UnitKind::Block)
                world.emit(variable.spec ? variable.spec->range : variable.range, findings::AbstractInstance(of->name));
    // All offsets are fixed from here on; trees of bodies contain them.
    layoutGlobals(world);
    const size_t checked = isKept ? checkChangedBodies(world, files, last) : checkBodies(world);
    // Writes into the image and adds copies, which the tasks connect.
    applyVarConfig(world);
    buildTasks(world);
    buildInitialiser(world);
    buildDispatch(world);
    // Uses are complete only now: connections of tasks and initial values count as well.
    checkUsage(world);
    checkTestNames(world);
    checkRecursion(world);
    finishLayout(world);
    world.program->functions.assign(std::make_move_iterator(world.functions.begin()),
                                    std::make_move_iterator(world.functions.end()));
    return checked;
}

/// What stands where nothing is analysed counts as used.
void useNamesIn(WorldBuilder& world, SourceRange range) {
    // Read as tokens: what could not be parsed names variables all the same, and they are not unused.
    diagnostics::Sink ignored;
    const std::string_view text = world.textOf(range);
    for (const lex::Token& token : lex::tokenize(range.file, text, ignored).tokens)
        if (token.kind == lex::TokenKind::Identifier)
            world.options.usedElsewhere.insert("." + foldCase(text.substr(token.begin, token.end - token.begin)));
}

/// A block with generic constants is checked for each list of values and says the same of a place each time.
void dropRepeated(std::vector<Reference>& references) {
    const auto isSame = [](const Reference& a, const Reference& b) {
        return a.symbol == b.symbol && a.isRead == b.isRead && a.isWrite == b.isWrite;
    };
    size_t kept = 0;
    for (size_t i = 0; i < references.size(); ++i) {
        bool isRepeated = false;
        for (size_t k = kept; k > 0 && !isRepeated && references[k - 1].range == references[i].range; --k)
            isRepeated = isSame(references[k - 1], references[i]);
        if (!isRepeated) references[kept++] = references[i];
    }
    references.erase(references.begin() + static_cast<std::ptrdiff_t>(kept), references.end());
}

std::shared_ptr<const Analysis> analyze(const SourceSet& sources, Files files,
                                        std::vector<diagnostics::Diagnostic> syntaxDiagnostics,
                                        const Options& options) {
    return analyze(sources, std::move(files), std::move(syntaxDiagnostics), options, nullptr);
}

std::shared_ptr<const Analysis> analyze(const SourceSet& sources, Files files,
                                        std::vector<diagnostics::Diagnostic> syntaxDiagnostics, const Options& options,
                                        KeptBodies* kept) {
    auto program = std::make_shared<tree::Program>();
    program->types = std::make_shared<types::TypeTable>();
    program->types->strings = options.strings;
    types::prepare(options.strings);
    WorldBuilder world(sources, options, program);
    for (diagnostics::Diagnostic& diagnostic : syntaxDiagnostics) {
        const Kind kind = diagnostic.kind;
        if (diagnostic.severity == diagnostics::Severity::Error) world.syntaxErrors.push_back(diagnostic.range);
        if (kind == Kind::StatementInStep) useNamesIn(world, diagnostic.range);
        world.sink.add(std::move(diagnostic));
    }
    const size_t checked = build(world, files, kept ? kept->m_last.get() : nullptr, kept);
    if (kept) {
        kept->m_last = world.check;
        kept->m_checkedLast = checked;
    }
    auto analysis = std::make_shared<Analysis>();
    analysis->files = std::move(files);
    analysis->program = world.program;
    // The editor's check needs diagnostics and symbols; the records of kept bodies hold their trees themselves.
    if (!options.wantProgram)
        for (tree::Function& function : analysis->program->functions) function.body.clear();
    analysis->symbols = std::move(world.symbols);
    // Of "a.b.c" the reference to c is the name alone.
    for (Reference& reference : world.references) {
        const std::string_view text = sources[reference.range.file].slice(reference.range);
        const std::string& name = analysis->symbols[reference.symbol.index()].name;
        if (text.size() <= name.size() || text[text.size() - name.size() - 1] != '.') continue;
        if (equalsIgnoringCase(text.substr(text.size() - name.size()), name))
            reference.range.begin = reference.range.end - static_cast<uint32_t>(name.size());
    }
    // Sorted by place: "what is under the caret" is a binary search.
    std::stable_sort(world.references.begin(), world.references.end(), [](const Reference& a, const Reference& b) {
        return std::tuple(a.range.file, a.range.begin, a.range.end) <
               std::tuple(b.range.file, b.range.begin, b.range.end);
    });
    dropRepeated(world.references);
    analysis->references = std::move(world.references);
    world.sink.sort();
    analysis->diagnostics = world.sink.take();
    analysis->hasErrors =
        std::any_of(analysis->diagnostics.begin(), analysis->diagnostics.end(),
                    [](const diagnostics::Diagnostic& d) { return d.severity == diagnostics::Severity::Error; });
    // The World without what was gathered; from here on it is const and read by any number of threads.
    analysis->scopes = std::make_shared<const World>(std::move(static_cast<World&>(world)));
    return analysis;
}

} // namespace plc::sema
