#include "app/project/libraries_dialog.h"

#include "runtime/compiler/driver/driver.h"

#include <QCheckBox>
#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QVBoxLayout>

#include <algorithm>

namespace plc::app {

LibrariesDialog::LibrariesDialog(const std::vector<std::string>& used, QWidget* parent) : QDialog(parent) {
    setWindowTitle(QCoreApplication::translate("plc::app::MainWindow", "Libraries"));
    auto* layout = new QVBoxLayout(this);
    for (const std::string& name : driver::libraryNames()) {
        auto* box = new QCheckBox(QString::fromStdString(name), this);
        box->setChecked(std::find(used.begin(), used.end(), name) != used.end());
        layout->addWidget(box);
        m_boxes.emplace_back(name, box);
    }
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    layout->addWidget(buttons);
}

std::vector<std::string> LibrariesDialog::chosen() const {
    std::vector<std::string> out;
    for (const auto& [name, box] : m_boxes)
        if (box->isChecked()) out.push_back(name);
    return out;
}

} // namespace plc::app
