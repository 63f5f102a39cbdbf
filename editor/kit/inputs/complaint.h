// What is wrong with what was typed, below its line in a dialog; hidden while nothing is. Owned by its Qt parent; GUI
// thread.
#pragma once
#include <QLabel>

class QLineEdit;

namespace plc::kit {

class Complaint : public QLabel {
    Q_OBJECT
public:
    explicit Complaint(QWidget* parent);
    /// "" takes it away. Else the line has the keyboard, with all of it selected, and says it to those who cannot see.
    void say(const QString& text, QLineEdit* line);
};

} // namespace plc::kit
