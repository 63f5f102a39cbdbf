#include "editor/plot/plot_export.h"

#include "editor/kit/curve_words.h"
#include "editor/kit/errors.h"
#include "editor/kit/theme.h"
#include "editor/plot/painting/plot_renderer.h"
#include "editor/plot/painting/plot_text.h"

#include <QApplication>
#include <QClipboard>
#include <QFileInfo>
#include <QPdfWriter>
#include <QSaveFile>
#include <QSvgGenerator>

#include <cmath>

namespace plc::plot {

Error cannotWrite(const QString& path, const QString& why) {
    return {errors::NotWritten(why.toStdString()), path.toStdString()};
}

QByteArray csvQuoted(QString text) {
    if (!text.contains(QLatin1Char(',')) && !text.contains(QLatin1Char('"')) && !text.contains(QLatin1Char('\n')))
        return text.toUtf8();
    text.replace(QLatin1Char('"'), QStringLiteral("\"\""));
    return '"' + text.toUtf8() + '"';
}

namespace {

/// Nanoseconds as seconds, exact, without trailing zeros.
QByteArray secondsText(int64_t time) {
    const bool negative = time < 0;
    const uint64_t size = negative ? 0 - static_cast<uint64_t>(time) : static_cast<uint64_t>(time);
    QByteArray text = QByteArray::number(static_cast<qulonglong>(size / 1'000'000'000));
    if (const uint64_t rest = size % 1'000'000'000) {
        QByteArray fraction = QByteArray::number(static_cast<qulonglong>(rest)).rightJustified(9, '0');
        while (fraction.endsWith('0')) fraction.chop(1);
        text += '.' + fraction;
    }
    return negative ? '-' + text : text;
}

QByteArray csvValue(const PlotCurve& curve, int64_t time, double raw) {
    if (std::isnan(raw)) return {};
    if (const auto decimals = curve.decimals(); decimals && curve.valueNames.empty())
        if (const auto integer = curve.source->integerAt(time))
            return QByteArray::fromStdString(exactText(*integer, *decimals));
    if (const auto name = curve.valueNames.find(static_cast<int64_t>(raw)); name != curve.valueNames.end())
        return csvQuoted(name->second);
    const PlotValueKind kind = curve.source->valueKind();
    if (curve.scale == 1 && curve.offset == 0) return QByteArray::fromStdString(exactText(raw, kind));
    return QByteArray::fromStdString(exactText(curve.shown(raw), PlotValueKind::Double));
}

} // namespace

QImage paintedImage(const PictureOptions& options, const Painting& paint) {
    QImage image(options.size * options.scale, QImage::Format_ARGB32_Premultiplied);
    image.setDevicePixelRatio(options.scale);
    image.fill(kit::colors().plotGround);
    QPainter painter(&image);
    paint(painter, QRectF(QPointF(), QSizeF(options.size)));
    return image;
}

Result<void> exportPainted(const QString& title, const QString& path, const PictureOptions& options,
                           const Painting& paint) {
    const QString suffix = QFileInfo(path).suffix().toLower();
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly)) return cannotWrite(path, file.errorString());
    const QRectF rect(QPointF(), QSizeF(options.size));
    if (suffix == QLatin1String("png")) {
        if (!paintedImage(options, paint).save(&file, "PNG")) return cannotWrite(path, file.errorString());
    } else if (suffix == QLatin1String("svg")) {
        QSvgGenerator generator;
        generator.setOutputDevice(&file);
        generator.setSize(options.size);
        generator.setViewBox(rect);
        generator.setResolution(96);
        generator.setTitle(title);
        QPainter painter(&generator);
        paint(painter, rect);
    } else if (suffix == QLatin1String("pdf")) {
        QPdfWriter writer(&file);
        writer.setResolution(96);
        writer.setPageSize(
            QPageSize(QSizeF(options.size) * 72.0 / 96.0, QPageSize::Point, QString(), QPageSize::ExactMatch));
        writer.setPageMargins(QMarginsF());
        writer.setTitle(title);
        QPainter painter(&writer);
        paint(painter, rect);
    } else {
        return Error{errors::PictureEnding({{".png", ".svg", ".pdf"}}), path.toStdString()};
    }
    if (!file.commit()) return cannotWrite(path, file.errorString());
    return {};
}

QImage plotPicture(const PlotModel& model, const PictureOptions& options) {
    return paintedImage(options, [&](QPainter& painter, const QRectF& rect) {
        PlotRenderer renderer;
        renderer.setFont(QApplication::font());
        renderer.setPixelRatio(options.scale);
        renderer.setFineSamples(100'000);
        renderer.paint(painter, model, rect);
    });
}

Result<void> exportPicture(const PlotModel& model, const QString& path, const PictureOptions& options) {
    const bool isImage = path.endsWith(QLatin1String(".png"), Qt::CaseInsensitive);
    return exportPainted(model.title, path, options, [&](QPainter& painter, const QRectF& rect) {
        PlotRenderer renderer;
        renderer.setFont(QApplication::font());
        if (isImage) renderer.setPixelRatio(options.scale);
        if (isImage) renderer.setFineSamples(100'000);
        renderer.paint(painter, model, rect);
    });
}

void copyPicture(const PlotModel& model, const PictureOptions& options) {
    QApplication::clipboard()->setImage(plotPicture(model, options));
}

void printPlot(const PlotModel& model, QPainter& painter, const QRectF& page) {
    PlotRenderer renderer;
    renderer.setFont(QApplication::font());
    renderer.paint(painter, model, page);
}

bool writeCsv(const PlotModel& model, int64_t from, int64_t to, QIODevice& out, const ExportProgress& progress) {
    std::vector<const PlotCurve*> curves;
    QByteArray line = "time [s]";
    for (const PlotCurve& curve : model.curves) {
        if (!curve.isVisible || !curve.source) continue;
        curves.push_back(&curve);
        line += ',' + csvQuoted(kit::withUnit(curve.name, curve.unit));
    }
    out.write(line + '\n');
    if (curves.empty() || to < from) return true;
    uint64_t most = 1;
    for (const PlotCurve* curve : curves) most = std::max(most, curve->source->countIn(from, to + 1));
    // In windows of time, so that a long recording is never in memory twice.
    const uint64_t windows = most / 20'000 + 1;
    const double width = (static_cast<double>(to) - static_cast<double>(from) + 1) / static_cast<double>(windows);
    std::vector<std::optional<double>> held(curves.size());
    for (uint64_t w = 0; w < windows; ++w) {
        if (progress && !progress(static_cast<double>(w) / static_cast<double>(windows))) return false;
        const int64_t begin = w == 0 ? from : from + static_cast<int64_t>(width * static_cast<double>(w));
        const int64_t end = w + 1 == windows ? to + 1 : from + static_cast<int64_t>(width * static_cast<double>(w + 1));
        std::vector<std::vector<SignalSample>> samples(curves.size());
        for (size_t i = 0; i < curves.size(); ++i)
            curves[i]->source->visit(begin, end, [&](std::span<const SignalSample> block) {
                samples[i].insert(samples[i].end(), block.begin(), block.end());
            });
        std::vector<size_t> at(curves.size(), 0);
        for (;;) {
            std::optional<int64_t> time;
            for (size_t i = 0; i < curves.size(); ++i)
                if (at[i] < samples[i].size() && (!time || samples[i][at[i]].time < *time))
                    time = samples[i][at[i]].time;
            if (!time) break;
            line = secondsText(*time - model.origin);
            for (size_t i = 0; i < curves.size(); ++i) {
                if (at[i] < samples[i].size() && samples[i][at[i]].time == *time) held[i] = samples[i][at[i]++].value;
                line += ',';
                if (held[i]) line += csvValue(*curves[i], *time, *held[i]);
            }
            out.write(line + '\n');
        }
    }
    return true;
}

Result<void> exportCsv(const PlotModel& model, int64_t from, int64_t to, const QString& path,
                       const ExportProgress& progress) {
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly)) return cannotWrite(path, file.errorString());
    if (!writeCsv(model, from, to, file, progress)) return {}; // nothing is committed
    if (!file.commit()) return cannotWrite(path, file.errorString());
    return {};
}

} // namespace plc::plot
