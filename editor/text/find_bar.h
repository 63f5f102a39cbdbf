// Find and replace in the open file: as you type, with regular expressions, case, whole words; Enter next, Shift+Enter
// before, Esc closes. Owned by the tab it lies under; GUI thread.
#pragma once
#include <QWidget>

class QCheckBox;
class QLabel;
class QLineEdit;
class QToolButton;

namespace plc::editor {

class StEditor;

class FindBar : public QWidget {
    Q_OBJECT
public:
    explicit FindBar(StEditor& editor, QWidget* parent = nullptr);
    /// The side of a split it searches in.
    void setEditor(StEditor& editor);
    void open(bool withReplace);
    void findNext();
    void findPrevious();
    void replaceOne();
    int replaceAll();
    [[nodiscard]] QLineEdit& findField() { return *m_find; }
    [[nodiscard]] QLineEdit& replaceField() { return *m_replace; }

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    bool find(bool forward, bool fromStart);
    void countMatches();

    void close();

    StEditor* m_editor;
    QLineEdit* m_find;
    QLineEdit* m_replace;
    QToolButton *m_regex, *m_case, *m_word;
    QLabel* m_count;
    QWidget* m_replaceRow;
};

} // namespace plc::editor
