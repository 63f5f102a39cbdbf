// The elements of the panel as a tree, topmost first: what lies in groups and tabs below them, with lock marks;
// selection both ways, and dragging changes order and group. Owned by its Qt parent; main thread.
#pragma once
#include "hmi/designer/context/design_context.h"
#include "hmi/designer/context/selection.h"
#include "hmi/model/document.h"

#include <QTreeWidget>

namespace plc::hmi {

class Outline final : public QTreeWidget {
    Q_OBJECT
public:
    Outline(PanelDocument& document, Selection& selection, DesignContext& context, QWidget* parent = nullptr);
    void rebuild();
    QTreeWidgetItem* itemOf(const ElementId& id) const;

protected:
    void dropEvent(QDropEvent* event) override;
    void paintEvent(QPaintEvent* event) override; // says how to begin while there is nothing

private:
    void showSelection();
    PanelDocument& m_document;
    Selection& m_selection;
    DesignContext& m_context;
    bool m_updating = false;
};

} // namespace plc::hmi
