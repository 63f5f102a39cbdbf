// The graph of a textual SFC, edited in place: every edit leaves as a list of text replacements for the one undo history of the text (D4); a text
// with syntax errors leaves the last good drawing, read-only. Owned by its page; GUI thread.
#pragma once
#include "editor/graph/chart_scene.h"
#include "editor/kit/canvas.h"
#include "editor/kit/expression_edit.h"
#include "projects/analysis/code_model.h"
#include "runtime/compiler/chart/edits.h"

#include <QElapsedTimer>
#include <QWidget>

#include <functional>
#include <memory>

class QLabel;
class QToolBar;

namespace plc::editor {

/// Value of an expression as seen from the chart's unit: text, and whether it is TRUE; empty text = no value.
struct ChartValue {
    QString text;
    bool isTrue = false;
};
using ChartValues = std::function<ChartValue(const QString& expression)>;

class ChartView : public QWidget {
    Q_OBJECT
public:
    explicit ChartView(QWidget* parent = nullptr);
    ~ChartView() override;

    /// The unit whose chart is shown; the text as it stands in the editor.
    void setUnit(const QString& pou) { m_unit = pou; }
    [[nodiscard]] const QString& unit() const { return m_unit; }
    void setText(const std::string& text);
    void setModel(const std::shared_ptr<const analysis::CodeModel>& model, const QString& file);
    void setValues(ChartValues values) { m_values = std::move(values); }
    void refreshOnline();
    /// Selects what stands at the text's cursor.
    void showCursor(uint32_t offset);
    [[nodiscard]] bool isReadOnly() const { return m_isStale; }
    [[nodiscard]] kit::Canvas& canvas() { return *m_canvas; }
    [[nodiscard]] ChartScene& scene() { return *m_scene; }

    // commands, on the selection; also in the context menu
    void insertStep();
    void insertAlternative();
    void insertSimultaneous();
    void insertAction();
    void deleteSelected();
    void moveSelected(int direction);
    void editSelected(); // name or condition, in place
    void makeInitial();

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

private:
    struct Picked {
        ChartScene::ItemKind kind = ChartScene::None;
        int index = -1, sub = -1;
    };
    [[nodiscard]] Picked picked() const;
    [[nodiscard]] chart::ChartEditor editor() const { return {m_text, *m_pou, *m_chart}; }
    void request(const Result<chart::Edits>& edits, const QString& selectName = {});
    void rebuild();
    void selectionMoved();
    void openField(const QRectF& sceneRect, const QString& text, bool isExpression, std::function<void(const QString&)> done);
    void closeField(bool accept);

    QString m_unit;
    std::string m_text;
    std::unique_ptr<syntax::SyntaxFile> m_syntax;
    const syntax::Pou* m_pou = nullptr;
    std::unique_ptr<chart::Chart> m_chart;
    bool m_isStale = false;
    QString m_selectAfter;

    ChartScene* m_scene;
    kit::Canvas* m_canvas;
    QToolBar* m_bar;
    QLabel* m_state;
    kit::ExpressionEdit* m_field;
    std::function<void(const QString&)> m_fieldDone;
    std::shared_ptr<const analysis::CodeModel> m_model;
    ChartValues m_values;
    std::vector<qint64> m_takenAt;
    std::vector<bool> m_wasActive;
    QElapsedTimer m_clock;
};

} // namespace plc::editor
