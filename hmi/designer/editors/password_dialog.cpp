#include "hmi/designer/editors/password_dialog.h"

#include "editor/kit/message_text.h"
#include "hmi/people/password.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

namespace plc::hmi {

PasswordDialog::PasswordDialog(const QString& user, QWidget* parent)
    : QDialog(parent), m_user(user), m_first(new QLineEdit), m_again(new QLineEdit), m_problem(new QLabel) {
    setWindowTitle(tr("Set Password"));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    m_ok = buttons->button(QDialogButtonBox::Ok);
    auto* layout = new QFormLayout(this);
    layout->addRow(tr("Password of %1:").arg(user), m_first);
    layout->addRow(tr("Repeat:"), m_again);
    layout->addRow(m_problem);
    layout->addRow(buttons);
    m_problem->setWordWrap(true);
    m_problem->setMinimumHeight(2 *
                                m_problem->fontMetrics().lineSpacing()); // the dialog keeps its size while one types
    for (QLineEdit* line : {m_first, m_again}) {
        line->setEchoMode(QLineEdit::Password);
        line->setMinimumWidth(260);
        connect(line, &QLineEdit::textChanged, this, &PasswordDialog::check);
    }
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    check();
}

QString PasswordDialog::password() const { return m_first->text(); }

QString PasswordDialog::problem() const { return m_problem->text(); }

void PasswordDialog::check() {
    const Message weakness = weaknessOf(m_first->text(), m_user);
    const bool isSame = m_first->text() == m_again->text();
    QString problem;
    if (!weakness.isEmpty())
        problem = kit::messageText(weakness);
    else if (!isSame)
        problem = m_again->text().isEmpty() ? tr("Repeat the password.") : tr("The two passwords differ.");
    m_problem->setText(problem);
    m_ok->setEnabled(problem.isEmpty());
}

} // namespace plc::hmi
