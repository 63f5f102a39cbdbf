// The graph of a textual SFC, edited in place: every edit leaves as a list of text replacements for the one undo
// history of the text (D4); a text with syntax errors leaves the last good drawing, read-only. Owned by its page; GUI
// thread.
#pragma once
#include "editor/graph/chart_scene.h"
#include "editor/graph/chart_unit.h"
#include "editor/kit/canvas.h"
#include "editor/kit/expression_edit.h"
#include "projects/analysis/code_model.h"
#include "runtime/compiler/chart/edits.h"

#include <QElapsedTimer>
#include <QWidget>

#include <functional>
#include <memory>
#include <optional>
#include <set>

class QAction;
class QLabel;
class QMouseEvent;
class QToolBar;

namespace plc::editor {

/// Value of an expression as seen from the chart's unit: text, and whether it is TRUE; empty text = no value.
struct ChartValue {
    QString text;
    bool isTrue = false;
    bool isForced = false;
    int64_t nanoseconds = 0; // of a TIME
};
using ChartValues = std::function<ChartValue(const QString& expression)>;

class ChartView : public QWidget {
    Q_OBJECT
public:
    explicit ChartView(QWidget* parent = nullptr);
    ~ChartView() override;

    /// The unit whose chart is shown, "Main", or one of its actions, "Main.Fill".
    void setUnit(const QString& unit);
    [[nodiscard]] const QString& unit() const { return m_unit; }
    /// The text as it stands in the editor.
    void setText(const std::string& text);
    void setModel(const std::shared_ptr<const analysis::CodeModel>& model, const QString& file);
    void setValues(ChartValues values) { m_values = std::move(values); }
    /// Lines from 1 with a breakpoint; of `disabled` those that are switched off.
    void setBreakpoints(const std::set<int>& lines, const std::set<int>& disabled = {});
    /// What is shown is a recorded scan: nothing is taken from one look to the next.
    void setPast(bool isPast);
    void refreshOnline();
    /// Selects what stands at the text's cursor.
    void showCursor(uint32_t offset);
    [[nodiscard]] bool isReadOnly() const { return m_isStale; }
    [[nodiscard]] kit::Canvas& canvas() { return *m_canvas; }
    [[nodiscard]] ChartScene& scene() { return *m_scene; }
    [[nodiscard]] kit::ExpressionEdit& field() { return *m_field; }

    // commands, on the selection; also in the context menu
    void insertStep();
    void insertAlternative();
    void insertSimultaneous();
    void insertAction();
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
    void editsRequested(const std::vector<plc::diagnostics::TextEdit>& edits);
    void placeSelected(uint32_t offset);
    void breakpointRequested(uint32_t offset);
    void forceStepRequested(const QString& step, bool active);
    void failed(const QString& message);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

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
    using MakeEdits = std::function<Result<chart::Edits>(const QString& text)>;
    enum class FieldKind : uint8_t { Name, Condition, Action };

    [[nodiscard]] Picked picked() const;
    [[nodiscard]] Picked pickedAt(QPoint viewportPoint) const;
    [[nodiscard]] chart::ChartEditor editor() const { return {m_text, *m_place.pou, *m_chart}; }
    [[nodiscard]] SourceRange rangeOf(const Picked& picked) const;
    void request(const Result<chart::Edits>& edits, const QString& selectName = {});
    void rebuild();
    void showStale(const QString& reason);
    void applyBreakpoints();
    void updateMap();
    void updateActions();
    void selectionMoved();

    // in place (chart_field.cpp)
    void openField(const QRectF& sceneRect, const QString& text, FieldKind kind, uint32_t at, MakeEdits make,
                   bool keepsSelection = false);
    void closeField(bool accept);
    [[nodiscard]] QString complaintOf(const QString& text) const;
    [[nodiscard]] std::vector<kit::Completion> completions(const QString& text, int cursor) const;

    // dragging (chart_drag.cpp)
    bool dragEvent(QEvent* event);
    void endDrag(bool drop);
    [[nodiscard]] Drop dropAt(const QPointF& scenePoint) const;
    [[nodiscard]] Drop dropStep(const QPointF& scenePoint) const;
    [[nodiscard]] Drop dropTransition(const QPointF& scenePoint) const;
    [[nodiscard]] Drop dropAction(const QPointF& scenePoint) const;
    [[nodiscard]] Drop besideSibling(const std::vector<chart::TransitionId>& siblings, chart::TransitionId moved,
                                     double x) const;

    QString m_unit;
    std::string m_text;
    std::unique_ptr<syntax::SyntaxFile> m_syntax;
    ChartPlace m_place;
    std::unique_ptr<chart::Chart> m_chart;
    bool m_isStale = false, m_isPast = false, m_isFresh = true;
    QString m_selectAfter;
    std::set<int> m_breakpoints, m_disabled;

    ChartScene* m_scene;
    kit::Canvas* m_canvas;
    QToolBar* m_bar;
    QLabel* m_state;
    QAction* m_up;
    kit::ExpressionEdit* m_field;
    MakeEdits m_makeEdits;
    QString m_fieldBegin;
    FieldKind m_fieldKind = FieldKind::Name;
    uint32_t m_fieldAt = 0;
    std::shared_ptr<const analysis::CodeModel> m_model;
    QString m_file;
    std::vector<QString> m_listConditions; // transition → where the result of its instruction list is kept
    ChartValues m_values;
    std::vector<qint64> m_takenAt; // by the wall clock, live
    std::vector<int> m_enteredBy;  // step → the transition that last led to it
    std::vector<bool> m_wasActive;
    QElapsedTimer m_clock;

    Picked m_dragged;
    QPoint m_pressedAt;
    bool m_isDragging = false;
};

} // namespace plc::editor
