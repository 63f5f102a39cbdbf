// Programs run by tests of runtime/inside, and places in their text.
#pragma once
#include "projects/session/session.h"
#include "runtime/compiler/jit/jit.h"
#include "runtime/inside/look.h"
#include "tests/support/long_scans.h"

#include <gtest/gtest.h>

namespace plc::testing {

inline driver::Built buildText(const std::string& text, std::vector<std::string> libraries = {}) {
    jit::setRuntimeSymbols(controller::runtimeSymbols());
    driver::BuildInput input;
    input.files.push_back({"main.st", text});
    input.libraries = std::move(libraries);
    driver::Built built = driver::build(input);
    EXPECT_TRUE(built.program) << built.failure << text;
    if (!built.program)
        for (const auto& diagnostic : built.checked.analysis->diagnostics)
            ADD_FAILURE() << diagnostic.message.english();
    return built;
}

/// A scan of Main that calls a function so often, and then has the statements; it may take an hour.
inline std::string longScan(int calls, const std::string& statements = {}) {
    return "FUNCTION Next : LINT\nVAR_INPUT q : LINT; END_VAR\nNext := q + 1;\nEND_FUNCTION\n"
           "PROGRAM Main\nVAR a, i : LINT; END_VAR\nFOR i := 1 TO " +
           std::to_string(calls) + " DO a := Next(a); END_FOR\n" + statements + "\nEND_PROGRAM\n" + kAnHourForMain;
}

/// The text `part` behind `after` in the first file.
inline SourceRange rangeOf(const image::CompiledProgram& program, std::string_view part, std::string_view after = {}) {
    const std::string_view text = program.sources.files[0].text();
    const size_t from = after.empty() ? 0 : text.find(after);
    const size_t begin = text.find(part, from);
    EXPECT_NE(begin, std::string_view::npos) << part;
    return {FileId(0), static_cast<uint32_t>(begin), static_cast<uint32_t>(begin + part.size())};
}

inline types::Value integerFor(const image::CompiledProgram& program, const std::string& path, int64_t value) {
    const auto place = program.layout.find(path);
    EXPECT_TRUE(place) << path;
    types::Value v;
    v.type = place ? place->type : types::TypeId();
    v.data = value;
    return v;
}

} // namespace plc::testing
