// Parts dragged to another place: a step behind another transition or to another column, a branch to the left or right,
// a transition's end to another step, an action up, down or to another step. Each drop is one edit of the text.
#include "editor/graph/chart/chart_items.h"
#include "editor/graph/chart/chart_view.h"
#include "editor/kit/message_text.h"
#include "editor/kit/texts.h"

#include <QApplication>
#include <QMouseEvent>

#include <algorithm>
#include <cmath>

namespace plc::editor {

using chart::StepId;
using chart::TransitionId;

bool ChartView::dragEvent(QEvent* event) {
    if (event->type() == QEvent::MouseButtonPress) {
        const auto* mouse = static_cast<QMouseEvent*>(event);
        m_dragged = mouse->button() == Qt::LeftButton && m_chart && !m_isStale ? pickedAt(mouse->pos()) : Picked();
        m_pressedAt = mouse->pos();
        m_isDragging = false;
        return false;
    }
    if (event->type() == QEvent::MouseMove && m_dragged.kind != ChartScene::None) {
        const auto* mouse = static_cast<QMouseEvent*>(event);
        if (!(mouse->buttons() & Qt::LeftButton)) return endDrag(false), false;
        if (!m_isDragging && (mouse->pos() - m_pressedAt).manhattanLength() < QApplication::startDragDistance())
            return false;
        m_isDragging = true;
        const Drop drop = dropAt(m_canvas->mapToScene(mouse->pos()));
        const bool good = drop.edits && !drop.edits->empty();
        if (drop.hint.isNull())
            m_scene->dropHint().hide();
        else
            m_scene->dropHint().showAt(drop.hint,
                                       good         ? drop.text
                                       : drop.edits ? QString()
                                                    : kit::messageText(drop.edits.error()),
                                       good);
        m_canvas->viewport()->setCursor(good ? Qt::DragMoveCursor : Qt::ForbiddenCursor);
        return true;
    }
    if (event->type() == QEvent::MouseButtonRelease && m_isDragging) {
        const Drop drop = dropAt(m_canvas->mapToScene(static_cast<QMouseEvent*>(event)->pos()));
        endDrag(false);
        if (!drop.hint.isNull()) request(drop.edits, drop.select);
        return true;
    }
    if (event->type() == QEvent::MouseButtonRelease) m_dragged = {};
    return false;
}

void ChartView::endDrag(bool) {
    m_dragged = {};
    m_isDragging = false;
    if (m_chart) m_scene->dropHint().hide();
    m_canvas->viewport()->unsetCursor();
}

ChartView::Drop ChartView::dropAt(const QPointF& scenePoint) const {
    switch (m_dragged.kind) {
    case ChartScene::Step:
        return dropStep(scenePoint);
    case ChartScene::Transition:
        return dropTransition(scenePoint);
    case ChartScene::Action:
        return dropAction(scenePoint);
    case ChartScene::None:
        return {};
    }
    return {};
}

/// Left or right of the sibling whose column is nearest.
ChartView::Drop ChartView::besideSibling(const std::vector<TransitionId>& siblings, TransitionId moved,
                                         double x) const {
    Drop drop;
    TransitionId best;
    double least = 1e18;
    for (const TransitionId id : siblings) {
        const double distance = std::abs(m_scene->barRect(static_cast<int>(id.value)).center().x() - x);
        if (distance < least) least = distance, best = id;
    }
    if (!best.isValid() || best == moved) return drop;
    const QRectF bar = m_scene->barRect(static_cast<int>(best.value));
    const bool before = m_scene->barRect(static_cast<int>(moved.value)).center().x() > bar.center().x();
    drop.hint = QRectF(before ? bar.left() - 26 : bar.right() + 20, bar.top(), 6, bar.height());
    drop.text = before ? tr("Branch to the left") : tr("Branch to the right");
    drop.edits = editor().moveTransition(moved, before ? chart::Place::Before : chart::Place::After, best);
    return drop;
}

ChartView::Drop ChartView::dropStep(const QPointF& at) const {
    const StepId step(m_dragged.index);
    const chart::Step& moved = (*m_chart)[step];
    Drop drop;
    drop.select = kit::fromView(moved.decl->name.text);
    // behind a transition
    for (size_t i = 0; i < m_chart->transitions.size(); ++i) {
        const QRectF bar = m_scene->barRect(static_cast<int>(i));
        if (!bar.adjusted(-30, 0, 30, 0).contains(at)) continue;
        drop.hint = QRectF(bar.center().x() - kStepLeast / 2, bar.bottom() - 5, kStepLeast, 6);
        drop.text = tr("%1 after this transition").arg(drop.select);
        drop.edits = editor().moveStep(step, TransitionId(i));
        return drop;
    }
    // to another column of its divergence
    if (std::abs(at.x() - m_scene->stepRect(m_dragged.index).center().x()) < 30 || moved.in.size() != 1) return {};
    const chart::Transition& in = (*m_chart)[moved.in.front()];
    if (in.to.size() > 1) {
        size_t own = 0, best = 0;
        double least = 1e18;
        for (size_t k = 0; k < in.to.size(); ++k) {
            if (in.to[k] == step) own = k;
            const double distance = std::abs(m_scene->stepRect(static_cast<int>(in.to[k].value)).center().x() - at.x());
            if (distance < least) least = distance, best = k;
        }
        if (best == own) return {};
        const QRectF box = m_scene->stepRect(static_cast<int>(in.to[best].value));
        drop.hint = QRectF(best < own ? box.left() - 12 : box.right() + 6, box.top() - 8, 6, box.height() + 16);
        drop.text = best < own ? tr("Branch to the left") : tr("Branch to the right");
        drop.edits = editor().moveParallel(moved.in.front(), own, best);
        return drop;
    }
    if (in.from.size() == 1 && (*m_chart)[in.from.front()].out.size() > 1) {
        Drop beside = besideSibling((*m_chart)[in.from.front()].out, moved.in.front(), at.x());
        beside.select = drop.select;
        return beside;
    }
    return {};
}

ChartView::Drop ChartView::dropTransition(const QPointF& at) const {
    const TransitionId id(m_dragged.index);
    const chart::Transition& moved = (*m_chart)[id];
    Drop drop;
    // its end to another step
    for (size_t i = 0; i < m_chart->steps.size(); ++i) {
        if (!m_scene->stepRect(static_cast<int>(i)).adjusted(-4, -4, 4, 4).contains(at)) continue;
        if (moved.to.size() != 1 || moved.to.front() == StepId(i)) return {};
        drop.hint = m_scene->stepRect(static_cast<int>(i)).adjusted(-5, -5, 5, 5);
        drop.text = tr("leads to %1").arg(kit::fromView(m_chart->steps[i].decl->name.text));
        drop.edits = editor().setTarget(id, moved.to.front(), StepId(i));
        return drop;
    }
    if (moved.from.empty() || std::abs(at.x() - m_scene->barRect(m_dragged.index).center().x()) < 30) return {};
    return besideSibling((*m_chart)[moved.from.front()].out, id, at.x());
}

ChartView::Drop ChartView::dropAction(const QPointF& at) const {
    const int from = m_dragged.index, sub = m_dragged.sub;
    const auto& actions = m_chart->steps[static_cast<size_t>(from)].decl->actions;
    Drop drop;
    // within the block
    for (int k = 0; k < static_cast<int>(actions.size()); ++k) {
        const QRectF rect = m_scene->actionRect(from, k);
        if (!rect.contains(at)) continue;
        if (k == sub) return {};
        drop.hint = QRectF(rect.left(), k < sub ? rect.top() - 3 : rect.bottom() - 3, rect.width(), 6);
        drop.text = k < sub ? tr("further up") : tr("further down");
        drop.edits = editor().moveAction(StepId(from), static_cast<size_t>(sub), static_cast<size_t>(k));
        return drop;
    }
    // to another step
    for (size_t i = 0; i < m_chart->steps.size(); ++i) {
        QRectF box = m_scene->stepRect(static_cast<int>(i));
        for (size_t k = 0; k < m_chart->steps[i].decl->actions.size(); ++k)
            box |= m_scene->actionRect(static_cast<int>(i), static_cast<int>(k));
        if (static_cast<int>(i) == from || !box.contains(at)) continue;
        const syntax::ActionAssociation& action = actions[static_cast<size_t>(sub)];
        const std::string time =
            action.time ? m_text.substr(action.time->range.begin, action.time->range.length()) : std::string();
        drop.hint = box.adjusted(-5, -5, 5, 5);
        drop.text = tr("%1 in step %2")
                        .arg(kit::fromView(action.action.text), kit::fromView(m_chart->steps[i].decl->name.text));
        const Result<chart::Edits> gone = editor().deleteAction(StepId(from), static_cast<size_t>(sub));
        const Result<chart::Edits> come =
            editor().insertAction(StepId(i), m_chart->steps[i].decl->actions.size(), action.action.text,
                                  action.qualifier.text.empty() ? "N" : action.qualifier.text, time);
        if (!gone || !come) {
            drop.edits = gone ? come : gone;
            return drop;
        }
        chart::Edits both = *gone;
        both.insert(both.end(), come->begin(), come->end());
        std::sort(both.begin(), both.end(), [](const auto& a, const auto& b) { return a.range.begin < b.range.begin; });
        drop.edits = both;
        return drop;
    }
    return drop;
}

} // namespace plc::editor
