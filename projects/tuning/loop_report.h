// What a page on a loop says, and the page: how it is doing, the changes found, the model, the settings, with charts,
// in the reader's language. Command line and studio fill it. Values and functions, any thread.
#pragma once
#include "projects/tuning/bode_plot.h"
#include "projects/tuning/health.h"
#include "projects/tuning/proposal.h"

namespace plc::tuning {

/// Settings by a rule.
struct ReportedSettings {
    Rule rule{};
    Assessment assessment;
};

/// Of a recording that outlives it.
struct LoopReport {
    const LoopSeries& series;
    const Study& study;
    std::string name;            // of the loop, or of the file
    std::string measured, input; // the variables
    Health health{};
    Message whyNoModel{}; // where the study has none
    size_t model = 0;
    double cycle = 0;
    std::optional<Assessment> now{}; // with the block's present parameters
    std::vector<ReportedSettings> settings{};
    Rule rule{};                                                   // that was chosen
    std::vector<std::pair<std::string, std::string>> parameters{}; // pins of the block and their values by that rule

    [[nodiscard]] const Identified& best() const { return study.models[model]; }
    [[nodiscard]] const Assessment* chosen() const;
};

/// The language of the page.
struct ReportWords {
    std::function<std::string(const Message&)> sentence = [](const Message& message) { return message.english(); };
    std::function<std::string(std::string_view)> title = [](std::string_view text) { return std::string(text); };
    std::string language = "en";
};

/// What is known of the model's parameters: "gain 0.6 ± 0.01".
[[nodiscard]] std::vector<Message> boundWords(const Identified& model);
/// Sentences where the gain depends on direction or operating point.
[[nodiscard]] std::vector<Message> gainWords(const Identified& model);

/// Data and model, what the model leaves, both responses, the Bode plot.
[[nodiscard]] std::vector<waveform::Chart> modelCharts(const LoopReport& report, const ReportWords& words = {});
[[nodiscard]] std::array<waveform::Chart, 2> bodeOf(const LoopReport& report, const ReportWords& words = {});
/// Set point, measured value and output over the whole recording.
[[nodiscard]] std::vector<waveform::Chart> recordedCharts(const LoopReport& report, const ReportWords& words = {});
/// "mean absolute error" and "0.12".
[[nodiscard]] std::vector<std::pair<Message, std::string>> healthRows(const Health& health);
[[nodiscard]] Message movedWord(Moved moved);
/// All of it as HTML.
[[nodiscard]] std::string htmlOf(const LoopReport& report, const ReportWords& words = {});

} // namespace plc::tuning
