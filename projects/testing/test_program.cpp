#include "projects/testing/test_program.h"

#include "runtime/base/text.h"

namespace plc::testing {

using syntax::Expr;
using syntax::ExprKind;
using syntax::Stmt;
using syntax::StmtKind;

namespace {

/// A variable as layout and history name it: names, members, bits and constant indices.
bool isPlainPath(const Expr* target) {
    if (!target) return false;
    switch (target->kind) {
    case ExprKind::NameRef:
    case ExprKind::Address:
        return true;
    case ExprKind::Member:
    case ExprKind::Bit:
        return isPlainPath(target->base);
    case ExprKind::Index:
        for (const syntax::Argument& argument : target->arguments)
            if (!argument.value || argument.value->kind != ExprKind::Literal) return false;
        return isPlainPath(target->base);
    default:
        return false;
    }
}

bool isCarriedOutHere(const Stmt& statement, const CodeNames& names) {
    switch (statement.kind) {
    case StmtKind::Run:
    case StmtKind::Assert:
    case StmtKind::Force:
    case StmtKind::Release:
    case StmtKind::Compare:
    case StmtKind::PowerOff:
        return true;
    case StmtKind::Assign:
        return statement.op == lex::TokenKind::Assign && isPlainPath(statement.target) &&
               !names.needsCode(statement.target) && !names.needsCode(statement.value) && statement.value &&
               statement.value->kind != ExprKind::AssignChain && statement.value->kind != ExprKind::ArrayInit &&
               statement.value->kind != ExprKind::StructInit;
    default:
        return false;
    }
}

template <class Visit> void forEachBlock(const Stmt& statement, const Visit& visit) {
    visit(statement.body);
    visit(statement.elseBody);
    for (const syntax::IfBranch& branch : statement.branches) visit(branch.body);
    for (const syntax::CaseArm& arm : statement.arms) visit(arm.body);
}

/// RUN, ASSERT… or a write somewhere inside: then the loops and branches around it are walked here.
bool holdsTestStatement(const Stmt& statement) {
    bool found = statement.kind >= StmtKind::Run;
    forEachBlock(statement, [&](const syntax::Block& block) {
        for (const Stmt* inner : block) found = found || holdsTestStatement(*inner);
    });
    return found;
}

} // namespace

TestProgram::TestProgram(const projects::Project& project) : m_input(project.buildInput()) {
    m_sources.files.reserve(project.tests.size() + project.sources.size());
    for (const driver::SourceFile& file : project.tests) {
        const FileId id = m_sources.add(file.path, file.text);
        m_files.push_back(parse::parseFile(id, m_sources[id].text(), m_problems));
    }
    for (const driver::SourceFile& file : project.sources) m_names.gather(file.text);
    for (const driver::SourceFile& file : project.tests) m_names.gather(file.text);
    m_madeFile = m_input.files.size();
    m_input.files.push_back({"tests", ""});
    for (size_t file = 0; file < m_files.size(); ++file)
        for (const syntax::Decl* declaration : m_files[file]->declarations) {
            if (declaration->kind == syntax::DeclKind::Test)
                planTest(*declaration->test, file);
            else if (declaration->kind != syntax::DeclKind::Using) { // helpers of the tests: types, functions, blocks
                copy(declaration->range, file, m_input.files[m_madeFile].text);
                m_input.files[m_madeFile].text += "\n";
            }
        }
    for (const driver::SourceFile& file : project.sources) planTestsOf(file);
}

/// TESTs beside the program: loose ST files, and files of src. The rest of such a file is the program's.
void TestProgram::planTestsOf(const driver::SourceFile& source) {
    if (foldCase(source.text).find("end_test") == std::string::npos) return;
    diagnostics::Sink told; // again, when the program is built
    const FileId id = m_sources.add(source.path, source.text);
    m_files.push_back(parse::parseFile(id, m_sources[id].text(), told));
    for (const syntax::Decl* declaration : m_files.back()->declarations)
        if (declaration->kind == syntax::DeclKind::Test) planTest(*declaration->test, m_files.size() - 1);
}

void TestProgram::copy(SourceRange range, size_t file, std::string& out) {
    m_pieces.push_back({static_cast<uint32_t>(out.size()), range.length(), range.begin, file});
    out += m_sources[FileId(file)].slice(range);
}

void TestProgram::planTest(const syntax::TestDecl& test, size_t file) {
    PlannedTest planned;
    planned.test = &test;
    planned.fileIndex = file;
    planned.title = std::string(test.title);
    planned.block = "Test__" + std::to_string(m_tests.size() + 1);
    planned.instance = planned.block + "_run";
    std::string& text = m_input.files[m_madeFile].text;
    text += "FUNCTION_BLOCK " + planned.block + "\n";
    for (const syntax::VarSection* section : test.sections) {
        copy(section->range, file, text);
        text += "\n";
    }
    text += "VAR assert__ : ARRAY[0..999] OF BOOL; END_VAR\n"; // results of assertions that need code
    text += "END_FUNCTION_BLOCK\n";
    m_assertions = 0;
    planStatements(test.body, text, planned.block, file);
    text += "VAR_GLOBAL RETAIN {attribute 'hide'} " + planned.instance + " : " + planned.block + "; END_VAR\n";
    m_tests.push_back(planned);
}

void TestProgram::planStatements(const syntax::Block& block, std::string& text, const std::string& blockName,
                                 size_t file) {
    for (const Stmt* statement : block) {
        const bool asserts =
            statement->kind == StmtKind::Assert && m_names.needsCode(statement->value) && m_assertions < 1000;
        if (statement->kind == StmtKind::Empty || (isCarriedOutHere(*statement, m_names) && !asserts)) continue;
        if (!asserts && holdsTestStatement(*statement)) {
            forEachBlock(*statement, [&](const syntax::Block& inner) { planStatements(inner, text, blockName, file); });
            continue;
        }
        const std::string action = "run__" + std::to_string(m_actions.size() + 1);
        const size_t end = text.rfind("END_FUNCTION_BLOCK\n"); // actions stand before the end of their block
        std::string made = "ACTION " + action + ":\n";
        const std::string result = "assert__[" + std::to_string(m_assertions) + "]";
        if (asserts) made += result + " := ";
        const SourceRange copied = asserts ? statement->value->range : statement->range;
        const auto begin = static_cast<uint32_t>(end + made.size());
        made += std::string(m_sources[FileId(file)].slice(copied)) + ";\nEND_ACTION\n";
        text.insert(end, made);
        m_pieces.push_back({begin, copied.length(), copied.begin, file});
        m_actions.emplace_back(statement, blockName + "." + action);
        if (asserts) m_assertionResults.emplace_back(statement, result), ++m_assertions;
    }
}

std::string TestProgram::actionOf(const Stmt& statement) const {
    for (const auto& [each, action] : m_actions)
        if (each == &statement) return action;
    return {};
}

std::string TestProgram::assertionResult(const Stmt& statement) const {
    for (const auto& [each, result] : m_assertionResults)
        if (each == &statement) return result;
    return {};
}

SourceRange TestProgram::originalOf(SourceRange made, bool& isTestFile) const {
    isTestFile = made.file.isValid() && made.file.index() == m_madeFile;
    if (!isTestFile) return made;
    for (const CopiedPiece& piece : m_pieces)
        if (made.begin >= piece.madeBegin && made.begin <= piece.madeBegin + piece.length) {
            const uint32_t begin = piece.originalBegin + (made.begin - piece.madeBegin);
            return {FileId(piece.testFile), begin,
                    std::max(begin, std::min(begin + made.length(), piece.originalBegin + piece.length))};
        }
    return {FileId(size_t(0)), 0, 0};
}

} // namespace plc::testing
