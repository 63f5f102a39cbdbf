// The measuring table of two cursors: per channel the values at both, their difference, and statistics between them.
// As texts for a widget, and painted beneath a picture. GUI thread.
#pragma once

#include "editor/plot/model/measure.h"
#include "editor/plot/model/plot_model.h"

#include <QFont>
#include <QRectF>
#include <QStringList>

class QPainter;

namespace plc::plot {

struct MeasureTable {
    QString headline; // A, B, Δt, 1/Δt
    QStringList headers;
    struct Row {
        int curve = 0;
        QColor color;
        QStringList cells; // one per header
    };
    std::vector<Row> rows;
};

/// `everyColumn`: also those that have no value for any channel.
[[nodiscard]] MeasureTable measureTable(const PlotModel& model, bool everyColumn = false);
[[nodiscard]] double measureTableHeight(const PlotModel& model, const QFont& font);
void paintMeasureTable(QPainter& painter, const QRectF& rect, const PlotModel& model, const QFont& font);

} // namespace plc::plot
