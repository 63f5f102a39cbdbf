#include "editor/kit/inputs/complaint.h"

#include "editor/kit/theme.h"

#include <QLineEdit>

namespace plc::kit {

Complaint::Complaint(QWidget* parent) : QLabel(parent) {
    setWordWrap(true);
    setTextFormat(Qt::PlainText);
    hide();
}

void Complaint::say(const QString& text, QLineEdit* line) {
    QPalette inRed = palette();
    inRed.setColor(QPalette::WindowText, colors().bad);
    setPalette(inRed);
    setText(text);
    setVisible(!text.isEmpty());
    if (!line) return;
    line->setAccessibleDescription(text);
    if (text.isEmpty()) return;
    line->setFocus();
    line->selectAll();
}

} // namespace plc::kit
