// The project as it is being edited: its files on disk, overlaid by what the open editors hold, and the newest analysis
// of all of it. Owned by the main window; GUI thread. Checking runs on one worker thread; a result that a newer text
// overtook is dropped (flow 1).
#pragma once
#include "projects/analysis/code_model.h"
#include "projects/model/project.h"
#include "runtime/base/result.h"

#include <QFileSystemWatcher>
#include <QObject>
#include <QString>
#include <QTimer>

#include <condition_variable>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

namespace plc::editor {

class Workspace : public QObject {
    Q_OBJECT
public:
    explicit Workspace(QObject* parent = nullptr);
    ~Workspace() override;

    Result<void> open(const QString& folder);
    void close();
    [[nodiscard]] bool isOpen() const { return m_project.has_value(); }
    [[nodiscard]] const projects::Project& project() const { return *m_project; }
    [[nodiscard]] QString folder() const;
    /// What would be built now: open editors included.
    [[nodiscard]] driver::BuildInput buildInput() const;
    /// Source and test files by their path in the project ("src/main.st"), in order.
    [[nodiscard]] QStringList files() const;
    [[nodiscard]] static bool isTestFile(const QString& file) { return file.startsWith("tests/"); }
    [[nodiscard]] QString absolutePath(const QString& file) const;

    [[nodiscard]] std::string text(const QString& file) const;
    /// As it was read or saved last.
    [[nodiscard]] std::string savedText(const QString& file) const;
    void setText(const QString& file, std::string text); // an editor's content; starts a check
    [[nodiscard]] bool isModified(const QString& file) const;
    [[nodiscard]] QStringList modifiedFiles() const;
    /// What is done about a file whose mode has no w.
    enum class ReadOnly : uint8_t { Keep, Replace };
    Result<void> save(const QString& file, ReadOnly readOnly = ReadOnly::Keep);
    /// Nobody may write the file (or this user may not); also where the user could all the same, as root can.
    [[nodiscard]] bool isReadOnly(const QString& file) const;
    Result<void> makeWritable(const QString& file);
    /// Of tests: who says whether a file on disk is read-only.
    void setAccess(std::function<bool(const QString& absolute)> isReadOnly) { m_isReadOnly = std::move(isReadOnly); }
    Result<void> saveAll();
    void revert(const QString& file); // back to what is on disk
    Result<void> addFile(const QString& file, const std::string& text);
    Result<void> removeFile(const QString& file);
    Result<void> renameFile(const QString& from, const QString& to);
    /// Looks for what other programs have changed, where nobody reports it.
    void lookAtDisk();
    /// Panels, traces and settings as they stand on disk now; the texts stay as edited.
    Result<void> rereadProject();
    /// Writes what `json` says otherwise than the project's own; what another program wrote meanwhile stays. Wrong
    /// settings are refused, and nothing is written.
    Result<void> saveProjectFile(const nlohmann::ordered_json& json);

    [[nodiscard]] std::shared_ptr<const analysis::CodeModel> model() const { return m_model; }
    void announce(); // the newest analysis again, to views that are new
    void checkNow(); // without waiting for the pause in typing
    /// The model of the texts as they are now: waits for it, at most some seconds; null when it does not come.
    [[nodiscard]] std::shared_ptr<const analysis::CodeModel> presentModel();

    /// Side files of unsaved texts, found after a crash: file → text.
    [[nodiscard]] std::map<QString, std::string> recoverable() const;
    void discardRecovery();

signals:
    void opened();
    void closed();
    void filesChanged();
    void settingsChanged();                 // project.json says something else, here or on disk
    void textReplaced(const QString& file); // changed from outside or reverted: editors load it again
    void modificationChanged(const QString& file, bool modified);
    void changedOnDiskAndHere(const QString& file); // the user must choose
    void analysed(std::shared_ptr<const plc::analysis::CodeModel> model);
    void saved(const QString& file);
    void accessChanged(const QString& file, bool isReadOnly);
    /// The file is not UTF-8; saving it writes the encoding it was found in.
    void encodingFound(const QString& file, const QString& encoding);

private:
    struct File {
        std::string text; // as edited
        std::string onDisk;
    };
    /// What the worker checks; it reads what names variables elsewhere (panels, texts, traces) from the folder itself.
    struct Job {
        driver::BuildInput input;
        std::string folder; // empty: no project on disk
        uint64_t revision = 0;
    };
    struct Answer {
        std::vector<std::string> companions; // as they are on disk
        std::shared_ptr<const analysis::CodeModel> model;
    };
    void startCheck();
    void takeAnswer(Answer answer);
    void takeFile(const QString& file, const std::string& text);
    void tellEncodings();
    void workerLoop();
    void readDiskChange(const QString& absolute);
    void readFolderChange();
    void takeSettings(projects::Project changed);
    [[nodiscard]] bool isNewerOnDisk(const QString& file) const;
    void watchFiles();
    void autosave();
    [[nodiscard]] QString sideFile(const QString& file) const;

    std::optional<projects::Project> m_project;
    std::map<QString, File> m_files;
    std::function<bool(const QString&)> m_isReadOnly;
    std::shared_ptr<const analysis::CodeModel> m_model;
    QFileSystemWatcher m_watcher;
    QTimer m_pause;
    QTimer m_autosave;
    uint64_t m_revision = 0;

    std::mutex m_mutex;
    std::condition_variable m_wake;
    std::optional<Job> m_job;
    bool m_quit = false;
    std::thread m_worker;
};

} // namespace plc::editor
