// The mouse on ladder and function block diagrams: a click selects, or puts something on a wire; a double click edits;
// a contact is dragged to another place, a rung by anything else of it; what a tree or library gives is dropped.
#include "editor/graph/ladder/ladder_view.h"

#include "editor/kit/icons.h"
#include "editor/kit/texts.h"
#include "runtime/base/messages.h"
#include "runtime/base/text.h"

#include <QApplication>
#include <QDragMoveEvent>
#include <QMenu>
#include <QMimeData>
#include <QMouseEvent>

namespace plc::editor {

using ladder::LadderEditor;
using ladder::NodeKind;
using ladder::Place;
using ladder::RungId;
using ladder::RungKind;

namespace {

bool isMovableContact(const ladder::Node& node) {
    return node.expr &&
           (node.kind == NodeKind::Contact || node.kind == NodeKind::Compare || node.kind == NodeKind::Edge);
}

} // namespace

bool LadderView::mouseEvent(QEvent* event) {
    switch (event->type()) {
    case QEvent::MouseButtonPress:
        return pressed(*static_cast<QMouseEvent*>(event));
    case QEvent::MouseMove:
        return moved(*static_cast<QMouseEvent*>(event));
    case QEvent::MouseButtonRelease:
        return released(*static_cast<QMouseEvent*>(event));
    case QEvent::MouseButtonDblClick: {
        const QPointF point = m_canvas->mapToScene(static_cast<QMouseEvent*>(event)->pos());
        m_pressedGap.reset();
        if (m_scene->gapAt(point)) return true; // the first click has opened the field
        m_scene->select(m_scene->pickAt(point));
        editSelected();
        return true;
    }
    case QEvent::Leave:
        m_scene->markGap(std::nullopt);
        return false;
    case QEvent::DragEnter:
    case QEvent::DragMove:
        return dragEntered(*static_cast<QDragMoveEvent*>(event));
    case QEvent::DragLeave:
        m_scene->markGap(std::nullopt);
        return false;
    case QEvent::Drop:
        return dropped(*static_cast<QDropEvent*>(event));
    case QEvent::ToolTip:
        m_canvas->viewport()->setToolTip(
            m_scene->problemAt(m_scene->pickAt(m_canvas->mapToScene(static_cast<QHelpEvent*>(event)->pos()))));
        return false;
    default:
        return false;
    }
}

bool LadderView::pressed(const QMouseEvent& mouse) {
    if (mouse.button() != Qt::LeftButton || m_canvas->cursor().shape() == Qt::OpenHandCursor) return false;
    const QPointF point = m_canvas->mapToScene(mouse.pos());
    m_pressedAt = mouse.pos();
    m_isDragging = false;
    m_dragged = m_scene->pickAt(point);
    m_pressedGap = m_isStale ? std::nullopt : m_scene->gapAt(point);
    m_scene->select(m_dragged);
    return false;
}

bool LadderView::isContactDragged() const {
    return m_dragged.node.isValid() && m_syntax && isMovableContact(m_diagram[m_dragged.node]);
}

/// Where a contact comes that is dropped at a point: on the wire there, or beside the contact there.
std::optional<LadderGap> LadderView::gapBeside(QPointF point) const {
    if (auto gap = m_scene->gapAt(point)) return gap;
    const LadderPick pick = m_scene->pickAt(point);
    if (!pick.rung.isValid() || m_diagram[pick.rung].kind != RungKind::Logic) return std::nullopt;
    LadderGap gap{pick.rung, {}, Place::After, m_scene->rectOf(pick)};
    if (!pick.node.isValid() || !isMovableContact(m_diagram[pick.node])) return gap;
    gap.beside = pick.node;
    gap.place = point.x() < gap.at.center().x() ? Place::Before : Place::After;
    const double x = gap.place == Place::Before ? gap.at.left() : gap.at.right();
    gap.at = QRectF(x - 4, gap.at.bottom() - m_scene->cellHeight() / 2 - 4, 8, 8);
    return gap;
}

bool LadderView::moved(const QMouseEvent& mouse) {
    const QPointF point = m_canvas->mapToScene(mouse.pos());
    if (!(mouse.buttons() & Qt::LeftButton)) {
        m_scene->markGap(m_isStale || m_field->isVisible() ? std::nullopt : m_scene->gapAt(point));
        return false;
    }
    const bool far = (mouse.pos() - m_pressedAt).manhattanLength() >= QApplication::startDragDistance();
    if (!m_dragged.rung.isValid() || m_isStale || !far) return false;
    m_isDragging = true;
    const LadderPick under = m_scene->pickAt(point);
    const auto gap = isContactDragged() ? gapBeside(point) : std::nullopt;
    const bool canDrop = isContactDragged() ? gap && gap->beside != m_dragged.node
                                            : under.rung.isValid() && under.rung != m_dragged.rung;
    m_scene->markGap(canDrop ? gap : std::nullopt);
    m_canvas->viewport()->setCursor(canDrop ? Qt::DragMoveCursor : Qt::ForbiddenCursor);
    return true;
}

/// As dragging it: to the other side of the contact that is next in this direction.
void LadderView::moveContact(int direction) {
    const LadderPick moved = m_scene->picked();
    if (!moved.node.isValid() || !canEdit()) return;
    if (!isMovableContact(m_diagram[moved.node])) return emit failed(tr("Select a contact; a rung moves up and down"));
    selectTowards(direction, 0);
    const LadderPick beside = m_scene->picked();
    m_scene->select(moved);
    if (!beside.node.isValid() || beside == moved || !isMovableContact(m_diagram[beside.node])) return;
    request(editor().moveContact(moved.node, beside.node, direction < 0 ? Place::Before : Place::After),
            kit::fromView(m_diagram[moved.node].label));
}

Result<LadderView::Edits> LadderView::moveTo(QPointF point) const {
    if (isContactDragged()) {
        const auto gap = gapBeside(point);
        if (!gap || gap->beside == m_dragged.node) return Edits();
        if (gap->beside.isValid()) return editor().moveContact(m_dragged.node, gap->beside, gap->place);
        return editor().moveContact(m_dragged.node, gap->rung);
    }
    const RungId from = m_dragged.rung, to = m_scene->pickAt(point).rung;
    if (!to.isValid() || to == from) return Edits();
    return editor().moveRung(from, to < from ? Place::Before : Place::After, to);
}

bool LadderView::released(const QMouseEvent& mouse) {
    const auto gap = std::exchange(m_pressedGap, std::nullopt);
    m_scene->markGap(std::nullopt);
    if (!std::exchange(m_isDragging, false)) {
        m_dragged = {};
        const bool isClick = gap && mouse.button() == Qt::LeftButton && mouse.modifiers() == Qt::NoModifier;
        if (isClick && canEdit()) insertOnWire(*gap);
        return false;
    }
    m_canvas->viewport()->unsetCursor();
    if (canEdit()) {
        const QString label = m_dragged.node.isValid() ? kit::fromView(m_diagram[m_dragged.node].label) : QString();
        request(moveTo(m_canvas->mapToScene(mouse.pos())), label);
    }
    m_dragged = {};
    return true;
}

/// With the tool that was used last.
void LadderView::insertOnWire(const LadderGap& gap) {
    if (m_tool == Tool::Block) return m_scene->select({gap.rung, {}}), insertBlock();
    if (m_tool == Tool::Parallel && gap.beside.isValid())
        return m_scene->select({gap.rung, gap.beside}), insertParallel();
    const QString present = m_tool == Tool::NegatedContact ? QStringLiteral("/") : QString();
    ask(FieldKind::Operand, QRectF(gap.at.center() - QPointF(60, 13), QSizeF(120, 26)), present,
        m_diagram[gap.rung].range.begin, [this, gap](const std::string& text) {
            return gap.beside.isValid() ? editor().insertContact(gap.beside, gap.place, text)
                                        : editor().appendContact(gap.rung, text);
        });
    m_field->setCursorPosition(static_cast<int>(present.size()));
}

void LadderView::addWireMenu(QMenu& menu, const LadderGap& gap) {
    const auto add = [&](kit::Icon icon, const QString& text, Tool tool) {
        connect(menu.addAction(kit::icon(icon), text), &QAction::triggered, this, [this, gap, tool] {
            m_tool = tool;
            if (canEdit()) insertOnWire(gap);
        });
    };
    add(kit::Icon::Add, tr("Contact Here"), Tool::Contact);
    add(kit::Icon::Add, tr("Negated Contact Here"), Tool::NegatedContact);
    add(kit::Icon::Layers, tr("Function Block Here"), Tool::Block);
    menu.addSeparator();
}

// ------------------------------------------------------------------ what comes from a tree or a library

bool LadderView::dragEntered(QDragMoveEvent& drag) {
    if (!drag.mimeData()->hasText() || m_isStale) return false;
    const QPointF point = m_canvas->mapToScene(drag.position().toPoint());
    m_scene->markGap(m_scene->gapAt(point));
    drag.acceptProposedAction();
    return true;
}

/// TON gives ton1, or the first number that is free.
std::string LadderView::freeInstance(const std::string& type) const {
    const ladder::DeclaredTypes::Scope scope{m_place.pou, m_place.owner};
    for (int number = 1;; ++number) {
        std::string name = foldCase(type) + std::to_string(number);
        if (!m_types->isDeclared(name, scope)) return name;
    }
}

/// A block is called in the rung, with an instance of its own; a variable becomes a contact, or the operand it fell on.
Result<LadderView::Edits> LadderView::dropOn(QPointF point, const std::string& name) const {
    const LadderPick pick = m_scene->pickAt(point);
    const syntax::Pou* unit = m_types->pou(name);
    if (unit && unit->kind == syntax::PouKind::FunctionBlock) {
        const std::string instance = freeInstance(name);
        if (pick.rung.isValid()) return editor().insertBlock(pick.rung, instance, name);
        const auto edits = editor().insertRung(pickedRung(), Place::After, instance + "();");
        return edits ? Result<Edits>(withDeclaration(*edits, instance, name)) : edits;
    }
    if (!pick.rung.isValid()) return editor().insertRung(pickedRung(), Place::After, name + " := TRUE;");
    if (pick.node.isValid() && m_diagram[pick.node].operand) return editor().setOperand(pick.node, name);
    const auto gap = m_scene->gapAt(point);
    return gap && gap->beside.isValid() ? editor().insertContact(gap->beside, gap->place, name)
                                        : editor().appendContact(pick.rung, name);
}

bool LadderView::dropped(QDropEvent& drop) {
    m_scene->markGap(std::nullopt);
    if (!drop.mimeData()->hasText() || !canEdit()) return false;
    const QString name = drop.mimeData()->text().section('\n', 0, 0).trimmed();
    request(dropOn(m_canvas->mapToScene(drop.position().toPoint()), name.toStdString()), name);
    drop.acceptProposedAction();
    return true;
}

} // namespace plc::editor
