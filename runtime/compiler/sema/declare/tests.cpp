// TESTs of a project: declared as hidden blocks, their own statements, and names that only tests have.
#include "runtime/compiler/sema/declare/tests.h"

#include "runtime/compiler/sema/context.h"
#include "runtime/compiler/sema/declare/declare.h"
#include "runtime/compiler/sema/names/names.h"
#include "runtime/compiler/sema/statements/statements.h"
#include "runtime/compiler/sema/tests.h"
#include "runtime/compiler/sema/types/conversions.h"
#include "runtime/compiler/sema/values/expressions.h"

#include "runtime/base/text.h"

namespace plc::sema {

using syntax::StmtKind;

/// No program holds the block: its variables and statements are checked, nothing is laid out or compiled.
void declareTest(WorldBuilder& world, const syntax::TestDecl& test, Space& space, const syntax::SyntaxFile& file) {
    // TEST is a word only in tests/: elsewhere the parser has said so.
    if (!isTestPath(world.sources[file.file].path())) return;
    // A test is declared as a block because it has variables, statements and calls of blocks, like one.
    syntax::Pou* pou = world.arena.make<syntax::Pou>();
    pou->kind = syntax::PouKind::FunctionBlock;
    pou->name = {world.names.folded(world.key(testUnitName(test))), test.titleRange};
    pou->sections = test.sections;
    pou->body.language = syntax::BodyLanguage::St;
    pou->body.statements = test.body;
    pou->body.range = test.range;
    pou->range = test.range;
    pou->header = test.titleRange;
    Unit& unit = *declareUnit(world, *pou, space, file);
    unit.isTest = true;
    world.symbols[unit.symbol.index()].declaration = {}; // its name stands nowhere
}

/// What the tests declare the program does not have.
void checkTestNames(WorldBuilder& world) {
    const auto isInTests = [&](SourceRange range) {
        return range.file.isValid() && isTestPath(world.sources[range.file].path());
    };
    for (const Reference& reference : world.references) {
        const Symbol& symbol = world.symbols[reference.symbol.index()];
        // The program is built without its tests: a name that only they have would be missing then, so it is missing
        // now.
        if (symbol.owner.empty() && isInTests(symbol.declaration) && !isInTests(reference.range))
            world.emit(reference.range, findings::UndeclaredName(symbol.name));
    }
}

// Names of VAR_ACCESS exist only after the layout. A test may use them; that one exists is all that can be said here.
bool isAccessName(const World& world, std::string_view name) {
    const auto has = [&](const std::vector<syntax::VarSection*>& sections) {
        for (const syntax::VarSection* section : sections) {
            if (section->kind != syntax::SectionKind::Access) continue;
            for (const syntax::VarDecl* declaration : section->declarations)
                for (const syntax::Name& each : declaration->names)
                    if (equalsIgnoringCase(each.text, name)) return true;
        }
        return false;
    };
    for (const Configuration& configuration : world.configurations) {
        if (has(configuration.declaration->sections)) return true;
        for (const syntax::ResourceDecl* resource : configuration.declaration->resources)
            if (has(resource->sections)) return true;
    }
    return false;
}

/// RUN, ASSERT, FORCE, RELEASE, COMPARE: carried out between scans; here only what they name and of which type.
void testStatement(Context& context, const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out) {
    const auto duration = [&](const syntax::Expr& e) {
        const Operand length = settled(context, expression(context, e, context.elementary(TypeKind::Time)),
                                       context.elementary(TypeKind::Time));
        if (!length.isUnknown() && !context.isKind(length.type(), TypeKind::Ltime))
            (void)converted(context, length, context.elementary(TypeKind::Time));
    };
    switch (stmt.kind) {
    case StmtKind::Run:
        if (stmt.value) (void)condition(context, *stmt.value);
        // RUN 5 SCANS or RUN T#2s: the same field of the syntax, another type.
        if (stmt.to && stmt.countsScans)
            (void)converted(context, expression(context, *stmt.to, context.elementary(TypeKind::Lint)),
                            context.elementary(TypeKind::Lint));
        else if (stmt.to)
            duration(*stmt.to);
        return;
    case StmtKind::Assert:
        if (stmt.value) (void)condition(context, *stmt.value);
        if (stmt.to) (void)expression(context, *stmt.to, context.types.string(255));
        return;
    case StmtKind::Force: {
        if (!stmt.target || !stmt.value) return;
        // FORCE x := v is checked as x := v: the same types fit, and what cannot be assigned cannot be forced.
        syntax::Stmt assigned = stmt;
        assigned.kind = StmtKind::Assign;
        assigned.op = lex::TokenKind::Assign;
        return assignment(context, assigned, out);
    }
    case StmtKind::Release:
        if (stmt.target) (void)denote(context, *stmt.target, Access::Read);
        return;
    case StmtKind::PowerOff:
        if (stmt.to) duration(*stmt.to);
        return;
    default:
        if (stmt.value) (void)expression(context, *stmt.value, context.types.string(255));
        if (stmt.to) (void)expression(context, *stmt.to);
        return;
    }
}

} // namespace plc::sema
