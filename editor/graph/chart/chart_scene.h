// The drawing of one sequential function chart, as IEC 61131-3 draws it: a cache of the model, made again with each
// text. Items know their step or transition by id; nothing here edits. Owned by ChartView; GUI thread.
#pragma once
#include <QGraphicsScene> // before the standard library's: moc stumbles over <concepts> otherwise
#include <QHash>
#include <QSet>

#include "editor/graph/coverage_mark.h"
#include "runtime/compiler/chart/chart.h"
#include "runtime/compiler/chart/layout.h"

#include <optional>
#include <vector>

namespace plc::editor {

class ChartDropHint;

/// What a chart shows of a running controller, by index of step and transition.
struct ChartOnline {
    struct StepState {
        bool isActive = false, isForced = false, isLate = false; // late: beyond its maxTime
        QString time;
        bool operator==(const StepState&) const = default;
    };
    struct ActionState {
        bool asks = false;     // this association asks for the action now
        bool isActive = false; // the action's control, whoever asked for it
        double progress = -1;  // of a qualifier with a time: gone of it, 0 … 1
        bool operator==(const ActionState&) const = default;
    };
    std::vector<StepState> steps;
    std::vector<std::optional<bool>> transitions; // value of the condition
    std::vector<double> taken;                    // 1 just now … 0 long ago
    std::vector<std::vector<ActionState>> associations;
    QHash<QString, bool> actions; // name in lower case → is active
    bool isOn = false;
};

struct ChartMessage {
    SourceRange range;
    QString text;
    bool isError = true;
};

/// Breakpoints by index; true: enabled.
struct ChartMarks {
    QHash<int, bool> steps, transitions;
    bool operator==(const ChartMarks&) const = default;
};

class ChartScene : public QGraphicsScene {
    Q_OBJECT
public:
    explicit ChartScene(QObject* parent = nullptr);
    /// `text` is the file's; chart and text must outlive the next call. `charts`: actions, in lower case, that hold a
    /// chart.
    void show(const chart::Chart& chart, std::string_view text, const QSet<QString>& charts = {});
    void forget(); // the chart goes
    void showMessages(const std::vector<ChartMessage>& messages);
    void setOnline(ChartOnline online);
    void setMarks(const ChartMarks& marks);
    void setCoverage(const ChartCoverage& coverage);
    [[nodiscard]] const ChartCoverage& coverage() const { return m_coverage; }
    /// A drawing that is no longer the text's.
    void setFaint(bool faint);
    [[nodiscard]] const ChartOnline& online() const { return m_online; }
    [[nodiscard]] const ChartMarks& marks() const { return m_marks; }
    [[nodiscard]] const chart::Chart* chart() const { return m_chart; }
    [[nodiscard]] const chart::Layout& layout() const { return m_layout; }
    [[nodiscard]] int problemCount() const {
        return static_cast<int>(m_stepProblems.size() + m_transitionProblems.size() + m_actionProblems.size());
    }

    enum ItemRole { Kind = 0, Index = 1, Sub = 2 };
    enum ItemKind { None, Step, Transition, Action };
    [[nodiscard]] QGraphicsItem* itemOf(ItemKind kind, int index, int sub = -1) const;
    [[nodiscard]] QRectF stepRect(int index) const { return m_stepRects[static_cast<size_t>(index)]; }
    [[nodiscard]] QRectF conditionRect(int index) const { return m_conditionRects[static_cast<size_t>(index)]; }
    [[nodiscard]] QRectF actionRect(int step, int action) const {
        return m_actionRects[static_cast<size_t>(step)][static_cast<size_t>(action)];
    }
    /// The place of a transition's bar.
    [[nodiscard]] QRectF barRect(int index) const;
    [[nodiscard]] QString conditionText(int transition) const;
    void refreshTheme();
    [[nodiscard]] ChartDropHint& dropHint();

private:
    struct Problem {
        QString text;
        bool isError = true;
    };
    void measure();
    void showToolTips();
    void drawLines();
    void indexCells();
    [[nodiscard]] QString makeConditionText(int transition) const;
    [[nodiscard]] double rowTop(int row) const { return m_rowTops[static_cast<size_t>(row)]; }
    [[nodiscard]] double rowMiddle(int row) const {
        return (m_rowTops[static_cast<size_t>(row)] + m_rowTops[static_cast<size_t>(row) + 1]) / 2;
    }
    [[nodiscard]] double lowerEdge(int column, int row) const;
    [[nodiscard]] double upperEdge(int column, int row) const;

    const chart::Chart* m_chart = nullptr;
    std::string_view m_text;
    chart::Layout m_layout;
    ChartOnline m_online;
    ChartMarks m_marks;
    ChartCoverage m_coverage;
    bool m_isFaint = false;
    QSet<QString> m_charts;
    std::vector<double> m_rowTops, m_columnMiddles;
    std::vector<QString> m_conditions;
    std::vector<QRectF> m_stepRects, m_conditionRects;
    std::vector<std::vector<QRectF>> m_actionRects;
    QHash<QPair<int, int>, QPair<int, int>> m_cells; // column, row → kind, index
    QHash<int, Problem> m_stepProblems, m_transitionProblems;
    QHash<QPair<int, int>, Problem> m_actionProblems;
    std::vector<QGraphicsItem*> m_stepItems, m_transitionItems;
    std::vector<std::vector<QGraphicsItem*>> m_actionItems;
    ChartDropHint* m_hint = nullptr;
    QGraphicsItem* m_lines = nullptr;
    friend class ChartItem;
};

} // namespace plc::editor
