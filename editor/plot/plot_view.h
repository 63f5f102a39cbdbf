// The plot as a widget: zoom with wheel and box on x, y or both, pan, two cursors that snap to samples, follow the
// newest sample. It owns its model; sources are shared with whoever fills them. `refresh` is called by a timer of the
// owner. GUI thread.
#pragma once

#include "editor/plot/painting/plot_renderer.h"

#include <QImage>
#include <QWidget>

#include <deque>

namespace plc::plot {

enum class PlotTool : uint8_t { ZoomBox, Pan, Ruler };

class PlotView : public QWidget {
    Q_OBJECT
public:
    explicit PlotView(QWidget* parent = nullptr);
    ~PlotView() override;

    const PlotModel& model() const { return m_model; }
    /// Changes the model through a function, then repaints; the part of time in view is the view's own.
    void edit(const std::function<void(PlotModel&)>& change);
    const PlotRenderer& renderer() const { return m_renderer; }

    void setTool(PlotTool tool);
    PlotTool tool() const { return m_tool; }
    void setRange(int64_t from, int64_t to);
    /// Everything recorded, on both axes.
    void fit();
    /// y of all charts only.
    void fitValues();
    void zoomTime(double factor, int64_t about);
    void zoomValues(double factor, int chart, std::optional<int> axis, double aboutY);
    void panTime(double parts);
    void zoomBack();
    bool canZoomBack() const { return !m_past.empty(); }

    bool isFollowing() const { return m_follow; }
    void setFollowing(bool follow);
    /// Looks at the sources; repaints when they have grown, moves on when following.
    void refresh();

    bool hasCursors() const { return m_model.cursorA || m_model.cursorB; }
    void setCursorsShown(bool shown);
    void setCursor(int which, int64_t time); // 0: A, 1: B; snaps
    void moveActiveCursor(int samples);
    QImage picture(double scale = 0) const;

signals:
    void rangeChanged(qint64 from, qint64 to);
    void followingChanged(bool following);
    void cursorsChanged();
    void toolChanged(plc::plot::PlotTool tool);
    void curveSelected(const QString& id);
    void curveToggled(const QString& id, bool visible);
    void variablesDropped(const QStringList& paths, int chart);
    void menuRequested(const QPoint& global, int chart, const QString& curve);
    void timeActivated(qint64 time); // double click, or Enter at the active cursor, else in the middle

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dragMoveEvent(QDragMoveEvent* event) override;
    void dragLeaveEvent(QDragLeaveEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    bool event(QEvent* event) override;
    QSize sizeHint() const override { return {720, 420}; }

private:
    enum class Drag : uint8_t { None, Box, Pan, CursorA, CursorB, Ruler };
    struct Past {
        int64_t from, to;
        std::vector<std::vector<std::optional<PlotRange>>> zooms;
    };
    PlotMapping timeMapping() const;
    Past present() const;
    void remember();
    void takeRange(int64_t from, int64_t to);
    void markDirty();
    void applyBox(const QRectF& box);
    void dragRuler();
    QRectF boxNow() const;
    std::optional<Drag> cursorNear(const QPointF& point) const;
    int chartAt(const QPointF& point) const;
    std::vector<uint64_t> revisions() const;

    PlotModel m_model;
    PlotRenderer m_renderer;
    PlotTool m_tool = PlotTool::ZoomBox;
    QImage m_base; // an image, so that curves are written into it directly
    bool m_dirty = true, m_follow = false;
    std::vector<uint64_t> m_revisions;
    Drag m_drag = Drag::None;
    int m_activeCursor = 0, m_dropChart = -1;
    QPointF m_dragFrom, m_dragAt;
    int64_t m_panFrom = 0, m_panTo = 0;
    bool m_panRemembered = false;
    std::deque<Past> m_past;
};

} // namespace plc::plot
