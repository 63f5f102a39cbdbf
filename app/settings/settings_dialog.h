// The settings: look, language of the studio, editor, running, shortcuts. Owned by the main window; GUI thread.
#pragma once
#include "app/settings/settings.h"

#include <QAction>
#include <QDialog>
#include <QKeySequence>
#include <QMap>

class QCheckBox;
class QComboBox;
class QKeySequenceEdit;
class QLabel;
class QSpinBox;
class QTableWidget;

namespace plc::app {

class SettingsDialog : public QDialog {
    Q_OBJECT
public:
    /// `defaults`: the shortcuts that actions have unless the user gives them others, by the name of the action.
    SettingsDialog(Settings& settings, const QList<QAction*>& actions, QMap<QString, QKeySequence> defaults,
                   QWidget* parent);
    void accept() override;
    [[nodiscard]] bool languageChanged() const { return m_languageChanged; }

private:
    QWidget* makeGeneral();
    QWidget* makeEditor();
    QWidget* makeRun();
    QWidget* makeShortcuts();
    void markConflicts();
    [[nodiscard]] QKeySequenceEdit* keysOf(int row) const;
    [[nodiscard]] int takenBy(int row) const;

    Settings& m_settings;
    QList<QAction*> m_actions;
    QMap<QString, QKeySequence> m_defaults;
    QComboBox *m_theme, *m_language;
    QSpinBox *m_indent, *m_history, *m_runs;
    QCheckBox *m_upperCase, *m_autoClose, *m_formatOnSave, *m_changeOnSave, *m_values;
    QTableWidget* m_shortcuts;
    QLabel* m_conflict;
    QList<int> m_edited; // rows, the last one wins a shortcut
    bool m_languageChanged = false;
};

} // namespace plc::app
