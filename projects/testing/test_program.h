// Turns the TESTs of a project into a program that can be built: per test a hidden block with the test's variables, and
// one action for each piece of ordinary ST; the rest is a list of steps. Ranges of the made text lead back to the test
// file. Values; one thread.
#pragma once
#include "projects/model/project.h"
#include "projects/testing/code_names.h"
#include "runtime/compiler/parse/parser.h"

#include <memory>
#include <string>
#include <vector>

namespace plc::testing {

/// What a statement of a test becomes.
struct Step {
    const syntax::Stmt* statement = nullptr;
    std::string action; // not empty: run this action of the test's block
};

struct PlannedTest {
    const syntax::TestDecl* test = nullptr;
    size_t fileIndex = 0; // index into TestProgram::testFiles
    std::string title;
    std::string instance; // global variable that holds the test's block
    std::string block;    // its type
};

/// A piece of made text that was copied from a test file.
struct CopiedPiece {
    uint32_t madeBegin = 0, length = 0, originalBegin = 0;
    size_t testFile = 0;
};

class TestProgram {
public:
    explicit TestProgram(const projects::Project& project);
    [[nodiscard]] const driver::BuildInput& input() const { return m_input; }
    [[nodiscard]] const std::vector<PlannedTest>& tests() const { return m_tests; }
    [[nodiscard]] const SourceSet& testSources() const { return m_sources; }
    [[nodiscard]] const diagnostics::Sink& problems() const { return m_problems; }
    /// "" when the statement is carried out here, else the action that runs it.
    [[nodiscard]] std::string actionOf(const syntax::Stmt& statement) const;
    /// Where the action of an ASSERT that calls the program's own functions leaves its result, relative to the test's
    /// block.
    [[nodiscard]] std::string assertionResult(const syntax::Stmt& statement) const;
    /// Leads a range of the made file back to the test file; others are returned as they are.
    [[nodiscard]] SourceRange originalOf(SourceRange made, bool& isTestFile) const;

private:
    void planTestsOf(const driver::SourceFile& source);
    void planTest(const syntax::TestDecl& test, size_t file);
    void planStatements(const syntax::Block& block, std::string& actions, const std::string& blockName, size_t file);
    void copy(SourceRange range, size_t file, std::string& out);

    CodeNames m_names;
    SourceSet m_sources;
    std::vector<std::unique_ptr<syntax::SyntaxFile>> m_files;
    diagnostics::Sink m_problems;
    driver::BuildInput m_input;
    std::vector<PlannedTest> m_tests;
    std::vector<std::pair<const syntax::Stmt*, std::string>> m_actions;
    std::vector<std::pair<const syntax::Stmt*, std::string>> m_assertionResults;
    int m_assertions = 0; // of the test that is planned now
    std::vector<CopiedPiece> m_pieces;
    size_t m_madeFile = 0; // index into input().files
};

} // namespace plc::testing
