#include "projects/testing/interpreter.h"
#include "projects/session/versions.h"

#include "runtime/base/messages.h"
#include "runtime/base/text.h"
#include "runtime/types/conversion.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace plc::testing {

using syntax::Expr;
using syntax::Stmt;
using syntax::StmtKind;
using types::Value;

Interpreter::Interpreter(const projects::Project& project, const TestProgram& program, const PlannedTest& test,
                         const driver::Built& built, session::Session& session)
    : m_project(project), m_program(program), m_test(test), m_built(built), m_session(session) {}

void Interpreter::run(TestResult& result) {
    m_result = &result;
    m_session.controller().start();
    block(m_test.test->body);
}

std::string_view Interpreter::textOf(const Expr* expression) const {
    return expression ? m_program.testSources()[FileId(m_test.fileIndex)].slice(expression->range) : std::string_view();
}

Interpreter::Flow Interpreter::fail(const Stmt& at, Message message, Message detail) {
    const SourceText& file = m_program.testSources()[FileId(m_test.fileIndex)];
    Failure failure;
    failure.message = std::move(message);
    failure.detail = std::move(detail);
    failure.file = file.path();
    failure.line = file.lineColumn(at.range.begin).line;
    failure.scan = m_session.controller().nextScan();
    failure.time = m_session.controller().lastTime();
    m_result->failures.push_back(std::move(failure));
    return Flow::Stop;
}

Result<expression::Expression> Interpreter::compile(std::string_view text) {
    return m_session.expression(std::string(text), m_test.instance);
}

std::optional<Value> Interpreter::evaluate(const Expr* expression, const Stmt& at) {
    const auto compiled = compile(textOf(expression));
    if (!compiled) {
        fail(at, errors::About(textOf(expression), compiled.error().message));
        return std::nullopt;
    }
    const expression::Outcome outcome = compiled->evaluate(m_session.controller().image());
    if (!outcome.hasValue()) {
        fail(at, errors::HasNoValue(textOf(expression), outcome.reason));
        return std::nullopt;
    }
    return outcome.value;
}

std::optional<int64_t> Interpreter::wholeNumber(const Expr* expression, const Stmt& at,
                                                const messages::TypedForm<messages::Name>& otherwise) {
    const auto value = evaluate(expression, at);
    if (!value) return std::nullopt;
    if (const auto* number = std::get_if<int64_t>(&value->data)) return *number;
    fail(at, otherwise(std::string(textOf(expression))));
    return std::nullopt;
}

std::optional<bool> Interpreter::condition(const Expr* expression, const Stmt& at) {
    const auto value = evaluate(expression, at);
    if (!value) return std::nullopt;
    return value->isTrue();
}

std::string Interpreter::pathOf(std::string_view target) const {
    const std::string first = foldCase(target.substr(0, target.find_first_of(".[ ")));
    for (const syntax::VarSection* section : m_test.test->sections)
        for (const syntax::VarDecl* declaration : section->declarations)
            for (const syntax::Name& name : declaration->names)
                if (foldCase(name.text) == first) return m_test.instance + "." + std::string(target);
    return std::string(target);
}

Interpreter::Flow Interpreter::block(const syntax::Block& statements) {
    for (const Stmt* each : statements) {
        const Flow flow = statement(*each);
        if (flow != Flow::Next) return flow;
    }
    return Flow::Next;
}

Interpreter::Flow Interpreter::statement(const Stmt& at) {
    if (isCancelled(m_watched)) return Flow::Stop;
    if (const std::string name = m_program.actionOf(at); !name.empty()) {
        const Flow flow = action(at, name);
        const std::string result = m_program.assertionResult(at);
        if (flow != Flow::Next || result.empty()) return flow;
        const auto value = m_session.controller().read(m_test.instance + "." + result);
        return value && value->isTrue() ? Flow::Next : failAssertion(at, {});
    }
    switch (at.kind) {
    case StmtKind::Empty:
    case StmtKind::Label:
        return Flow::Next;
    case StmtKind::Assign:
        return assign(at, false);
    case StmtKind::Force:
        return assign(at, true);
    case StmtKind::Release:
        return releaseForce(at);
    case StmtKind::Assert:
        return assertion(at);
    case StmtKind::Run:
        return runScans(at);
    case StmtKind::Compare:
        return compare(at);
    case StmtKind::PowerOff:
        return powerOff(at);
    case StmtKind::If:
        return branches(at);
    case StmtKind::Case:
        return caseOf(at);
    case StmtKind::For:
        return countedLoop(at);
    case StmtKind::While:
    case StmtKind::Repeat:
        return loop(at);
    case StmtKind::Exit:
        return Flow::Exit;
    case StmtKind::Continue:
        return Flow::Continue;
    case StmtKind::Return:
        return Flow::Stop;
    case StmtKind::Block:
        return block(at.body);
    case StmtKind::Call:
    case StmtKind::Try:
    case StmtKind::Jump:
    case StmtKind::Il:
        break;
    }
    return fail(at, errors::NotPossibleInTest());
}

