// A text as it is here beside the same text as another program has written it: the differences one after the other,
// each taken over with one key, or by hand in the left one. GUI thread.
#pragma once
#include "editor/text/line_diff.h"

#include <QDialog>

#include <string>
#include <vector>

class QLabel;
class QsciScintilla;
class QSplitter;
class QToolButton;

namespace plc::app {

class MergeDialog : public QDialog {
    Q_OBJECT
public:
    MergeDialog(const QString& file, const std::string& here, const std::string& onDisk, QWidget* parent);
    /// The left text, with what was taken over.
    [[nodiscard]] std::string merged() const;
    [[nodiscard]] const std::vector<editor::Hunk>& hunks() const { return m_hunks; }
    [[nodiscard]] int currentHunk() const { return m_current; } // -1: there is none
    void goToHunk(int index);
    void takeOver(); // the current one
    void takeAll();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QsciScintilla* addSide(const QString& title, const std::string& text, QSplitter* sides, const QString& file);
    void setLeft(const std::string& text);
    void compare();
    void markHunks();
    void scrollAlong(QsciScintilla& from, QsciScintilla& to, bool isFromHere);

    std::string m_onDisk;
    std::vector<editor::Hunk> m_hunks;
    int m_current = -1;
    QsciScintilla *m_here, *m_disk;
    QLabel* m_where = nullptr;
    std::vector<QToolButton*> m_buttons;
    bool m_isScrolling = false;
};

} // namespace plc::app
