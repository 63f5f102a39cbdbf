#include "hmi/designer/canvas/design_canvas.h"

#include "editor/kit/message_text.h"
#include "editor/kit/theme.h"
#include "hmi/model/property_literals.h"
#include "hmi/view/controls/containers.h"

#include <QMouseEvent>
#include <cmath>

namespace plc::hmi {

namespace {
constexpr int kMargin = 48; // around the panel where it is scrolled
constexpr int kFree = 14;   // where it is not
} // namespace

DesignCanvas::DesignCanvas(PanelDocument& document, Selection& selection, DesignContext& context, QWidget* parent)
    : QAbstractScrollArea(parent), m_document(document), m_selection(selection), m_context(context) {
    setFocusPolicy(Qt::StrongFocus);
    viewport()->setMouseTracking(true);
    viewport()->setAcceptDrops(true);
    setAcceptDrops(true);
    setFrameShape(QFrame::NoFrame);
    m_scene.setDesigning(true);
    m_scene.setUnderlay([this](QPainter& painter) {
        painter.save();
        painter.resetTransform();
        drawGrid(painter);
        painter.restore();
    });
    m_scene.setFolder(context.project().folder);
    m_scene.setPicturesOutside(context.project().picturesOutside);
    m_scene.setTexts(&context.project().texts);
    m_alarms.setFile(context.project().alarms);
    m_scene.setAlarms(&m_alarms);
    m_scene.setLanguage(context.language());
    m_scene.setFaceplates(context.project().panelLookup());
    m_scene.setThemes(context.project().themes);
    m_scene.setRecipes(&context.project().recipes);
    m_scene.setPanel(document.panel());
    m_scene.refresh(0);
    connect(&m_document, &PanelDocument::changed, this, [this](const Touched& touched) {
        m_scene.follow(m_document.panel(), touched);
        m_selection.prune(m_document.panel());
        if (touched.panel) updateScrollBars();
        viewport()->update();
    });
    connect(&m_selection, &Selection::changed, viewport(), qOverload<>(&QWidget::update));
    connect(&m_context, &DesignContext::textsChanged, this, [this] {
        m_scene.setTexts(&m_context.project().texts);
        viewport()->update();
    });
    connect(&m_context, &DesignContext::panelEdited, this, [this](const QString& name) {
        if (name == m_panelName || !placesPanel(m_document.panel(), name, m_context.project().panelLookup())) return;
        m_scene.setPanel(m_document.panel());
        m_scene.refresh(0);
        viewport()->update();
    });
    connect(&m_context, &DesignContext::themesTaken, this, [this] {
        m_scene.setThemes(m_context.project().themes);
        m_scene.refresh(0);
        viewport()->update();
    });
    connect(&m_context, &DesignContext::alarmsChanged, this, [this] { m_alarms.setFile(m_context.project().alarms); });
    connect(&m_context, &DesignContext::languageChanged, this, [this] {
        m_scene.setLanguage(m_context.language());
        viewport()->update();
    });
    updateScrollBars();
}

// ---- view

QPointF DesignCanvas::origin() const {
    const QSizeF shown = QSizeF(m_scene.size()) * m_zoom;
    const double freeX = viewport()->width() - kRuler - shown.width(),
                 freeY = viewport()->height() - kRuler - shown.height();
    const double x = freeX > 2 * kFree ? kRuler + freeX / 2 : kRuler + kMargin - horizontalScrollBar()->value();
    const double y = freeY > 2 * kFree ? kRuler + freeY / 2 : kRuler + kMargin - verticalScrollBar()->value();
    return {std::floor(x), std::floor(y)};
}

QPointF DesignCanvas::toPanel(QPointF point) const { return (point - origin()) / m_zoom; }

QPointF DesignCanvas::toViewport(QPointF point) const { return origin() + point * m_zoom; }

QPointF DesignCanvas::visibleCenter() const {
    const QRectF shown =
        QRectF(toPanel(QPointF(kRuler, kRuler)), toPanel(QPointF(viewport()->width(), viewport()->height()))) &
        QRectF(QPointF(), m_scene.size());
    return shown.isEmpty() ? QRectF(QPointF(), m_scene.size()).center() : shown.center();
}

void DesignCanvas::updateScrollBars() {
    const QSizeF shown = QSizeF(m_scene.size()) * m_zoom;
    const QSize room = viewport()->size() - QSize(kRuler, kRuler);
    const auto range = [](double length, int there) {
        return there - length > 2 * kFree ? 0 : std::max(0, static_cast<int>(length) + 2 * kMargin - there);
    };
    horizontalScrollBar()->setRange(0, range(shown.width(), room.width()));
    verticalScrollBar()->setRange(0, range(shown.height(), room.height()));
    horizontalScrollBar()->setPageStep(room.width());
    verticalScrollBar()->setPageStep(room.height());
    viewport()->update();
}

void DesignCanvas::setZoom(double zoom, std::optional<QPointF> about) {
    const QPointF anchor = about.value_or(QPointF(viewport()->width() / 2.0, viewport()->height() / 2.0)),
                  panel = toPanel(anchor);
    m_zoom = std::clamp(zoom, 0.1, 8.0);
    m_keepsFit = false;
    updateScrollBars();
    const QPointF off = toViewport(panel) - anchor;
    horizontalScrollBar()->setValue(horizontalScrollBar()->value() + static_cast<int>(std::round(off.x())));
    verticalScrollBar()->setValue(verticalScrollBar()->value() + static_cast<int>(std::round(off.y())));
    emit zoomChanged(m_zoom);
}

void DesignCanvas::zoomToFit() {
    const QSizeF panel = m_scene.size();
    const double room = 2 * kMargin + kRuler + 2;
    setZoom(
        std::min({(viewport()->width() - room) / panel.width(), (viewport()->height() - room) / panel.height(), 1.0}));
    m_keepsFit = true;
}

void DesignCanvas::setGridShown(bool on) {
    m_gridShown = on;
    viewport()->update();
}

void DesignCanvas::setFindings(const std::vector<Finding>& findings) {
    m_findings.clear();
    for (const Finding& one : findings)
        if (!one.element.isEmpty()) {
            QString& text = m_findings[one.element];
            text += (text.isEmpty() ? QString() : QStringLiteral("\n")) +
                    (one.language.isEmpty() ? QString() : QStringLiteral("[%1] ").arg(one.language)) +
                    kit::messageText(one.message);
        }
    viewport()->update();
}

void DesignCanvas::resizeEvent(QResizeEvent*) {
    if (m_keepsFit)
        zoomToFit();
    else
        updateScrollBars();
}

void DesignCanvas::scrollContentsBy(int, int) { viewport()->update(); }

// ---- what lies where

ElementId DesignCanvas::elementAt(QPointF at, bool inside) const {
    const auto& views = m_scene.views();
    for (size_t i = views.size(); i-- > 0;) {
        const ElementView& view = *views[i];
        if (m_scene.isInner(view)) continue; // the faceplate is one element here
        if (!m_scene.isShown(view) || !m_scene.shownRect(view).contains(at) || view.element().isSet("locked"_flag))
            continue;
        if (!QRectF(view.rect()).adjusted(-3, -3, 3, 3).contains(at) && view.element().number("angle"_number) == 0)
            continue;
        const hmi::Panel& panel = m_document.panel();
        // A frame or group is taken by its contents or its edge, not by the empty middle.
        if (view.element().kind() == ElementKind::Group && !panel.childrenOf(view.element().id()).empty() &&
            view.rect().adjusted(6, 6, -6, -6).contains(at))
            continue;
        ElementId id = view.element().id();
        if (inside) return id;
        // A press takes the outermost group, unless that group was entered.
        for (ElementId outer = view.element().parent(); !outer.isEmpty() && outer != m_entered;) {
            const Element* group = panel.find(outer);
            if (!group || group->kind() != ElementKind::Group) break;
            if (group->isSet("locked"_flag)) return {};
            id = outer;
            outer = group->parent();
        }
        return id;
    }
    return {};
}

ElementIds DesignCanvas::movable() const {
    ElementIds out;
    for (const ElementId& id : m_selection.ids())
        if (const Element* element = m_document.panel().find(id); element && !element->isSet("locked"_flag))
            out.push_back(id);
    return out;
}

SnapField DesignCanvas::snapField(const ElementIds& without) const {
    SnapField field;
    QSet<ElementId> moving;
    for (const ElementId& id : without)
        for (const ElementId& one : m_document.panel().withDescendants(id)) moving += one;
    for (const auto& view : m_scene.views())
        if (!moving.contains(view->element().id()) && !m_scene.isInner(*view) && m_scene.isShown(*view))
            field.others.push_back(view->rect());
    field.panel = QRectF(QPointF(), m_scene.size());
    field.grid = std::max(1.0, m_document.panel().number("grid"_number));
    field.reach = 6 / m_zoom;
    return field;
}

QPointF DesignCanvas::handle(int index) const {
    const QRectF r = toViewport(boundsOf(m_document.panel(), movable()));
    const double xs[] = {r.left(), r.center().x(), r.right(), r.right(), r.right(), r.center().x(), r.left(), r.left()};
    const double ys[] = {r.top(), r.top(), r.top(), r.center().y(), r.bottom(), r.bottom(), r.bottom(), r.center().y()};
    return {xs[index], ys[index]};
}

int DesignCanvas::handleAt(QPoint at) const {
    if (movable().empty()) return -1;
    for (const int i : {0, 2, 4, 6, 1, 3, 5, 7})
        if ((handle(i) - at).manhattanLength() < 9) return i;
    return -1;
}

bool DesignCanvas::hasPoints() const {
    if (m_selection.ids().size() != 1) return false;
    const Element* element = m_document.panel().find(m_selection.ids().front());
    return element && element->descriptor().property("points"_field) && !element->isSet("locked"_flag) &&
           element->number("angle"_number) == 0;
}

QPointF DesignCanvas::pointPlace(int index) const {
    const Element* element = m_document.panel().find(m_selection.ids().front());
    const QPointF point = element->points("points"_field).value(index);
    return toViewport(element->rect().topLeft() +
                      QPointF(point.x() * element->rect().width(), point.y() * element->rect().height()));
}

int DesignCanvas::pointAt(QPoint at) const {
    if (!hasPoints()) return -1;
    const auto count = m_document.panel().find(m_selection.ids().front())->points("points"_field).size();
    for (int i = 0; i < count; ++i)
        if ((pointPlace(i) - at).manhattanLength() < 9) return i;
    return -1;
}

ElementId DesignCanvas::tabAt(QPointF at, int* page) const {
    const auto& views = m_scene.views();
    for (size_t i = views.size(); i-- > 0;) {
        if (views[i]->element().kind() != ElementKind::Tab || m_scene.isInner(*views[i]) ||
            !m_scene.isShown(*views[i]) || !views[i]->rect().contains(at))
            continue;
        *page = views[i]->currentPage();
        return views[i]->element().id();
    }
    return {};
}

// ---- mouse

void DesignCanvas::mousePressEvent(QMouseEvent* event) {
    const QPoint at = event->position().toPoint();
    const QPointF panel = toPanel(at);
    m_drag = {};
    m_drag.from = panel;
    m_drag.fromViewport = at;
    if (event->button() == Qt::MiddleButton || (m_space && event->button() == Qt::LeftButton)) {
        m_drag.mode = Mode::Pan;
        viewport()->setCursor(Qt::ClosedHandCursor);
        return;
    }
    const bool adds = event->modifiers() & (Qt::ShiftModifier | Qt::ControlModifier);
    if (event->button() == Qt::RightButton) {
        const ElementId id = elementAt(panel, false);
        if (!id.isEmpty() && !m_selection.contains(id)) m_selection.set({id});
        return;
    }
    if (event->button() != Qt::LeftButton) return;
    if (const int point = pointAt(at); point >= 0) {
        m_drag.mode = Mode::Point;
        m_drag.handle = point;
        m_drag.gesture = m_document.newGesture();
        return;
    }
    if (const int index = handleAt(at); index >= 0) {
        m_drag.mode = Mode::Resize;
        m_drag.handle = index;
        m_drag.bounds = boundsOf(m_document.panel(), movable());
        m_drag.gesture = m_document.newGesture();
        return;
    }
    const ElementId id = elementAt(panel, event->modifiers() & Qt::AltModifier);
    if (id.isEmpty()) {
        m_drag.mode = Mode::Band;
        m_drag.before = adds ? m_selection.ids() : ElementIds();
        m_band = QRectF(panel, QSizeF());
        if (!adds) m_selection.clear();
        if (!m_entered.isEmpty() && m_document.panel().find(m_entered) &&
            !m_document.panel().find(m_entered)->rect().contains(panel))
            m_entered.clear();
        return;
    }
    // The head of a tab that is selected turns its page.
    if (auto* tab = dynamic_cast<TabView*>(m_scene.view(id));
        tab && m_selection.contains(id) && tab->touchArea().contains(panel - tab->rect().topLeft())) {
        const int pages = static_cast<int>(tab->element().at("pages"_field).size());
        for (int page = 0; page < pages; ++page) {
            const double w =
                std::min(tab->element().number("fontSize"_number) * 11, tab->rect().width() / std::max(1, pages));
            if (panel.x() - tab->rect().left() >= page * w && panel.x() - tab->rect().left() < (page + 1) * w)
                tab->showPage(page);
        }
        viewport()->update();
    }
    if (adds)
        m_selection.toggle(id);
    else if (!m_selection.contains(id))
        m_selection.set({id});
    m_drag.mode = Mode::Press;
    m_drag.pressed = id;
}

void DesignCanvas::beginMove(QPointF) {
    m_drag.mode = Mode::Move;
    m_drag.bounds = boundsOf(m_document.panel(), movable());
    m_drag.gesture = m_document.newGesture();
}

void DesignCanvas::moveTo(QPointF at, bool freely) {
    const ElementIds ids = movable();
    if (ids.empty()) return;
    if (liesInCells(ids)) return showCell(ids, at);
    QPointF offset = at - m_drag.from;
    m_guides.clear();
    if (m_snaps && !freely) {
        const Snapped snapped = snapMove(m_drag.bounds.translated(offset), snapField(ids));
        offset += snapped.offset;
        m_guides = snapped.guides;
    } else {
        offset = QPointF(std::round(offset.x()), std::round(offset.y()));
    }
    const QPointF step = offset - m_drag.done;
    if (!step.isNull()) m_document.perform(tr("Move"), moveBy(m_document.panel(), ids, step), m_drag.gesture);
    m_drag.done = offset;
    viewport()->update();
}

void DesignCanvas::resizeSelection(QPointF at, bool freely, bool keepsRatio) {
    const ElementIds ids = movable();
    DraggedEdges edges;
    edges.left = m_drag.handle == 0 || m_drag.handle == 6 || m_drag.handle == 7;
    edges.right = m_drag.handle >= 2 && m_drag.handle <= 4;
    edges.top = m_drag.handle <= 2;
    edges.bottom = m_drag.handle >= 4 && m_drag.handle <= 6;
    QRectF wanted = m_drag.bounds;
    const QPointF by = at - m_drag.from;
    const auto apply = [&](QPointF offset) {
        if (edges.left) wanted.setLeft(std::min(wanted.left() + offset.x(), wanted.right() - 4));
        if (edges.right) wanted.setRight(std::max(wanted.right() + offset.x(), wanted.left() + 4));
        if (edges.top) wanted.setTop(std::min(wanted.top() + offset.y(), wanted.bottom() - 4));
        if (edges.bottom) wanted.setBottom(std::max(wanted.bottom() + offset.y(), wanted.top() + 4));
    };
    apply(by);
    m_guides.clear();
    if (m_snaps && !freely) {
        const Snapped snapped = snapResize(wanted, edges, snapField(ids));
        apply(snapped.offset);
        m_guides = snapped.guides;
    }
    if (keepsRatio && m_drag.bounds.height() > 0 && (edges.left || edges.right) && (edges.top || edges.bottom)) {
        const double ratio = m_drag.bounds.width() / m_drag.bounds.height(), height = wanted.width() / ratio;
        if (edges.top)
            wanted.setTop(wanted.bottom() - height);
        else
            wanted.setHeight(height);
    }
    wanted = QRectF(std::round(wanted.x()), std::round(wanted.y()), std::max(1.0, std::round(wanted.width())),
                    std::max(1.0, std::round(wanted.height())));
    // Several elements keep their places within the whole.
    const QRectF now = boundsOf(m_document.panel(), ids);
    if (now == wanted) return;
    EditList list;
    const double sx = now.width() > 0 ? wanted.width() / now.width() : 1,
                 sy = now.height() > 0 ? wanted.height() / now.height() : 1;
    for (const ElementId& id : ids) {
        const QRectF rect = m_document.panel().find(id)->rect();
        const QRectF scaled(wanted.x() + (rect.x() - now.x()) * sx, wanted.y() + (rect.y() - now.y()) * sy,
                            rect.width() * sx, rect.height() * sy);
        list.edits.push_back(resizeTo(m_document.panel(), id, scaled));
    }
    m_document.perform(tr("Resize"), {list}, m_drag.gesture);
}

void DesignCanvas::movePoint(QPointF at, bool freely) {
    const Element* element = m_document.panel().find(m_selection.ids().front());
    if (!element) return;
    if (m_snaps && !freely) at += snapMove(QRectF(at, QSizeF(0.001, 0.001)), snapField({element->id()})).offset;
    // The rectangle follows the points: it always is their bounds.
    QList<QPointF> points;
    for (const QPointF& point : element->points("points"_field))
        points += element->rect().topLeft() +
                  QPointF(point.x() * element->rect().width(), point.y() * element->rect().height());
    if (m_drag.handle >= points.size()) return;
    points[m_drag.handle] = at;
    QRectF bounds = QPolygonF(points).boundingRect();
    bounds.setWidth(std::max(1.0, bounds.width()));
    bounds.setHeight(std::max(1.0, bounds.height()));
    Json list = Json::array();
    for (const QPointF& point : points)
        list.push_back(Json::array({std::round((point.x() - bounds.x()) / bounds.width() * 10000) / 10000,
                                    std::round((point.y() - bounds.y()) / bounds.height() * 10000) / 10000}));
    EditList edits{{hmi::setProperty(m_document.panel(), element->id(), "rect", rectToJson(bounds)),
                    hmi::setProperty(m_document.panel(), element->id(), "points", list)}};
    m_document.perform(tr("Move point"), {edits}, m_drag.gesture);
}

void DesignCanvas::bandTo(QPointF at) {
    m_band = QRectF(m_drag.from, at).normalized();
    ElementIds ids = m_drag.before;
    for (const auto& view : m_scene.views()) {
        if (m_scene.isInner(*view) || !m_scene.isShown(*view) || view->element().isSet("locked"_flag) ||
            !m_band.contains(view->rect()))
            continue;
        const Element* outer = m_document.panel().find(view->element().parent());
        if (outer && outer->kind() == ElementKind::Group && outer->id() != m_entered) continue;
        if (std::find(ids.begin(), ids.end(), view->element().id()) == ids.end()) ids.push_back(view->element().id());
    }
    m_selection.set(ids);
    viewport()->update();
}

void DesignCanvas::mouseMoveEvent(QMouseEvent* event) {
    const QPoint at = event->position().toPoint();
    m_pointer = toPanel(at);
    emit pointerMoved(m_pointer);
    const bool freely = event->modifiers() & Qt::AltModifier;
    switch (m_drag.mode) {
    case Mode::Idle: {
        const int index = handleAt(at);
        const Qt::CursorShape shapes[] = {Qt::SizeFDiagCursor, Qt::SizeVerCursor,   Qt::SizeBDiagCursor,
                                          Qt::SizeHorCursor,   Qt::SizeFDiagCursor, Qt::SizeVerCursor,
                                          Qt::SizeBDiagCursor, Qt::SizeHorCursor};
        viewport()->setCursor(pointAt(at) >= 0 ? Qt::CrossCursor : index >= 0 ? shapes[index] : Qt::ArrowCursor);
        const QString finding = m_findings.value(elementAt(m_pointer, true));
        viewport()->setToolTip(finding);
        viewport()->update(QRect(0, 0, viewport()->width(), kRuler));
        viewport()->update(QRect(0, 0, kRuler, viewport()->height()));
        return;
    }
    case Mode::Press:
        if ((at - m_drag.fromViewport).manhattanLength() < 4) return;
        beginMove(m_pointer);
        return moveTo(m_pointer, freely);
    case Mode::Move:
        return moveTo(m_pointer, freely);
    case Mode::Resize:
        return resizeSelection(m_pointer, freely, event->modifiers() & Qt::ShiftModifier);
    case Mode::Band:
        return bandTo(m_pointer);
    case Mode::Point:
        return movePoint(m_pointer, freely);
    case Mode::Pan: {
        const QPoint by = at - m_drag.fromViewport;
        m_drag.fromViewport = at;
        horizontalScrollBar()->setValue(horizontalScrollBar()->value() - by.x());
        verticalScrollBar()->setValue(verticalScrollBar()->value() - by.y());
        return;
    }
    }
}

void DesignCanvas::mouseReleaseEvent(QMouseEvent* event) {
    // A press without a move on one of several narrows the selection to it.
    const bool isClick = m_drag.mode == Mode::Press && event->button() == Qt::LeftButton;
    if (isClick && !(event->modifiers() & (Qt::ShiftModifier | Qt::ControlModifier)) && m_selection.ids().size() > 1 &&
        m_selection.contains(m_drag.pressed))
        m_selection.set({m_drag.pressed});
    if (m_drag.mode == Mode::Move) endMove(toPanel(event->position()));
    m_drag.mode = Mode::Idle;
    m_guides.clear();
    viewport()->setCursor(m_space ? Qt::OpenHandCursor : Qt::ArrowCursor);
    viewport()->update();
}

void DesignCanvas::mouseDoubleClickEvent(QMouseEvent* event) {
    const QPointF at = toPanel(event->position());
    if (hasPoints()) {
        const Element* element = m_document.panel().find(m_selection.ids().front());
        QList<QPointF> points = element->points("points"_field);
        const int hit = pointAt(event->position().toPoint());
        if (hit >= 0 && points.size() > 2) {
            points.removeAt(hit);
        } else if (hit < 0) { // a new point on the nearest piece
            const QPointF local((at.x() - element->rect().x()) / element->rect().width(),
                                (at.y() - element->rect().y()) / element->rect().height());
            qsizetype best = 1;
            double nearest = 1e18;
            for (qsizetype i = 1; i < points.size(); ++i) {
                const double distance = QLineF(points[i - 1], local).length() + QLineF(local, points[i]).length() -
                                        QLineF(points[i - 1], points[i]).length();
                if (distance < nearest) nearest = distance, best = i;
            }
            points.insert(best, QPointF(std::round(local.x() * 1000) / 1000, std::round(local.y() * 1000) / 1000));
        }
        Json list = Json::array();
        for (const QPointF& point : points) list.push_back(Json::array({point.x(), point.y()}));
        m_document.perform(tr("Points"), hmi::setProperty(m_document.panel(), element->id(), "points", list));
        return;
    }
    const ElementId outer = elementAt(at, false), inner = elementAt(at, true);
    if (const Element* group = m_document.panel().find(outer);
        group && group->kind() == ElementKind::Group && inner != outer) {
        m_entered = outer;
        m_selection.set({elementAt(at, false)});
        return;
    }
    if (!outer.isEmpty()) emit editRequested(outer);
}

void DesignCanvas::wheelEvent(QWheelEvent* event) {
    if (event->modifiers() & Qt::ControlModifier) {
        setZoom(m_zoom * std::pow(1.0015, event->angleDelta().y()), event->position());
        event->accept();
        return;
    }
    QAbstractScrollArea::wheelEvent(event);
}

void DesignCanvas::contextMenuEvent(QContextMenuEvent* event) {
    if (event->reason() != QContextMenuEvent::Keyboard) return emit contextMenuRequested(event->globalPos());
    const QRect selected = toViewport(boundsOf(m_document.panel(), m_selection.ids())).toRect() & viewport()->rect();
    emit contextMenuRequested(viewport()->mapToGlobal(selected.isEmpty() ? QPoint(8, 8) : selected.bottomLeft()));
}

// ---- keys

void DesignCanvas::nudge(QPointF by) {
    const ElementIds ids = movable();
    if (!ids.empty()) m_document.perform(tr("Move"), moveBy(m_document.panel(), ids, by));
}

/// As a double click: into a group, to its first element; else to the text or the variable of the element.
void DesignCanvas::openSelected() {
    if (m_selection.ids().size() != 1) return;
    const Element* element = m_document.panel().find(m_selection.ids().front());
    if (!element) return;
    if (element->kind() != ElementKind::Group) return emit editRequested(element->id());
    for (const Element& each : m_document.panel().elements())
        if (each.parent() == element->id()) {
            m_entered = element->id();
            return m_selection.set({each.id()});
        }
}

void DesignCanvas::deleteSelection() {
    const ElementIds ids = movable();
    if (!ids.empty()) m_document.perform(tr("Delete"), removeElements(m_document.panel(), ids));
}

void DesignCanvas::keyPressEvent(QKeyEvent* event) {
    const double step =
        event->modifiers() & Qt::ShiftModifier ? std::max(1.0, m_document.panel().number("grid"_number)) : 1;
    switch (event->key()) {
    case Qt::Key_Left:
        return nudge({-step, 0});
    case Qt::Key_Right:
        return nudge({step, 0});
    case Qt::Key_Up:
        return nudge({0, -step});
    case Qt::Key_Down:
        return nudge({0, step});
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
        return deleteSelection();
    case Qt::Key_Escape:
        if (!m_entered.isEmpty()) {
            m_selection.set({std::exchange(m_entered, {})});
            return;
        }
        return m_selection.clear();
    case Qt::Key_Tab:
    case Qt::Key_Backtab: {
        const auto& elements = m_document.panel().elements();
        if (elements.empty()) return;
        const int count = static_cast<int>(elements.size()),
                  now = m_selection.isEmpty() ? -1 : m_document.panel().indexOf(m_selection.ids().front());
        m_selection.set(
            {elements[static_cast<size_t>((now + (event->key() == Qt::Key_Tab ? 1 : count - 1) + count) % count)]
                 .id()});
        return;
    }
    case Qt::Key_Return:
    case Qt::Key_Enter:
        return openSelected();
    case Qt::Key_Space:
        if (event->isAutoRepeat()) return;
        m_space = true;
        viewport()->setCursor(Qt::OpenHandCursor);
        return;
    default:
        QAbstractScrollArea::keyPressEvent(event);
    }
}

void DesignCanvas::keyReleaseEvent(QKeyEvent* event) {
    if (event->key() != Qt::Key_Space || event->isAutoRepeat()) return QAbstractScrollArea::keyReleaseEvent(event);
    m_space = false;
    viewport()->setCursor(Qt::ArrowCursor);
}

} // namespace plc::hmi
