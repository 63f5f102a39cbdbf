// A plot as a file: picture (PNG, SVG, PDF) or table (CSV). Needs no window: the command line uses it too. GUI thread.
#pragma once

#include "editor/plot/model/plot_model.h"
#include "runtime/base/result.h"

#include <QImage>
#include <QSize>
#include <QString>

#include <functional>

class QIODevice;
class QPainter;

namespace plc::plot {

struct PictureOptions {
    QSize size{1200, 700}; // in units of 1/96 inch
    double scale = 1;      // PNG: pixels per unit
};

/// What draws onto the rectangle of a picture.
using Painting = std::function<void(QPainter& painter, const QRectF& rect)>;
[[nodiscard]] QImage paintedImage(const PictureOptions& options, const Painting& paint);
/// The suffix decides: .png, .svg or .pdf.
Result<void> exportPainted(const QString& title, const QString& path, const PictureOptions& options,
                           const Painting& paint);
[[nodiscard]] Error cannotWrite(const QString& path, const QString& why);
/// A cell of a CSV file.
[[nodiscard]] QByteArray csvQuoted(QString text);

[[nodiscard]] QImage plotPicture(const PlotModel& model, const PictureOptions& options = {});
/// The suffix decides: .png, .svg or .pdf.
Result<void> exportPicture(const PlotModel& model, const QString& path, const PictureOptions& options = {});
void copyPicture(const PlotModel& model, const PictureOptions& options = {});
void printPlot(const PlotModel& model, QPainter& painter, const QRectF& page);

/// Every sample of the visible curves in [from, to]: a line per time, empty where a channel has no value yet; numbers
/// read back the same. Times in seconds. `progress` hears the share that is done and ends it by false: then the file
/// stays as it was.
using ExportProgress = std::function<bool(double share)>;
Result<void> exportCsv(const PlotModel& model, int64_t from, int64_t to, const QString& path,
                       const ExportProgress& progress = {});
/// False when `progress` ended it.
bool writeCsv(const PlotModel& model, int64_t from, int64_t to, QIODevice& out, const ExportProgress& progress = {});

} // namespace plc::plot
