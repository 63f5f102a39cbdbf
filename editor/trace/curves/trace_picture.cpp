#include "editor/trace/curves/trace_picture.h"

#include "editor/kit/theme.h"
#include "editor/plot/model/plot_scale.h"
#include "editor/plot/painting/plot_renderer.h"
#include "editor/plot/painting/plot_table.h"
#include "editor/plot/plot_export.h"
#include "editor/trace/curves/trace_figure.h"
#include "editor/trace/curves/trace_plot.h"
#include "editor/trace/setup/program_variables.h"
#include "editor/trace/setup/trigger.h"

#include <QApplication>
#include <QPainter>

#include <cmath>

namespace plc::trace {

namespace {

struct TraceText {
    Q_DECLARE_TR_FUNCTIONS(TraceText)
};

/// First complete shot over the whole recording; one that lacks its end when none is complete.
std::optional<int64_t> shotOf(const TraceSetup& setup, const TraceFeed& feed) {
    const auto source = feed.triggerSource();
    if (!source || setup.trigger.mode == TriggerMode::Off) return std::nullopt;
    TriggerMachine machine;
    machine.setSetup(setup.trigger);
    source->visit(INT64_MIN, INT64_MAX, [&](std::span<const SignalSample> block) {
        for (const SignalSample& s : block)
            machine.feed(s.time, std::isnan(s.value) ? std::nullopt : std::optional(s.value != 0));
    });
    return machine.completeAt() ? machine.completeAt() : machine.firedAt();
}

std::string tableText(const plot::MeasureTable& table) {
    std::vector<qsizetype> widths;
    for (qsizetype c = 0; c < table.headers.size(); ++c) {
        qsizetype wide = table.headers[c].size();
        for (const auto& row : table.rows) wide = std::max(wide, row.cells[c].size());
        widths.push_back(wide);
    }
    QString out = table.headline + QLatin1Char('\n');
    auto line = [&](const QStringList& cells) {
        for (qsizetype c = 0; c < cells.size(); ++c)
            out += c == 0 ? cells[c].leftJustified(widths[static_cast<size_t>(c)])
                          : QStringLiteral("  ") + cells[c].rightJustified(widths[static_cast<size_t>(c)]);
        out += QLatin1Char('\n');
    };
    line(table.headers);
    for (const auto& row : table.rows) line(row.cells);
    return out.toStdString();
}

/// The charts over time with the figure below them; or the figure alone.
Result<void> exportBoth(const plot::PlotModel& model, const plot::Figure& figure, const TraceOutput& output) {
    const plot::PictureOptions options{output.size, output.scale};
    if (output.onlyFigure) return plot::exportFigure(figure, output.picture, options);
    return plot::exportPainted(model.title, output.picture, options, [&](QPainter& painter, const QRectF& rect) {
        QRectF above = rect, below = rect;
        above.setBottom(std::round(rect.center().y()));
        below.setTop(above.bottom());
        plot::PlotRenderer renderer;
        renderer.setFont(QApplication::font());
        renderer.setPixelRatio(output.scale);
        renderer.paint(painter, model, above);
        plot::paintFigure(painter, figure, below, QApplication::font());
    });
}

} // namespace

Result<std::string> renderTrace(const Recording& recording, const TraceOutput& output) {
    TraceFeed feed(recording, std::make_shared<history::ColumnStore>(size_t(2) << 30));
    TraceSetup setup = output.setup;
    ProgramVariables variables;
    variables.setProgram(recording.program());
    for (ChannelSetup& channel : setup.channels)
        if (channel.unit.empty())
            channel.unit = variables.unitOf(QString::fromStdString(channel.expression)).toStdString();
    feed.setSettings({setup.every, setup.condition});
    std::vector<std::string> needed = expressionsOf(setup);
    feed.setExpressions(needed, setup.trigger.expression);
    if (!setup.trigger.expression.empty()) needed.push_back(setup.trigger.expression);
    for (const std::string& expression : needed)
        if (const Message problem = feed.problem(expression); !problem.isEmpty()) return Error{problem, expression};
    if (!setup.condition.empty())
        if (const auto type = recording.typeOf(setup.condition); !type)
            return Error{type.error().message, setup.condition};
    feed.pumpAll();
    OtherRecordings others(std::make_shared<history::ColumnStore>(size_t(2) << 30));
    if (output.openOther) others.follow(setup, output.openOther);
    for (const ChannelSetup& channel : setup.channels) {
        if (channel.recording.empty()) continue;
        if (const Message problem = others.problemOf(channel.recording); !problem.isEmpty())
            return Error{problem, channel.recording};
        const TraceFeed* other = others.feedOf(channel.recording);
        if (const Message problem = other ? other->problem(channel.expression) : Message(); !problem.isEmpty())
            return Error{problem, channel.expression};
    }
    others.pumpAll();

    kit::Theme& theme = kit::Theme::current();
    const kit::ThemeChoice before = theme.choice();
    theme.setChoice(output.isDark ? kit::ThemeChoice::Dark : kit::ThemeChoice::Light);
    plot::PlotModel model;
    applySetup(model, setup, &feed, &others);
    applyMarks(model, recording, feed.chain());
    std::unique_ptr<TraceFeed> older;
    if (output.beneath) {
        older = std::make_unique<TraceFeed>(*output.beneath, std::make_shared<history::ColumnStore>(size_t(2) << 30));
        older->setExpressions(expressionsOf(setup));
        older->pumpAll();
        applyBeneath(model, setup, *older);
    }
    std::string text;
    auto whole = plot::wholeRange(model);
    if (whole) // the last scan's values hold for the length of a scan
        for (const plot::PlotCurve& curve : model.curves)
            if (const auto last = curve.source ? curve.source->timeRange() : std::nullopt;
                last && last->second == whole->second)
                if (const auto before = curve.source->inForceAt(last->second - 1)) {
                    whole->second += last->second - before->time;
                    break;
                }
    model.from = output.from.value_or(whole ? whole->first : 0);
    model.to = std::max(output.to.value_or(whole ? whole->second : 1), model.from + 1);
    if (const auto shot = shotOf(setup, feed)) {
        model.trigger = shot;
        model.origin = *shot;
        if (!output.from) model.from = *shot - setup.trigger.before;
        if (!output.to) model.to = std::max(*shot + setup.trigger.after, model.from + 1);
        text += TraceText::tr("Triggered at %1.").arg(plot::momentText(*shot)).toStdString() + "\n";
    } else if (setup.trigger.mode != TriggerMode::Off && !setup.trigger.expression.empty()) {
        text += TraceText::tr("The trigger did not fire.").toStdString() + "\n";
    }
    model.cursorA = setup.cursorA;
    model.cursorB = setup.cursorB;
    model.hasTable = setup.hasTable;
    if (output.wantsStatistics) { // without cursors: over all that is shown
        plot::PlotModel measured = model;
        measured.cursorA = plot::snappedTime(model, model.cursorA.value_or(model.from));
        measured.cursorB = plot::snappedTime(model, model.cursorB.value_or(model.to));
        text += tableText(plot::measureTable(measured));
    }
    const FigureAnswer answer = figureOf(figureJob(setup, model, &feed));
    if (!answer.text.isEmpty()) text += answer.text.toStdString() + "\n";
    Result<void> done;
    const bool hasFigure = setup.figure.kind != FigureKind::None;
    if (!output.picture.isEmpty())
        done = hasFigure ? exportBoth(model, answer.figure, output)
                         : plot::exportPicture(model, output.picture, {output.size, output.scale});
    if (done && !output.csv.isEmpty())
        done = output.onlyFigure ? plot::exportFigureCsv(answer.figure, output.csv)
                                 : plot::exportCsv(model, model.from, model.to, output.csv);
    theme.setChoice(before);
    if (!done) return done.error();
    return text;
}

} // namespace plc::trace
