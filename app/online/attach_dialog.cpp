#include "app/online/attach_dialog.h"

#include "app/online/attachment.h"
#include "editor/kit/message_text.h"
#include "editor/kit/theme.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

namespace plc::app {

AttachDialog::AttachDialog(Attachment& attachment, QWidget* parent)
    : QDialog(parent), m_attachment(attachment), m_address(new QComboBox), m_code(new QLineEdit),
      m_certificate(new QLineEdit), m_problem(new QLabel),
      m_buttons(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel)) {
    setObjectName("attachDialog");
    setWindowTitle(tr("Attach to a Controller"));
    m_address->setObjectName("address");
    m_address->setEditable(true);
    const auto recent = Attachment::recent();
    for (const auto& [url, trust] : recent) m_address->addItem(url, trust);
    if (recent.isEmpty()) m_address->setEditText("http://127.0.0.1:8080/");
    m_code->setObjectName("code");
    m_code->setEchoMode(QLineEdit::Password);
    m_code->setPlaceholderText(tr("from the file attach-code of the controller"));
    m_certificate->setObjectName("certificate");
    m_certificate->setAccessibleName(tr("Trusted certificate"));
    m_certificate->setPlaceholderText(tr("only for certificates that this computer does not know"));
    connect(m_address, &QComboBox::activated, this,
            [this](int row) { m_certificate->setText(m_address->itemData(row).toString()); });
    if (!recent.isEmpty()) m_certificate->setText(recent.front().second);
    auto* browse = new QToolButton;
    browse->setText(tr("…"));
    browse->setAccessibleName(tr("Choose a certificate"));
    connect(browse, &QToolButton::clicked, this, &AttachDialog::chooseCertificate);
    auto* certificate = new QHBoxLayout;
    certificate->addWidget(m_certificate, 1);
    certificate->addWidget(browse);
    auto* form = new QFormLayout;
    form->addRow(tr("Address"), m_address);
    form->addRow(tr("Code"), m_code);
    form->addRow(tr("Trusted certificate"), certificate);
    m_problem->setObjectName("problem");
    m_problem->setWordWrap(true);
    m_buttons->button(QDialogButtonBox::Ok)->setText(tr("Attach"));
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(form);
    layout->addWidget(m_problem);
    layout->addStretch();
    layout->addWidget(m_buttons);
    connect(m_buttons, &QDialogButtonBox::accepted, this, &AttachDialog::accept);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &AttachDialog::reject);
    connect(&attachment, &Attachment::attached, this, [this] { QDialog::accept(); });
    connect(&attachment, &Attachment::failed, this, &AttachDialog::showProblem);
    m_code->setFocus();
    resize(520, 220);
}

void AttachDialog::chooseCertificate() {
    const QString path = QFileDialog::getOpenFileName(this, tr("Choose a Certificate"), m_certificate->text(),
                                                      tr("Certificates (*.pem *.crt *.cer);;All files (*)"));
    if (!path.isEmpty()) m_certificate->setText(path);
}

void AttachDialog::showProblem(const QString& text) {
    m_isTrying = false;
    m_buttons->button(QDialogButtonBox::Ok)->setEnabled(true);
    m_problem->setStyleSheet(QString("color: %1").arg(kit::colors().bad.name()));
    m_problem->setText(text);
}

void AttachDialog::accept() {
    const QUrl url = QUrl::fromUserInput(m_address->currentText().trimmed());
    const auto begun = m_attachment.attach({url, m_code->text().trimmed(), m_certificate->text().trimmed(), {}});
    if (!begun) return showProblem(kit::messageText(begun.error()));
    m_isTrying = true;
    m_buttons->button(QDialogButtonBox::Ok)->setEnabled(false);
    m_problem->setStyleSheet(QString());
    m_problem->setText(tr("Attaching…"));
}

void AttachDialog::reject() {
    if (m_isTrying) m_attachment.detach();
    QDialog::reject();
}

} // namespace plc::app
