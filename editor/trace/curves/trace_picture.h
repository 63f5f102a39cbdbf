// A trace without a window: a set-up and a recording give a picture, a CSV file and statistics. What `stepwise trace`
// does and what the pictures of the documentation are made with. Needs a QApplication (offscreen will do); its thread.
#pragma once

#include "editor/trace/curves/other_recordings.h"
#include "editor/trace/curves/trace_feed.h"
#include "editor/trace/setup/trace_setup.h"

#include <QSize>
#include <QString>

namespace plc::trace {

struct TraceOutput {
    TraceSetup setup;
    QString picture, csv; // paths; empty: none
    QSize size{1200, 700};
    double scale = 1;
    bool isDark = false;
    bool wantsStatistics = false;
    std::optional<int64_t> from, to; // shown; absent: all, or around the trigger when it fired
    const Recording* beneath = nullptr;
    bool onlyFigure = false;         // without the charts over time
    OtherRecordings::Open openOther; // of the files that channels name
};

/// Writes the files; the text is the statistics table, or what the trigger did. An expression that cannot be compiled
/// is the error.
[[nodiscard]] Result<std::string> renderTrace(const Recording& recording, const TraceOutput& output);

} // namespace plc::trace
