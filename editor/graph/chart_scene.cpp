#include "editor/graph/chart_scene.h"

#include "editor/kit/theme.h"

#include <QFontMetricsF>
#include <QGraphicsItem>
#include <QPainter>
#include <QStyleOptionGraphicsItem>

#include <algorithm>
#include <map>

namespace plc::editor {

namespace {

constexpr double kStepHeight = 40, kStepLeast = 92, kActionHeight = 24, kTransitionRow = 52, kBarRow = 22, kGap = 36;
constexpr double kQualifierWidth = 58, kBarHalf = 15;

QString view(std::string_view text) { return QString::fromUtf8(text.data(), static_cast<int>(text.size())); }
QFont chartFont() {
    QFont font("Noto Sans");
    font.setPointSizeF(9.5);
    return font;
}
double widthOf(const QString& text) { return QFontMetricsF(chartFont()).horizontalAdvance(text); }

QString qualifierOf(const syntax::ActionAssociation& action, std::string_view text) {
    QString out = action.qualifier.text.empty() ? QStringLiteral("N") : view(action.qualifier.text);
    if (action.time) out += " " + view(text.substr(action.time->range.begin, action.time->range.length()));
    return out;
}

} // namespace

/// One item for every part that can be picked: it draws itself from the scene's model.
class ChartItem : public QGraphicsItem {
public:
    ChartItem(ChartScene& scene, ChartScene::ItemKind kind, int index, int sub, const QRectF& rect) : m_scene(scene), m_kind(kind), m_index(index), m_sub(sub), m_rect(rect) {
        setFlag(ItemIsSelectable);
        setData(ChartScene::Kind, kind);
        setData(ChartScene::Index, index);
        setData(ChartScene::Sub, sub);
        setCacheMode(NoCache);
    }
    QRectF boundingRect() const override { return m_rect.adjusted(-4, -4, 4, 4); }
    QPainterPath shape() const override {
        QPainterPath path;
        path.addRect(m_kind == ChartScene::Transition ? m_rect : m_rect.adjusted(-2, -2, 2, 2));
        return path;
    }
    void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override {
        painter->setRenderHint(QPainter::Antialiasing);
        painter->setFont(chartFont());
        switch (m_kind) {
        case ChartScene::Step: return paintStep(*painter);
        case ChartScene::Transition: return paintTransition(*painter);
        case ChartScene::Action: return paintAction(*painter);
        case ChartScene::None: return;
        }
    }

private:
    void paintStep(QPainter& painter) const {
        const kit::ThemeColors& c = kit::colors();
        const syntax::StepDecl& step = *m_scene.m_chart->steps[static_cast<size_t>(m_index)].decl;
        const ChartOnline& online = m_scene.m_online;
        const bool known = online.isOn && m_index < static_cast<int>(online.steps.size());
        const bool active = known && online.steps[static_cast<size_t>(m_index)].isActive;
        QColor fill = c.base;
        if (active) fill = c.dark ? c.good.darker(160) : c.good.lighter(165);
        painter.setBrush(fill);
        const bool problem = m_scene.m_stepProblems.contains(m_index);
        painter.setPen(QPen(problem ? c.bad : isSelected() ? c.accent : active ? c.good : c.text, isSelected() || active || problem ? 2.2 : 1.3));
        painter.drawRect(m_rect);
        if (step.isInitial) painter.drawRect(m_rect.adjusted(3.5, 3.5, -3.5, -3.5));
        painter.setPen(c.text);
        const QString time = active ? online.steps[static_cast<size_t>(m_index)].time : QString();
        QFont bold = chartFont();
        bold.setBold(active);
        painter.setFont(bold);
        painter.drawText(time.isEmpty() ? m_rect : m_rect.adjusted(0, 1, 0, -14), Qt::AlignCenter, view(step.name.text));
        if (!time.isEmpty()) {
            QFont small = chartFont();
            small.setPointSizeF(7.5);
            painter.setFont(small);
            painter.setPen(c.muted);
            painter.drawText(m_rect.adjusted(0, 20, 0, -1), Qt::AlignCenter, time);
        }
        if (active) { // the token
            painter.setPen(Qt::NoPen);
            painter.setBrush(c.good);
            painter.drawEllipse(QPointF(m_rect.left() + 11, m_rect.top() + 11), 4, 4);
        }
    }
    void paintTransition(QPainter& painter) const {
        const kit::ThemeColors& c = kit::colors();
        const ChartOnline& online = m_scene.m_online;
        const auto index = static_cast<size_t>(m_index);
        const bool problem = m_scene.m_transitionProblems.contains(m_index);
        QColor ink = problem ? c.bad : isSelected() ? c.accent : c.text;
        if (online.isOn && index < online.transitions.size() && online.transitions[index]) ink = *online.transitions[index] ? c.good : c.muted;
        const double taken = online.isOn && index < online.taken.size() ? online.taken[index] : 0;
        const double x = m_scene.m_columnMiddles[static_cast<size_t>(m_scene.m_layout.transitions[index].column)], y = m_scene.rowMiddle(m_scene.m_layout.transitions[index].row);
        if (taken > 0) { // the last path, fading
            QColor glow = c.good;
            glow.setAlphaF(0.55 * taken);
            painter.setPen(QPen(glow, 7, Qt::SolidLine, Qt::RoundCap));
            painter.drawLine(QPointF(x, m_rect.top()), QPointF(x, m_rect.bottom()));
        }
        painter.setPen(QPen(c.text, 1.3));
        painter.drawLine(QPointF(x, m_rect.top()), QPointF(x, m_rect.bottom()));
        painter.setPen(QPen(isSelected() ? c.accent : ink, isSelected() ? 4 : 3, Qt::SolidLine, Qt::FlatCap));
        painter.drawLine(QPointF(x - kBarHalf, y), QPointF(x + kBarHalf, y));
        painter.setPen(ink);
        painter.drawText(m_scene.m_conditionRects[index], Qt::AlignVCenter | Qt::AlignLeft, m_scene.conditionText(m_index));
    }
    void paintAction(QPainter& painter) const {
        const kit::ThemeColors& c = kit::colors();
        const syntax::StepDecl& step = *m_scene.m_chart->steps[static_cast<size_t>(m_index)].decl;
        const syntax::ActionAssociation& action = step.actions[static_cast<size_t>(m_sub)];
        const bool active = m_scene.m_online.isOn && m_scene.m_online.actions.value(view(action.action.text).toLower());
        painter.setBrush(active ? (c.dark ? c.good.darker(180) : c.good.lighter(175)) : c.base);
        painter.setPen(QPen(isSelected() ? c.accent : c.text, isSelected() ? 2 : 1));
        painter.drawRect(m_rect);
        const double split = m_rect.left() + std::max(kQualifierWidth * 0.45, widthOf(qualifierOf(action, m_scene.m_text)) + 10);
        painter.drawLine(QPointF(split, m_rect.top()), QPointF(split, m_rect.bottom()));
        painter.setPen(c.text);
        painter.drawText(QRectF(m_rect.left(), m_rect.top(), split - m_rect.left(), m_rect.height()), Qt::AlignCenter, qualifierOf(action, m_scene.m_text));
        painter.drawText(QRectF(split + 5, m_rect.top(), m_rect.right() - split - 6, m_rect.height()), Qt::AlignVCenter | Qt::AlignLeft, view(action.action.text));
    }

