// Which lines of which POU ran, from the quick tier's sites. One thread; attach to each test's controller, collect
// after it.
#pragma once
#include "projects/testing/test_run.h"
#include "runtime/image/program.h"

#include <vector>

namespace plc::testing {

class Coverage {
public:
    explicit Coverage(const image::CompiledProgram& program) : m_program(program), m_hit(program.sites.size()) {}
    void attach(controller::Controller& controller);
    void collect(controller::Controller& controller);
    [[nodiscard]] std::vector<PouCoverage> perPou() const; // project files only, by POU name

private:
    const image::CompiledProgram& m_program;
    std::vector<bool> m_hit; // by site
};

} // namespace plc::testing
