// The graph of a textual SFC, edited in place (graph_view.h says what all graph views do). Owned by its page; GUI
// thread.
#pragma once
#include "editor/graph/chart/chart_scene.h"
#include "editor/graph/chart/chart_unit.h"
#include "editor/graph/graph_view.h"
#include "runtime/compiler/chart/edits.h"

#include <QElapsedTimer>

#include <optional>

class QLabel;
class QMouseEvent;
class QPushButton;

namespace plc::editor {

using ChartValue = GraphValue;
using ChartValues = GraphValues;

class ChartView : public GraphView {
    Q_OBJECT
public:
    explicit ChartView(QWidget* parent = nullptr);
    ~ChartView() override;

    /// The unit whose chart is shown, "Main", or one of its actions, "Main.Fill".
    void setUnit(const QString& unit) override;
    void setText(const std::string& text) override;
    void setModel(const std::shared_ptr<const analysis::CodeModel>& model, const QString& file) override;
    /// Nothing is taken from one look to the next.
    void setPast(bool isPast) override;
    void refreshOnline() override;
    void showCursor(uint32_t offset) override;
    [[nodiscard]] ChartScene& scene() { return *m_scene; }

    // commands, on the selection; also in the context menu
    void insertStep();
    void insertAlternative();
    void insertSimultaneous();
    void insertAction();
    void copySelected(); // as text of the file, for this chart, another one or a text
    void cutSelected();
    void paste();      // behind what is selected
    void beginChart(); // in a unit without a body
    void deleteSelected();
    void deleteBranch();
    void moveSelected(int direction);
    void editSelected(); // name or condition, in place
    void editPriority();
    void makeInitial();
    void openAction(); // the chart inside the action, or its body in the text
    void openParent();
    void toggleBreakpoint();
    void forceSelected(bool active);
    void selectTowards(int dx, int dy);

signals:
    void forceStepRequested(const QString& step, bool active);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void showStale(const QString& reason) override;
    [[nodiscard]] QString complaintOf(const QString& text) const override;
    [[nodiscard]] std::vector<kit::Completion> completions(const QString& text, int cursor) const override;
    void marksChanged() override;
    void themeChanged() override;
    [[nodiscard]] bool hasDrawing() const override { return m_chart != nullptr; }
    [[nodiscard]] ChartCoverage coverageOf() const;

private:
    struct Picked {
        ChartScene::ItemKind kind = ChartScene::None;
        int index = -1, sub = -1;
        bool operator==(const Picked&) const = default;
    };
    /// What a drop at a place would do.
    struct Drop {
        QRectF hint;
        QString text;
        Result<chart::Edits> edits = Error{};
        QString select;
    };
    enum class FieldKind : uint8_t { Name, Condition, Action };

    [[nodiscard]] Picked picked() const;
    [[nodiscard]] Picked pickedAt(QPoint viewportPoint) const;
    [[nodiscard]] chart::ChartEditor editor() const { return {m_text, *m_place.pou, *m_chart}; }
    [[nodiscard]] SourceRange rangeOf(const Picked& picked) const;
    void rebuild();
    void updateActions();
    void selectionMoved();
    void addClipboardCommands();
    /// The selection and the field for the name of what was inserted last.
    void selectInserted();
    void showNoChart(const std::string& text);
    [[nodiscard]] bool canBegin() const;

    // in place (chart_field.cpp)
    void openField(const QRectF& sceneRect, const QString& text, FieldKind kind, uint32_t at, MakeEdits make,
                   bool keepsSelection = false);

    // dragging (chart_drag.cpp)
    bool dragEvent(QEvent* event);
    void endDrag(bool drop);
    [[nodiscard]] Drop dropAt(const QPointF& scenePoint) const;
    [[nodiscard]] Drop dropStep(const QPointF& scenePoint) const;
    [[nodiscard]] Drop dropTransition(const QPointF& scenePoint) const;
    [[nodiscard]] Drop dropAction(const QPointF& scenePoint) const;
    [[nodiscard]] Drop besideSibling(const std::vector<chart::TransitionId>& siblings, chart::TransitionId moved,
                                     double x) const;

    std::unique_ptr<syntax::SyntaxFile> m_syntax;
    ChartPlace m_place;
    std::unique_ptr<chart::Chart> m_chart;
    ChartScene* m_scene = nullptr;
    QAction* m_up = nullptr;
    QWidget* m_begin = nullptr; // over an empty canvas: how to begin a chart
    QLabel* m_beginText = nullptr;
    QPushButton* m_beginButton = nullptr;
    bool m_namesInserted = false; // what is inserted next is named by the user
    FieldKind m_fieldKind = FieldKind::Name;
    std::vector<QString> m_listConditions; // transition → where the result of its instruction list is kept
    std::vector<qint64> m_takenAt;         // by the wall clock, live
    std::vector<int> m_enteredBy;          // step → the transition that last led to it
    std::vector<bool> m_wasActive;
    QElapsedTimer m_clock;

    Picked m_dragged;
    QPoint m_pressedAt;
    bool m_isDragging = false;
};

} // namespace plc::editor
