#include "app/project/rename_dialog.h"

#include "editor/kit/inputs/complaint.h"
#include "editor/kit/theme.h"

#include <QDialogButtonBox>
#include <QFontDatabase>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace plc::app {

RenameDialog::RenameDialog(const QString& old, const std::vector<Place>& places, const QString& note, Check check,
                           QWidget* parent)
    : QDialog(parent), m_check(std::move(check)), m_old(old), m_name(new QLineEdit(old, this)),
      m_places(new QTreeWidget(this)), m_complaint(new kit::Complaint(this)) {
    setWindowTitle(tr("Rename"));
    resize(720, 420);
    auto* label = new QLabel(tr("New name of %1, in the whole project:").arg(old), this);
    label->setBuddy(m_name);
    m_name->selectAll();
    m_places->setHeaderLabels({tr("Place"), tr("Text")});
    m_places->setRootIsDecorated(false);
    m_places->setUniformRowHeights(true);
    m_places->setAccessibleName(tr("Places that change"));
    for (const Place& place : places) {
        auto* item = new QTreeWidgetItem(m_places, {place.where, place.text});
        item->setForeground(0, kit::colors().muted);
        item->setFont(1, QFontDatabase::systemFont(QFontDatabase::FixedFont));
    }
    m_places->resizeColumnToContents(0);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    buttons->button(QDialogButtonBox::Ok)->setText(tr("Rename"));
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(label);
    layout->addWidget(m_name);
    connect(m_name, &QLineEdit::textChanged, m_complaint, [this] { m_complaint->say({}, m_name); });
    layout->addWidget(m_complaint);
    if (!note.isEmpty()) {
        auto* more = new QLabel(note, this);
        more->setWordWrap(true);
        layout->addWidget(more);
    }
    layout->addWidget(new QLabel(tr("%n place(s) change:", nullptr, static_cast<int>(places.size())), this));
    layout->addWidget(m_places, 1);
    layout->addWidget(buttons);
    m_name->setFocus();
}

QString RenameDialog::name() const { return m_name->text().trimmed(); }

QString RenameDialog::complaint() const { return m_complaint->text(); }

void RenameDialog::accept() {
    if (name().isEmpty()) return;
    const QString complaint = name() == m_old ? QString() : m_check(name());
    if (complaint.isEmpty()) return QDialog::accept();
    m_complaint->say(complaint, m_name);
}

} // namespace plc::app
