#include "editor/kit/inputs/text_question.h"

#include "editor/kit/theme.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

namespace plc::kit {

namespace {
constexpr int kWidth = 340; // pixels, so that a reason has two lines rather than five
}

TextQuestion::TextQuestion(const QString& title, const QString& label, const QString& present, Take take,
                           QWidget* parent)
    : QInputDialog(parent), m_take(std::move(take)), m_complaint(new QLabel(this)) {
    setWindowTitle(title);
    setLabelText(label);
    setTextValue(present);
    setMinimumWidth(kWidth);
    m_complaint->setWordWrap(true);
    m_complaint->setTextFormat(Qt::PlainText);
    m_complaint->hide();
    (void)sizeHint(); // Qt makes the layout here
    if (auto* column = qobject_cast<QVBoxLayout*>(layout())) column->insertWidget(column->count() - 1, m_complaint);
    connect(this, &QInputDialog::textValueChanged, this, [this](const QString& text) {
        if (auto* buttons = findChild<QDialogButtonBox*>())
            if (QPushButton* ok = buttons->button(QDialogButtonBox::Ok)) ok->setEnabled(!text.trimmed().isEmpty());
        complain({});
    });
}

QString TextQuestion::complaint() const { return m_complaint->text(); }

void TextQuestion::complain(const QString& text) {
    QPalette palette = m_complaint->palette();
    palette.setColor(QPalette::WindowText, colors().bad);
    m_complaint->setPalette(palette);
    m_complaint->setText(text);
    m_complaint->setVisible(!text.isEmpty());
    if (auto* line = findChild<QLineEdit*>()) line->setAccessibleDescription(text);
    if (text.isEmpty()) return;
    resize(size().expandedTo({width(), layout()->totalHeightForWidth(width())}));
}

void TextQuestion::done(int result) {
    if (result != Accepted) return QInputDialog::done(result);
    const QString text = textValue().trimmed();
    if (text.isEmpty()) return; // the button is off as well
    const QString complaint = m_take(text);
    if (complaint.isEmpty()) return QInputDialog::done(result);
    complain(complaint);
    if (auto* line = findChild<QLineEdit*>()) {
        line->setFocus();
        line->selectAll();
    }
}

} // namespace plc::kit