Interpreter::Flow Interpreter::action(const Stmt& at, const std::string& name) {
    controller::Controller& controller = m_session.controller();
    const image::CompiledProgram& program = controller.program();
    const auto place = program.layout.find(m_test.instance);
    const auto it = std::find_if(program.functions.begin(), program.functions.end(),
                                 [&](const image::FunctionInfo& f) { return f.name == name; });
    if (!place || it == program.functions.end()) return fail(at, errors::TestCodeMissing());
    if (controller.runFunction(static_cast<uint32_t>(it - program.functions.begin()), place->offset)) return Flow::Next;
    return fail(at, errors::FaultInTest(controller.fault() ? controller.fault()->message : Message()));
}

Interpreter::Flow Interpreter::assign(const Stmt& at, bool isForce) {
    controller::Controller& controller = m_session.controller();
    const std::string path = pathOf(textOf(at.target));
    const auto place = controller.program().layout.find(path);
    if (!place) return fail(at, place.error().message);
    auto value = evaluate(at.value, at);
    std::string text(textOf(at.value));
    const types::TypeTable& types = *controller.program().layout.types;
    if (!value) return Flow::Stop;
    bool ok = true;
    if (!types.isAggregate(place->type)) *value = types::convert(types, *value, place->type, &ok);
    if (!ok) return fail(at, errors::NotAValueFor(text, path));
    const auto done = isForce ? controller.force(path, *value) : controller.write(path, *value);
    return done ? Flow::Next : fail(at, done.error().message);
}

Interpreter::Flow Interpreter::releaseForce(const Stmt& at) {
    if (!at.target) {
        m_session.controller().releaseAll();
        return Flow::Next;
    }
    const auto done = m_session.controller().release(pathOf(textOf(at.target)));
    return done ? Flow::Next : fail(at, done.error().message);
}

Interpreter::Flow Interpreter::branches(const Stmt& at) {
    for (const syntax::IfBranch& branch : at.branches) {
        if (branch.condition) {
            const auto isTrue = condition(branch.condition, at);
            if (!isTrue) return Flow::Stop;
            if (!*isTrue) continue;
        }
        return block(branch.body);
    }
    return Flow::Next;
}

Interpreter::Flow Interpreter::caseOf(const Stmt& at) {
    for (const syntax::CaseArm& arm : at.arms)
        for (const syntax::CaseLabel& label : arm.labels) {
            const std::string selector = "(" + std::string(textOf(at.value)) + ")";
            const std::string text = label.high ? selector + " >= " + std::string(textOf(label.low)) + " AND " +
                                                      selector + " <= " + std::string(textOf(label.high))
                                                : selector + " = " + std::string(textOf(label.low));
            const auto compiled = compile(text);
            if (!compiled) return fail(at, errors::About(text, compiled.error().message));
            if (compiled->isTrue(m_session.controller().image())) return block(arm.body);
        }
    return at.hasElse ? block(at.elseBody) : Flow::Next;
}

Interpreter::Flow Interpreter::loop(const Stmt& at) {
    const bool isWhile = at.kind == StmtKind::While;
    for (;;) {
        if (isCancelled(m_watched)) return Flow::Stop; // its body may be empty
        if (++m_loopPasses > 10'000'000) return fail(at, errors::TestLoopEndless());
        if (isWhile) {
            const auto isTrue = condition(at.value, at);
            if (!isTrue) return Flow::Stop;
            if (!*isTrue) return Flow::Next;
        }
        const Flow flow = block(at.body);
        if (flow == Flow::Exit) return Flow::Next;
        if (flow == Flow::Stop) return flow;
        if (isWhile) continue;
        const auto isTrue = condition(at.value, at);
        if (!isTrue) return Flow::Stop;
        if (*isTrue) return Flow::Next;
    }
}

