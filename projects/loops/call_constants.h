// Parameters that a call hands over as constants, `pid(KP := 2.0, …)`: where they are in the text, and the program with
// others in their place. Functions and values, any thread.
#pragma once
#include "projects/loops/loops.h"

namespace plc::loops {

struct CallConstant {
    std::string member; // of the form: "KP"
    std::string file;   // as the project names it
    SourceRange range;  // of the literal, its sign included
    std::string text;   // as it is written
    uint32_t line = 0;
};

/// Constants of the loop's parameters, in the order of the text; a block that is called in several places has several.
[[nodiscard]] std::vector<CallConstant> callConstants(const Loop& loop, const ProgramPointer& program);

struct ConstantEdit {
    CallConstant place;
    std::string text; // in the place of the literal
};
/// What has to be written in the text for these parameters; nothing where it is written already.
[[nodiscard]] std::vector<ConstantEdit> editsFor(const Loop& loop, const ProgramPointer& program,
                                                 const std::vector<tuning::ParameterValue>& parameters);

/// The program with other constants: for a trial. Its image is laid out as before, else it is an error.
[[nodiscard]] Result<ProgramPointer> withConstants(const driver::BuildInput& input, const ProgramPointer& program,
                                                   const std::vector<ConstantEdit>& edits);

} // namespace plc::loops
