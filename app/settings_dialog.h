// The settings: look, language of the studio, editor, running, shortcuts. Owned by the main window; GUI thread.
#pragma once
#include "app/settings.h"

#include <QAction>
#include <QDialog>

class QCheckBox;
class QComboBox;
class QSpinBox;
class QTableWidget;

namespace plc::app {

class SettingsDialog : public QDialog {
    Q_OBJECT
public:
    SettingsDialog(Settings& settings, const QList<QAction*>& actions, QWidget* parent);
    void accept() override;
    [[nodiscard]] bool languageChanged() const { return m_languageChanged; }

private:
    QWidget* makeGeneral();
    QWidget* makeEditor();
    QWidget* makeRun();
    QWidget* makeShortcuts();
    void markConflicts();

    Settings& m_settings;
    QList<QAction*> m_actions;
    QComboBox *m_theme, *m_language;
    QSpinBox *m_indent, *m_history;
    QCheckBox *m_upperCase, *m_autoClose, *m_formatOnSave, *m_changeOnSave, *m_values;
    QTableWidget* m_shortcuts;
    bool m_languageChanged = false;
};

} // namespace plc::app
