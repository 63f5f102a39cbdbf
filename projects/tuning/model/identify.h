// Finds the model that explains recorded steps: output error, least squares over several excerpts at once, the
// structure chosen by validation on what was left out. Values and functions, any thread.
#pragma once
#include "projects/tuning/model/process_model.h"

#include <string_view>

namespace plc::tuning {

/// Input and output around one step or disturbance, evenly sampled; input[i] acts from sample i to the next.
struct Excerpt {
    double interval = 1; // [s]
    std::vector<double> input, output;
    bool startsAtRest = true;
};

enum class Structure : uint8_t {
#define PLC_STRUCTURE(Name, Title) Name,
#include "projects/tuning/model/structures.def"
};
[[nodiscard]] std::string_view title(Structure structure);

struct Bound {
    std::string name; // "gain", "lag 1", "dead time"…
    double value = 0;
    double halfWidth = 0; // of the 95 % confidence interval
};

/// The gain about a level of the output.
struct GainAt {
    double level = 0, gain = 0;
};

struct Identified {
    ProcessModel model;
    Structure structure{};
    double fit = 0;                   // per cent of the deviation that the model explains
    std::optional<double> validation; // the same on an excerpt that the fit did not see
    double noise = 0;                 // standard deviation of the residual
    double score = 0;                 // least is best
    std::vector<Bound> bounds;
    std::vector<std::vector<double>> simulated; // one for each excerpt
    std::optional<double> gainUp, gainDown;     // where steps in both directions say different things
    std::vector<GainAt> gainsAt;                // where it depends on the operating point, rising
};

/// What the fit of one structure says; none where it does not fit at all.
[[nodiscard]] std::optional<Identified> identify(const std::vector<Excerpt>& excerpts, Structure structure);
/// The best first; empty: nothing explains the data.
[[nodiscard]] std::vector<Identified> identify(const std::vector<Excerpt>& excerpts);

} // namespace plc::tuning
