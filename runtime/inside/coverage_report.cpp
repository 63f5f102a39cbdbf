#include "runtime/inside/coverage.h"

#include "runtime/base/xml_text.h"

#include <algorithm>
#include <cstdio>

namespace plc::inside {

namespace {

std::string rate(size_t part, size_t whole) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4f", whole == 0 ? 1.0 : static_cast<double>(part) / static_cast<double>(whole));
    return text;
}

struct Sums {
    size_t statements = 0, run = 0, branches = 0, taken = 0, conditions = 0, met = 0;
    void add(const FunctionCoverage& f) {
        statements += f.statements.size();
        run += f.statementsRun();
        branches += f.branches.size();
        taken += f.branchesTaken();
        conditions += f.conditionCount();
        met += f.conditionsMet();
    }
};

Sums sumsOf(const std::vector<FunctionCoverage>& all) {
    Sums sums;
    for (const FunctionCoverage& f : all) sums.add(f);
    return sums;
}

} // namespace

std::string coberturaXml(const image::CompiledProgram& program, const std::vector<FunctionCoverage>& all) {
    const Sums sums = sumsOf(all);
    std::string out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                      "<!DOCTYPE coverage SYSTEM \"http://cobertura.sourceforge.net/xml/coverage-04.dtd\">\n"
                      "<coverage line-rate=\"" +
                      rate(sums.run, sums.statements) + "\" branch-rate=\"" + rate(sums.taken, sums.branches) +
                      "\" lines-covered=\"" + std::to_string(sums.run) + "\" lines-valid=\"" +
                      std::to_string(sums.statements) + "\" branches-covered=\"" + std::to_string(sums.taken) +
                      "\" branches-valid=\"" + std::to_string(sums.branches) +
                      "\" complexity=\"0\" version=\"1\" timestamp=\"0\">\n  <sources><source>.</source></sources>\n"
                      "  <packages>\n    <package name=\"plc\" line-rate=\"" +
                      rate(sums.run, sums.statements) + "\" branch-rate=\"" + rate(sums.taken, sums.branches) +
                      "\" complexity=\"0\">\n      <classes>\n";
    for (const FunctionCoverage& f : all) {
        Sums own;
        own.add(f);
        out += "        <class name=\"" + xmlText(f.name) + "\" filename=\"" + xmlText(f.file) + "\" line-rate=\"" +
               rate(own.run, own.statements) + "\" branch-rate=\"" + rate(own.taken, own.branches) +
               "\" complexity=\"0\">\n          <methods/>\n          <lines>\n";
        for (const auto& [number, line] : linesOf(program, f)) {
            if (!line.isStatement) continue;
            out += "            <line number=\"" + std::to_string(number) + "\" hits=\"" + std::to_string(line.count) +
                   "\" branch=\"" + (line.branches ? "true" : "false") + "\"";
            if (line.branches)
                out += " condition-coverage=\"" + std::to_string(100 * line.taken / line.branches) + "% (" +
                       std::to_string(line.taken) + "/" + std::to_string(line.branches) + ")\"";
            out += "/>\n";
        }
        out += "          </lines>\n        </class>\n";
    }
    return out + "      </classes>\n    </package>\n  </packages>\n</coverage>\n";
}

std::string coverageHtml(const image::CompiledProgram& program, const std::vector<FunctionCoverage>& all) {
    std::string out =
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>Coverage</title><style>\n"
        ":root{color-scheme:light dark;--run:#d7f0dc;--missed:#f8d7d7;--part:#fbeec2}\n"
        "@media(prefers-color-scheme:dark){:root{--run:#1d3b26;--missed:#4a2323;--part:#4a4020}}\n"
        "body{font:14px system-ui,sans-serif;margin:2em}table{border-collapse:collapse}td,th{padding:.1em .8em;"
        "text-align:right}td:first-child,th:first-child{text-align:left}pre{margin:0}\n"
        ".l{display:flex}.l b{width:4em;text-align:right;padding-right:1em;font-weight:normal;opacity:.6}\n"
        ".r{background:var(--run)}.m{background:var(--missed)}.p{background:var(--part)}i{padding-left:2em;opacity:.8}"
        "\n"
        "</style></head><body><h1>Coverage</h1>\n<table><tr><th>POU</th><th>Statements</th><th>Branches</th><th>MC/DC</"
        "th></tr>\n";
    const auto cell = [](size_t part, size_t whole) {
        return "<td>" + std::to_string(part) + " of " + std::to_string(whole) + "</td>";
    };
    for (const FunctionCoverage& f : all)
        out += "<tr><td>" + xmlText(f.name) + "</td>" + cell(f.statementsRun(), f.statements.size()) +
               cell(f.branchesTaken(), f.branches.size()) + cell(f.conditionsMet(), f.conditionCount()) + "</tr>\n";
    const Sums sums = sumsOf(all);
    out += "<tr><th>All</th>" + cell(sums.run, sums.statements) + cell(sums.taken, sums.branches) +
           cell(sums.met, sums.conditions) + "</tr></table>\n";
    std::map<std::string, std::map<uint32_t, LineCoverage>> files;
    for (const FunctionCoverage& f : all)
        for (auto& [number, line] : linesOf(program, f)) files[f.file][number] = std::move(line);
    for (const SourceText& source : program.sources.files) {
        const auto file = files.find(source.path());
        if (file == files.end()) continue;
        out += "<h2>" + xmlText(source.path()) + "</h2>\n";
        for (uint32_t number = 1; number <= source.lineCount(); ++number) {
            const auto line = file->second.find(number);
            std::string kind, missing;
            if (line != file->second.end()) {
                static constexpr const char* kKinds[] = {"", "r", "p", "m"}; // by LineCoverage::State
                kind = kKinds[static_cast<size_t>(line->second.state())];
                for (const Message& each : line->second.missing)
                    missing += (missing.empty() ? "" : "; ") + each.english();
            }
            out += "<div class=\"l " + kind + "\"><b>" + std::to_string(number) + "</b><pre>" +
                   xmlText(source.line(number)) + "</pre>" +
                   (missing.empty() ? "" : "<i>" + xmlText(missing) + "</i>") + "</div>\n";
        }
    }
    return out + "</body></html>\n";
}

} // namespace plc::inside
