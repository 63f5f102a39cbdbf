// A question for one line of text, or one of a list, whose dialog stays open and says what is wrong below the line
// until what was typed is taken. Made on the stack by who asks; GUI thread.
#pragma once
#include <QInputDialog>

#include <functional>

namespace plc::kit {

class Complaint;

class TextQuestion : public QInputDialog {
    Q_OBJECT
public:
    /// Takes the text, given without the blanks around it. Returns what is wrong with it and stays open, or "".
    using Take = std::function<QString(const QString& text)>;
    TextQuestion(const QString& title, const QString& label, const QString& present, Take take, QWidget* parent);

    /// Shows the dialog; true once a text was taken, false when it was cancelled.
    bool ask() { return exec() == Accepted; }
    /// What is shown below the line.
    QString complaint() const;
    void done(int result) override;

private:
    Take m_take;
    Complaint* m_complaint;
};

} // namespace plc::kit
