// Coverage of a project's tests, gathered by running every recorded scan of them again (`test --coverage mcdc`).
#pragma once
#include "projects/testing/test_run.h"
#include "runtime/inside/coverage.h"

#include <memory>
#include <optional>
#include <string>

namespace plc::cli {

class CoverageRun {
public:
    /// The tests of `options` are followed from now on; this must outlive them.
    void follow(testing::Options& options);
    [[nodiscard]] std::string text() const;
    /// FILE.html or FILE.xml (Cobertura).
    [[nodiscard]] Result<void> write(const std::string& file) const;

private:
    std::shared_ptr<const image::CompiledProgram> m_program;
    std::optional<inside::Coverage> m_coverage;
    size_t m_failed = 0; // scans that could not be run again
};

} // namespace plc::cli
