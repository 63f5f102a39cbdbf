// Where a moved or resized rectangle snaps: grid, edges and centres of others and of the panel, equal gaps; with the
// guides to draw. Pure functions.
#pragma once
#include <QLineF>
#include <QRectF>
#include <optional>
#include <vector>

namespace plc::hmi {

struct SnapField {
    std::vector<QRectF> others;
    QRectF panel;
    double grid = 8;  // 0: no grid
    double reach = 6; // in panel units: how near is near
};

struct Guide {
    QLineF line;
    bool isGap = false; // one of several equal gaps
};

struct Snapped {
    QPointF offset; // to be added to the rectangle
    std::vector<Guide> guides;
};

/// Edges, centres and gaps first; where nothing is near, the grid.
Snapped snapMove(const QRectF& rect, const SnapField& field);
/// Snaps only the edges that are dragged.
struct DraggedEdges {
    bool left = false, right = false, top = false, bottom = false;
};
Snapped snapResize(const QRectF& rect, DraggedEdges edges, const SnapField& field);

} // namespace plc::hmi
