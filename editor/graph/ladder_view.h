// Ladder and function block diagram of one ST body, edited in place (graph_view.h says what all graph views do). Keys
// follow CODESYS's. Owned by its page; GUI thread.
#pragma once
#include "editor/graph/graph_view.h"
#include "editor/graph/ladder_scene.h"
#include "runtime/compiler/ladder/edits.h"

#include <optional>

namespace plc::editor {

/// What the program computed at a place of the text, in the scan that is shown; none where that is not known.
using FlowSource = std::function<std::optional<bool>(SourceRange range)>;

class LadderView : public GraphView {
    Q_OBJECT
public:
    explicit LadderView(QWidget* parent = nullptr);
    ~LadderView() override;

    /// The unit, or its method or action: "Main", "Motor.Start".
    void setUnit(const QString& unit) override;
    void setForm(ladder::Form form);
    [[nodiscard]] ladder::Form form() const { return m_form; }
    void setText(const std::string& text) override;
    void setModel(const std::shared_ptr<const analysis::CodeModel>& model, const QString& file) override;
    /// Exact values, where there are any; else the values of the variables are shown.
    void setFlowSource(FlowSource source) { m_flow = std::move(source); }
    void refreshOnline() override;
    void showCursor(uint32_t offset) override;
    [[nodiscard]] LadderScene& scene() { return *m_scene; }
    [[nodiscard]] const ladder::Diagram& diagram() const { return m_diagram; }

    // commands, on the selection; also in the context menu
    void insertContactLeft();
    void insertContactRight();
    void insertParallel();
    void insertCoil();
    void insertBlock();
    void insertRungAbove();
    void insertRungBelow();
    void deleteSelected();
    void negate();
    void nextCoil(); // normal, set, reset
    void editSelected();
    void editComment();
    void moveRung(int direction);
    void toggleBreakpoint();
    void forceSelected(const QString& value); // empty: released
    void toggleForm();
    void showKeys();
    void selectTowards(int dx, int dy);

signals:
    void forceRequested(const QString& variable, const QString& value);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void showStale(const QString& reason) override;
    [[nodiscard]] QString complaintOf(const QString& text) const override;
    [[nodiscard]] std::vector<kit::Completion> completions(const QString& text, int cursor) const override;
    void marksChanged() override;
    void themeChanged() override { m_scene->refreshTheme(); }
    [[nodiscard]] bool hasDrawing() const override { return m_syntax != nullptr; }

private:
    enum class FieldKind : uint8_t { Operand, Place, Block, Statement, Comment };
    using Make = std::function<Result<Edits>(const std::string& text)>;

    [[nodiscard]] ladder::LadderEditor editor() const { return {m_text, *m_syntax, m_place, m_diagram, *m_types}; }
    [[nodiscard]] bool canEdit();
    [[nodiscard]] const ladder::Node* pickedNode() const;
    [[nodiscard]] ladder::RungId pickedRung() const;
    void rebuild();
    void makeTypes();
    void showProblems();
    void selectAgain(const LadderPick& before);
    void ask(FieldKind kind, const QRectF& place, const QString& text, uint32_t at, Make make);
    void insertRung(ladder::Place place);
    [[nodiscard]] Edits withDeclaration(Edits edits, const std::string& name, const std::string& type) const;
    [[nodiscard]] LadderOnline online() const;
    [[nodiscard]] double progressOf(const ladder::Node& box) const;
    bool mouseEvent(QEvent* event);
    [[nodiscard]] std::optional<LadderPick> dropAt(QPointF point) const;

    ladder::Form m_form = ladder::Form::Ladder;
    std::unique_ptr<syntax::SyntaxFile> m_syntax;
    ladder::Unit m_place;
    std::unique_ptr<ladder::DeclaredTypes> m_types;
    std::shared_ptr<const analysis::CodeModel> m_typesModel; // whose trees m_types looks into
    ladder::Diagram m_diagram;
    ladder::Layout m_layout;
    LadderScene* m_scene;
    QAction* m_formAction = nullptr;
    FieldKind m_fieldKind = FieldKind::Operand;
    FlowSource m_flow;
    LadderPick m_dragged;
    QPoint m_pressedAt;
    bool m_isDragging = false;
};

} // namespace plc::editor
