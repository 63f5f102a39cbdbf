// What `stepwise tune` prints and draws: steps, models, settings. Values and functions, one thread.
#pragma once
#include "projects/loops/call_constants.h"
#include "projects/tuning/loop_report.h"

namespace plc::cli {

using RuleAnswer = tuning::ReportedSettings;

struct TuneReport {
    std::string name; // of the loop, or of the file
    loops::Signals channels;
    tuning::LoopSeries series;
    tuning::Study study;
    double cycle = 0;
    tuning::ControllerKind kind{};
    tuning::Rule rule{}; // that was asked for
    std::vector<RuleAnswer> answers;
    std::optional<loops::Loop> loop;
    std::optional<tuning::Assessment> now; // with the block's present parameters
    std::vector<tuning::ParameterValue> parameters;
    std::vector<loops::Target> targets;
    std::vector<loops::CallConstant> constants; // parameters that the call has as numbers
    std::string measuredName, inputName;        // for axes: the variables behind the pins

    tuning::Health health;
    Message whyNoModel;

    [[nodiscard]] const tuning::Identified& best() const { return study.models.front(); }
    [[nodiscard]] const RuleAnswer* answer() const; // of the rule that was asked for
};

[[nodiscard]] std::string textOf(const TuneReport& report);
[[nodiscard]] std::string jsonOf(const TuneReport& report);
/// Data and model, both responses, the Bode plot of the loop.
[[nodiscard]] std::string pictureOf(const TuneReport& report, bool isDark);

/// Gain and phase of the process and of the loop, now and with the answer, crossover and margins marked.
[[nodiscard]] std::string bodePictureOf(const TuneReport& report, bool isDark);

/// How the loop is doing, as sentences and figures.
[[nodiscard]] std::string healthText(const TuneReport& report);
/// All of it as a page of its own, charts included; without a model only how the loop is doing.
[[nodiscard]] std::string pageOf(const TuneReport& report);

} // namespace plc::cli
