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

inline driver::BuildInput inputOf(std::string_view bytes) {
    driver::BuildInput input;
    input.files.push_back({"fuzz.st", std::string(bytes)});
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
    uint32_t seed = 2166136261u;
    for (const char c : bytes) seed = (seed ^ static_cast<unsigned char>(c)) * 16777619u;
    const driver::Built second = driver::build(inputOf(mutateByGrammar(bytes, bytes, seed)));
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
