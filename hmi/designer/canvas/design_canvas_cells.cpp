// Rows and grids on the canvas of the panel designer: what is dropped or dragged into one takes a cell.
#include "hmi/designer/canvas/design_canvas.h"

#include "hmi/designer/context/arrange.h"
#include "hmi/model/cells.h"
#include "hmi/model/property_literals.h"

namespace plc::hmi {

bool DesignCanvas::liesInCells(const ElementIds& ids) const {
    for (const ElementId& id : ids) {
        const Element* element = m_document.panel().find(id);
        const Element* outer = element ? m_document.panel().find(element->parent()) : nullptr;
        if (outer && hasCells(*outer)) return true;
    }
    return false;
}

/// Into the cell at the point; out of the cells where there is none. Nothing for elements that stay free.
Edit DesignCanvas::cellEdit(const ElementIds& ids, QPointF at) const {
    const hmi::Panel& panel = m_document.panel();
    if (const ElementId group = groupWithCellsAt(panel, at, ids); !group.isEmpty())
        return putIntoCells(panel, ids, group, cellAt(panel, group, at, ids));
    EditList list;
    if (!liesInCells(ids)) return {list};
    for (const ElementId& id : ids) {
        const Element* outer = panel.find(panel.find(id)->parent());
        if (!outer || !hasCells(*outer)) continue;
        list.edits.push_back(hmi::setProperty(panel, id, "parent"_field, toUtf8(outer->parent())));
        list.edits.push_back(hmi::setProperty(panel, id, "page"_field, outer->integer("page"_number)));
    }
    list.edits.push_back(moveBy(panel, ids, at - m_drag.from));
    return {list};
}

void DesignCanvas::showCell(const ElementIds& ids, QPointF at) {
    hmi::Panel scratch = m_document.panel();
    applyTo(scratch, cellEdit(ids, at));
    applyTo(scratch, arrangement(scratch));
    m_dropRect = boundsOf(scratch, ids);
    viewport()->update();
}

void DesignCanvas::endMove(QPointF at) {
    const ElementIds ids = movable();
    m_dropRect.reset();
    if (ids.empty()) return;
    m_document.perform(tr("Place in cell"), cellEdit(ids, at), m_drag.gesture);
}

Edit DesignCanvas::withCells(const Edit& inserted, const ElementIds& added, QPointF at) const {
    const ElementId group = groupWithCellsAt(m_document.panel(), at, {});
    if (group.isEmpty()) return inserted;
    hmi::Panel scratch = m_document.panel();
    const int cell = cellAt(scratch, group, at, {});
    applyTo(scratch, inserted);
    return {EditList{{inserted, putIntoCells(scratch, added, group, cell)}}};
}

} // namespace plc::hmi
