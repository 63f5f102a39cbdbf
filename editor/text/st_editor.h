// One ST file in the studio: QScintilla with the compiler's colours, folding, indentation, completion, diagnostics and
// fixes, breakpoints, the executed line and online values beside the text. Owned by its tab; GUI thread. It knows no
// controller: values come through OnlineValues, requests leave as signals.
#pragma once
#include "editor/kit/ask_why.h"
#include "editor/text/exact_text.h"
#include "editor/text/st_lexer.h"
#include "projects/analysis/block_structure.h"
#include "projects/analysis/code_model.h"

#include <QTimer>
#include <Qsci/qsciscintilla.h>

#include <functional>
#include <map>
#include <set>

namespace plc::editor {

using analysis::BlockMark, analysis::BlockPair, analysis::FoldLine;
using analysis::closesBlock, analysis::findBlocks, analysis::foldLines, analysis::indentAfter, analysis::missingEnd,
    analysis::opensBlock;

/// Asks for the present text of values; empty = nothing to show.
struct OnlineValue {
    QString name, value;
    bool isBool = false, isTrue = false, isForced = false;
    bool isAccumulator = false;   // the current result of a line of an instruction list
    QString before;               // what it was at the line's begin, where the line has changed it
    std::optional<uint32_t> loop; // the value is the pass of this loop
    bool operator==(const OnlineValue&) const = default;
};
using OnlineValues =
    std::function<std::vector<OnlineValue>(const std::vector<std::pair<QString, QString>>& namesWithPou)>;

struct EditorSettings {
    int indent = 4;
    bool upperCaseKeywords = true;
    bool autoCloseBlocks = true;
    bool showOnlineValues = true;
    int zoom = 0;
};

class StEditor : public QsciScintilla {
    Q_OBJECT
public:
    explicit StEditor(QWidget* parent = nullptr);

    /// Gives the path of a name as seen from a POU, for what is dragged out of the text; empty: no variable.
    using PathOf = std::function<QString(const QString& name, const QString& pou)>;
    void setPathOf(PathOf pathOf) { m_pathOf = std::move(pathOf); }
    QMimeData* toMimeData(const QByteArray& text, bool rectangular) const override;

    void setFile(const QString& file) { m_file = file; }
    [[nodiscard]] const QString& file() const { return m_file; }
    void setSettings(const EditorSettings& settings);
    /// Replaces the whole text and forgets undo (loading).
    void load(const std::string& text);
    /// Replaces what differs, as one step of undo, for those who hold this text already: nothing is emitted.
    void takeText(const std::string& text);
    /// What Ctrl+Z and Ctrl+Y do when changes of several files belong together; else the editor's own undo.
    void setUndo(std::function<void()> undo, std::function<void()> redo) {
        m_undo = std::move(undo);
        m_redo = std::move(redo);
    }
    [[nodiscard]] std::string utf8() const;
    /// Marks lines that differ from this text.
    void setSavedText(const std::string& text);
    void setModel(std::shared_ptr<const analysis::CodeModel> model);
    [[nodiscard]] const std::vector<diagnostics::Diagnostic>& diagnosticsHere() const { return m_diagnostics; }
    /// The second view of a split shows the same document.
    void shareDocumentOf(StEditor& other);

    // positions in bytes
    [[nodiscard]] uint32_t cursorOffset() const;
    void goTo(uint32_t offset, uint32_t length = 0);
    void goToLine(int line);                                     // 1-based
    [[nodiscard]] uint32_t offsetOf(int line, int column) const; // 1-based, column in characters
    /// One undo step; offsets are of the present text, edits do not overlap.
    void applyEdits(std::vector<diagnostics::TextEdit> edits);
    [[nodiscard]] QString wordUnderCursor() const;
    /// Of the main selection; QsciScintilla's writes all of them into a buffer for the last one.
    [[nodiscard]] QString selectedText() const;

    void setBreakpoints(const std::set<int>& lines, const std::set<int>& disabled = {}); // 1-based
    /// Where edits have moved them since: old line → new line, of those that moved.
    [[nodiscard]] std::map<int, int> movedBreakpoints() const;
    void setExecutedLine(int line); // 0 = none
    void setFaultLine(int line);    // where the controller has stopped with a fault; 0 = none
    /// They move with their lines.
    void toggleBookmark(int line);                 // from 0
    [[nodiscard]] std::set<int> bookmarks() const; // from 1
    void goToBookmark(int direction);              // the next one, 1, or the one before, -1; around the end
    void setOnlineValues(OnlineValues values);
    void refreshOnlineValues();
    /// What a recorded scan did in this text, in the place of the live values; none: these again.
    /// `atMoment` runs what it is given while the online values are those of the same moment; empty: they are.
    using AtMoment = std::function<void(const std::function<void()>&)>;
    void setExactText(std::optional<ExactText> exact, AtMoment atMoment = {});
    /// Runs it while the online values are those of the moment that the text shows.
    void atShownMoment(const std::function<void()>& read) const;
    [[nodiscard]] const std::optional<ExactText>& exactText() const { return m_exact; }
    [[nodiscard]] bool showsValues() const { return m_settings.showOnlineValues; }
    [[nodiscard]] bool isAsAnalysed() const { return m_isAsAnalysed; }
    /// Of the analysed text.
    [[nodiscard]] const std::vector<analysis::AccumulatorPlace>& accumulators() const { return m_accumulators; }
    /// By line from 1, in a margin of its own; none: no margin.
    void setCoverage(const std::map<int, LineCoverage>& lines);
    /// What the line's coverage says, with edits taken into account; line from 0.
    [[nodiscard]] QString coverageAt(int line) const;
    [[nodiscard]] std::optional<LineCoverage> coverageOf(int line) const;
    /// Bytes of the lines in sight.
    [[nodiscard]] std::pair<uint32_t, uint32_t> visibleRange() const;
    /// What stands beside the lines now, by line from 0.
    [[nodiscard]] const std::vector<std::pair<int, std::vector<OnlineValue>>>& shownValues() const {
        return m_shownValues;
    }

