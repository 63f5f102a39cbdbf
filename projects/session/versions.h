// The versions of the program that a session has run, and the expressions compiled for them. Shared by the session and
// by the closures it hands out; any thread.
#pragma once
#include "runtime/compiler/driver/driver.h"
#include "runtime/history/history.h"

#include <map>
#include <memory>
#include <mutex>

namespace plc::session {

/// What a program of a recording is built from: the recorded texts, the libraries' included (D19).
[[nodiscard]] driver::BuildInput recordedInput(const history::History::Sources& sources);

class Versions {
public:
    void add(std::shared_ptr<const driver::Built> built);
    [[nodiscard]] std::shared_ptr<const driver::Built> of(const image::CompiledProgram* program) const;
    /// Forgets versions that nothing recorded needs any more; the newest few stay.
    void keepOnly(const std::vector<std::shared_ptr<const image::CompiledProgram>>& programs,
                  const driver::Built* current);
    [[nodiscard]] Result<expression::Expression> expression(const driver::Built& built, const std::string& text,
                                                            const std::string& scope);

private:
    struct Key {
        const image::CompiledProgram* program;
        std::string text, scope;
        auto operator<=>(const Key&) const = default;
    };
    mutable std::mutex m_mutex;
    std::vector<std::shared_ptr<const driver::Built>> m_versions; // oldest first
    std::map<Key, Result<expression::Expression>> m_expressions;
};

} // namespace plc::session
