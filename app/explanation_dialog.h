// What a diagnostic means, by a wrong and a right program, beside the editor while the mistake is being fixed. Not
// modal; one per window, which owns it. GUI thread.
#pragma once
#include <QDialog>

class QTextBrowser;

namespace plc::app {

class MainWindow;

class ExplanationDialog : public QDialog {
    Q_OBJECT
public:
    explicit ExplanationDialog(QWidget* parent = nullptr);
    /// False when there is no such code (the findings of panels have none).
    bool show(const QString& code);
    [[nodiscard]] QTextBrowser& page() { return *m_page; }

private:
    QTextBrowser* m_page;
};

/// That of the row in the list of problems that has the focus, else of the problem at the cursor.
void explainProblem(MainWindow& window);

} // namespace plc::app
