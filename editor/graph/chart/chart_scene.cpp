#include "editor/graph/chart/chart_scene.h"

#include "editor/graph/chart/chart_items.h"
#include "editor/kit/texts.h"
#include "editor/kit/theme.h"

#include <algorithm>

namespace plc::editor {

namespace {
enum CellKind { StepCell, TransitionCell, JumpCell, DoubleBarCell };
constexpr int kConditionColumns = 38, kConditionLines = 3;

/// A long condition in lines, so that branches stay near each other; what is too long even so is cut.
QString wrapped(const QString& text) {
    if (text.size() <= kConditionColumns) return text;
    QStringList lines{QString()};
    for (const QString& word : text.split(' ')) {
        if (!lines.last().isEmpty() && lines.last().size() + 1 + word.size() > kConditionColumns) lines << QString();
        lines.last() += (lines.last().isEmpty() ? "" : " ") + word;
    }
    for (QString& line : lines)
        if (line.size() > 60) line = line.left(58) + QChar(0x2026); // one long name
    if (lines.size() <= kConditionLines) return lines.join('\n');
    lines = lines.mid(0, kConditionLines);
    lines.last() += QChar(0x2026);
    return lines.join('\n');
}
double widthOfLines(const QString& text) {
    double width = 0;
    for (const QString& line : text.split('\n')) width = std::max(width, widthOf(line));
    return width;
}
constexpr double kDoubleHalf = 2.5; // half of what lies between the lines of a simultaneous bar
} // namespace

ChartScene::ChartScene(QObject* parent) : QGraphicsScene(parent) {}

QString ChartScene::makeConditionText(int transition) const {
    const syntax::TransitionDecl& decl = *m_chart->transitions[static_cast<size_t>(transition)].decl;
    QString text = decl.name.isValid() ? kit::fromView(decl.name.text) + ": " : QString();
    const auto slice = [&](SourceRange range) {
        return kit::fromView(m_text.substr(range.begin, range.length())).simplified();
    };
    if (decl.condition) text += slice(decl.condition->range);
    QStringList lines;
    for (const syntax::Stmt* instruction : decl.ilCondition) lines << slice(instruction->range);
    text += lines.join(" · ");
    return wrapped(text);
}

QString ChartScene::conditionText(int transition) const { return m_conditions[static_cast<size_t>(transition)]; }

void ChartScene::forget() {
    m_chart = nullptr;
    m_hint = nullptr;
    m_lines = nullptr;
    m_stepItems.clear();
    m_transitionItems.clear();
    m_actionItems.clear();
    clear();
}

void ChartScene::show(const chart::Chart& chart, std::string_view text, const QSet<QString>& charts) {
    forget();
    m_chart = &chart;
    m_text = text;
    m_charts = charts;
    m_layout = chart::computeLayout(chart);
    m_online = {};
    m_isFaint = false;
    m_stepProblems.clear();
    m_transitionProblems.clear();
    m_actionProblems.clear();
    m_conditions.clear();
    for (size_t i = 0; i < chart.transitions.size(); ++i)
        m_conditions.push_back(makeConditionText(static_cast<int>(i)));
    measure();
    indexCells();
    drawLines();
    const auto add = [&](ItemKind kind, size_t index, int sub, const QRectF& rect) {
        auto* item = new ChartItem(*this, kind, static_cast<int>(index), sub, rect);
        addItem(item);
        return item;
    };
    for (size_t i = 0; i < chart.transitions.size(); ++i) {
        const double x = m_columnMiddles[static_cast<size_t>(m_layout.transitions[i].column)];
        const int row = m_layout.transitions[i].row;
        const QRectF rect(x - kBarHalf, rowTop(row), std::max(2 * kBarHalf, m_conditionRects[i].right() - x + kBarHalf),
                          m_rowTops[static_cast<size_t>(row) + 1] - rowTop(row));
        m_transitionItems.push_back(add(Transition, i, -1, rect));
    }
    for (size_t i = 0; i < chart.steps.size(); ++i) {
        m_stepItems.push_back(add(Step, i, -1, m_stepRects[i]));
        m_actionItems.emplace_back();
        for (size_t k = 0; k < m_actionRects[i].size(); ++k)
            m_actionItems.back().push_back(add(Action, i, static_cast<int>(k), m_actionRects[i][k]));
    }
    setSceneRect(itemsBoundingRect().adjusted(-30, -30, 30, 30));
}

void ChartScene::measure() {
    const auto& steps = m_chart->steps;
    const int rows = std::max(1, m_layout.rows), columns = std::max(1, m_layout.columns);
    std::vector<double> heights(static_cast<size_t>(rows), kBarRow), left(static_cast<size_t>(columns), kStepLeast / 2),
        right(static_cast<size_t>(columns), kStepLeast / 2);
    const auto grow = [](double& value, double wanted) { value = std::max(value, wanted); };
    std::vector<double> boxWidths(steps.size()), actionWidths(steps.size());
    for (size_t i = 0; i < steps.size(); ++i) {
        const chart::Cell cell = m_layout.steps[i];
        const syntax::StepDecl& step = *steps[i].decl;
        boxWidths[i] = std::max(kStepLeast, widthOf(kit::fromView(step.name.text)) + 28);
        double name = 0, mark = 0, qualifier = 0, indicator = 0; // a block's cells stand under each other
        for (const syntax::ActionAssociation& action : step.actions) {
            grow(qualifier, qualifierWidth(qualifierOf(action, m_text)));
            grow(name, widthOf(kit::fromView(action.action.text)) + 14);
            if (m_charts.contains(kit::fromView(action.action.text).toLower())) grow(mark, 14);
            if (const QString indicators = indicatorsOf(action); !indicators.isEmpty())
                grow(indicator, widthOf(indicators) + kIndicatorPad);
        }
        if (!step.actions.empty()) actionWidths[i] = qualifier + name + mark + indicator;
        grow(heights[static_cast<size_t>(cell.row)],
             std::max(kStepHeight, kActionHeight * static_cast<double>(step.actions.size())) + 14);
        grow(left[static_cast<size_t>(cell.column)], boxWidths[i] / 2);
        grow(right[static_cast<size_t>(cell.column)],
             boxWidths[i] / 2 + (actionWidths[i] > 0 ? kActionGap + actionWidths[i] : 0));
    }
    for (size_t i = 0; i < m_chart->transitions.size(); ++i) {
        const chart::Cell cell = m_layout.transitions[i];
        grow(heights[static_cast<size_t>(cell.row)], kTransitionRow);
        grow(right[static_cast<size_t>(cell.column)], kBarHalf + 8 + widthOfLines(m_conditions[i]));
    }
    for (const chart::Jump& jump : m_layout.jumps) {
        grow(heights[static_cast<size_t>(jump.at.row)], 30);
        if (jump.target.isValid())
            grow(right[static_cast<size_t>(jump.at.column)],
                 14 + widthOf(kit::fromView((*m_chart)[jump.target].decl->name.text)));
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
        const double middle = m_columnMiddles[static_cast<size_t>(m_layout.steps[i].column)],
                     y = rowMiddle(m_layout.steps[i].row);
        m_stepRects.emplace_back(middle - boxWidths[i] / 2, y - kStepHeight / 2, boxWidths[i], kStepHeight);
        std::vector<QRectF> rects;
        const double top = y - kActionHeight * static_cast<double>(steps[i].decl->actions.size()) / 2;
        for (size_t k = 0; k < steps[i].decl->actions.size(); ++k)
            rects.emplace_back(m_stepRects[i].right() + kActionGap, top + kActionHeight * static_cast<double>(k),
                               actionWidths[i], kActionHeight);
        m_actionRects.push_back(std::move(rects));
    }
    for (size_t i = 0; i < m_chart->transitions.size(); ++i) {
        const double middle = m_columnMiddles[static_cast<size_t>(m_layout.transitions[i].column)],
                     y = rowMiddle(m_layout.transitions[i].row);
        const double half = 4 + 7.5 * static_cast<double>(m_conditions[i].count('\n') + 1);
        m_conditionRects.emplace_back(middle + kBarHalf + 6, y - half,
                                      std::max(40.0, widthOfLines(m_conditions[i]) + 6), 2 * half);
    }
}

void ChartScene::indexCells() {
    m_cells.clear();
    for (const chart::Bar& bar : m_layout.bars)
        if (bar.kind == chart::BarKind::SimultaneousOpen || bar.kind == chart::BarKind::SimultaneousClose)
            for (int column = bar.firstColumn; column <= bar.lastColumn; ++column)
                m_cells[{column, bar.row}] = {DoubleBarCell, 0};
    for (size_t i = 0; i < m_layout.jumps.size(); ++i)
        m_cells[{m_layout.jumps[i].at.column, m_layout.jumps[i].at.row}] = {JumpCell, static_cast<int>(i)};
    for (size_t i = 0; i < m_layout.transitions.size(); ++i)
        m_cells[{m_layout.transitions[i].column, m_layout.transitions[i].row}] = {TransitionCell, static_cast<int>(i)};
    for (size_t i = 0; i < m_layout.steps.size(); ++i)
        m_cells[{m_layout.steps[i].column, m_layout.steps[i].row}] = {StepCell, static_cast<int>(i)};
}

double ChartScene::lowerEdge(int column, int row) const {
    const auto cell = m_cells.find({column, row});
    if (cell != m_cells.end() && cell->first == StepCell)
        return m_stepRects[static_cast<size_t>(cell->second)].bottom();
    if (cell != m_cells.end() && cell->first == TransitionCell) return m_rowTops[static_cast<size_t>(row) + 1];
    if (cell != m_cells.end() && cell->first == DoubleBarCell) return rowMiddle(row) + kDoubleHalf;
    return rowMiddle(row);
}

double ChartScene::upperEdge(int column, int row) const {
    const auto cell = m_cells.find({column, row});
    if (cell == m_cells.end()) return rowMiddle(row);
    if (cell->first == StepCell) return m_stepRects[static_cast<size_t>(cell->second)].top();
    if (cell->first == TransitionCell) return rowTop(row);
    if (cell->first == DoubleBarCell) return rowMiddle(row) - kDoubleHalf;
    return m_rowTops[static_cast<size_t>(row) + 1] - 8;
}

void ChartScene::drawLines() {
    auto* lines = new ChartLines;
    const auto stroke = [&](QPointF from, QPointF to, double width = 1.3) {
        lines->strokes.push_back({QLineF(from, to), width});
    };
    for (const chart::Line& line : m_layout.lines) {
        const double x = m_columnMiddles[static_cast<size_t>(line.column)];
        stroke({x, lowerEdge(line.column, line.fromRow)}, {x, upperEdge(line.column, line.toRow)});
    }
    for (const chart::Bar& bar : m_layout.bars) {
        const double from = m_columnMiddles[static_cast<size_t>(bar.firstColumn)],
                     to = m_columnMiddles[static_cast<size_t>(bar.lastColumn)], y = rowMiddle(bar.row);
        const bool simultaneous =
            bar.kind == chart::BarKind::SimultaneousOpen || bar.kind == chart::BarKind::SimultaneousClose;
        if (simultaneous) {
            stroke({from - 26, y - kDoubleHalf}, {to + 26, y - kDoubleHalf}, 1.4);
            stroke({from - 26, y + kDoubleHalf}, {to + 26, y + kDoubleHalf}, 1.4);
        } else {
            stroke({from, y}, {to, y});
        }
    }
    for (const chart::Jump& jump : m_layout.jumps) {
        const double x = m_columnMiddles[static_cast<size_t>(jump.at.column)],
                     tip = m_rowTops[static_cast<size_t>(jump.at.row) + 1] - 2;
        stroke({x, rowTop(jump.at.row)}, {x, tip - 8});
        lines->arrows.push_back({QPointF(x, tip), jump.target.isValid()
                                                      ? kit::fromView((*m_chart)[jump.target].decl->name.text)
                                                      : QString()});
    }
    for (const chart::Link& link : m_layout.links) {
        const QPointF from(m_stepRects[link.step.index()].center().x(), m_stepRects[link.step.index()].bottom());
        const QRectF to = m_conditionRects[link.join.index()];
        stroke(from, {to.left() - kBarHalf, to.top() - 12});
    }
    for (size_t i = 0; i < m_stepRects.size(); ++i)
        if (!m_actionRects[i].empty())
            stroke({m_stepRects[i].right(), m_stepRects[i].center().y()},
                   {m_actionRects[i].front().left(), m_stepRects[i].center().y()});
    lines->finish();
    m_lines = lines;
    addItem(lines);
}

QRectF ChartScene::barRect(int index) const {
    const chart::Cell cell = m_layout.transitions[static_cast<size_t>(index)];
    const double x = m_columnMiddles[static_cast<size_t>(cell.column)];
    return {x - kBarHalf, rowTop(cell.row), 2 * kBarHalf,
            m_rowTops[static_cast<size_t>(cell.row) + 1] - rowTop(cell.row)};
}

void ChartScene::showMessages(const std::vector<ChartMessage>& messages) {
    m_stepProblems.clear();
    m_transitionProblems.clear();
    m_actionProblems.clear();
    if (!m_chart) return;
    const auto inside = [](SourceRange outer, SourceRange inner) {
        return inner.begin >= outer.begin && inner.begin <= outer.end;
    };
    const auto note = [](auto& problems, const auto& key, const ChartMessage& message) {
        Problem& problem = problems[key];
        const bool first = problem.text.isEmpty();
        if (!first && problem.text.contains(message.text)) return;
        problem.text += (first ? "" : "\n") + message.text;
        problem.isError = message.isError || (!first && problem.isError);
    };
    for (const ChartMessage& message : messages) {
        for (size_t i = 0; i < m_chart->steps.size(); ++i) {
            const syntax::StepDecl& step = *m_chart->steps[i].decl;
            if (!inside(step.range, message.range)) continue;
            bool isOfAction = false;
            for (size_t k = 0; k < step.actions.size(); ++k)
                if (inside(step.actions[k].range, message.range)) {
                    note(m_actionProblems, QPair<int, int>(static_cast<int>(i), static_cast<int>(k)), message);
                    isOfAction = true;
                    break;
                }
            if (!isOfAction) note(m_stepProblems, static_cast<int>(i), message);
        }
        for (size_t i = 0; i < m_chart->transitions.size(); ++i)
            if (inside(m_chart->transitions[i].decl->range, message.range))
                note(m_transitionProblems, static_cast<int>(i), message);
    }
    showToolTips();
    update();
}

/// What is wrong there, then what is covered.
void ChartScene::showToolTips() {
    const auto tipOf = [](QString problem, const CoverageMark& coverage) {
        if (!problem.isEmpty() && !coverage.text.isEmpty()) problem += u'\n';
        return problem + coverage.text;
    };
    for (size_t i = 0; i < m_stepItems.size(); ++i) {
        const int step = static_cast<int>(i);
        m_stepItems[i]->setToolTip(tipOf(m_stepProblems.value(step).text, m_coverage.steps.value(step)));
        for (size_t k = 0; k < m_actionItems[i].size(); ++k) {
            const QPair<int, int> key(step, static_cast<int>(k));
            m_actionItems[i][k]->setToolTip(tipOf(m_actionProblems.value(key).text, m_coverage.actions.value(key)));
        }
    }
    for (size_t i = 0; i < m_transitionItems.size(); ++i) {
        QString tip = m_transitionProblems.value(static_cast<int>(i)).text;
        const syntax::TransitionDecl& decl = *m_chart->transitions[i].decl;
        if (tip.isEmpty() && m_conditions[i].contains(QChar(0x2026)) && decl.condition)
            tip = kit::fromView(
                m_text.substr(decl.condition->range.begin, decl.condition->range.length())); // cut: the whole of it
        m_transitionItems[i]->setToolTip(tipOf(tip, m_coverage.transitions.value(static_cast<int>(i))));
    }
}

void ChartScene::setOnline(ChartOnline online) {
    const ChartOnline before = std::exchange(m_online, std::move(online));
    if (before.isOn != m_online.isOn || before.steps.size() != m_online.steps.size() ||
        before.transitions.size() != m_online.transitions.size() ||
        before.associations.size() != m_online.associations.size())
        return update();
    // only what changed is redrawn
    for (size_t i = 0; i < m_stepItems.size() && i < m_online.steps.size(); ++i) {
        if (!(before.steps[i] == m_online.steps[i])) m_stepItems[i]->update();
        if (i < m_online.associations.size() && before.associations[i] != m_online.associations[i])
            for (QGraphicsItem* item : m_actionItems[i]) item->update();
    }
    for (size_t i = 0; i < m_transitionItems.size() && i < m_online.transitions.size(); ++i)
        if (before.transitions[i] != m_online.transitions[i] || before.taken.size() != m_online.taken.size() ||
            before.taken[i] != m_online.taken[i])
            m_transitionItems[i]->update();
}

void ChartScene::setMarks(const ChartMarks& marks) {
    if (marks == m_marks) return;
    m_marks = marks;
    update();
}

void ChartScene::setCoverage(const ChartCoverage& coverage) {
    if (coverage == m_coverage) return;
    m_coverage = coverage;
    if (m_chart) showToolTips();
    update();
}

void ChartScene::setFaint(bool faint) {
    if (m_isFaint == faint) return;
    m_isFaint = faint;
    if (m_lines) static_cast<ChartLines*>(m_lines)->isFaint = faint;
    update();
}

QGraphicsItem* ChartScene::itemOf(ItemKind kind, int index, int sub) const {
    const auto at = static_cast<size_t>(index);
    switch (kind) {
    case Step:
        return at < m_stepItems.size() ? m_stepItems[at] : nullptr;
    case Transition:
        return at < m_transitionItems.size() ? m_transitionItems[at] : nullptr;
    case Action:
        return at < m_actionItems.size() && static_cast<size_t>(std::max(0, sub)) < m_actionItems[at].size()
                   ? m_actionItems[at][static_cast<size_t>(std::max(0, sub))]
                   : nullptr;
    case None:
        return nullptr;
    }
    return nullptr;
}

ChartDropHint& ChartScene::dropHint() {
    if (!m_hint) {
        m_hint = new ChartDropHint;
        addItem(m_hint);
    }
    return *m_hint;
}

void ChartScene::refreshTheme() { update(); }

} // namespace plc::editor
