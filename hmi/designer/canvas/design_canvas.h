// Where a panel is drawn: the scene with its sample values under handles, guides and rulers; moves, resizes, inserts by
// dropping, selects. It asks the document for edits and keeps no truth of its own. Owned by its Qt parent; main thread.
#pragma once
#include "hmi/alarms/alarm_book.h"
#include "hmi/designer/canvas/snapping.h"
#include "hmi/designer/context/design_context.h"
#include "hmi/designer/context/selection.h"
#include "hmi/view/element_factory.h"
#include "hmi/view/scene/panel_scene.h"

#include <QAbstractScrollArea>

class QMimeData;

namespace plc::hmi {

class DesignCanvas final : public QAbstractScrollArea {
    Q_OBJECT
public:
    DesignCanvas(PanelDocument& document, Selection& selection, DesignContext& context, QWidget* parent = nullptr);

    PanelScene& scene() { return m_scene; }
    void setZoom(double zoom, std::optional<QPointF> about = std::nullopt);
    double zoom() const { return m_zoom; }
    void zoomToFit();
    void setSnapping(bool on) { m_snaps = on; }
    bool isSnapping() const { return m_snaps; }
    void setGridShown(bool on);
    bool isGridShown() const { return m_gridShown; }
    /// Elements that have findings: a mark shows it.
    /// Which panel this is: it cannot be placed in itself.
    void setPanelName(const QString& name) { m_panelName = name; }
    void setFindings(const std::vector<Finding>& findings);

    QPointF toPanel(QPointF viewportPoint) const;
    QPointF toViewport(QPointF panelPoint) const;
    QRectF toViewport(const QRectF& rect) const { return {toViewport(rect.topLeft()), rect.size() * m_zoom}; }
    /// Inserts new elements with their middle at a point (snapped), into the tab that lies there; selects them.
    void insertElements(const Json& elements, QPointF at);
    void insertVariables(const QStringList& paths, QPointF at, bool operates);
    /// Moved so that all of it, or its upper left corner, lies on the panel.
    QRectF onPanel(QRectF rect) const;
    QPointF visibleCenter() const;
    /// The outermost element of the group that is entered; empty: none.
    ElementId enteredGroup() const { return m_entered; }
    const std::vector<Guide>& guides() const { return m_guides; }
    /// The place of a handle of the selection, in the viewport: 0 upper left, clockwise to 7 left.
    QPointF handle(int index) const;

signals:
    void refused(const QString& reason);
    void zoomChanged(double zoom);
    void pointerMoved(QPointF at);
    void contextMenuRequested(QPoint globalPoint);
    void editRequested(const plc::hmi::ElementId& element); // a double click

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dragMoveEvent(QDragMoveEvent* event) override;
    void dragLeaveEvent(QDragLeaveEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void scrollContentsBy(int dx, int dy) override;

private:
    static constexpr int kRuler = 22;      // wide, above and left
    static constexpr double kHandle = 4.5; // half the side of a handle

    QStringList droppedVariables(const QMimeData* mime) const;
    /// The element under the place and the property of it that takes the variable; none: a new element is made.
    std::pair<ElementId, std::string> bindingUnder(QPointF at, const QStringList& variables) const;
    /// The trend chart under the place, if all variables can be curves of it.
    ElementId trendUnder(QPointF at, const QStringList& variables) const;
    void addCurves(const ElementId& trend, const QStringList& variables);
    enum class Mode { Idle, Press, Move, Resize, Band, Point, Pan };
    struct Drag {
        Mode mode = Mode::Idle;
        QPointF from; // panel coordinates
        QPoint fromViewport;
        QRectF bounds;   // of what is moved or resized, at the start
        int handle = -1; // of the rectangle, or the index of a point
        QPointF done;    // how far it was moved so far
        int gesture = 0;
        ElementIds before; // the selection when a band was begun
        ElementId pressed;
    };
    void updateScrollBars();
    QPointF origin() const;
    ElementId elementAt(QPointF at, bool inside) const;
    ElementIds movable() const;
    bool liesInCells(const ElementIds& ids) const;
    Edit cellEdit(const ElementIds& ids, QPointF at) const;
    void showCell(const ElementIds& ids, QPointF at);
    void endMove(QPointF at);
    /// An insertion at a point that lies in a row or grid goes into its cell.
    Edit withCells(const Edit& inserted, const ElementIds& added, QPointF at) const;
    SnapField snapField(const ElementIds& without) const;
    int handleAt(QPoint at) const;
    int pointAt(QPoint at) const;
    bool hasPoints() const;
    QPointF pointPlace(int index) const;
    void beginMove(QPointF at);
    void moveTo(QPointF at, bool freely);
    void resizeSelection(QPointF at, bool freely, bool keepsRatio);
    void movePoint(QPointF at, bool freely);
    void bandTo(QPointF at);
    void nudge(QPointF by);
    void deleteSelection();
    void openSelected();
    void drawRulers(QPainter& painter);
    void drawGrid(QPainter& painter);
    void drawSelection(QPainter& painter);
    void drawGuides(QPainter& painter);
    void drawFindings(QPainter& painter);
    void drawDrop(QPainter& painter);
    ElementId tabAt(QPointF at, int* page) const;

    PanelDocument& m_document;
    Selection& m_selection;
    DesignContext& m_context;
    AlarmBook m_alarms; // lists show the texts of the project
    PanelScene m_scene{makeElementView};
    QString m_panelName;
    double m_zoom = 1;
    bool m_keepsFit = true; // until a zoom is chosen
    bool m_snaps = true, m_gridShown = true, m_space = false;
    Drag m_drag;
    QRectF m_band;
    std::vector<Guide> m_guides;
    ElementId m_entered;
    QHash<ElementId, QString> m_findings;
    QPointF m_pointer;
    std::optional<QRectF> m_dropRect;
};

} // namespace plc::hmi
