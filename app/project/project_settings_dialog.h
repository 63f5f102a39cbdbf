// What project.json says of the program and of its panels, as a form. Owned by who shows it; GUI thread.
#pragma once
#include "projects/model/project.h"

#include <QDialog>

class QCheckBox;
class QComboBox;
class QDialogButtonBox;
class QLabel;
class QLineEdit;
class QSpinBox;

namespace plc::app {

class ProjectSettingsDialog : public QDialog {
    Q_OBJECT
public:
    ProjectSettingsDialog(const projects::Project& project, QWidget* parent);
    /// The text of project.json with what was entered. What the form does not show, and what stays as it is when
    /// nothing is said, is left as it was.
    [[nodiscard]] nlohmann::ordered_json json() const;

private:
    QWidget* makeProgram(const projects::Project& project);
    QWidget* makePanels(const projects::Project& project);
    /// OK only while everything entered can be used; otherwise the reason is shown.
    void judge();

    nlohmann::ordered_json m_json;
    std::string m_usualName; // a project without one is named after its folder
    QLineEdit *m_name, *m_symbols, *m_start, *m_font, *m_languageVariable;
    QComboBox *m_addresses, *m_strings, *m_startPanel, *m_frame;
    QSpinBox* m_memory;
    QCheckBox* m_picturesOutside;
    QLabel* m_complaint;
    QDialogButtonBox* m_buttons;
};

} // namespace plc::app
