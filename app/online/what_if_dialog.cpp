#include "app/online/what_if_dialog.h"

#include "editor/kit/message_text.h"
#include "editor/kit/theme.h"

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

namespace plc::app {

namespace {
enum WhatIfColumn { Path, Was, Instead, Columns };
} // namespace

WhatIfDialog::WhatIfDialog(const editor::RunControl& control, const QStringList& variables,
                           kit::CompletionSource complete, QWidget* parent)
    : QDialog(parent), m_control(control) {
    setWindowTitle(tr("What If?"));
    auto* explained = new QLabel(tr("The controller goes back to the scan shown and continues from there with these "
                                    "values. The trace draws what really happened behind the new curves."),
                                 this);
    explained->setWordWrap(true);
    m_input = new kit::ExpressionEdit(this);
    m_input->setObjectName("whatIfVariable");
    m_input->setPlaceholderText(tr("A variable, such as Main.level"));
    m_input->setAccessibleName(tr("Variable"));
    m_input->setCompletionSource(std::move(complete));
    m_input->setEndsWithCompletion(true);
    auto* add = new QPushButton(tr("Add"), this);
    add->setAutoDefault(false);
    const auto take = [this] {
        addVariable(m_input->text().trimmed());
        m_input->clear();
    };
    connect(add, &QPushButton::clicked, this, take);
    m_table = new QTableWidget(0, Columns, this);
    m_table->setHorizontalHeaderLabels({tr("Variable"), tr("Was"), tr("Instead")});
    m_table->horizontalHeader()->setSectionResizeMode(Path, QHeaderView::Stretch);
    m_table->verticalHeader()->hide();
    m_table->setAccessibleName(tr("Values to change"));
    m_problem = new QLabel(this);
    m_problem->setWordWrap(true);
    QPalette red = m_problem->palette();
    red.setColor(QPalette::WindowText, kit::colors().bad);
    m_problem->setPalette(red);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    buttons->button(QDialogButtonBox::Ok)->setText(tr("Run from Here"));
    connect(buttons, &QDialogButtonBox::accepted, this, &WhatIfDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* row = new QHBoxLayout;
    row->addWidget(m_input, 1);
    row->addWidget(add);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(explained);
    layout->addLayout(row);
    layout->addWidget(m_table, 1);
    layout->addWidget(m_problem);
    layout->addWidget(buttons);
    for (const QString& each : variables) addVariable(each);
    resize(560, 380);
}

void WhatIfDialog::addVariable(const QString& path) {
    if (path.isEmpty()) return;
    const auto shown = m_control.value(path);
    if (shown.text.isEmpty()) {
        m_problem->setText(tr("%1 has no value in this scan; choose another variable").arg(path));
        return;
    }
    m_problem->clear();
    const int row = m_table->rowCount();
    m_table->insertRow(row);
    const auto cell = [&](WhatIfColumn column, const QString& text, bool isEditable) {
        auto* item = new QTableWidgetItem(text);
        if (!isEditable) item->setFlags(item->flags() & ~Qt::ItemIsEditable);
        m_table->setItem(row, column, item);
    };
    cell(Path, path, false);
    cell(Was, shown.text, false);
    cell(Instead, QString(), true);
    m_table->setCurrentCell(row, Instead);
}

std::vector<std::pair<QString, QString>> WhatIfDialog::changes() const {
    std::vector<std::pair<QString, QString>> all;
    for (int row = 0; row < m_table->rowCount(); ++row)
        if (const QString instead = m_table->item(row, Instead)->text().trimmed(); !instead.isEmpty())
            all.emplace_back(m_table->item(row, Path)->text(), instead);
    return all;
}

void WhatIfDialog::accept() {
    m_table->setCurrentItem(nullptr); // what is being typed counts
    for (const auto& [path, value] : changes())
        if (const auto parsed = m_control.parse(path, value); !parsed)
            return m_problem->setText(kit::messageText(parsed.error()));
    if (changes().empty()) return m_problem->setText(tr("Enter a different value for at least one variable"));
    QDialog::accept();
}

} // namespace plc::app
