// Tuning rules of the literature, from a model to gains: SIMC, AMIGO, Chien-Hrones-Reswick, Ziegler-Nichols, and the
// optimum under a bound of robustness. Values and functions, any thread.
#pragma once
#include "projects/tuning/optimum.h"

#include <string_view>

namespace plc::tuning {

enum class Rule : uint8_t {
#define PLC_TUNING_RULE(Name, Word, Title) Name,
#include "projects/tuning/rules.def"
};
[[nodiscard]] std::string_view word(Rule rule);  // of the command line
[[nodiscard]] std::string_view title(Rule rule); // English; the studio translates it
[[nodiscard]] std::optional<Rule> parseRule(std::string_view word);
[[nodiscard]] std::vector<Rule> allRules();

/// One lag (or an integrator) and dead time: what the rules know of a process.
struct FirstOrder {
    double gain = 1; // slope, where it integrates
    double lag = 0;  // 0 with an integrator
    double secondLag = 0;
    double deadTime = 0;
    bool isIntegrating = false;
};
/// By the half rule: of the greatest neglected lag one half goes to the dead time and one to the lag, the rest to the
/// dead time. `keepsSecond`: for a controller with a derivative part.
[[nodiscard]] FirstOrder halfRule(const ProcessModel& process, bool keepsSecond);
/// By two points of the step response, at 28 and 63 per cent of the way.
[[nodiscard]] FirstOrder byStepResponse(const ProcessModel& process);

struct Wish {
    ControllerKind kind = ControllerKind::Pi;
    /// 0 calm … 1 brisk; 0.5: as the rule's authors recommend.
    double briskness = 0.5;
    /// 0: for disturbances … 1: for set points.
    double setPoint = 0.5;
    double delay = 0; // what sampling adds to the dead time [s]
};

/// None where the rule has no answer for the process or the kind.
[[nodiscard]] std::optional<ControllerGains> tune(const ProcessModel& process, Rule rule, const Wish& wish);
/// The bound of the sensitivity that a briskness stands for: 1.2 … 1.59 … 2.0.
[[nodiscard]] double sensitivityOf(double briskness);

} // namespace plc::tuning
