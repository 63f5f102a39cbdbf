// A unit's text parsed and projected, as tests of ladder and function block diagrams need it. One thread.
#pragma once
#include "runtime/compiler/ladder/diagram.h"
#include "runtime/compiler/parse/parser.h"

#include <memory>
#include <string>

namespace plc::ladder {

/// The blocks of the standard that the tests call.
inline constexpr std::string_view kBlocks =
    "FUNCTION_BLOCK TON VAR_INPUT IN : BOOL; PT : TIME; END_VAR VAR_OUTPUT Q : BOOL; ET : TIME; END_VAR "
    "END_FUNCTION_BLOCK\n"
    "FUNCTION_BLOCK CTU VAR_INPUT CU, R : BOOL; PV : INT; END_VAR VAR_OUTPUT Q : BOOL; CV : INT; END_VAR "
    "END_FUNCTION_BLOCK\n"
    "FUNCTION_BLOCK SR VAR_INPUT S1, R : BOOL; END_VAR VAR_OUTPUT Q1 : BOOL; END_VAR END_FUNCTION_BLOCK\n"
    "FUNCTION_BLOCK R_TRIG VAR_INPUT CLK : BOOL; END_VAR VAR_OUTPUT Q : BOOL; END_VAR END_FUNCTION_BLOCK\n"
    "FUNCTION_BLOCK F_TRIG VAR_INPUT CLK : BOOL; END_VAR VAR_OUTPUT Q : BOOL; END_VAR END_FUNCTION_BLOCK\n"
    "FUNCTION Limits : INT VAR_INPUT MN, IN, MX : INT; END_VAR END_FUNCTION\n";

/// `statements` in a program with these declarations; also any whole file.
struct Opened {
    std::string text;
    std::unique_ptr<syntax::SyntaxFile> file, blocks;
    std::unique_ptr<DeclaredTypes> types;
    Unit unit;
    Diagram diagram;
    std::string errors;

    explicit Opened(std::string source, Form form = Form::Ladder, std::string_view name = {})
        : text(std::move(source)) {
        diagnostics::Sink sink, others;
        file = parse::parseFile(FileId(0), text, sink);
        blocks = parse::parseFile(FileId(1), kBlocks, others);
        for (const diagnostics::Diagnostic& d : sink.all())
            if (d.severity == diagnostics::Severity::Error) errors += d.message.english() + "\n";
        types = std::make_unique<DeclaredTypes>(std::vector<const syntax::SyntaxFile*>{file.get(), blocks.get()});
        unit = findUnit(*file, name);
        diagram = project(text, *file, unit, *types, form);
    }
    [[nodiscard]] std::string words() const { return describe(diagram); }
};

inline std::string program(const std::string& statements) {
    return "PROGRAM Main\n"
           "VAR\n"
           "    a, b, c, d, x, y, z, start, stop, motor, lamp : BOOL;\n"
           "    i, j, k : INT; r : REAL; w, v : WORD; t : TIME;\n"
           "    T1, T2 : TON; C1 : CTU; S1 : SR; up : R_TRIG; down : F_TRIG;\n"
           "END_VAR\n"
           "VAR_TEMP h : BOOL; END_VAR\n" +
           statements + "END_PROGRAM\n";
}

} // namespace plc::ladder
