// The drawing of one sequential function chart, as IEC 61131-3 draws it: a cache of the model, made anew with each text. Items know their step
// or transition by id; nothing here edits. Owned by ChartView; GUI thread.
#pragma once
#include <QGraphicsScene> // before the standard library's: moc stumbles over <concepts> otherwise
#include <QHash>

#include "runtime/compiler/chart/chart.h"
#include "runtime/compiler/chart/layout.h"

#include <vector>

namespace plc::editor {

/// What a chart shows of a running controller, by index of step and transition.
struct ChartOnline {
    struct StepState {
        bool isActive = false;
        QString time;
    };
    std::vector<StepState> steps;
    std::vector<std::optional<bool>> transitions; // value of the condition
    std::vector<double> taken;                    // 1 just now … 0 long ago
    QHash<QString, bool> actions;                 // name → is active
    bool isOn = false;
};

struct ChartMessage {
    SourceRange range;
    QString text;
    bool isError = true;
};

class ChartScene : public QGraphicsScene {
    Q_OBJECT
public:
    explicit ChartScene(QObject* parent = nullptr);
    /// `text` is the file's; chart and text must outlive the next call.
    void show(const chart::Chart& chart, std::string_view text);
    void showMessages(const std::vector<ChartMessage>& messages);
    void setOnline(ChartOnline online);
    [[nodiscard]] const ChartOnline& online() const { return m_online; }
    [[nodiscard]] const chart::Chart* chart() const { return m_chart; }

    enum ItemRole { Kind = 0, Index = 1, Sub = 2 };
    enum ItemKind { None, Step, Transition, Action };
    [[nodiscard]] QGraphicsItem* itemOf(ItemKind kind, int index) const;
    [[nodiscard]] QRectF stepRect(int index) const { return m_stepRects[static_cast<size_t>(index)]; }
    [[nodiscard]] QRectF conditionRect(int index) const { return m_conditionRects[static_cast<size_t>(index)]; }
    [[nodiscard]] QRectF actionRect(int step, int action) const { return m_actionRects[static_cast<size_t>(step)][static_cast<size_t>(action)]; }
    [[nodiscard]] QString conditionText(int transition) const;
    void refreshTheme();

private:
    void measure();
    void drawLines();
    [[nodiscard]] double rowTop(int row) const { return m_rowTops[static_cast<size_t>(row)]; }
    [[nodiscard]] double rowMiddle(int row) const { return (m_rowTops[static_cast<size_t>(row)] + m_rowTops[static_cast<size_t>(row) + 1]) / 2; }
    [[nodiscard]] double lowerEdge(int column, int row) const;
    [[nodiscard]] double upperEdge(int column, int row) const;

    const chart::Chart* m_chart = nullptr;
    std::string_view m_text;
    chart::Layout m_layout;
    ChartOnline m_online;
    std::vector<double> m_rowTops, m_columnMiddles;
    std::vector<QRectF> m_stepRects, m_conditionRects;
    std::vector<std::vector<QRectF>> m_actionRects;
    QHash<int, QString> m_stepProblems, m_transitionProblems;
    friend class ChartItem;
};

} // namespace plc::editor
