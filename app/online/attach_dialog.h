// Which controller to attach to: address, code, the certificate that is trusted. Stays open with what is wrong until
// the controller is attached. Made for one question; modal; GUI thread.
#pragma once
#include <QDialog>

class QComboBox;
class QDialogButtonBox;
class QLabel;
class QLineEdit;

namespace plc::app {

class Attachment;

class AttachDialog : public QDialog {
    Q_OBJECT
public:
    AttachDialog(Attachment& attachment, QWidget* parent = nullptr);
    void accept() override; // begins to attach
    void reject() override; // also ends the attempt

private:
    void chooseCertificate();
    void showProblem(const QString& text);
    Attachment& m_attachment;
    QComboBox* m_address;
    QLineEdit *m_code, *m_certificate;
    QLabel* m_problem;
    QDialogButtonBox* m_buttons;
    bool m_isTrying = false;
};

} // namespace plc::app