    ChartScene& m_scene;
    ChartScene::ItemKind m_kind;
    int m_index, m_sub;
    QRectF m_rect;
};

/// All lines, bars and arrows in one item: they can not be picked and are redrawn together.
class ChartLines : public QGraphicsItem {
public:
    struct Stroke {
        QLineF line;
        double width = 1.3;
    };
    std::vector<Stroke> strokes;
    std::vector<std::pair<QPointF, QString>> arrows;
    QRectF bounds;
    QRectF boundingRect() const override { return bounds; }
    QPainterPath shape() const override { return {}; }
    void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget*) override {
        painter->setRenderHint(QPainter::Antialiasing);
        const QRectF exposed = option->exposedRect;
        for (const Stroke& stroke : strokes) {
            const QRectF box = QRectF(stroke.line.p1(), stroke.line.p2()).normalized().adjusted(-3, -3, 3, 3);
            if (!box.intersects(exposed)) continue;
            painter->setPen(QPen(kit::colors().text, stroke.width));
            painter->drawLine(stroke.line);
        }
        painter->setFont(chartFont());
        for (const auto& [at, target] : arrows) {
            painter->setPen(QPen(kit::colors().text, 1.3));
            painter->setBrush(kit::colors().text);
            const QPointF head[3] = {at, at + QPointF(-5, -9), at + QPointF(5, -9)};
            painter->drawPolygon(head, 3);
            painter->drawText(QRectF(at.x() + 10, at.y() - 16, 200, 18), Qt::AlignVCenter | Qt::AlignLeft, target);
        }
    }
};

