// Charts whose horizontal axis is not the time of the recording: one value over another, spectra, frequency responses,
// runs laid over each other. From values to ink, for screen, PNG, SVG and PDF alike. Functions and values; GUI thread.
#pragma once

#include "editor/plot/model/plot_model.h"
#include "editor/plot/plot_export.h"
#include "projects/waveform/chart.h"

#include <QFont>
#include <QRectF>

#include <array>

class QPainter;

namespace plc::plot {

/// One above the other; charts of one figure share what is zoomed in on x.
struct Figure {
    std::vector<waveform::Chart> charts;
    QString empty; // what to do, where there is nothing to draw
    [[nodiscard]] bool isEmpty() const;
};

struct FigureZoom {
    std::optional<PlotRange> x;
    std::vector<std::optional<PlotRange>> y; // by chart
};

/// Where the values of one chart are on the paper.
struct FigureFrame {
    QRectF area;
    QRectF place; // with title and axes; its height does not count
    PlotRange x, y;
    bool isLogarithmicX = false, isLogarithmicY = false;
    bool hasTitleX = true;
    [[nodiscard]] double xOf(double value) const;
    [[nodiscard]] double yOf(double value) const;
    [[nodiscard]] double xAt(double pixel) const;
    [[nodiscard]] double yAt(double pixel) const;
};

struct FigurePoint {
    size_t chart = 0;
    double x = 0, y = 0;
};
/// From one point to another: their distance in both directions is written beside them.
struct FigureRuler {
    FigurePoint from, to;
};

[[nodiscard]] std::vector<FigureFrame> framesOf(const Figure& figure, const QRectF& rect, const QFont& font,
                                                const FigureZoom& zoom);
void paintFigure(QPainter& painter, const Figure& figure, const QRectF& rect, const QFont& font,
                 const FigureZoom& zoom = {}, const std::optional<FigureRuler>& ruler = std::nullopt);
/// A curve's name above its chart.
struct FigureName {
    size_t curve = 0;
    QString text; // shortened where there is little room
};
/// As many as find room beside the title.
[[nodiscard]] std::vector<FigureName> legendOf(const waveform::Chart& chart, const FigureFrame& frame,
                                               const QFont& font);
/// The sample nearest to a place on the paper, of any curve within reach.
[[nodiscard]] std::optional<FigurePoint> nearestPoint(const Figure& figure, const std::vector<FigureFrame>& frames,
                                                      const QPointF& place, double reach);
/// "Δx 0.5   Δy 2.25   Δy/Δx 4.5".
[[nodiscard]] QString rulerText(const FigureRuler& ruler);

[[nodiscard]] QImage figurePicture(const Figure& figure, const PictureOptions& options = {},
                                   const FigureZoom& zoom = {});
/// The suffix decides: .png, .svg or .pdf.
Result<void> exportFigure(const Figure& figure, const QString& path, const PictureOptions& options = {},
                          const FigureZoom& zoom = {});
/// A line for each point: chart, curve, x, y.
Result<void> exportFigureCsv(const Figure& figure, const QString& path);

} // namespace plc::plot
