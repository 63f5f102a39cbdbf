// A reporter that keeps the best time of each benchmark by name, for the tables of ratios printed at the end.
#pragma once
#include <benchmark/benchmark.h>

#include <map>
#include <string>

namespace plc::bench {

class BestTimes : public benchmark::ConsoleReporter {
public:
    void ReportRuns(const std::vector<Run>& runs) override;
    /// Nanoseconds per iteration; 0 when it did not run.
    [[nodiscard]] double best(const std::string& name) const;

private:
    std::map<std::string, double> m_best;
};

/// Runs what is registered and filtered by the command line.
[[nodiscard]] bool runBenchmarks(int argc, char** argv, BestTimes& times);

} // namespace plc::bench
