// What the views of SFC, ladder and function blocks share (D14): a drawing of one unit's text on a canvas with a tool
// bar, a field over the drawing for what is typed, and edits that leave as text replacements for the one undo history
// of the text (D4). A text with syntax errors leaves the last good drawing, read-only. Owned by its page; GUI thread.
#pragma once
#include "editor/graph/coverage_mark.h"
#include "editor/kit/canvas.h"
#include "editor/kit/inputs/expression_edit.h"
#include "projects/analysis/code_model.h"
#include "runtime/diagnostics/text_edits.h"

#include <QAction>
#include <QWidget>

#include <functional>
#include <memory>
#include <optional>
#include <set>

class QLabel;
class QPrinter;
class QToolBar;

namespace plc::editor {

/// Value of an expression as seen from the unit: text, and whether it is TRUE; empty text = no value.
struct GraphValue {
    QString text;
    bool isTrue = false;
    bool isForced = false;
    int64_t nanoseconds = 0; // of a TIME
};
using GraphValues = std::function<GraphValue(const QString& expression)>;

/// What the scan that is shown computed, by place in the text as the view has it.
class ComputedValues {
public:
    virtual ~ComputedValues() = default;
    /// False where the text was edited since it was built: nothing is known there.
    [[nodiscard]] virtual bool covers(SourceRange range) const = 0;
    /// None: it was not computed, or is a constant.
    [[nodiscard]] virtual std::optional<GraphValue> at(SourceRange range) const = 0;
    [[nodiscard]] virtual bool isExecuted(SourceRange statement) const = 0;
};
/// Null: not known; then the values at the scan's end are shown.
using ComputedSource = std::function<std::shared_ptr<const ComputedValues>()>;

class GraphView : public QWidget {
    Q_OBJECT
public:
    GraphView(QGraphicsScene& scene, const QString& accessibleName, QWidget* parent);

    /// The unit that is shown: "Main", "Main.Fill".
    virtual void setUnit(const QString& unit) = 0;
    [[nodiscard]] const QString& unit() const { return m_unit; }
    /// The text as it stands in the editor.
    virtual void setText(const std::string& text) = 0;
    virtual void setModel(const std::shared_ptr<const analysis::CodeModel>& model, const QString& file) = 0;
    void setValues(GraphValues values) { m_values = std::move(values); }
    void setComputed(ComputedSource source) { m_computed = std::move(source); }
    /// Lines from 1 with a breakpoint; of `disabled` those that are switched off.
    void setBreakpoints(const std::set<int>& lines, const std::set<int>& disabled = {});
    /// Where in this text the controller stands at a breakpoint, if it does.
    virtual void setStanding(std::optional<uint32_t>) {}
    /// Lines from 1 with a bookmark.
    void setBookmarks(const std::set<int>& lines);
    /// Asked with each new drawing, and when it has changed.
    void setCoverage(CoverageSource source);
    void coverageChanged() { marksChanged(); }
    /// What is shown is a recorded scan.
    virtual void setPast(bool isPast) { m_isPast = isPast; }
    virtual void refreshOnline() = 0;
    /// Selects what stands at the text's cursor.
    virtual void showCursor(uint32_t offset) = 0;
    [[nodiscard]] bool isReadOnly() const { return m_isStale; }
    /// In the colours of paper, in whatever theme the studio is.
    void print(QPrinter& printer);
    [[nodiscard]] kit::Canvas& canvas() { return *m_canvas; }
    [[nodiscard]] kit::ExpressionEdit& field() { return *m_field; }

signals:
    void editsRequested(const std::vector<plc::diagnostics::TextEdit>& edits);
    void placeSelected(uint32_t offset);
    void breakpointRequested(uint32_t offset);
    void bookmarkRequested(uint32_t offset);
    /// Of the name at a place of the text.
    void renameRequested(uint32_t offset);
    void usesRequested(uint32_t offset);
    void definitionRequested(uint32_t offset);
    void fixRequested(uint32_t offset);
    void failed(const QString& message);

protected:
    using Edits = diagnostics::Edits;
    using MakeEdits = std::function<Result<Edits>(const QString& text)>;

    bool eventFilter(QObject* watched, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

    /// A button of the tool bar.
    template <class View, class Run> QAction* addCommand(kit::Icon icon, const QString& text, View* view, Run run) {
        QAction* action = makeCommand(icon, text);
        connect(action, &QAction::triggered, view, run);
        return action;
    }
    /// Show all, export and print, then the label for what is wrong.
    void addSheetCommands();
    [[nodiscard]] QAction* makeCommand(kit::Icon icon, const QString& text);
    virtual void showStale(const QString& reason);
    void showFresh();
    void onPaper(const std::function<void()>& draw);
    void request(const Result<Edits>& edits, const QString& selectAfter = {});
    void updateMap();
    /// Where a new drawing is looked at first.
    void showWhole();
    /// For each offset of `places` whether its line has a breakpoint: 0 none, 1 enabled, -1 disabled.
    [[nodiscard]] std::vector<int> breakpointsAt(const std::vector<uint32_t>& places) const;
    /// From 1.
    [[nodiscard]] std::vector<int> linesOf(const std::vector<uint32_t>& places) const;
    /// What the last check says of this file; empty when it saw another text.
    [[nodiscard]] std::vector<diagnostics::Diagnostic> modelMessages() const;

    void openField(const QRectF& sceneRect, const QString& text, uint32_t at, MakeEdits make,
                   bool keepsSelection = false);
    void closeField(bool accept);
    /// What the field completes: names as they resolve at the place that is edited.
    [[nodiscard]] std::vector<kit::Completion> namesAt(const QString& text, int cursor,
                                                       const std::function<bool(const QString& type)>& accepts) const;
    [[nodiscard]] virtual std::vector<kit::Completion> completions(const QString& text, int cursor) const = 0;
    [[nodiscard]] virtual QString complaintOf(const QString& text) const = 0;
    virtual void marksChanged() = 0;
    /// The view has another size, because docks opened beside it, for example: what is worked on stays in sight.
    virtual void revealSelection() {}
    virtual void themeChanged() = 0;
    [[nodiscard]] virtual bool hasDrawing() const = 0;

    QString m_unit;
    std::string m_text;
    bool m_isStale = false, m_isPast = false, m_isFresh = true;
    QString m_selectAfter;
    std::set<int> m_breakpoints, m_disabled, m_bookmarks;
    kit::Canvas* m_canvas = nullptr;
    QToolBar* m_bar = nullptr;
    QLabel* m_state = nullptr;
    kit::ExpressionEdit* m_field = nullptr;
    MakeEdits m_makeEdits;
    QString m_fieldBegin;
    uint32_t m_fieldAt = 0;
    std::shared_ptr<const analysis::CodeModel> m_model;
    QString m_file;
    GraphValues m_values;
    ComputedSource m_computed;
    CoverageSource m_coverage;
};

} // namespace plc::editor
