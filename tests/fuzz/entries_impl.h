// The bodies, included once per program. Broken promises abort: libFuzzer and the test runner both see that.
#pragma once
#include "tests/fuzz/entries.h"

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

void runText(std::string_view bytes) {
    driver::BuildInput input;
    input.files.push_back({"fuzz.st", std::string(bytes)});
    const driver::Built built = driver::build(input);
    if (!built.program) return;
    controller::Settings settings;
    settings.loopBudgetPerScan = 20'000;
    controller::Controller controller(built.program, settings);
    controller.start();
    for (int scan = 0; scan < 8 && controller.state() == controller::State::Running; ++scan) controller.scan();
}

} // namespace plc::fuzz
