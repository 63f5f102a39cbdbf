#include "editor/trace/curves/trace_plot.h"

#include "editor/kit/contrast.h"
#include "editor/kit/curve_words.h"
#include "editor/kit/message_text.h"
#include "editor/kit/theme.h"
#include "editor/plot/model/plot_scale.h"
#include "editor/trace/curves/other_recordings.h"
#include "runtime/controller/controller.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <algorithm>
#include <cmath>

namespace plc::trace {

namespace {

/// A colour by its name, as it can be seen on the ground of plots; the curve called "red" is red.
QColor colorOf(const QString& name) {
    const struct {
        const char *name, *onLight, *onDark;
    } all[] = {{"red", "#D6281F", "#F2473C"},
               {"yellow", "#C89600", "#F7CB36"},
               {"green", "#2B9A57", "#3FBF74"},
               {"blue", "#2878C8", "#4A9DF0"},
               {"orange", "#E87417", "#F68B33"}};
    const bool isDark = kit::colors().plotGround.lightness() < 128;
    for (const auto& one : all)
        if (name == QLatin1String(one.name)) return QColor(QLatin1String(isDark ? one.onDark : one.onLight));
    return {};
}

constexpr double ReadableOnDark = 4.5; // the names at the ends of the curves have their colours

QColor withLightness(const QColor& color, double lightness) {
    return QColor::fromHslF(static_cast<float>(std::max(0.0, static_cast<double>(color.hslHueF()))),
                            color.hslSaturationF(), static_cast<float>(std::clamp(lightness, 0.0, 1.0)));
}

/// A colour chosen on a light ground must also be seen on a dark one, and the other way round.
QColor readable(const QColor& color) {
    const QColor& paper = kit::colors().plotGround;
    const double ground = paper.lightnessF();
    double own = color.lightnessF();
    QColor out = color;
    if (std::abs(ground - own) < 0.3) {
        own = ground < 0.5 ? ground + 0.45 : ground - 0.45;
        out = withLightness(color, own);
    }
    for (; ground < 0.5 && own < 1 && kit::contrast(out, paper) < ReadableOnDark; own += 0.02)
        out = withLightness(color, own);
    return kit::legible(out);
}

plot::AxisMode modeOf(ScaleMode mode) {
    switch (mode) {
    case ScaleMode::Automatic:
        return plot::AxisMode::Automatic;
    case ScaleMode::Fit:
        return plot::AxisMode::Fit;
    case ScaleMode::Fixed:
        return plot::AxisMode::Fixed;
    }
    return plot::AxisMode::Automatic;
}

/// What a mark of the history is on the chart; nothing for those that would only be in the way.
std::optional<plot::MarkerKind> markerOf(int kind) {
    using controller::EventKind;
    switch (static_cast<EventKind>(kind)) {
    case EventKind::Started:
    case EventKind::Stopped:
    case EventKind::Paused:
        return plot::MarkerKind::Start;
    case EventKind::Fault:
        return plot::MarkerKind::Fault;
    case EventKind::Reset:
        return plot::MarkerKind::Reset;
    case EventKind::Force:
    case EventKind::Release:
        return plot::MarkerKind::Force;
    case EventKind::OnlineChange:
        return plot::MarkerKind::OnlineChange;
    case EventKind::Breakpoint:
        return plot::MarkerKind::Breakpoint;
    case EventKind::SkippedScans:
        return plot::MarkerKind::SkippedScans;
    case EventKind::WentBack:
        return plot::MarkerKind::Branch;
    case EventKind::Write:
    case EventKind::RetainSaved:
    case EventKind::RetainRestored:
        return std::nullopt;
    }
    return plot::MarkerKind::Event;
}

struct MarkText {
    Q_DECLARE_TR_FUNCTIONS(MarkText)
};

} // namespace

QString markText(int kind, const Message& message) {
    using controller::EventKind;
    const QString text = kit::messageText(message);
    const auto with = [&](const QString& word) { return text.isEmpty() ? word : word + QStringLiteral(": ") + text; };
    switch (static_cast<EventKind>(kind)) {
    case EventKind::Started:
        return with(MarkText::tr("Started"));
    case EventKind::Stopped:
        return with(MarkText::tr("Stopped"));
    case EventKind::Paused:
        return with(MarkText::tr("Paused"));
    case EventKind::Fault:
        return with(MarkText::tr("Fault"));
    case EventKind::Reset:
        return with(MarkText::tr("Reset"));
    case EventKind::Write:
        return with(MarkText::tr("Written"));
    case EventKind::Force:
        return with(MarkText::tr("Forced"));
    case EventKind::Release:
        return text.isEmpty() ? MarkText::tr("All forces released") : with(MarkText::tr("Released"));
    case EventKind::OnlineChange:
        return with(MarkText::tr("Online change"));
    case EventKind::Breakpoint:
        return with(MarkText::tr("Breakpoint"));
    case EventKind::RetainSaved:
        return with(MarkText::tr("Retained values saved"));
    case EventKind::RetainRestored:
        return with(MarkText::tr("Retained values restored"));
    case EventKind::SkippedScans:
        return MarkText::tr("%n scan(s) skipped: the machine was late", nullptr, text.toInt());
    case EventKind::WentBack:
        return with(MarkText::tr("Resumed from this scan"));
    }
    return text;
}

QColor channelColor(const TraceSetup& setup, size_t channel) {
    const QColor own(QString::fromStdString(setup.channels[channel].color));
    if (own.isValid()) return own;
    const ChannelSetup& wanted = setup.channels[channel];
    for (const std::string& words : {wanted.label, wanted.expression})
        if (const QColor named = colorOf(kit::colorNamed(QString::fromStdString(words))); named.isValid()) return named;
    return kit::colors().curve(static_cast<int>(channel));
}

QColor drawnColor(const TraceSetup& setup, size_t channel) { return readable(channelColor(setup, channel)); }

plot::CurveStyle styleOf(const ChannelSetup& channel, const ChannelType* type) {
    switch (channel.style) {
    case ChannelStyle::Line:
        return plot::CurveStyle::Line;
    case ChannelStyle::Hold:
        return plot::CurveStyle::Hold;
    case ChannelStyle::Digital:
        return plot::CurveStyle::Digital;
    case ChannelStyle::Automatic:
        return type && (type->isBool || !type->valueNames.empty()) ? plot::CurveStyle::Digital : plot::CurveStyle::Hold;
    }
    return plot::CurveStyle::Hold;
}

std::vector<std::string> expressionsOf(const TraceSetup& setup, const std::string& recording) {
    std::vector<std::string> out;
    for (const ChannelSetup& channel : setup.channels)
        if (channel.recording == recording) out.push_back(channel.expression);
    return out;
}

void applySetup(plot::PlotModel& model, const TraceSetup& setup, const TraceFeed* shown,
                const OtherRecordings* others) {
    model.title = QString::fromStdString(setup.title);
    std::vector<plot::PlotChart> before = std::move(model.charts);
    model.charts.clear();
    for (size_t c = 0; c < setup.charts.size(); ++c) {
        plot::PlotChart chart;
        chart.title = QString::fromStdString(setup.charts[c].title);
        chart.weight = setup.charts[c].weight;
        chart.axes.clear();
        for (size_t a = 0; a < setup.charts[c].axes.size(); ++a) {
            const AxisSetup& axis = setup.charts[c].axes[a];
            plot::PlotAxis shown;
            shown.title = QString::fromStdString(axis.title);
            shown.unit = QString::fromStdString(axis.unit);
            shown.mode = modeOf(axis.mode);
            shown.fixed = {axis.minimum, axis.maximum};
            shown.isOnRight = axis.isOnRight;
            if (c < before.size() && a < before[c].axes.size()) shown.zoom = before[c].axes[a].zoom;
            chart.axes.push_back(std::move(shown));
        }
        model.charts.push_back(std::move(chart));
    }
    model.curves.clear();
    for (size_t i = 0; i < setup.channels.size(); ++i) {
        const ChannelSetup& channel = setup.channels[i];
        const bool isOther = !channel.recording.empty();
        const TraceFeed* feed = !isOther ? shown : others ? others->feedOf(channel.recording) : nullptr;
        const ChannelType* type = feed ? feed->type(channel.expression) : nullptr;
        plot::PlotCurve curve;
        curve.id = QString::number(i);
        curve.name = QString::fromStdString(channel.label.empty() ? channel.expression : channel.label);
        curve.unit = QString::fromStdString(channel.unit);
        curve.color = drawnColor(setup, i);
        curve.width = channel.width;
        curve.style = styleOf(channel, type);
        curve.chart = channel.chart;
        curve.axis = channel.axis;
        curve.scale = channel.scale;
        curve.offset = channel.offset;
        curve.isVisible = channel.isVisible;
        if (feed) curve.source = feed->source(channel.expression);
        if (feed) curve.problem = kit::messageText(feed->problem(channel.expression));
        if (isOther && others && !feed) curve.problem = kit::messageText(others->problemOf(channel.recording));
        if (type) {
            for (const auto& [value, name] : type->valueNames)
                curve.valueNames.emplace(value, QString::fromStdString(name));
            if (type->toText)
                curve.integerText = [toText = type->toText](int64_t value) {
                    return QString::fromStdString(toText(value));
                };
            if (type->isTime) { // kept as nanoseconds, read as milliseconds
                curve.scale *= 1e-6;
                if (curve.unit.isEmpty()) curve.unit = QStringLiteral("ms");
            }
        }
        model.curves.push_back(std::move(curve));
    }
    model.notes.clear();
    for (const NoteSetup& note : setup.notes)
        model.notes.push_back({note.time, note.value, note.chart, QString::fromStdString(note.text)});
}

void applyMarks(plot::PlotModel& model, const Recording& recording, const std::vector<PositionRange>& chain) {
    model.markers.clear();
    for (const history::Mark& mark : recording.marks()) {
        const auto kind = markerOf(mark.kind);
        if (!kind || (*kind == plot::MarkerKind::Start && mark.time.count() == 0))
            continue; // that it began at 0 goes without saying
        const bool onChain = std::any_of(chain.begin(), chain.end(), [&](const PositionRange& r) {
            return mark.position >= r.begin && mark.position < r.end;
        });
        if (onChain || chain.empty())
            model.markers.push_back({mark.time.count(), *kind, markText(mark.kind, mark.text)});
    }
    std::stable_sort(model.markers.begin(), model.markers.end(),
                     [](const plot::PlotMarker& a, const plot::PlotMarker& b) { return a.time < b.time; });
}

void applyBeneath(plot::PlotModel& model, const TraceSetup& setup, const TraceFeed& older) {
    for (size_t i = 0; i < model.curves.size() && i < setup.channels.size(); ++i) {
        const auto source = older.source(setup.channels[i].expression);
        model.curves[i].beneath.clear();
        if (source && setup.channels[i].recording.empty())
            model.curves[i].beneath.push_back({source, setup.compareShift});
    }
    const QString name = QFileInfo(QString::fromStdString(setup.compareWith)).completeBaseName();
    const QString shift = plot::durationText(std::abs(setup.compareShift));
    if (setup.compareShift == 0)
        model.beneathName = name;
    else if (setup.compareShift > 0)
        model.beneathName = QCoreApplication::translate("plc::trace::TraceView", "%1, %2 later").arg(name, shift);
    else
        model.beneathName = QCoreApplication::translate("plc::trace::TraceView", "%1, %2 earlier").arg(name, shift);
}

} // namespace plc::trace
