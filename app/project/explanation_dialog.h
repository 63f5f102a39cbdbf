// What a diagnostic means, by a wrong and a right program, beside the editor while the mistake is being fixed. Not
// modal; one per window, which owns it. GUI thread.
#pragma once
#include <QDialog>

class QTextBrowser;

namespace plc::app {

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

} // namespace plc::app
