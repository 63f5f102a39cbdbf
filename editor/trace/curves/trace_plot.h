// From a set-up and what was recorded to what is drawn: colours, styles, names, units, markers. Used by the trace view
// and by the command line alike. Functions; GUI thread.
#pragma once

#include "editor/plot/model/plot_model.h"
#include "editor/trace/curves/trace_feed.h"
#include "editor/trace/setup/trace_setup.h"

namespace plc::trace {

class OtherRecordings;

/// Fills charts and curves of the model, without samples where there is no feed; the part in view, cursors and y zooms
/// stay as they are.
void applySetup(plot::PlotModel& model, const TraceSetup& setup, const TraceFeed* feed,
                const OtherRecordings* others = nullptr);
/// What happened, in words: an event's kind and its text. Also the log says it so.
[[nodiscard]] QString markText(int kind, const Message& text);
/// Events of the recording that lie on the way to the newest scan.
void applyMarks(plot::PlotModel& model, const Recording& recording, const std::vector<PositionRange>& chain);
/// Draws another recording's channels beneath those of the same expression, both beginning at the same place on the
/// axis.
void applyBeneath(plot::PlotModel& model, const TraceSetup& setup, const TraceFeed& older);

/// What feeds must read for a set-up: its channels, and its trigger.
/// `recording`: of the channels that are read from that file, else of those without one.
[[nodiscard]] std::vector<std::string> expressionsOf(const TraceSetup& setup, const std::string& recording = {});
[[nodiscard]] QColor channelColor(const TraceSetup& setup, size_t channel);
/// The colour in which its curve is drawn: that one, or a lighter or darker one that can be read on the present ground.
[[nodiscard]] QColor drawnColor(const TraceSetup& setup, size_t channel);
[[nodiscard]] plot::CurveStyle styleOf(const ChannelSetup& channel, const ChannelType* type);

} // namespace plc::trace
