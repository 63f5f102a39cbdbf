// Sources → checked, compiled program: the one door to the compiler for command line, studio and tests. Owned by
// nobody: functions and immutable results. Any thread; one build at a time per call.
#pragma once
#include "runtime/base/progress.h"
#include "runtime/compiler/driver/reading.h"
#include "runtime/compiler/sema/sema.h"
#include "runtime/expression/expression.h"
#include "runtime/image/program.h"

#include <string>
#include <vector>

namespace plc::driver {

struct SourceFile {
    std::string path; // as shown in messages
    std::string text;
};
inline constexpr int64_t kMostMemoryForNew = 64 << 20;

struct BuildInput {
    std::vector<SourceFile> files;
    std::vector<std::string> libraries; // "toolbox", …; the standard is always there
    bool strict = false;
    std::vector<std::string> companions{}; // texts of panels, alarms, traces, tests: a variable they name is used
    std::vector<std::string> defines{};    // NAME or NAME=VALUE, for conditional pragmas
    image::Addressing addressing = image::Addressing::Bytes; // what the number of %MW1 counts
    uint32_t memoryForNew = 0;                               // bytes that __NEW may take; 0: there is no __NEW
    types::StringCode strings = types::StringCode::Latin1;   // what the bytes of a STRING are
    bool keepsEveryResult = true;                            // of each line of an instruction list, for online values
    bool threadSanitizer = false; // instruments the generated code (tests of the thread contract)
    /// "toolbox/valves.st" and its text, of every library that is used: in the place of this studio's own (D19).
    std::vector<std::pair<std::string, std::string>> libraryTexts{};
};

/// Libraries, defines and what else decides the layout in one list, as recordings keep them: "util", "#Simulation",
/// "%word", "%strings=UTF-8".
[[nodiscard]] std::vector<std::string> recordedSettings(const BuildInput& input);
void setRecordedSettings(BuildInput& input, const std::vector<std::string>& settings);

/// Everything known after checking; `analysis->hasErrors` says whether it can run.
struct Checked {
    std::shared_ptr<const SourceSet> sources;
    std::shared_ptr<const sema::Analysis> analysis;
};
/// The libraries a project can name, lower case, sorted ("analog", "plant", …); the standard is always there and not
/// listed.
[[nodiscard]] std::vector<std::string> libraryNames();
/// The texts of the libraries that the build uses, for a recording.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> libraryTexts(const BuildInput& input);
[[nodiscard]] Checked check(const BuildInput& input);
/// For who checks again and again: only files that changed are read.
[[nodiscard]] Checked check(const BuildInput& input, KeptFiles& kept);

struct Built {
    Checked checked;
    std::shared_ptr<image::CompiledProgram> program; // null when there are errors
    bool isCancelled = false;                        // then nothing else of it counts
    Message failure;                                 // the compiler's own failure (never the user's), else empty
    double checkMs = 0, codeMs = 0;
    std::shared_ptr<const BuildInput> input; // what it was built from (recordings keep it)
};
/// Compiles what was checked with the quick tier; it is not changed, others may read it meanwhile. `input`: what it was
/// checked from. Its trees are moved where they were kept from an earlier text.
[[nodiscard]] Built build(const Checked& checked, const BuildInput& input, Progress* progress = nullptr);
/// Expressions over what it was built from show references by their names, too. It writes into built.checked: only
/// where nobody else reads that meanwhile.
void nameReferences(const Built& built);
/// Checks and compiles with the quick tier. `progress` may cancel it between files, functions and parts of the code.
[[nodiscard]] Built build(const BuildInput& input, Progress* progress = nullptr);
/// Compiles the optimised tier and publishes it in `program`; call from a worker thread. Cancelled, it is
/// an error and the program stays as it was.
[[nodiscard]] Result<void> optimise(const Built& built, Progress* progress = nullptr);

/// What a built program was made from; null: made otherwise.
[[nodiscard]] const tree::Program* treeOf(const std::shared_ptr<const image::CompiledProgram>& program);
[[nodiscard]] Checked checkedOf(const std::shared_ptr<const image::CompiledProgram>& program);
/// Code that reports what it computes (image/watch.h): the functions named (none: all) and whatever leads to them; the
/// others run in the quick code. Any thread.
[[nodiscard]] Result<std::shared_ptr<const image::Code>>
compileWatched(const std::shared_ptr<const image::CompiledProgram>& program,
               const std::vector<uint32_t>& functions = {}, Progress* progress = nullptr);

/// Compiles an expression (D7) for images of `checked`'s layout, as seen from instance path `scope` ("" = top).
/// The error text is the first diagnostic's message.
[[nodiscard]] Result<expression::Expression> compileExpression(const Checked& checked, std::string_view text,
                                                               std::string_view scope = {});

} // namespace plc::driver
