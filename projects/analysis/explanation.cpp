#include "projects/analysis/explanation.h"

#include "runtime/base/text.h"
#include "runtime/diagnostics/examples.h"
#include "runtime/diagnostics/severity_name.h"

#include <algorithm>

namespace plc::analysis {

namespace {

using diagnostics::Diagnostic;
using diagnostics::Kind;

constexpr Kind kKinds[] = {
#define PLC_DIAGNOSTIC(Name, SeverityName, Code, Text, ...) Kind::Name,
#include "runtime/diagnostics/diagnostics.def"
};

std::string_view exampleOf(std::string_view side, std::string_view code) {
    for (const diagnostics::Example& example : diagnostics::examples())
        if (example.side == side && example.fileName.substr(0, example.fileName.find('.')) == code) return example.text;
    return {};
}

/// What follows "// watch: " in a program, for the diagnostics of expressions outside of programs.
std::string_view watchIn(std::string_view program) {
    constexpr std::string_view mark = "// watch: ";
    const size_t at = program.find(mark);
    if (at == std::string_view::npos) return {};
    program.remove_prefix(at + mark.size());
    return program.substr(0, program.find('\n'));
}

std::vector<Diagnostic> findingsOf(const driver::Checked& checked, Kind kind, std::string_view program) {
    std::vector<Diagnostic> out;
    for (const Diagnostic& each : checked.analysis->diagnostics)
        if (each.kind == kind) out.push_back(each);
    if (const std::string_view watch = watchIn(program); !watch.empty())
        if (const auto expression = driver::compileExpression(checked, watch); !expression)
            out.push_back({kind, diagnostics::severityOf(kind), {}, expression.error().message, {}, {}});
    return out;
}

/// As UTF-8, whatever it is: one example is not.
std::string readable(std::string_view program) {
    std::string out;
    for (size_t at = 0; at < program.size();) appendUtf8(out, decodeUtf8(program, at));
    return out;
}

std::string fenced(std::string_view program) { return "```iecst\n" + readable(program) + "```\n"; }

std::string pageOf(const Explanation& shown) {
    std::string out = "## " + std::string(diagnostics::codeOf(shown.kind)) + "\n\n";
    for (const Diagnostic& finding : shown.findings) {
        out += "- " + std::string(diagnostics::severityName(diagnostics::severityOf(shown.kind)));
        if (finding.range.file.isValid())
            out +=
                ", line " +
                std::to_string((*shown.checkedWrong.sources)[finding.range.file].lineColumn(finding.range.begin).line);
        out += ": " + finding.message.english() + "\n";
        for (const diagnostics::Fix& fix : finding.fixes) out += "  - fix: " + fix.title.english() + "\n";
    }
    return out + "\nWrong:\n\n" + fenced(shown.wrong) + "\nRight:\n\n" + fenced(shown.right) + "\n";
}

} // namespace

std::optional<Explanation> explain(std::string_view code) {
    for (const Kind kind : kKinds) {
        if (!equalsIgnoringCase(diagnostics::codeOf(kind), code)) continue;
        Explanation out;
        out.kind = kind;
        out.wrong = exampleOf("wrong", diagnostics::codeOf(kind));
        out.right = exampleOf("right", diagnostics::codeOf(kind));
        out.checkedWrong = driver::check({{{"wrong.st", std::string(out.wrong)}}, {}});
        out.findings = findingsOf(out.checkedWrong, kind, out.wrong);
        return out;
    }
    return std::nullopt;
}

std::string numbered(std::string_view program) {
    std::string out;
    for (int line = 1; !program.empty(); ++line) {
        const size_t end = std::min(program.find('\n'), program.size());
        const std::string number = std::to_string(line);
        out += std::string(number.size() < 4 ? 4 - number.size() : 0, ' ') + number + " | " +
               readable(program.substr(0, end)) + "\n";
        program.remove_prefix(std::min(end + 1, program.size()));
    }
    return out;
}

std::vector<std::string_view> diagnosticCodes() {
    std::vector<std::string_view> out;
    for (const Kind kind : kKinds) out.push_back(diagnostics::codeOf(kind));
    return out;
}

std::string diagnosticsReference() {
    std::string out = "# Diagnostics\n\nEvery code, with a program that causes it, what the checker reports, and a "
                      "correct program. `stepwise explain CODE` shows one of them, F1 in the studio the one at "
                      "the cursor or of the row in the list of problems. Written by `stepwise doc diagnostics`.\n\n";
    for (const std::string_view code : diagnosticCodes())
        if (const auto shown = explain(code)) out += pageOf(*shown);
    out.pop_back();
    return out;
}

} // namespace plc::analysis
