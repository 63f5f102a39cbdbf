#include "editor/kit/inputs/text_question.h"

#include "editor/kit/inputs/complaint.h"

#include <QDialogButtonBox>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace plc::kit {

namespace {
constexpr int kWidth = 340; // pixels, so that a reason has two lines rather than five
}

TextQuestion::TextQuestion(const QString& title, const QString& label, const QString& present, Take take,
                           QWidget* parent)
    : QInputDialog(parent), m_take(std::move(take)), m_complaint(new Complaint(this)) {
    setWindowTitle(title);
    setLabelText(label);
    setTextValue(present);
    (void)sizeHint(); // Qt makes the layout here
    if (auto* column = qobject_cast<QVBoxLayout*>(layout())) column->insertWidget(column->count() - 1, m_complaint);
    layout()->setSizeConstraint(QLayout::SetDefaultConstraint); // Qt's own lets nobody widen it
    setMinimumSize(0, 0); // the layout's: a long label is not cut, whatever the size of the letters
    if (auto* line = findChild<QLineEdit*>()) line->setMinimumWidth(kWidth);
    setMaximumSize(QWIDGETSIZE_MAX, QWIDGETSIZE_MAX);
    const auto changed = [this](const QString& text) {
        if (auto* buttons = findChild<QDialogButtonBox*>())
            if (QPushButton* ok = buttons->button(QDialogButtonBox::Ok)) ok->setEnabled(!text.trimmed().isEmpty());
        m_complaint->say({}, findChild<QLineEdit*>());
    };
    changed(present);
    connect(this, &QInputDialog::textValueChanged, this, changed);
}

QString TextQuestion::complaint() const { return m_complaint->text(); }

void TextQuestion::done(int result) {
    if (result != Accepted) return QInputDialog::done(result);
    const QString text = textValue().trimmed();
    if (text.isEmpty()) return; // the button is off as well
    const QString complaint = m_take(text);
    if (complaint.isEmpty()) return QInputDialog::done(result);
    m_complaint->say(complaint, findChild<QLineEdit*>());
    resize(width(), std::max(height(), layout()->totalHeightForWidth(width())));
}

} // namespace plc::kit
