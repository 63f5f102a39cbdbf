#include "app/online/native_program.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProcess>
#include <QPushButton>
#include <QSysInfo>
#include <QToolButton>
#include <QVBoxLayout>

namespace plc::app {

namespace {

/// Machine and file; stays open while the process works, and with what it says when it fails.
class NativeProgramDialog : public QDialog {
    Q_DECLARE_TR_FUNCTIONS(plc::app::NativeProgramDialog)
public:
    NativeProgramDialog(QWidget* window, const QString& folder, const std::function<void()>& save);
    [[nodiscard]] QString output() const { return m_output->text(); }
    void accept() override;
    void reject() override;

private:
    void finish(int code);
    const QString m_folder;
    const std::function<void()>& m_save;
    QComboBox* m_target = new QComboBox;
    QLineEdit* m_output = new QLineEdit;
    QLabel* m_problem = new QLabel;
    QDialogButtonBox* m_buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    QProcess m_process;
};

NativeProgramDialog::NativeProgramDialog(QWidget* window, const QString& folder, const std::function<void()>& save)
    : QDialog(window), m_folder(folder), m_save(save) {
    setObjectName("nativeProgramDialog");
    setWindowTitle(tr("Build a Native Program"));
    m_target->addItems({"x86_64", "aarch64"});
    m_target->setCurrentText(QSysInfo::buildCpuArchitecture() == "arm64" ? "aarch64" : "x86_64");
    m_target->setObjectName("target");
    m_output->setText(folder + "/" + QFileInfo(folder).fileName() + "-" + m_target->currentText());
    m_output->setObjectName("output");
    m_output->setAccessibleName(tr("File"));
    auto* browse = new QToolButton;
    browse->setText(tr("…"));
    browse->setAccessibleName(tr("Choose the file"));
    connect(browse, &QToolButton::clicked, this, [this] {
        const QString path = QFileDialog::getSaveFileName(this, tr("Native Program"), m_output->text());
        if (!path.isEmpty()) m_output->setText(path);
    });
    auto* output = new QHBoxLayout;
    output->addWidget(m_output, 1);
    output->addWidget(browse);
    auto* form = new QFormLayout;
    form->addRow(tr("Machine"), m_target);
    form->addRow(tr("File"), output);
    auto* about = new QLabel(tr("The program runs without Stepwise on a machine with Linux: its PLC code and a small "
                                "runner in one file."));
    about->setWordWrap(true);
    m_problem->setObjectName("problem");
    m_problem->setWordWrap(true);
    m_buttons->button(QDialogButtonBox::Ok)->setText(tr("Build"));
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(about);
    layout->addLayout(form);
    layout->addWidget(m_problem);
    layout->addStretch();
    layout->addWidget(m_buttons);
    connect(m_buttons, &QDialogButtonBox::accepted, this, &NativeProgramDialog::accept);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &NativeProgramDialog::reject);
    connect(&m_process, &QProcess::finished, this, [this](int code) { finish(code); });
    connect(&m_process, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
        if (error == QProcess::FailedToStart) m_problem->setText(m_process.errorString());
    });
    resize(520, 220);
}

void NativeProgramDialog::accept() {
    m_save(); // the process reads the files
    m_buttons->button(QDialogButtonBox::Ok)->setEnabled(false);
    m_problem->setText(tr("Building…"));
    m_process.setProcessChannelMode(QProcess::MergedChannels);
    m_process.start(QCoreApplication::applicationFilePath(),
                    {"build", m_folder, "--target", m_target->currentText(), "--output", m_output->text()});
}

void NativeProgramDialog::finish(int code) {
    m_buttons->button(QDialogButtonBox::Ok)->setEnabled(true);
    if (code != 0) return m_problem->setText(QString::fromUtf8(m_process.readAll()).trimmed());
    QDialog::accept();
}

void NativeProgramDialog::reject() {
    m_process.disconnect(this);
    m_process.kill();
    m_process.waitForFinished(2000);
    QDialog::reject();
}

} // namespace

QString buildNativeProgram(QWidget* window, const QString& folder, const std::function<void()>& save) {
    NativeProgramDialog dialog(window, folder, save);
    if (dialog.exec() != QDialog::Accepted) return {};
    return NativeProgramDialog::tr("%1 is built").arg(dialog.output());
}

} // namespace plc::app
