// New projects from templates (empty, motor, PID loop, sequence) and new program units (program, block, function, type,
// interface, globals, test): what is written, and the two dialogs that ask. The texts are plain functions; the dialogs
// are GUI.
#pragma once
#include "runtime/base/result.h"

#include <QDialog>
#include <QString>

#include <string>
#include <vector>

class QComboBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;

#include <set>

namespace plc::app {

struct ProjectTemplate {
    const char* id;
    const char* title; // translated when shown
    const char* summary;
};
[[nodiscard]] const std::vector<ProjectTemplate>& projectTemplates();
/// A copy of a project without what runs and editors left beside it.
Result<void> copyProject(const std::string& from, const std::string& to);
struct ExampleCopy {
    QString folder;
    bool isNew = false;
};
/// The user's own copy of a shipped example in `projects`: the one made earlier, or a `fresh` one beside it.
Result<ExampleCopy> copyExample(const QString& example, const QString& projects, bool fresh);
/// Makes the folder with its files; refuses a folder that is not empty.
Result<void> createProject(const std::string& folder, const std::string& name, const std::string& templateId);

struct UnitTemplate {
    const char* id;
    const char* title;
    const char* word; // "program"
};
[[nodiscard]] const std::vector<UnitTemplate>& unitTemplates();
[[nodiscard]] std::string unitText(const std::string& templateId, const std::string& name);

class NewProjectDialog : public QDialog {
    Q_OBJECT
public:
    explicit NewProjectDialog(QWidget* parent);
    [[nodiscard]] QString folder() const;
    [[nodiscard]] QString name() const;
    [[nodiscard]] QString templateId() const;

private:
    void check();
    QListWidget* m_templates;
    QLineEdit *m_name, *m_parent;
    QLabel* m_complaint;
    QPushButton* m_create;
};

class NewUnitDialog : public QDialog {
    Q_OBJECT
public:
    /// `taken`: names of the project at the top, folded.
    NewUnitDialog(const QStringList& files, std::set<std::string> taken, QWidget* parent);
    void preset(const QString& templateId, const QString& file);
    [[nodiscard]] QString name() const;
    [[nodiscard]] QString templateId() const;
    [[nodiscard]] QString file() const; // existing one to append to, or a new one

private:
    void check();
    QStringList m_files;
    std::set<std::string> m_taken;
    QComboBox *m_kind, *m_file;
    QLineEdit* m_name;
    QLabel* m_complaint;
    QPushButton* m_create;
};

} // namespace plc::app
