#include "editor/graph/chart/chart_items.h"

#include "editor/kit/texts.h"
#include "editor/kit/theme.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QStyleOptionGraphicsItem>

#include <algorithm>

namespace plc::editor {

namespace {
QColor faded(const QColor& colour, double alpha) {
    QColor out = colour;
    out.setAlphaF(alpha);
    return out;
}
/// The ground of what is active: the signal colour thinned by the ground behind it.
QColor litGround() {
    const kit::ThemeColors& c = kit::colors();
    const double share = c.dark ? 0.32 : 0.24;
    return QColor::fromRgbF(c.good.redF() * share + c.base.redF() * (1 - share),
                            c.good.greenF() * share + c.base.greenF() * (1 - share),
                            c.good.blueF() * share + c.base.blueF() * (1 - share));
}
} // namespace

namespace {
QColor colourOf(const CoverageMark& coverage) {
    const kit::ThemeColors& c = kit::colors();
    switch (coverage.state) {
    case CoverageMark::State::Run:
        return c.good;
    case CoverageMark::State::Partly:
        return c.warning;
    case CoverageMark::State::NotRun:
        return c.bad;
    }
    return c.muted;
}
/// As in the margin of a text: a strip of the colour; nothing where nothing is known.
template <class Marks, class Key>
void paintCoverage(QPainter& painter, const Marks& marks, const Key& key, const QRectF& strip) {
    if (const auto mark = marks.find(key); mark != marks.end()) painter.fillRect(strip, colourOf(*mark));
}
} // namespace

const QFont& chartFont() {
    static const QFont font = [] {
        QFont f("Noto Sans");
        f.setPointSizeF(9.5);
        return f;
    }();
    return font;
}

double widthOf(const QString& text) {
    static const QFontMetricsF metrics(chartFont());
    return metrics.horizontalAdvance(text);
}

QString qualifierOf(const syntax::ActionAssociation& action, std::string_view text) {
    QString out = action.qualifier.text.empty() ? QStringLiteral("N") : kit::fromView(action.qualifier.text);
    if (action.time) out += " " + kit::fromView(text.substr(action.time->range.begin, action.time->range.length()));
    return out;
}

QString indicatorsOf(const syntax::ActionAssociation& action) {
    QStringList out;
    for (const syntax::Name& name : action.indicators) out << kit::fromView(name.text);
    return out.join(", ");
}

double qualifierWidth(const QString& qualifier) { return std::max(kQualifierLeast, widthOf(qualifier) + 12); }

// ------------------------------------------------------------------ parts

ChartItem::ChartItem(ChartScene& scene, ChartScene::ItemKind kind, int index, int sub, const QRectF& rect)
    : m_scene(scene), m_kind(kind), m_index(index), m_sub(sub), m_rect(rect) {
    setFlag(ItemIsSelectable);
    setData(ChartScene::Kind, kind);
    setData(ChartScene::Index, index);
    setData(ChartScene::Sub, sub);
}

QPainterPath ChartItem::shape() const {
    QPainterPath path;
    path.addRect(m_kind == ChartScene::Transition ? m_rect : m_rect.adjusted(-2, -2, 2, 2));
    return path;
}

void ChartItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
    const bool isSmall = QStyleOptionGraphicsItem::levelOfDetailFromTransform(painter->worldTransform()) < 0.3;
    painter->setRenderHint(QPainter::Antialiasing, !isSmall);
    if (m_scene.m_isFaint) painter->setOpacity(0.5);
    painter->setFont(chartFont());
    switch (m_kind) {
    case ChartScene::Step:
        return paintStep(*painter, isSmall);
    case ChartScene::Transition:
        return paintTransition(*painter, isSmall);
    case ChartScene::Action:
        return paintAction(*painter, isSmall);
    case ChartScene::None:
        return;
    }
}

void ChartItem::paintBreakpoint(QPainter& painter, QPointF at, const QHash<int, bool>& marks) const {
    const auto mark = marks.find(m_index);
    if (mark == marks.end()) return;
    const kit::ThemeColors& c = kit::colors();
    painter.setPen(QPen(c.breakpoint, 1.5));
    painter.setBrush(*mark ? QBrush(c.breakpoint) : QBrush(c.base));
    painter.drawEllipse(at, 4.5, 4.5);
}