ChartScene::ChartScene(QObject* parent) : QGraphicsScene(parent) {}

QString ChartScene::conditionText(int transition) const {
    const syntax::TransitionDecl& decl = *m_chart->transitions[static_cast<size_t>(transition)].decl;
    QString text = decl.name.isValid() ? view(decl.name.text) + ": " : QString();
    if (decl.condition) text += view(m_text.substr(decl.condition->range.begin, decl.condition->range.length())).simplified();
    else if (!decl.ilCondition.empty()) text += QStringLiteral("(IL)");
    return text.size() > 60 ? text.left(58) + "…" : text;
}

void ChartScene::show(const chart::Chart& chart, std::string_view text) {
    m_chart = &chart;
    m_text = text;
    m_layout = chart::computeLayout(chart);
    m_online = {};
    m_stepProblems.clear();
    m_transitionProblems.clear();
    clear();
    measure();
    drawLines();
    for (size_t i = 0; i < chart.transitions.size(); ++i) {
        const double x = m_columnMiddles[static_cast<size_t>(m_layout.transitions[i].column)];
        const int row = m_layout.transitions[i].row;
        const QRectF rect(x - kBarHalf, rowTop(row), std::max(2 * kBarHalf, m_conditionRects[i].right() - x + kBarHalf), m_rowTops[static_cast<size_t>(row) + 1] - rowTop(row));
        addItem(new ChartItem(*this, Transition, static_cast<int>(i), -1, rect));
    }
    for (size_t i = 0; i < chart.steps.size(); ++i) {
        addItem(new ChartItem(*this, Step, static_cast<int>(i), -1, m_stepRects[i]));
        for (size_t k = 0; k < m_actionRects[i].size(); ++k) addItem(new ChartItem(*this, Action, static_cast<int>(i), static_cast<int>(k), m_actionRects[i][k]));
    }
    setSceneRect(itemsBoundingRect().adjusted(-30, -30, 30, 30));
}

