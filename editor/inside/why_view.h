// "Who set this?", "Why?" and "Why not?" of any value: the answer as sentences, a tree to unfold, triggers told apart
// from enablers; a click goes to the place in the text and to the scan. Owned by its dock; GUI thread.
#pragma once
#include "editor/inside/inside_desk.h"
#include "editor/kit/ask_why.h"
#include "editor/kit/inputs/expression_edit.h"
#include "runtime/inside/words.h"

#include <QWidget>

class QLabel;
class QToolButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace plc::editor {

class WhyView : public QWidget {
    Q_OBJECT
public:
    WhyView(InsideDesk& desk, RunControl& control, QWidget* parent = nullptr);

    /// `scope`: the instance it is seen from, "" = top; `at`: the scan, none: the one that is shown.
    void ask(kit::AskWhy question, const QString& expression, const QString& scope = {},
             std::optional<history::Position> at = {});
    void setCompletionSource(kit::CompletionSource source) { m_input->setCompletionSource(std::move(source)); }
    [[nodiscard]] QTreeWidget& tree() { return *m_tree; }
    [[nodiscard]] kit::ExpressionEdit& input() { return *m_input; }
    /// The whole answer, a line for each sentence.
    [[nodiscard]] QString text() const;
    void clear();
    /// Nobody waits for the answer any more.
    void cancel();
    /// The variable that the sentence with the focus speaks of; empty: none.
    [[nodiscard]] QString focusedPath() const;

signals:
    void placeRequested(const QString& file, uint32_t offset, uint32_t length);
    void scanRequested(plc::history::Position position);
    void answered();

protected:
    void keyPressEvent(QKeyEvent* event) override; // Esc

private:
    struct Asked {
        kit::AskWhy question = kit::AskWhy::Why;
        QString expression, scope;
        std::optional<history::Position> at;
    };
    /// What came back from the desk.
    struct Answer {
        Error error;
        std::vector<inside::Sentence> sentences;
        std::shared_ptr<const image::CompiledProgram> program; // its ranges are in
        std::optional<history::Position> more;                 // there are changes before this one
    };
    void askAgain(kit::AskWhy question);
    static Answer answerOf(InsideDesk::Bench& bench, const Asked& asked, const inside::Question& question);
    static Answer writersOf(InsideDesk::Bench& bench, const inside::Question& question, history::Position at,
                            bool isFirst);
    void show(const Answer& answer, bool isMore);
    QTreeWidgetItem* add(QTreeWidgetItem* parent, const inside::Sentence& sentence, const Answer& answer);
    void goTo(QTreeWidgetItem* item);
    void showMore(QTreeWidgetItem* item);
    void showMenu(const QPoint& position);
    void showState(const QString& text, bool isError);
    void setWaiting(bool isWaiting);

    InsideDesk& m_desk;
    RunControl& m_control;
    Asked m_asked;
    unsigned m_number = 0; // of the question; an answer to an older one is dropped
    std::vector<std::shared_ptr<const image::CompiledProgram>> m_programs;
    std::vector<std::pair<SourceRange, const image::CompiledProgram*>> m_places; // by the role of an item
    kit::ExpressionEdit* m_input;
    QToolButton *m_why, *m_whyNot, *m_who, *m_cancel;
    bool m_isWaiting = false;
    QLabel* m_state;
    QTreeWidget* m_tree;
};

} // namespace plc::editor
