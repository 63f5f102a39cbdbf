// The bodies, included once per program. Broken promises abort: libFuzzer and the test runner both see that.
#pragma once
#include "tests/fuzz/entries.h"
#include "tests/fuzz/grammar.h"

#include "runtime/compiler/driver/driver.h"
#include "runtime/compiler/format/format.h"
#include "runtime/compiler/jit/jit.h"
#include "runtime/compiler/lex/token.h"
#include "runtime/compiler/parse/parser.h"
#include "runtime/controller/controller.h"

#include <cstdlib>
#include <string>

namespace plc::fuzz {

inline void promise(bool kept) {
    if (!kept) std::abort();
}

void lexText(std::string_view bytes) {
    diagnostics::Sink sink;
    const lex::TokenList list = lex::tokenize(FileId(size_t(0)), bytes, sink);
    promise(!list.tokens.empty() && list.tokens.back().kind == lex::TokenKind::EndOfFile);
    uint32_t end = 0;
    for (const lex::Token& token : list.tokens) {
        promise(token.begin >= end && token.end >= token.begin && token.end <= bytes.size());
        end = token.end;
    }
}

void parseText(std::string_view bytes) {
    const std::string text(bytes);
    diagnostics::Sink sink;
    const auto file = parse::parseFile(FileId(size_t(0)), text, sink);
    promise(file != nullptr);
    for (const diagnostics::Diagnostic& d : sink.all())
        promise(d.range.begin <= d.range.end && d.range.end <= text.size());
    const std::string once = format::format(text, {});
    promise(format::format(once, {}) == once);
}

inline uint32_t hashOf(std::string_view bytes) {
    uint32_t hash = 2166136261u;
    for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
    return hash;
}
/// Decided by the bytes, so that a finding repeats.
inline bool isOneOf(uint32_t number, std::string_view bytes) { return (hashOf(bytes) >> 7) % number == 0; }

/// Declaring the whole standard library takes longer than checking what is fuzzed: most texts get four blocks of it.
inline driver::BuildInput inputOf(std::string_view bytes) {
    static const std::string fewBlocks = R"(
FUNCTION_BLOCK R_TRIG VAR_INPUT CLK : BOOL; END_VAR VAR_OUTPUT Q : BOOL; END_VAR VAR M : BOOL; END_VAR
Q := CLK AND NOT M; M := CLK; END_FUNCTION_BLOCK
FUNCTION_BLOCK SR VAR_INPUT S1, R : BOOL; END_VAR VAR_OUTPUT Q1 : BOOL; END_VAR
Q1 := S1 OR (Q1 AND NOT R); END_FUNCTION_BLOCK
FUNCTION_BLOCK CTU VAR_INPUT CU : BOOL R_EDGE; R : BOOL; PV : INT; END_VAR VAR_OUTPUT Q : BOOL; CV : INT; END_VAR
IF R THEN CV := 0; ELSIF CU AND CV < 32767 THEN CV := CV + 1; END_IF; Q := CV >= PV; END_FUNCTION_BLOCK
FUNCTION_BLOCK TON VAR_INPUT IN : BOOL; PT : TIME; END_VAR VAR_OUTPUT Q : BOOL; ET : TIME; END_VAR
VAR since : TIME; END_VAR
IF NOT IN THEN since := TIME(); END_IF; ET := TIME() - since; Q := IN AND ET >= PT; END_FUNCTION_BLOCK
)";
    driver::BuildInput input;
    input.files.push_back({"fuzz.st", std::string(bytes)});
    if (!isOneOf(16, bytes)) input.libraryTexts.emplace_back("standard/few.st", fewBlocks);
    return input;
}

inline controller::Settings boundedSettings() {
    controller::Settings settings;
    settings.loopBudgetPerScan = 20'000;
    return settings;
}

inline void someScans(controller::Controller& controller) {
    for (int scan = 0; scan < 8 && controller.state() == controller::State::Running; ++scan) controller.scan();
}

void checkText(std::string_view bytes) {
    static driver::KeptFiles kept; // the libraries are read once
    const driver::Checked checked = driver::check(inputOf(bytes), kept);
    bool hasErrors = false;
    for (const diagnostics::Diagnostic& d : checked.analysis->diagnostics) {
        hasErrors = hasErrors || d.severity == diagnostics::Severity::Error;
        if (!d.range.file.isValid()) continue;
        promise(d.range.file.index() < checked.sources->files.size());
        promise(d.range.begin <= d.range.end && d.range.end <= (*checked.sources)[d.range.file].text().size());
    }
    promise(hasErrors == checked.analysis->hasErrors);
    if (isOneOf(32, bytes))
        promise(driver::check(inputOf(bytes)).analysis->diagnostics.size() == checked.analysis->diagnostics.size());
}

void runText(std::string_view bytes) {
    const driver::Built built = driver::build(inputOf(bytes));
    if (!built.program) return;
    controller::Controller controller(built.program, boundedSettings());
    controller.start();
    someScans(controller);
}

void changeText(std::string_view bytes) {
    const driver::Built first = driver::build(inputOf(bytes));
    if (!first.program) return;
    const driver::Built second = driver::build(inputOf(mutateByGrammar(bytes, bytes, hashOf(bytes))));
    if (!second.program) return;
    controller::Controller controller(first.program, boundedSettings());
    controller.start();
    someScans(controller);
    for (const driver::Built* next : {&second, &first}) {
        (void)controller.changeProgram(next->program); // what it refuses it says
        someScans(controller);
    }
}

} // namespace plc::fuzz
