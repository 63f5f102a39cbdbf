// Carries out one TEST: RUN moves the virtual clock, ASSERT looks, FORCE, RELEASE and POWER_OFF act, everything else
// runs as compiled code. One thread; one object per test.
#pragma once
#include "projects/session/session.h"
#include "projects/testing/test_program.h"
#include "projects/testing/test_run.h"

namespace plc::testing {

class Interpreter {
public:
    Interpreter(const projects::Project& project, const TestProgram& program, const PlannedTest& test,
                const driver::Built& built, session::Session& session);
    void run(TestResult& result);
    /// Ends the test at the next statement or scan once that is cancelled; null: never.
    void cancelWith(const Progress* watched) { m_watched = watched; }

private:
    enum class Flow : uint8_t { Next, Exit, Continue, Stop };
    Flow block(const syntax::Block& statements);
    Flow statement(const syntax::Stmt& statement);
    Flow branches(const syntax::Stmt& statement);
    Flow caseOf(const syntax::Stmt& statement);
    Flow loop(const syntax::Stmt& statement);
    Flow countedLoop(const syntax::Stmt& statement);
    Flow action(const syntax::Stmt& statement, const std::string& name);
    Flow runScans(const syntax::Stmt& statement);
    Flow assertion(const syntax::Stmt& statement);
    Flow failAssertion(const syntax::Stmt& at, Message detail);
    Flow assign(const syntax::Stmt& statement, bool isForce);
    Flow releaseForce(const syntax::Stmt& statement);
    Flow compare(const syntax::Stmt& statement);
    Flow powerOff(const syntax::Stmt& statement);

    [[nodiscard]] std::string_view textOf(const syntax::Expr* expression) const;
    /// Compiles and evaluates; a failure of the test when there is no value.
    [[nodiscard]] std::optional<types::Value> evaluate(const syntax::Expr* expression, const syntax::Stmt& at);
    [[nodiscard]] Result<expression::Expression> compile(std::string_view text);
    /// As evaluate; when it is not an integer or time, the test fails with what `otherwise` says.
    [[nodiscard]] std::optional<int64_t> wholeNumber(const syntax::Expr* expression, const syntax::Stmt& at,
                                                     const messages::TypedForm<messages::Name>& otherwise);
    [[nodiscard]] std::optional<bool> condition(const syntax::Expr* expression, const syntax::Stmt& at);
    [[nodiscard]] std::string
    pathOf(std::string_view target) const; // a variable of the test gets its instance in front
    [[nodiscard]] bool oneScan(const syntax::Stmt& at);
    [[nodiscard]] Message explain(const syntax::Expr& expression);
    Flow fail(const syntax::Stmt& at, Message message, Message detail = {});

    const projects::Project& m_project;
    const TestProgram& m_program;
    const PlannedTest& m_test;
    const driver::Built& m_built;
    session::Session& m_session;
    const Progress* m_watched = nullptr;
    TestResult* m_result = nullptr;
    std::vector<std::vector<std::byte>> m_images; // of this test's scans, only while a COMPARE needs them
    uint64_t m_loopPasses = 0;
};

} // namespace plc::testing