void ChartScene::measure() {
    const auto& steps = m_chart->steps;
    const int rows = std::max(1, m_layout.rows), columns = std::max(1, m_layout.columns);
    std::vector<double> heights(static_cast<size_t>(rows), kBarRow), left(static_cast<size_t>(columns), kStepLeast / 2), right(static_cast<size_t>(columns), kStepLeast / 2);
    const auto grow = [](double& value, double wanted) { value = std::max(value, wanted); };
    std::vector<double> boxWidths(steps.size()), actionWidths(steps.size());
    for (size_t i = 0; i < steps.size(); ++i) {
        const chart::Cell cell = m_layout.steps[i];
        const syntax::StepDecl& step = *steps[i].decl;
        boxWidths[i] = std::max(kStepLeast, widthOf(view(step.name.text)) + 28);
        for (const syntax::ActionAssociation& action : step.actions)
            grow(actionWidths[i], std::max(kQualifierWidth * 0.45, widthOf(qualifierOf(action, m_text)) + 10) + widthOf(view(action.action.text)) + 16);
        grow(heights[static_cast<size_t>(cell.row)], std::max(kStepHeight, kActionHeight * static_cast<double>(step.actions.size())) + 14);
        grow(left[static_cast<size_t>(cell.column)], boxWidths[i] / 2);
        grow(right[static_cast<size_t>(cell.column)], boxWidths[i] / 2 + (actionWidths[i] > 0 ? 18 + actionWidths[i] : 0));
    }
    for (size_t i = 0; i < m_chart->transitions.size(); ++i) {
        const chart::Cell cell = m_layout.transitions[i];
        grow(heights[static_cast<size_t>(cell.row)], kTransitionRow);
        grow(right[static_cast<size_t>(cell.column)], kBarHalf + 8 + widthOf(conditionText(static_cast<int>(i))));
    }
    for (const chart::Jump& jump : m_layout.jumps) {
        grow(heights[static_cast<size_t>(jump.at.row)], 30);
        if (jump.target.isValid()) grow(right[static_cast<size_t>(jump.at.column)], 14 + widthOf(view((*m_chart)[jump.target].decl->name.text)));
    }
    m_rowTops.assign(1, 0);
    for (const double height : heights) m_rowTops.push_back(m_rowTops.back() + height);
    m_columnMiddles.clear();
    double x = 0;
    for (size_t column = 0; column < left.size(); ++column) {
        m_columnMiddles.push_back(x + left[column]);
        x += left[column] + right[column] + kGap;
    }
    m_stepRects.clear();
    m_actionRects.clear();
    m_conditionRects.clear();
    for (size_t i = 0; i < steps.size(); ++i) {
        const double middle = m_columnMiddles[static_cast<size_t>(m_layout.steps[i].column)], y = rowMiddle(m_layout.steps[i].row);
        m_stepRects.emplace_back(middle - boxWidths[i] / 2, y - kStepHeight / 2, boxWidths[i], kStepHeight);
        std::vector<QRectF> rects;
        const double top = y - kActionHeight * static_cast<double>(steps[i].decl->actions.size()) / 2;
        for (size_t k = 0; k < steps[i].decl->actions.size(); ++k)
            rects.emplace_back(m_stepRects[i].right() + 18, top + kActionHeight * static_cast<double>(k), actionWidths[i], kActionHeight);
        m_actionRects.push_back(std::move(rects));
    }
    for (size_t i = 0; i < m_chart->transitions.size(); ++i) {
        const double middle = m_columnMiddles[static_cast<size_t>(m_layout.transitions[i].column)], y = rowMiddle(m_layout.transitions[i].row);
        m_conditionRects.emplace_back(middle + kBarHalf + 6, y - 11, std::max(40.0, widthOf(conditionText(static_cast<int>(i))) + 6), 22);
    }
}

double ChartScene::lowerEdge(int column, int row) const {
    for (size_t i = 0; i < m_layout.steps.size(); ++i)
        if (m_layout.steps[i] == chart::Cell{column, row}) return m_stepRects[i].bottom();
    for (const chart::Cell& cell : m_layout.transitions)
        if (cell == chart::Cell{column, row}) return m_rowTops[static_cast<size_t>(row) + 1];
    return rowMiddle(row);
}

double ChartScene::upperEdge(int column, int row) const {
    for (size_t i = 0; i < m_layout.steps.size(); ++i)
        if (m_layout.steps[i] == chart::Cell{column, row}) return m_stepRects[i].top();
    for (const chart::Cell& cell : m_layout.transitions)
        if (cell == chart::Cell{column, row}) return rowTop(row);
    for (const chart::Jump& jump : m_layout.jumps)
        if (jump.at == chart::Cell{column, row}) return m_rowTops[static_cast<size_t>(row) + 1] - 8;
    return rowMiddle(row);
}

