// A trace set-up: what traces/NAME.trace.json holds. A value without Qt; reading and writing keep what this version
// does not know, and loading and saving our own file changes no byte. Any thread.
#pragma once

#include "runtime/base/result.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace plc::trace {

using Json = nlohmann::ordered_json;

enum class ChannelStyle : uint8_t {
    Automatic,
    Line,
    Hold,
    Digital
}; // automatic: digital for BOOL and enums, hold else
enum class ScaleMode : uint8_t { Automatic, Fit, Fixed };
enum class TriggerEdge : uint8_t { Rising, Falling, Both, Level };
enum class TriggerMode : uint8_t { Off, Single, Repeated };

struct ChannelSetup {
    std::string expression;
    std::string label; // empty: the expression
    int chart = 0, axis = 0;
    std::string color; // "#rrggbb"; empty: by order
    double width = 1.6;
    ChannelStyle style = ChannelStyle::Automatic;
    double scale = 1, offset = 0;
    std::string unit;
    std::string recording; // file it is read from, relative to the project; empty: the one that is shown
    bool isVisible = true;
    Json origin; // as read
    bool operator==(const ChannelSetup&) const = default;
};

struct AxisSetup {
    std::string title, unit;
    ScaleMode mode = ScaleMode::Automatic;
    double minimum = 0, maximum = 100;
    bool isOnRight = false;
    Json origin;
    bool operator==(const AxisSetup&) const = default;
};

struct ChartSetup {
    std::string title;
    double weight = 1;
    std::vector<AxisSetup> axes = {AxisSetup{}};
    Json origin;
    bool operator==(const ChartSetup&) const = default;
};

struct TriggerSetup {
    std::string expression;
    TriggerEdge edge = TriggerEdge::Rising;
    TriggerMode mode = TriggerMode::Off;
    int64_t before = 1'000'000'000, after = 1'000'000'000; // nanoseconds shown around it
    Json origin;
    bool operator==(const TriggerSetup&) const = default;
};

/// What is drawn beside the charts over time.
enum class FigureKind : uint8_t { None, Xy, Spectrum, Response, Runs };
enum class FigureWindow : uint8_t { Hann, FlatTop, Rectangular };

struct FigureSetup {
    FigureKind kind = FigureKind::None;
    std::string x; // expression: of an XY plot the horizontal value, of a response the input; empty: the first channel
    FigureWindow window = FigureWindow::Hann; // of a spectrum
    bool isLogarithmic = true;                // the amplitudes of a spectrum
    Json origin;
    bool operator==(const FigureSetup&) const = default;
};

/// A remark at a time of the recording, and at a value where one was clicked.
struct NoteSetup {
    int64_t time = 0;
    std::optional<double> value;
    int chart = 0;
    std::string text;
    Json origin;
    bool operator==(const NoteSetup&) const = default;
};

struct TraceSetup {
    std::string title;
    int64_t span = 10'000'000'000; // width of the view
    uint32_t every = 1;            // records every n-th scan
    std::string condition;         // records only while this holds
    std::string compareWith;       // recording drawn beneath, relative to the project
    int64_t compareShift = 0;      // nanoseconds by which that one is moved to the right
    bool hasTable = false;         // measuring table shown
    std::optional<int64_t> cursorA, cursorB;
    TriggerSetup trigger;
    std::vector<ChartSetup> charts = {ChartSetup{}};
    std::vector<ChannelSetup> channels;
    FigureSetup figure;
    std::vector<NoteSetup> notes;
    Json origin;
    bool operator==(const TraceSetup&) const = default;
};

[[nodiscard]] Result<TraceSetup> readSetup(std::string_view text, const std::string& place);
[[nodiscard]] std::string writeSetup(const TraceSetup& setup);
/// Each expression of the running program that the set-up names: channels, condition, trigger, figure.
void forEachExpression(TraceSetup& setup, const std::function<void(std::string& expression)>& visit);

[[nodiscard]] Result<TraceSetup> loadSetup(const std::string& path);
Result<void> saveSetup(const TraceSetup& setup, const std::string& path);

/// A set-up of these expressions, one chart, all automatic.
[[nodiscard]] TraceSetup setupOf(const std::vector<std::string>& expressions);

} // namespace plc::trace
