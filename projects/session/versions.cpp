#include "projects/session/versions.h"

#include <algorithm>

namespace plc::session {

namespace {
constexpr size_t kKeptVersions = 4, kCachedExpressions = 4096;
}

driver::BuildInput recordedInput(const history::History::Sources& sources) {
    driver::BuildInput input;
    for (const auto& [path, text] : sources.files) input.files.push_back({path, text});
    driver::setRecordedSettings(input, sources.libraries);
    input.libraryTexts = sources.libraryTexts;
    return input;
}

void Versions::add(std::shared_ptr<const driver::Built> built) {
    const std::lock_guard lock(m_mutex);
    m_versions.push_back(std::move(built));
}

std::shared_ptr<const driver::Built> Versions::of(const image::CompiledProgram* program) const {
    const std::lock_guard lock(m_mutex);
    for (const auto& built : m_versions)
        if (built->program.get() == program) return built;
    return nullptr;
}

void Versions::keepOnly(const std::vector<std::shared_ptr<const image::CompiledProgram>>& programs,
                        const driver::Built* current) {
    std::vector<std::shared_ptr<const driver::Built>> dropped; // destroyed outside the lock
    const std::lock_guard lock(m_mutex);
    for (size_t i = 0; i + kKeptVersions < m_versions.size();) {
        const auto& built = m_versions[i];
        const bool isRecorded =
            std::any_of(programs.begin(), programs.end(), [&](const auto& p) { return p == built->program; });
        if (isRecorded || built.get() == current) {
            ++i;
            continue;
        }
        std::erase_if(m_expressions, [&](const auto& entry) { return entry.first.program == built->program.get(); });
        dropped.push_back(built);
        m_versions.erase(m_versions.begin() + static_cast<std::ptrdiff_t>(i));
    }
}

Result<expression::Expression> Versions::expression(const driver::Built& built, const std::string& text,
                                                    const std::string& scope) {
    const Key key{built.program.get(), text, scope};
    {
        const std::lock_guard lock(m_mutex);
        if (const auto known = m_expressions.find(key); known != m_expressions.end()) return known->second;
    }
    Result<expression::Expression> compiled = driver::compileExpression(built.checked, text, scope);
    const std::lock_guard lock(m_mutex);
    if (m_expressions.size() >= kCachedExpressions) m_expressions.clear();
    m_expressions.emplace(key, compiled);
    return compiled;
}

} // namespace plc::session
