#include "app/settings/settings_dialog.h"

#include "app/settings/translation.h"
#include "editor/kit/mnemonics.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTabWidget>
#include <QTableWidget>
#include <QVBoxLayout>

namespace plc::app {

namespace {

QString nameOf(const QAction* action) { return kit::withoutMnemonic(action->text()); }

} // namespace

SettingsDialog::SettingsDialog(Settings& settings, const QList<QAction*>& actions, QMap<QString, QKeySequence> defaults,
                               QWidget* parent)
    : QDialog(parent), m_settings(settings), m_actions(actions), m_defaults(std::move(defaults)) {
    setWindowTitle(tr("Settings"));
    auto* tabs = new QTabWidget(this);
    tabs->setAccessibleName(windowTitle());
    tabs->addTab(makeGeneral(), tr("General"));
    tabs->addTab(makeEditor(), tr("Editor"));
    tabs->addTab(makeRun(), tr("Running"));
    tabs->addTab(makeShortcuts(), tr("Shortcuts"));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    connect(buttons, &QDialogButtonBox::accepted, this, &SettingsDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(tabs);
    layout->addWidget(buttons);
    resize(560, 520);
}

QWidget* SettingsDialog::makeGeneral() {
    auto* page = new QWidget(this);
    auto* form = new QFormLayout(page);
    m_theme = new QComboBox(page);
    m_theme->addItems({tr("System default"), tr("Light"), tr("Dark"), tr("High contrast")});
    m_theme->setCurrentIndex(static_cast<int>(m_settings.theme()));
    m_language = new QComboBox(page);
    m_language->addItem(tr("System default"), "");
    for (const QString& language : translatedLanguages()) m_language->addItem(ownNameOf(language), language);
    m_language->setCurrentIndex(std::max(0, m_language->findData(m_settings.language())));
    form->addRow(tr("Theme"), m_theme);
    form->addRow(tr("Language of the studio"), m_language);
    return page;
}

QWidget* SettingsDialog::makeEditor() {
    auto* page = new QWidget(this);
    auto* form = new QFormLayout(page);
    const editor::EditorSettings editor = m_settings.editor();
    m_indent = new QSpinBox(page);
    m_indent->setRange(1, 8);
    m_indent->setValue(editor.indent);
    const auto check = [&](const QString& text, bool on) {
        auto* box = new QCheckBox(text, page);
        box->setChecked(on);
        form->addRow(box);
        return box;
    };
    form->addRow(tr("Indentation"), m_indent);
    m_upperCase = check(tr("Write keywords in capitals while typing"), editor.upperCaseKeywords);
    m_autoClose = check(tr("Close blocks with Enter (IF … END_IF)"), editor.autoCloseBlocks);
    m_values = check(tr("Show online values in the text"), editor.showOnlineValues);
    m_formatOnSave = check(tr("Format when saving"), m_settings.formatOnSave());
    return page;
}

QWidget* SettingsDialog::makeRun() {
    auto* page = new QWidget(this);
    auto* form = new QFormLayout(page);
    m_changeOnSave = new QCheckBox(tr("Apply an online change when saving"), page);
    m_changeOnSave->setChecked(m_settings.changeOnSave());
    m_history = new QSpinBox(page);
    m_history->setRange(16, 16384);
    m_history->setSuffix(tr(" MB"));
    m_history->setValue(m_settings.historyMegabytes());
    form->addRow(m_changeOnSave);
    form->addRow(tr("Memory for the recording of every scan"), m_history);
    m_runs = new QSpinBox(page);
    m_runs->setRange(0, 1 << 20);
    m_runs->setSingleStep(256);
    m_runs->setSuffix(tr(" MB"));
    m_runs->setSpecialValueText(tr("none is kept"));
    m_runs->setValue(m_settings.runsMegabytes());
    form->addRow(tr("Disk space for the recordings of earlier runs, per project"), m_runs);
    return page;
}

QWidget* SettingsDialog::makeShortcuts() {
    auto* page = new QWidget(this);
    auto* filter = new QLineEdit(page);
    filter->setPlaceholderText(tr("Filter"));
    m_shortcuts = new QTableWidget(static_cast<int>(m_actions.size()), 2, page);
    m_shortcuts->setHorizontalHeaderLabels({tr("Action"), tr("Shortcut")});
    m_shortcuts->verticalHeader()->hide();
    m_shortcuts->horizontalHeader()->setStretchLastSection(true);
    m_shortcuts->setColumnWidth(0, 300);
    m_shortcuts->setAccessibleName(tr("Shortcuts"));
    for (int row = 0; row < m_actions.size(); ++row) {
        auto* item = new QTableWidgetItem(m_actions[row]->icon(), nameOf(m_actions[row]));
        item->setFlags(item->flags() & ~Qt::ItemIsEditable);
        m_shortcuts->setItem(row, 0, item);
        auto* edit = new QKeySequenceEdit(m_actions[row]->shortcut(), m_shortcuts);
        m_shortcuts->setCellWidget(row, 1, edit);
        edit->setAccessibleName(tr("Shortcut of %1").arg(nameOf(m_actions[row])));
        connect(edit, &QKeySequenceEdit::keySequenceChanged, this, [this, row] {
            m_edited.removeAll(row);
            m_edited << row;
            markConflicts();
        });
    }
    connect(filter, &QLineEdit::textChanged, this, [this](const QString& text) {
        for (int row = 0; row < m_shortcuts->rowCount(); ++row)
            m_shortcuts->setRowHidden(row, !m_shortcuts->item(row, 0)->text().contains(text, Qt::CaseInsensitive));
    });
    filter->setAccessibleName(tr("Filter of the actions"));
    m_conflict = new QLabel(page);
    m_conflict->setWordWrap(true);
    m_conflict->hide();
    auto* defaults = new QPushButton(tr("Restore Defaults"), page);
    connect(defaults, &QPushButton::clicked, this, [this] {
        for (int row = 0; row < m_actions.size(); ++row)
            keysOf(row)->setKeySequence(m_defaults.value(m_actions[row]->objectName()));
    });
    auto* layout = new QVBoxLayout(page);
    layout->addWidget(filter);
    layout->addWidget(m_shortcuts);
    layout->addWidget(m_conflict);
    layout->addWidget(defaults, 0, Qt::AlignLeft);
    return page;
}

QKeySequenceEdit* SettingsDialog::keysOf(int row) const {
    return static_cast<QKeySequenceEdit*>(m_shortcuts->cellWidget(row, 1));
}

/// Which row gives its shortcut up, for one that was edited later or at all; -1 = keeps it.
int SettingsDialog::takenBy(int row) const {
    const QKeySequence keys = keysOf(row)->keySequence();
    if (keys.isEmpty()) return -1;
    int winner = row;
    for (int other = 0; other < m_shortcuts->rowCount(); ++other)
        if (keysOf(other)->keySequence() == keys && m_edited.lastIndexOf(other) > m_edited.lastIndexOf(winner))
            winner = other;
    return winner == row ? -1 : winner;
}

void SettingsDialog::markConflicts() {
    QStringList lost;
    for (int row = 0; row < m_shortcuts->rowCount(); ++row) {
        const int winner = takenBy(row);
        const auto name = [&](int which) { return m_shortcuts->item(which, 0)->text(); };
        m_shortcuts->item(row, 0)->setForeground(winner >= 0 ? kit::colors().bad : kit::colors().text);
        m_shortcuts->item(row, 0)->setToolTip(winner >= 0 ? tr("Another action has the same shortcut") : QString());
        if (winner >= 0)
            lost << tr("%1 is now assigned to “%2” instead of “%3”.")
                        .arg(keysOf(row)->keySequence().toString(QKeySequence::NativeText), name(winner), name(row));
    }
    m_conflict->setText(lost.join('\n'));
    m_conflict->setVisible(!lost.isEmpty());
}

void SettingsDialog::accept() {
    m_settings.setTheme(static_cast<kit::ThemeChoice>(m_theme->currentIndex()));
    m_languageChanged = m_settings.language() != m_language->currentData().toString();
    m_settings.setLanguage(m_language->currentData().toString());
    editor::EditorSettings editor = m_settings.editor();
    editor.indent = m_indent->value();
    editor.upperCaseKeywords = m_upperCase->isChecked();
    editor.autoCloseBlocks = m_autoClose->isChecked();
    editor.showOnlineValues = m_values->isChecked();
    m_settings.setEditor(editor);
    m_settings.setFormatOnSave(m_formatOnSave->isChecked());
    m_settings.setChangeOnSave(m_changeOnSave->isChecked());
    m_settings.setHistoryMegabytes(m_history->value());
    m_settings.setRunsMegabytes(m_runs->value());
    for (int row = 0; row < m_actions.size(); ++row) {
        const QKeySequence keys = takenBy(row) >= 0 ? QKeySequence() : keysOf(row)->keySequence();
        if (keys == m_actions[row]->shortcut()) continue;
        m_actions[row]->setShortcut(keys);
        m_actions[row]->setToolTip(
            keys.isEmpty() ? nameOf(m_actions[row])
                           : QString("%1 (%2)").arg(nameOf(m_actions[row]), keys.toString(QKeySequence::NativeText)));
        m_settings.setShortcut(m_actions[row]->objectName(), keys);
    }
    QDialog::accept();
}

} // namespace plc::app
