// Groups that lay out what lies in them: rows, columns and grids. The order of the elements is the order of the cells;
// their places follow from the group's rectangle. Pure functions, any thread.
#pragma once
#include "hmi/model/edit.h"

namespace plc::hmi {

/// Whether the group gives what lies in it a place.
bool hasCells(const Element& element);
/// The cells of a group that has this rectangle, in the order of `contents`.
std::vector<QRectF> cellsOf(const Element& group, const QRectF& rect, const std::vector<const Element*>& contents);
/// Moves everything that lies in cells to its cell; empty where it is there already.
Edit arrangement(const Panel& panel);
/// The innermost group with cells at a point, which is none of `without` nor in one of them; empty: none.
ElementId groupWithCellsAt(const Panel& panel, QPointF at, const std::vector<ElementId>& without);
/// The cell that a thing dropped there takes, of a group in which `without` are not counted.
int cellAt(const Panel& panel, const ElementId& group, QPointF at, const std::vector<ElementId>& without);
/// Puts elements into a group, from this cell on.
Edit putIntoCells(const Panel& panel, const std::vector<ElementId>& elements, const ElementId& group, int cell);

} // namespace plc::hmi