void ChartItem::paintStep(QPainter& painter, bool isSmall) const {
    const kit::ThemeColors& c = kit::colors();
    const auto index = static_cast<size_t>(m_index);
    const syntax::StepDecl& step = *m_scene.m_chart->steps[index].decl;
    const ChartOnline& online = m_scene.m_online;
    const bool known = online.isOn && index < online.steps.size();
    const ChartOnline::StepState state = known ? online.steps[index] : ChartOnline::StepState();
    const auto problem = m_scene.m_stepProblems.find(m_index);
    const QColor frame = problem != m_scene.m_stepProblems.end() ? (problem->isError ? c.bad : c.warning)
                         : isSelected()                          ? c.accent
                         : state.isLate                          ? c.warning
                         : state.isActive                        ? c.good
                                                                 : c.text;
    const bool strong = isSelected() || state.isActive || problem != m_scene.m_stepProblems.end();
    painter.setBrush(state.isActive ? litGround() : c.base);
    painter.setPen(QPen(frame, strong ? 2 : 1.3, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
    painter.drawRect(m_rect);
    if (step.isInitial) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(frame, 1.2, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
        painter.drawRect(m_rect.adjusted(4, 4, -4, -4));
    }
    paintCoverage(painter, m_scene.m_coverage.steps, m_index,
                  {m_rect.left() + 1, m_rect.top() + 1, kCoverageStrip, m_rect.height() - 2});
    if (isSmall) return;
    painter.setPen(c.text);
    if (state.isActive) {
        QFont bold = chartFont();
        bold.setBold(true);
        painter.setFont(bold);
    }
    painter.drawText(state.time.isEmpty() ? m_rect : m_rect.adjusted(0, 2, 0, -14), Qt::AlignCenter,
                     kit::fromView(step.name.text));
    if (!state.time.isEmpty()) {
        QFont small = chartFont();
        small.setPointSizeF(7.5);
        painter.setFont(small);
        painter.setPen(state.isLate ? c.warning : c.muted);
        painter.drawText(m_rect.adjusted(0, 19, 0, -4), Qt::AlignCenter, state.time);
    }
    if (state.isForced) {
        QFont small = chartFont();
        small.setPointSizeF(7);
        small.setBold(true);
        painter.setFont(small);
        const QRectF tag(m_rect.right() - 9, m_rect.top() - 6, 13, 13);
        painter.setPen(Qt::NoPen);
        painter.setBrush(c.forced);
        painter.drawRoundedRect(tag, 3, 3);
        painter.setPen(c.base);
        painter.drawText(tag, Qt::AlignCenter, QStringLiteral("F"));
    }
    paintBreakpoint(painter, {m_rect.left() - 9, m_rect.center().y()}, m_scene.m_marks.steps);
}

void ChartItem::paintTransition(QPainter& painter, bool isSmall) const {
    const kit::ThemeColors& c = kit::colors();
    const ChartOnline& online = m_scene.m_online;
    const auto index = static_cast<size_t>(m_index);
    const auto problem = m_scene.m_transitionProblems.find(m_index);
    QColor ink = c.text;
    if (online.isOn && index < online.transitions.size() && online.transitions[index])
        ink = *online.transitions[index] ? c.good : c.muted;
    if (problem != m_scene.m_transitionProblems.end()) ink = problem->isError ? c.bad : c.warning;
    const chart::Cell cell = m_scene.m_layout.transitions[index];
    const double x = m_scene.m_columnMiddles[static_cast<size_t>(cell.column)], y = m_scene.rowMiddle(cell.row);
    const double taken = online.isOn && index < online.taken.size() ? online.taken[index] : 0;
    if (taken > 0) { // the last path, fading
        painter.setPen(QPen(faded(c.good, 0.6 * taken), 8, Qt::SolidLine, Qt::FlatCap));
        painter.drawLine(QPointF(x, m_rect.top()), QPointF(x, m_rect.bottom()));
    }
    painter.setPen(QPen(c.text, 1.3, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(QPointF(x, m_rect.top()), QPointF(x, m_rect.bottom()));
    painter.setPen(QPen(isSelected() ? c.accent : ink, isSelected() ? 4 : 3, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(QPointF(x - kBarHalf, y), QPointF(x + kBarHalf, y));
    paintCoverage(painter, m_scene.m_coverage.transitions, m_index,
                  {x - kBarHalf, y + 2.5, 2 * kBarHalf, kCoverageStrip});
    if (isSmall) return;
    const syntax::TransitionDecl& decl = *m_scene.m_chart->transitions[index].decl;
    if (decl.priority) { // at the left, as the standard puts it
        QFont small = chartFont();
        small.setPointSizeF(7.5);
        painter.setFont(small);
        painter.setPen(c.muted);
        painter.drawText(
            QRectF(x - kBarHalf - 34, y - 16, 30, 14), Qt::AlignRight | Qt::AlignVCenter,
            kit::fromView(m_scene.m_text.substr(decl.priority->range.begin, decl.priority->range.length())));
        painter.setFont(chartFont());
    }
    painter.setPen(isSelected() ? c.accent : ink);
    const QStringList lines = m_scene.conditionText(m_index).split('\n');
    const QRectF place = m_scene.m_conditionRects[index];
    for (int k = 0; k < lines.size(); ++k) // tighter than the font would have it: they belong together
        painter.drawText(QRectF(place.left(), y + 15.0 * (k - (static_cast<double>(lines.size()) - 1) / 2) - 12,
                                place.width() + 4, 24),
                         Qt::AlignVCenter | Qt::AlignLeft, lines[k]);
    paintBreakpoint(painter, {x - kBarHalf - 9, y}, m_scene.m_marks.transitions);
}

void ChartItem::paintAction(QPainter& painter, bool isSmall) const {
    const kit::ThemeColors& c = kit::colors();
    const auto index = static_cast<size_t>(m_index), sub = static_cast<size_t>(m_sub);
    const syntax::ActionAssociation& action = m_scene.m_chart->steps[index].decl->actions[sub];
    ChartOnline::ActionState state;
    if (m_scene.m_online.isOn && index < m_scene.m_online.associations.size() &&
        sub < m_scene.m_online.associations[index].size())
        state = m_scene.m_online.associations[index][sub];
    const QString qualifier = qualifierOf(action, m_scene.m_text), indicators = indicatorsOf(action);
    const double split = m_rect.left() + qualifierWidth(qualifier);
    const double last = indicators.isEmpty() ? m_rect.right() : m_rect.right() - widthOf(indicators) - kIndicatorPad;
    const QRectF left(m_rect.left(), m_rect.top(), split - m_rect.left(), m_rect.height()),
        middle(split, m_rect.top(), last - split, m_rect.height());
    painter.setPen(Qt::NoPen);
    painter.setBrush(c.base);
    painter.drawRect(m_rect);
    if (state.isActive) painter.fillRect(middle, litGround());
    if (state.asks) painter.fillRect(left, litGround());
    if (state.progress >= 0) { // how far the time of the qualifier has gone
        painter.fillRect(
            QRectF(left.left(), left.bottom() - 3.5, left.width() * std::clamp(state.progress, 0.0, 1.0), 3.5),
            state.progress < 1 ? c.online : c.good);
    }
    paintCoverage(painter, m_scene.m_coverage.actions, QPair<int, int>(m_index, m_sub),
                  {m_rect.right() - kCoverageStrip, m_rect.top() + 1, kCoverageStrip, m_rect.height() - 2});
    painter.setBrush(Qt::NoBrush);
    const bool problem = m_scene.m_actionProblems.contains({m_index, m_sub});
    painter.setPen(QPen(problem        ? c.bad
                        : isSelected() ? c.accent
                                       : c.text,
                        isSelected() || problem ? 2 : 1.2, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
    painter.drawRect(m_rect);
    painter.drawLine(QPointF(split, m_rect.top()), QPointF(split, m_rect.bottom()));
    if (!indicators.isEmpty()) painter.drawLine(QPointF(last, m_rect.top()), QPointF(last, m_rect.bottom()));
    if (isSmall) return;
    painter.setPen(c.text);
    painter.drawText(left, Qt::AlignCenter, qualifier);
    const bool isChart = m_scene.m_charts.contains(kit::fromView(action.action.text).toLower());
    painter.drawText(middle.adjusted(6, 0, isChart ? -14 : -2, 0), Qt::AlignVCenter | Qt::AlignLeft,
                     kit::fromView(action.action.text));
    if (isChart) { // a chart of its own inside
        const QPointF at(middle.right() - 9, middle.center().y());
        painter.setPen(QPen(c.muted, 1.1));
        painter.drawRect(QRectF(at.x() - 3.5, at.y() - 7, 7, 5));
        painter.drawLine(at + QPointF(0, -2), at + QPointF(0, 2));
        painter.drawRect(QRectF(at.x() - 3.5, at.y() + 2, 7, 5));
        painter.setPen(c.text);
    }
    if (!indicators.isEmpty())
        painter.drawText(QRectF(last, m_rect.top(), m_rect.right() - last, m_rect.height()), Qt::AlignCenter,
                         indicators);
}

// ------------------------------------------------------------------ lines

void ChartLines::finish() {
    m_bounds = {};
    for (const Stroke& stroke : strokes)
        m_bounds |= QRectF(stroke.line.p1(), stroke.line.p2()).normalized().adjusted(-4, -4, 4, 4);
    for (const Arrow& arrow : arrows)
        m_bounds |= QRectF(arrow.tip.x() - 6, arrow.tip.y() - 18, 20 + widthOf(arrow.target), 22);
    std::sort(strokes.begin(), strokes.end(), [](const Stroke& a, const Stroke& b) {
        return std::min(a.line.y1(), a.line.y2()) < std::min(b.line.y1(), b.line.y2());
    });
    for (const Stroke& stroke : strokes) m_longest = std::max(m_longest, std::abs(stroke.line.dy()));
    std::sort(arrows.begin(), arrows.end(), [](const Arrow& a, const Arrow& b) { return a.tip.y() < b.tip.y(); });
    setFlag(ItemUsesExtendedStyleOption);
    setZValue(-1);
}

void ChartLines::paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget*) {
    const bool isSmall = QStyleOptionGraphicsItem::levelOfDetailFromTransform(painter->worldTransform()) < 0.3;
    painter->setRenderHint(QPainter::Antialiasing, !isSmall);
    if (isFaint) painter->setOpacity(0.5);
    const QRectF exposed = option->exposedRect;
    const QColor ink = kit::colors().text;
    const auto upper = [](const Stroke& stroke) { return std::min(stroke.line.y1(), stroke.line.y2()); };
    auto stroke = std::lower_bound(strokes.begin(), strokes.end(), exposed.top() - m_longest - 4,
                                   [&](const Stroke& s, double y) { return upper(s) < y; });
    for (; stroke != strokes.end() && upper(*stroke) <= exposed.bottom() + 4; ++stroke) {
        painter->setPen(QPen(ink, stroke->width, Qt::SolidLine, stroke->line.dx() == 0 ? Qt::FlatCap : Qt::SquareCap));
        painter->drawLine(stroke->line);
    }
    painter->setFont(chartFont());
    auto arrow = std::lower_bound(arrows.begin(), arrows.end(), exposed.top() - 24,
                                  [](const Arrow& a, double y) { return a.tip.y() < y; });
    for (; arrow != arrows.end() && arrow->tip.y() <= exposed.bottom() + 24; ++arrow) {
        painter->setPen(QPen(ink, 1));
        painter->setBrush(ink);
        const QPointF head[3] = {arrow->tip, arrow->tip + QPointF(-5, -9), arrow->tip + QPointF(5, -9)};
        painter->drawPolygon(head, 3);
        if (!isSmall)
            painter->drawText(QRectF(arrow->tip.x() + 10, arrow->tip.y() - 16, 400, 18),
                              Qt::AlignVCenter | Qt::AlignLeft, arrow->target);
    }
}

// ------------------------------------------------------------------ dragging

ChartDropHint::ChartDropHint() {
    setZValue(10);
    setAcceptedMouseButtons(Qt::NoButton);
    hide();
}

void ChartDropHint::showAt(const QRectF& rect, const QString& text, bool isAllowed) {
    prepareGeometryChange();
    m_rect = rect;
    m_text = text;
    m_isAllowed = isAllowed;
    show();
    update();
}

void ChartDropHint::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
    const kit::ThemeColors& c = kit::colors();
    const QColor ink = m_isAllowed ? c.accent : c.muted;
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setPen(QPen(ink, 2, m_isAllowed ? Qt::SolidLine : Qt::DashLine));
    painter->setBrush(faded(ink, 0.25));
    painter->drawRoundedRect(m_rect, 2, 2);
    if (m_text.isEmpty()) return;
    painter->setFont(chartFont());
    const QRectF label(m_rect.left(), m_rect.bottom() + 4, widthOf(m_text) + 14, 20);
    painter->setPen(QPen(c.border, 1));
    painter->setBrush(c.raised);
    painter->drawRoundedRect(label, 3, 3);
    painter->setPen(c.text);
    painter->drawText(label, Qt::AlignCenter, m_text);
}

} // namespace plc::editor