Interpreter::Flow Interpreter::countedLoop(const Stmt& at) {
    controller::Controller& controller = m_session.controller();
    const std::string path = pathOf(textOf(at.target));
    const auto from = wholeNumber(at.from, at, errors::NotAWholeNumber),
               to = wholeNumber(at.to, at, errors::NotAWholeNumber);
    if (!from || !to) return Flow::Stop;
    int64_t step = 1;
    if (at.by) {
        const auto by = wholeNumber(at.by, at, errors::NotAWholeNumber);
        if (!by) return Flow::Stop;
        step = *by;
    }
    if (step == 0) return fail(at, errors::LoopStepZero());
    const auto place = controller.program().layout.find(path);
    if (!place) return fail(at, place.error().message);
    for (int64_t i = *from; step > 0 ? i <= *to : i >= *to; i += step) {
        if (isCancelled(m_watched)) return Flow::Stop;
        if (auto written = controller.write(path, Value{place->type, i}); !written)
            return fail(at, written.error().message);
        const Flow flow = block(at.body);
        if (flow == Flow::Exit) break;
        if (flow == Flow::Stop) return flow;
    }
    return Flow::Next;
}

bool Interpreter::oneScan(const Stmt& at) {
    if (isCancelled(m_watched)) return false;
    controller::Controller& controller = m_session.controller();
    controller.scan();
    const bool wasFault = controller.state() == controller::State::Fault;
    const auto& fault = wasFault ? controller.fault() : controller.simulationFault();
    if (!fault) return true;
    Message where;
    if (fault->range.file.isValid()) {
        const SourceText& file = controller.program().sources[fault->range.file];
        where = errors::FaultAt(file.path(), file.lineColumn(fault->range.begin).line);
    }
    // A test may look at a fault (ASSERT after RUN), but the fault of the plant or an unnoticed one ends it.
    fail(at,
         fault->isSimulation ? errors::SimulationStopped(fault->message) : errors::ControllerStopped(fault->message),
         where);
    return false;
}

Interpreter::Flow Interpreter::runScans(const Stmt& at) {
    controller::Controller& controller = m_session.controller();
    if (at.countsScans) {
        const auto count = wholeNumber(at.to, at, errors::NotAScanCount);
        if (!count) return Flow::Stop;
        for (int64_t i = 0; i < *count; ++i)
            if (!oneScan(at)) return Flow::Stop;
        return Flow::Next;
    }
    const auto length = wholeNumber(at.to, at, errors::NotATime);
    if (!length) return Flow::Stop;
    const controller::Nanoseconds end = controller.nextDue() + controller::Nanoseconds(*length);
    if (!at.value) {
        while (controller.nextDue() < end)
            if (!oneScan(at)) return Flow::Stop;
        return Flow::Next;
    }
    const auto until = compile(textOf(at.value));
    if (!until) return fail(at, errors::About(textOf(at.value), until.error().message));
    while (controller.nextDue() < end) {
        if (!oneScan(at)) return Flow::Stop;
        if (until->isTrue(controller.image())) return Flow::Next;
    }
    return fail(at, errors::NotTrueWithin(textOf(at.value), types::durationText(*length)), explain(*at.value));
}

/// The controller is without power for a time: its outputs fall, the plant goes on, and retained variables are what is
/// left when it starts again. (The test's own variables are retained.)
Interpreter::Flow Interpreter::powerOff(const Stmt& at) {
    controller::Controller& controller = m_session.controller();
    const auto length = wholeNumber(at.to, at, errors::NotATime);
    if (!length) return Flow::Stop;
    controller.stop();
    const controller::Nanoseconds end = controller.nextDue() + controller::Nanoseconds(*length);
    while (controller.nextDue() < end)
        if (!oneScan(at)) return Flow::Stop;
    controller.reset(controller::ResetKind::Warm);
    controller.start();
    return Flow::Next;
}

/// "Main.n is 3, expected 5" for a comparison, the operands' values for anything else.
Message Interpreter::explain(const Expr& expression) {
    const auto show = [&](const Expr* part) {
        const auto compiled = compile(textOf(part));
        if (!compiled) return errors::Plainly(Verbatim("?"));
        const auto outcome = compiled->evaluate(m_session.controller().image());
        return outcome.hasValue() ? errors::Plainly(types::toText(compiled->types(), outcome.value)) : outcome.reason;
    };
    const auto isComparison = [](lex::TokenKind op) {
        return op >= lex::TokenKind::Equal && op <= lex::TokenKind::GreaterEqual;
    };
    if (expression.kind == syntax::ExprKind::Binary && expression.base && expression.right) {
        if (isComparison(expression.op))
            return errors::ValueIsExpected(textOf(expression.base), show(expression.base), lex::spelling(expression.op),
                                           show(expression.right));
        const Message left = explain(*expression.base), right = explain(*expression.right);
        return left.isEmpty() ? right : right.isEmpty() ? left : errors::Both(left, right);
    }
    if (expression.kind == syntax::ExprKind::Unary && expression.base) return explain(*expression.base);
    if (expression.kind == syntax::ExprKind::Literal) return {};
    return errors::ValueIs(textOf(&expression), show(&expression));
}

