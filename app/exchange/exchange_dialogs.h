// File > Import and File > Export: what would be read or written is shown with its report before anything is. The
// dialogs live as long as they are open; GUI thread.
#pragma once
#include "projects/exchange/import.h"

#include <QDialog>

#include <memory>
#include <utility>
#include <vector>

class QComboBox;
class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QPushButton;
class QTreeWidget;

namespace plc {
struct Error;
}
namespace plc::exchange {
struct Exported;
} // namespace plc::exchange
namespace plc::projects {
struct Project;
}

namespace plc::app {

class ImportDialog : public QDialog {
    Q_OBJECT
public:
    ImportDialog(const QString& projectsFolder, QWidget* parent);
    /// Reads a file or folder and shows what it holds; nothing is written.
    void preview(const QString& path);
    /// Writes the projects that are checked; false with a complaint in the dialog when that is refused or cancelled:
    /// then nothing is written.
    bool write();
    [[nodiscard]] QString folder() const; // of the new project, the first one of several
    /// Writes first; what cannot be written stays open.
    void accept() override;

private:
    void choose(bool isFolder);
    void addEncodings();
    void readAgain();
    void complain(const Error& error);
    void clear();
    void showProjects();
    void showCurrent();
    void check();
    [[nodiscard]] std::pair<int, int> current() const; // project and file; -1: none
    [[nodiscard]] std::vector<exchange::Imported> chosen() const;
    QString m_projectsFolder;
    std::vector<exchange::Imported> m_projects; // none: nothing is shown
    int m_shown = -1;                           // the project whose report is shown
    QString m_path;                             // that is shown
    QLineEdit *m_source, *m_target;
    QComboBox* m_encoding;
    QTreeWidget *m_files, *m_notes;
    QPlainTextEdit* m_text;
    QLabel *m_summary, *m_complaint;
    QPushButton* m_import;
};

class ExportDialog : public QDialog {
    Q_OBJECT
public:
    ExportDialog(const projects::Project& project, QWidget* parent);
    bool write();
    void setTarget(const QString& path);
    /// Writes first; what cannot be written stays open.
    void accept() override;

private:
    void preview();
    void check();
    const projects::Project& m_project;
    std::shared_ptr<const exchange::Exported> m_exported; // null: nothing is shown
    QComboBox* m_version;
    QLineEdit* m_target;
    QTreeWidget* m_notes;
    QLabel *m_summary, *m_complaint;
    QPushButton* m_export;
};

} // namespace plc::app
