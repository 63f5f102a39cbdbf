// What a plot shows, as plain values: charts one above the other over one time axis, curves in them, markers, cursors,
// the part of time in view. The view and the picture renderer both draw from this; neither keeps a second truth. GUI
// thread.
#pragma once

#include "editor/plot/model/plot_sample.h"

#include <QColor>
#include <QString>

#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace plc::plot {

enum class CurveStyle : uint8_t {
    Line,   // samples joined by straight lines
    Hold,   // a value holds until the next sample; jumps are vertical
    Digital // a lane of its own, as a logic analyser draws it
};

enum class AxisMode : uint8_t {
    Automatic, // round limits around everything recorded
    Fit,       // hugs what is in view
    Fixed      // minimum and maximum as set
};

struct PlotRange {
    double low = 0, high = 1;
    bool operator==(const PlotRange&) const = default;
};

struct PlotAxis {
    QString title;
    QString unit;
    AxisMode mode = AxisMode::Automatic;
    PlotRange fixed;
    bool isOnRight = false;
    std::optional<PlotRange> zoom; // while the user is zoomed in on y
};

/// An older recording drawn beneath a curve, moved in time so that the two can be compared.
struct PlotBeneath {
    std::shared_ptr<const SampleSource> source;
    int64_t shift = 0; // added to its times
};

struct PlotCurve {
    QString id;
    QString name;
    QString unit;
    QColor color;
    double width = 1.6;
    CurveStyle style = CurveStyle::Line;
    int chart = 0, axis = 0;
    double scale = 1, offset = 0; // shown = value * scale + offset
    bool isVisible = true;
    std::shared_ptr<const SampleSource> source;
    std::vector<PlotBeneath> beneath;
    std::map<int64_t, QString> valueNames;       // of an enumeration
    std::function<QString(int64_t)> integerText; // of dates and the like, where digits say nothing
    QString problem;                             // why there is nothing to draw

    [[nodiscard]] double shown(double value) const { return value * scale + offset; }
    /// Whole numbers keep all their digits when shown as they are or moved by powers of ten: how many stand behind the
    /// point.
    [[nodiscard]] std::optional<int> decimals() const;
};

struct PlotChart {
    QString title;
    double weight = 1; // share of the height
    std::vector<PlotAxis> axes = {PlotAxis{}};
};

enum class MarkerKind : uint8_t { Event, Start, Breakpoint, Force, OnlineChange, Fault, Reset, Branch, SkippedScans };

struct PlotMarker {
    int64_t time = 0;
    MarkerKind kind = MarkerKind::Event;
    QString text;
};

/// A remark of the user's at a time, and at a value where one was clicked.
struct PlotNote {
    int64_t time = 0;
    std::optional<double> value; // on the chart's first axis
    int chart = 0;
    QString text;
};

/// From one point of a chart to another: the distance in time and value is written beside it.
struct PlotRuler {
    int chart = 0, axis = 0;
    int64_t fromTime = 0, toTime = 0;
    double fromValue = 0, toValue = 0; // as the axis shows them
};

struct PlotModel {
    QString title;
    std::vector<PlotChart> charts = {PlotChart{}};
    std::vector<PlotCurve> curves;
    std::vector<PlotMarker> markers;
    std::vector<PlotNote> notes;
    std::optional<PlotRuler> ruler;
    int64_t from = 0, to = 1'000'000'000; // in view
    int64_t origin = 0;                   // the axis reads 0 here
    std::optional<int64_t> trigger;
    std::optional<int64_t> cursorA, cursorB;
    std::optional<int64_t> present; // the scan that the other windows show, while it is not the newest
    bool hasLegend = true, hasGrid = true, hasTable = false;
    QString beneathName; // of the recording drawn beneath the curves, with its shift in time; empty without one
    QString selected;    // id of the curve whose samples the cursors snap to
};

/// First and last time of everything visible; nothing while there are no samples.
[[nodiscard]] std::optional<std::pair<int64_t, int64_t>> wholeRange(const PlotModel& model);
/// The sample time nearest to `time` of the selected curve, else of any visible one.
[[nodiscard]] int64_t snappedTime(const PlotModel& model, int64_t time);
[[nodiscard]] const PlotCurve* findCurve(const PlotModel& model, const QString& id);
/// Value as the curve shows it: an enumeration's name, TRUE / FALSE, or a number with its unit.
[[nodiscard]] QString curveValueText(const PlotCurve& curve, double raw, int digits = 6, bool withUnit = true);
/// The same of the value in force at `time`: integers with all their digits, however large; a dash where there is none.
[[nodiscard]] QString curveTextAt(const PlotCurve& curve, int64_t time, int digits = 6, bool withUnit = true);
[[nodiscard]] QColor markerColor(MarkerKind kind);
/// "Δt 12.5 ms   Δy 3.5   280 /s   80 Hz".
[[nodiscard]] QString rulerText(const PlotRuler& ruler);

} // namespace plc::plot
