// Trying settings before they are written: the project's own program runs a recorded stretch again with other
// parameters, the measured value being what was recorded plus what the model says of the difference. With the
// parameters that were in force the result is the recording, bit for bit. Functions, any thread; each call has a
// controller of its own.
#pragma once
#include "projects/loops/loops.h"
#include "projects/tuning/model/process_model.h"

namespace plc::loops {

/// The variable that a call hands to a pin; the pin itself where no call does; empty where it is an expression.
[[nodiscard]] std::string sourceOf(const Loop& loop, const ProgramPointer& program, std::string_view pin);

struct ParameterWrite {
    std::string path;
    double value = 0; // as the variable holds it; times in seconds
};
/// Those of the parameters that can be written; `missing` receives the pins of the others.
[[nodiscard]] std::vector<ParameterWrite> writesOf(const Loop& loop, const ProgramPointer& program,
                                                   const std::vector<tuning::ParameterValue>& parameters,
                                                   std::vector<std::string>* missing = nullptr);
/// What is written in the same scan as other parameters so that the output goes on from where it is then: the block's
/// next call fits its integral to them. Nothing for a controller that has none, whose output is its error times its
/// gain.
[[nodiscard]] std::vector<ParameterWrite> bumplessWrites(const Loop& loop, const image::CompiledProgram& program);
/// The value as a variable of that type holds it.
[[nodiscard]] Result<types::Value> valueFor(const image::CompiledProgram& program, const std::string& path,
                                            double value);

struct TrialPlan {
    history::Position from = 0, to = 0; // scans of one version of the program, all of them recorded
    std::string input, measured;        // paths; the measured value is forced
    std::vector<std::string> played;    // others that are forced to what was recorded: a set point, other inputs
    std::vector<ParameterWrite> writes; // before the first scan
    ProgramPointer program;             // runs in the place of the recorded one: with other constants; null: that one
};

struct TrialRun {
    tuning::LoopSeries series; // what would have been
    tuning::LoopSeries before; // what was
    uint64_t scans = 0;
    std::optional<uint64_t> firstDifference; // scan in which the input first differs in any bit
};

/// `process`: none plays the recorded values alone.
[[nodiscard]] Result<TrialRun> tryOut(const history::History& history, const TrialPlan& plan,
                                      const std::optional<tuning::ProcessModel>& process);
/// The plan for a loop over a stretch of the recording.
[[nodiscard]] Result<TrialPlan> planFor(const Loop& loop, const history::History& history, history::Position from,
                                        history::Position to);

} // namespace plc::loops
