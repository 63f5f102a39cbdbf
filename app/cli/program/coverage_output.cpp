#include "app/cli/program/coverage_output.h"

#include "app/cli/kit/written_file.h"
#include "projects/session/session.h"

#include <cstdio>

namespace plc::cli {

void CoverageRun::follow(testing::Options& options) {
    options.finished = [this, watched = options.watched](session::Session& session) {
        if (!m_coverage) {
            m_program = session.program();
            m_coverage.emplace(m_program);
        }
        m_failed += m_coverage->addAll(session.history(), watched);
    };
}

std::string CoverageRun::text() const {
    if (!m_coverage) return "  no test ran\n";
    std::string out;
    char line[256];
    const auto percent = [](size_t part, size_t whole) {
        return whole == 0 ? 100.0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
    };
    for (const inside::FunctionCoverage& f : m_coverage->functions()) {
        std::snprintf(line, sizeof line, "  %-40s statements %5.1f %%   branches %5.1f %%   MC/DC %5.1f %%\n",
                      f.name.c_str(), percent(f.statementsRun(), f.statements.size()),
                      percent(f.branchesTaken(), f.branches.size()), percent(f.conditionsMet(), f.conditionCount()));
        out += line;
        for (const inside::DecisionCoverage& decision : f.decisions)
            for (const inside::ConditionCoverage& condition : decision.conditions)
                if (!condition.decidedAlone)
                    out += "      " + m_program->sources[condition.range.file].path() + ":" +
                           std::to_string(
                               m_program->sources[condition.range.file].lineColumn(condition.range.begin).line) +
                           ": missing " + condition.missing + "\n";
    }
    if (m_failed > 0) out += "  " + std::to_string(m_failed) + " scans could not be run again and are not counted\n";
    return out;
}

Result<void> CoverageRun::write(const std::string& file) const {
    if (!m_coverage) return writeFile(file, {});
    const auto all = m_coverage->functions();
    return writeFile(file, file.ends_with(".xml") ? inside::coberturaXml(*m_program, all)
                                                  : inside::coverageHtml(*m_program, all));
}

} // namespace plc::cli