void ChartScene::drawLines() {
    auto* lines = new ChartLines;
    const auto stroke = [&](QPointF from, QPointF to, double width = 1.3) { lines->strokes.push_back({QLineF(from, to), width}); };
    for (const chart::Line& line : m_layout.lines) {
        const double x = m_columnMiddles[static_cast<size_t>(line.column)];
        stroke({x, lowerEdge(line.column, line.fromRow)}, {x, upperEdge(line.column, line.toRow)});
    }
    for (const chart::Bar& bar : m_layout.bars) {
        const double from = m_columnMiddles[static_cast<size_t>(bar.firstColumn)], to = m_columnMiddles[static_cast<size_t>(bar.lastColumn)], y = rowMiddle(bar.row);
        const bool simultaneous = bar.kind == chart::BarKind::SimultaneousOpen || bar.kind == chart::BarKind::SimultaneousClose;
        if (simultaneous) {
            stroke({from - 26, y - 2.2}, {to + 26, y - 2.2}, 1.4);
            stroke({from - 26, y + 2.2}, {to + 26, y + 2.2}, 1.4);
        } else {
            stroke({from, y}, {to, y});
        }
    }
    for (const chart::Jump& jump : m_layout.jumps) {
        const double x = m_columnMiddles[static_cast<size_t>(jump.at.column)], tip = m_rowTops[static_cast<size_t>(jump.at.row) + 1] - 2;
        stroke({x, rowTop(jump.at.row)}, {x, tip - 8});
        lines->arrows.emplace_back(QPointF(x, tip), jump.target.isValid() ? view((*m_chart)[jump.target].decl->name.text) : QString());
    }
    for (const chart::Link& link : m_layout.links) {
        const QPointF from(m_stepRects[link.step.index()].center().x(), m_stepRects[link.step.index()].bottom());
        const QRectF to = m_conditionRects[link.join.index()];
        stroke(from, {to.left() - kBarHalf, to.top() - 12});
    }
    for (size_t i = 0; i < m_stepRects.size(); ++i)
        if (!m_actionRects[i].empty()) stroke({m_stepRects[i].right(), m_stepRects[i].center().y()}, {m_actionRects[i].front().left(), m_stepRects[i].center().y()});
    lines->bounds = QRectF(-60, -20, (m_columnMiddles.empty() ? 0 : m_columnMiddles.back()) + 400, m_rowTops.back() + 40);
    lines->setFlag(QGraphicsItem::ItemUsesExtendedStyleOption);
    lines->setZValue(-1);
    addItem(lines);
}

void ChartScene::showMessages(const std::vector<ChartMessage>& messages) {
    m_stepProblems.clear();
    m_transitionProblems.clear();
    if (!m_chart) return;
    const auto inside = [](SourceRange outer, SourceRange inner) { return inner.begin >= outer.begin && inner.begin <= outer.end; };
    for (const ChartMessage& message : messages) {
        if (!message.isError) continue;
        for (size_t i = 0; i < m_chart->steps.size(); ++i)
            if (inside(m_chart->steps[i].decl->range, message.range)) m_stepProblems[static_cast<int>(i)] = message.text;
        for (size_t i = 0; i < m_chart->transitions.size(); ++i)
            if (inside(m_chart->transitions[i].decl->range, message.range)) m_transitionProblems[static_cast<int>(i)] = message.text;
    }
    for (QGraphicsItem* item : items()) {
        const int index = item->data(Index).toInt();
        if (item->data(Kind).toInt() == Step) item->setToolTip(m_stepProblems.value(index));
        if (item->data(Kind).toInt() == Transition) item->setToolTip(m_transitionProblems.value(index));
    }
    update();
}

void ChartScene::setOnline(ChartOnline online) {
    m_online = std::move(online);
    update();
}

QGraphicsItem* ChartScene::itemOf(ItemKind kind, int index) const {
    for (QGraphicsItem* item : items())
        if (item->data(Kind).toInt() == kind && item->data(Index).toInt() == index) return item;
    return nullptr;
}

void ChartScene::refreshTheme() { update(); }

} // namespace plc::editor
