#include "tests/bench/bench_table.h"

namespace plc::bench {

void BestTimes::ReportRuns(const std::vector<Run>& runs) {
    for (const Run& run : runs) {
        if (run.run_type != Run::RT_Iteration || run.error_occurred) continue;
        const double time = run.iterations ? run.cpu_accumulated_time * 1e9 / static_cast<double>(run.iterations) : 0;
        double& best = m_best[run.run_name.function_name];
        if (best == 0 || time < best) best = time;
    }
}

double BestTimes::best(const std::string& name) const {
    const auto it = m_best.find(name);
    return it == m_best.end() ? 0 : it->second;
}

bool runBenchmarks(int argc, char** argv, BestTimes& times) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return false;
    benchmark::RunSpecifiedBenchmarks(&times);
    return true;
}

} // namespace plc::bench
