// Asks twice for a new password and says why it is not taken yet. Lives for one question; GUI thread.
#pragma once
#include <QDialog>

class QLabel;
class QLineEdit;
class QPushButton;

namespace plc::hmi {

class PasswordDialog final : public QDialog {
    Q_OBJECT
public:
    explicit PasswordDialog(const QString& user, QWidget* parent = nullptr);
    QString password() const;
    QLineEdit& first() { return *m_first; }
    QLineEdit& again() { return *m_again; }
    QString problem() const;

private:
    void check();
    QString m_user;
    QLineEdit *m_first, *m_again;
    QLabel* m_problem;
    QPushButton* m_ok;
};

} // namespace plc::hmi
