// TESTs of a project: declared as hidden blocks, their own statements, and names that only tests have.
#include "runtime/compiler/sema/tests.h"

#include "runtime/base/text.h"
#include "runtime/compiler/sema/checker.h"

namespace plc::sema {

using syntax::StmtKind;

/// No program holds the block: its variables and statements are checked, nothing is laid out or compiled.
void World::declareTest(const syntax::TestDecl& test, Space& space, const syntax::SyntaxFile& file) {
    if (!isTestPath(sources[file.file].path())) return;
    syntax::Pou* pou = arena.make<syntax::Pou>();
    pou->kind = syntax::PouKind::FunctionBlock;
    pou->name = {names.folded(key(testUnitName(test))), test.titleRange};
    pou->sections = test.sections;
    pou->body.language = syntax::BodyLanguage::St;
    pou->body.statements = test.body;
    pou->body.range = test.range;
    pou->range = test.range;
    pou->header = test.titleRange;
    Unit& unit = *declareUnit(*pou, space, file);
    unit.isTest = true;
    symbols[unit.symbol.index()].declaration = {}; // its name stands nowhere
}

/// What the tests declare the program does not have.
void World::checkTestNames() {
    const auto isInTests = [&](SourceRange range) {
        return range.file.isValid() && isTestPath(sources[range.file].path());
    };
    for (const Reference& reference : references) {
        const Symbol& symbol = symbols[reference.symbol.index()];
        if (symbol.owner.empty() && isInTests(symbol.declaration) && !isInTests(reference.range))
            emit(reference.range, findings::UndeclaredName(symbol.name));
    }
}

bool World::isAccessName(std::string_view name) const {
    const auto has = [&](const std::vector<syntax::VarSection*>& sections) {
        for (const syntax::VarSection* section : sections) {
            if (section->kind != syntax::SectionKind::Access) continue;
            for (const syntax::VarDecl* declaration : section->declarations)
                for (const syntax::Name& each : declaration->names)
                    if (equalsIgnoringCase(each.text, name)) return true;
        }
        return false;
    };
    for (const Configuration& configuration : configurations) {
        if (has(configuration.declaration->sections)) return true;
        for (const syntax::ResourceDecl* resource : configuration.declaration->resources)
            if (has(resource->sections)) return true;
    }
    return false;
}

/// RUN, ASSERT, FORCE, RELEASE, COMPARE: carried out between scans; here only what they name and of which type.
void Checker::testStatement(const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out) {
    const auto duration = [&](const syntax::Expr& e) {
        const Operand length = settled(expression(e, elementary(TypeKind::Time)), elementary(TypeKind::Time));
        if (!length.isUnknown() && !isKind(length.type(), TypeKind::Ltime))
            (void)converted(length, elementary(TypeKind::Time));
    };
    switch (stmt.kind) {
    case StmtKind::Run:
        if (stmt.value) (void)condition(*stmt.value);
        if (stmt.to && stmt.countsScans)
            (void)converted(expression(*stmt.to, elementary(TypeKind::Lint)), elementary(TypeKind::Lint));
        else if (stmt.to)
            duration(*stmt.to);
        return;
    case StmtKind::Assert:
        if (stmt.value) (void)condition(*stmt.value);
        if (stmt.to) (void)expression(*stmt.to, types.string(255));
        return;
    case StmtKind::Force: {
        if (!stmt.target || !stmt.value) return;
        syntax::Stmt assigned = stmt;
        assigned.kind = StmtKind::Assign;
        assigned.op = lex::TokenKind::Assign;
        return assignment(assigned, out);
    }
    case StmtKind::Release:
        if (stmt.target) (void)denote(*stmt.target, Access::Read);
        return;
    case StmtKind::PowerOff:
        if (stmt.to) duration(*stmt.to);
        return;
    default:
        if (stmt.value) (void)expression(*stmt.value, types.string(255));
        if (stmt.to) (void)expression(*stmt.to);
        return;
    }
}

} // namespace plc::sema
