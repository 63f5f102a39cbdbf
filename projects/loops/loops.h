// The control loops of a program: which controller blocks it has, what a recording says of each, which variables their
// parameters come from. Functions and values; any thread, a history may still be written meanwhile.
#pragma once
#include "projects/tuning/block_forms.h"
#include "projects/tuning/model/series.h"
#include "runtime/compiler/driver/driver.h"
#include "runtime/history/history.h"

namespace plc::loops {

using ProgramPointer = std::shared_ptr<const image::CompiledProgram>;

struct Loop {
    std::string name;     // "Main.pid"; of a cascade "Main.controller.PI"
    std::string instance; // "Main.controller"
    const tuning::BlockForm* form = nullptr;
    double taskTime = 0; // [s]
    [[nodiscard]] std::string pin(std::string_view member) const;
};

/// In order of declaration.
[[nodiscard]] std::vector<Loop> loopsOf(const image::CompiledProgram& program);
/// By name, without case; a part of it will do where it is clear. The error lists the loops there are.
[[nodiscard]] Result<Loop> findLoop(const image::CompiledProgram& program, const std::string& name);

struct Signals {
    std::string input, output, setPoint; // expressions; the set point's may be empty
};
[[nodiscard]] Signals signalsOf(const Loop& loop);

/// Signals as they were recorded; a row holds values of one scan.
struct RecordedSeries {
    tuning::LoopSeries series;
    std::vector<history::PositionRange> scans; // of the rows, in their order; more than one where time went back
    /// The scans of rows [begin, end), not empty: those that lead to the last one without a way back between them.
    [[nodiscard]] history::PositionRange scansOf(size_t begin, size_t end) const;
    [[nodiscard]] history::Position position(size_t row) const { return scansOf(row, row + 1).begin; }
};
/// On the newest branch, as far as the recording reaches back. Scans that are forgotten while they are read are left
/// out of all columns.
[[nodiscard]] Result<RecordedSeries> seriesOf(const history::History& history, const Signals& channels);

/// What the block works with at a scan.
struct Settings {
    std::vector<double> values; // in the order of the form's parameters, as the block's pins hold them
    tuning::ControllerGains gains;
    std::optional<double> low, high;
    double cycle = 0; // [s]
};
[[nodiscard]] Settings settingsOf(const Loop& loop, const image::CompiledProgram& program,
                                  std::span<const std::byte> image);

/// A variable of an image as a number; times in seconds.
[[nodiscard]] std::optional<double> numberAt(const image::CompiledProgram& program, std::span<const std::byte> image,
                                             const std::string& path);

/// Where a parameter is written so that it lasts: the variable that the call hands to the pin, the pin itself where no
/// call does; empty where the call has a constant or an expression.
struct Target {
    std::string member; // of the form
    std::string path;
};
[[nodiscard]] std::vector<Target> targetsOf(const Loop& loop, const ProgramPointer& program);

} // namespace plc::loops