Interpreter::Flow Interpreter::assertion(const Stmt& at) {
    const auto isTrue = condition(at.value, at);
    if (!isTrue) return Flow::Stop;
    return *isTrue ? Flow::Next : failAssertion(at, explain(*at.value));
}

Interpreter::Flow Interpreter::failAssertion(const Stmt& at, Message detail) {
    Message message = errors::AssertFailed(textOf(at.value));
    if (at.to) {
        const auto said = evaluate(at.to, at);
        if (said && std::holds_alternative<std::string>(said->data))
            message =
                errors::AssertFailedSaying(types::utf8OfString(m_session.controller().program().layout.types->strings,
                                                               std::get<std::string>(said->data)),
                                           textOf(at.value));
    }
    return fail(at, std::move(message), std::move(detail));
}

Interpreter::Flow Interpreter::compare(const Stmt& at) {
    std::string name(textOf(at.value));
    if (name.size() >= 2 && name.front() == '\'') name = name.substr(1, name.size() - 2);
    double tolerance = 0;
    if (at.to) {
        const auto value = evaluate(at.to, at);
        if (!value) return Flow::Stop;
        tolerance = std::holds_alternative<double>(value->data) ? value->real() : static_cast<double>(value->integer());
    }
    std::string file = m_project.folder + "/tests/" + name;
    if (m_project.folder.empty()) // beside the loose file
        file = (std::filesystem::path(m_program.testSources()[at.range.file].path()).parent_path() / name).string();
    if (!file.ends_with(".rec")) file += ".rec";
    const auto rebuild = [](const history::History::Sources& sources) -> std::shared_ptr<const image::CompiledProgram> {
        return driver::build(session::recordedInput(sources)).program;
    };
    const auto loaded = history::History::load(file, rebuild);
    if (!loaded) return fail(at, errors::withPlace(loaded.error()));
    const history::History& then = **loaded;
    const history::History& now = m_session.history();
    const auto was = then.statistics(), is = now.statistics();
    const history::Position common = std::min(was.end - was.first, is.end - is.first);
    if (was.scans != is.scans) return fail(at, errors::ScanCountDiffers(name, was.scans, is.scans));
    for (history::Position i = 0; i < common; ++i) {
        std::shared_ptr<const image::CompiledProgram> oldProgram, newProgram;
        const auto oldImage = then.seek(was.first + i, &oldProgram), newImage = now.seek(is.first + i, &newProgram);
        if (oldImage.empty() || newImage.empty() || !oldProgram || !newProgram) continue;
        for (const image::Root& root : oldProgram->layout.roots) {
            if (root.isHidden || root.constant || root.name.starts_with("Test__")) continue;
            Message difference;
            oldProgram->layout.forEachLeaf(
                root.list.empty() ? root.name : root.list + "." + root.name, {root.type, root.offset, root.bit},
                [&](const std::string& path, const image::Place& place) {
                    const auto other = newProgram->layout.find(path);
                    if (!other) return true;
                    const Value before = types::readValue(*oldProgram->layout.types, place.type,
                                                          std::span(oldImage).subspan(place.offset), place.bit);
                    const Value after = types::readValue(*newProgram->layout.types, other->type,
                                                         std::span(newImage).subspan(other->offset), other->bit);
                    const bool close =
                        std::holds_alternative<double>(before.data) && std::holds_alternative<double>(after.data)
                            ? std::abs(before.real() - after.real()) <= tolerance
                            : before.data == after.data;
                    if (!close)
                        difference = errors::RunDiffersAt(path, types::toText(*newProgram->layout.types, after),
                                                          types::toText(*oldProgram->layout.types, before), i);
                    return close;
                });
            if (!difference.isEmpty()) return fail(at, errors::RunDiffers(name), difference);
        }
    }
    return Flow::Next;
}

} // namespace plc::testing
