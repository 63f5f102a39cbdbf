#include "projects/testing/coverage.h"

#include <map>

namespace plc::testing {

void Coverage::attach(controller::Controller& controller) {
    controller.useQuickCode(true);
    std::fill(controller.siteFlags().begin(), controller.siteFlags().end(), uint8_t(1));
    // Each site reports once: its flag is cleared by the hook, so covered code runs at full speed.
    controller.setSiteHook([this, &controller](uint32_t site, uint32_t, uint32_t) {
        m_hit[site] = true;
        controller.siteFlags()[site] = 0;
    });
}

void Coverage::collect(controller::Controller& controller) { controller.setSiteHook({}); }

std::vector<PouCoverage> Coverage::perPou() const {
    std::map<std::string, std::map<uint32_t, bool>> lines; // POU → line → ran
    std::map<std::string, std::string> files;
    for (size_t site = 1; site < m_program.sites.size(); ++site) {
        const image::Site& each = m_program.sites[site];
        const image::FunctionInfo& function = m_program.functions[each.function];
        if (!each.range.file.isValid() || !function.library.empty() || function.name.starts_with("Test__")) continue;
        const SourceText& file = m_program.sources[each.range.file];
        bool& ran = lines[function.name][file.lineColumn(each.range.begin).line];
        ran = ran || m_hit[site];
        files[function.name] = file.path();
    }
    std::vector<PouCoverage> out;
    for (const auto& [pou, byLine] : lines) {
        PouCoverage coverage{pou, files[pou], 0, 0, {}};
        for (const auto& [line, ran] : byLine) {
            ++coverage.lines;
            if (ran)
                ++coverage.covered;
            else
                coverage.missed.push_back(line);
        }
        out.push_back(std::move(coverage));
    }
    return out;
}

} // namespace plc::testing
