// A line for an ST expression or a variable name: completion from a callback, and a check whose complaint is shown in
// place. Owned by its Qt parent; GUI thread. It knows no compiler: whoever uses it hands in what completes and what
// checks.
#pragma once

#include "editor/kit/icons.h"

#include <QLineEdit>

#include <functional>
#include <vector>

class QCompleter;
class QStandardItemModel;

namespace plc::kit {

struct Completion {
    QString text;   // what is inserted
    QString detail; // type or comment, shown dimmed
    Icon icon = Icon::Variable;
    int replaceFrom = -1; // where the replaced part begins; -1: the word left of the cursor
};

/// Completions for a text and a cursor position in it.
using CompletionSource = std::function<std::vector<Completion>(const QString& text, int cursor)>;
/// Empty when the text is good, else the complaint.
using TextCheck = std::function<QString(const QString& text)>;

class ExpressionEdit : public QLineEdit {
    Q_OBJECT
public:
    explicit ExpressionEdit(QWidget* parent = nullptr);

    void setCompletionSource(CompletionSource source);
    void setCheck(TextCheck check);
    /// Enter on a completion ends the line as well (where one name is asked for), else it waits for more.
    void setEndsWithCompletion(bool ends) { m_endsWithCompletion = ends; }
    QString complaint() const { return m_complaint; }
    bool isCompletionShown() const;
    QStringList shownCompletions() const;
    /// Opens the list as Ctrl+Space does.
    void complete();

signals:
    void complaintChanged(const QString& complaint);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    bool focusNextPrevChild(bool next) override;
    void focusInEvent(QFocusEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    void refresh(bool forced);
    void insertCompletion(const QModelIndex& index);
    void runCheck();
    bool isWordComplete() const;
    int wordStart() const;

    CompletionSource m_source;
    TextCheck m_check;
    QString m_complaint;
    bool m_endsWithCompletion = false;
    QCompleter* m_completer;
    QStandardItemModel* m_model;
};

} // namespace plc::kit
