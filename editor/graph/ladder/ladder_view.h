// Ladder and function block diagram of one ST body, edited in place (graph_view.h says what all graph views do). Keys
// follow CODESYS's. Owned by its page; GUI thread.
#pragma once
#include "editor/graph/graph_view.h"
#include "editor/graph/ladder/ladder_scene.h"
#include "runtime/compiler/ladder/edits.h"

#include <optional>

class QDragMoveEvent;
class QDropEvent;
class QMenu;

namespace plc::editor {

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
    void refreshOnline() override;
    void setStanding(std::optional<uint32_t> offset) override;
    void setLook(const LadderLook& look);
    [[nodiscard]] const LadderLook& look() const { return m_look; }
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
    void moveContact(int direction); // past its neighbour
    void toggleBreakpoint();
    void forceSelected(const QString& value); // empty: released
    void toggleForm();
    void showKeys();
    void selectTowards(int dx, int dy);
    void renameSelected();
    void usesOfSelected();
    void definitionOfSelected();
    void fixSelected();
    void toggleBookmark();
    void writeSelected(const QString& value);
    /// What a click on a wire puts there.
    enum class Tool : uint8_t { Contact, NegatedContact, Parallel, Block };
    void setTool(Tool tool) { m_tool = tool; }
    void insertOnWire(const LadderGap& gap);

signals:
    void forceRequested(const QString& variable, const QString& value);
    void writeRequested(const QString& variable, const QString& value);
    void lookChosen(int bits);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void showStale(const QString& reason) override;
    [[nodiscard]] QString complaintOf(const QString& text) const override;
    [[nodiscard]] std::vector<kit::Completion> completions(const QString& text, int cursor) const override;
    void marksChanged() override;
    void revealSelection() override;
    void themeChanged() override;
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
    [[nodiscard]] GraphValue valueOf(const ladder::Question& question, const ComputedValues* computed) const;
    void showValues(const ladder::Node& node, ladder::NodeId id, const ComputedValues* computed,
                    LadderOnline& out) const;
    [[nodiscard]] std::vector<kit::Completion> blockCompletions() const;
    [[nodiscard]] std::vector<kit::Completion> typeCompletions() const;
    void addLookMenu();
    void addWireMenu(QMenu& menu, const LadderGap& gap);
    [[nodiscard]] uint32_t placeOfName(const LadderPick& pick) const;
    [[nodiscard]] QString selectedVariable();
    [[nodiscard]] std::string typeExpected(const ladder::Node& node) const;
    bool mouseEvent(QEvent* event);
    bool pressed(const QMouseEvent& mouse);
    bool moved(const QMouseEvent& mouse);
    bool released(const QMouseEvent& mouse);
    bool dragEntered(QDragMoveEvent& drag);
    bool dropped(QDropEvent& drop);
    [[nodiscard]] bool isContactDragged() const;
    [[nodiscard]] Result<Edits> moveTo(QPointF point) const;
    [[nodiscard]] Result<Edits> dropOn(QPointF point, const std::string& name) const;
    [[nodiscard]] std::optional<LadderGap> gapBeside(QPointF point) const;
    [[nodiscard]] std::string freeInstance(const std::string& type) const;

    ladder::Form m_form = ladder::Form::Ladder;
    std::unique_ptr<syntax::SyntaxFile> m_syntax;
    ladder::Unit m_place;
    std::unique_ptr<ladder::DeclaredTypes> m_types;
    std::shared_ptr<const analysis::CodeModel> m_typesModel; // whose trees m_types looks into
    ladder::Diagram m_diagram;
    ladder::Layout m_layout;
    LadderScene* m_scene = nullptr;
    QAction* m_formAction = nullptr;
    LadderLook m_look;
    Tool m_tool = Tool::Contact;
    std::optional<uint32_t> m_standing;
    FieldKind m_fieldKind = FieldKind::Operand;
    std::string m_fieldType = "BOOL"; // of a new name that is typed next
    LadderPick m_dragged;
    QPoint m_pressedAt;
    bool m_isDragging = false;
    std::optional<LadderGap> m_pressedGap; // a click on it inserts
};

} // namespace plc::editor