    struct NamedValue {
        QString name, pou; // as written, and the unit around
    };
    /// The variable at a place, with its members and indices; none where the text is not the analysed one.
    [[nodiscard]] std::optional<NamedValue> variableAt(uint32_t at) const;

    /// What a question of the menu is about: the selection within a line, else the variable at the cursor.
    [[nodiscard]] std::optional<NamedValue> askedAbout() const;

    // commands (also in the menus)
    void triggerCompletion();
    void showParameterHelp();
    void applyFix(); // Alt+Enter: a menu when there are several
    void toggleComment();
    void duplicateLine();
    void moveLines(int direction); // -1: up, 1: down; the lines of every selection
    void selectBlock();
    void selectNextOccurrence(); // one more caret, where the selected word stands next
    void goToMatchingWord();
    void formatText();
    [[nodiscard]] bool goToDiagnostic(int direction); // F4, Shift+F4 within this file
    void highlightAll(const QString& text, bool regex, bool caseSensitive);

signals:
    void edited(const QString& file);
    void breakpointToggled(const QString& file, int line);
    void definitionRequested(const QString& file, uint32_t offset);
    void usesRequested(const QString& file, uint32_t offset);
    void renameRequested(const QString& file, uint32_t offset);
    void watchRequested(const QString& expression);
    /// What is selected, else the variable at the cursor, as seen from the unit.
    void whyRequested(plc::kit::AskWhy question, const QString& name, const QString& pou);
    /// The loop that begins there is to be shown in this pass, from 0.
    void passRequested(uint32_t loop, quint64 pass);
    void writeRequested(const QString& name, const QString& pou);
    void forceRequested(const QString& name, const QString& pou);
    void unforceRequested(const QString& name, const QString& pou);
    void cursorMoved(const QString& file, int line, int column);
    void bookmarksChanged();
    void hoverRequested(const QString& file, uint32_t offset, const QPoint& globalPosition);
    /// A fix that changes other files (too).
    void projectEditsRequested(const std::vector<plc::analysis::FileEdits>& edits);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    bool event(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;

private:
    void applyTheme();
    void onTextChanged();
    void updateFolding();
    void updateChangedLines();
    void showDiagnostics();
    void addDeclarations(const diagnostics::Diagnostic& diagnostic,
                         const std::function<void(const QString&, const diagnostics::TextEdit&)>& add) const;
    void highlightAroundCursor();
    void afterCharacter(int character);
    void enterPressed();
    void outdentClosingWord();
    /// Typing the END_… that Enter has put there already is that one, not another.
    bool typeOverEnd();
    void passAutomaticSemicolon();
    bool typeOverSemicolon(const QString& typed);
    void upperCaseWordBefore();
    [[nodiscard]] bool isWordComplete() const;
    void insertCompletion(const analysis::CompletionItem& item);
    void showToolTip(const QPoint& position);
    [[nodiscard]] std::string textRange(uint32_t begin, uint32_t end) const;
    void drawOnlineValues(QPainter& painter);
    void findShownValues();
    [[nodiscard]] const ExactText::Value* exactResult(uint32_t at) const;
    void findDeclared();
    void showExactMarks();
    [[nodiscard]] std::vector<OnlineValue> exactValues(uint32_t begin, uint32_t end) const;
    [[nodiscard]] bool isRun(uint32_t at) const;
    bool clickPass(const QPoint& at);
    [[nodiscard]] std::optional<FileId> fileId() const;

    QString m_file;
    PathOf m_pathOf;
    std::function<void()> m_undo, m_redo;
    EditorSettings m_settings;
    StLexer* m_lexer;
    std::shared_ptr<const analysis::CodeModel> m_model;
    std::vector<diagnostics::Diagnostic> m_diagnostics; // of this file, as of the analysed text
    std::string m_analysedText;
    bool m_isAsAnalysed = false, m_isApplying = false; // the text is m_analysedText; edits of one step are being made
    std::string m_savedText;
    analysis::Completion m_completion;
    std::vector<QString> m_listed; // its items as the list shows them
    OnlineValues m_onlineValues;
    std::map<int, int> m_breakpointMarks; // handle of the mark → line where it was set, from 1
    std::vector<std::pair<int, std::vector<OnlineValue>>> m_shownValues; // by visible line
    std::optional<ExactText> m_exact;
    AtMoment m_atMoment;
    std::map<int, LineCoverage> m_coverage;                 // by handle of a mark
    std::vector<std::pair<QRect, uint32_t>> m_passBoxes;    // where passes of loops are drawn
    std::vector<analysis::AccumulatorPlace> m_accumulators; // of the analysed text
    std::vector<const sema::Symbol*> m_declared;            // of the model, in order of place
    QTimer m_afterEdit;
    QTimer m_afterMove;
    bool m_isLoading = false;
    std::vector<std::pair<long, long>> m_caretsBefore; // anchor and caret, when a click with Alt began
    QPoint m_altClick;
};

} // namespace plc::editor
