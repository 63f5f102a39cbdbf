#include "editor/workspace/workspace.h"

#include "editor/kit/post.h"
#include "editor/kit/trash.h"
#include "editor/workspace/project_gone.h"
#include "projects/storage/project_file.h"
#include "runtime/base/messages.h"

#include <QDir>
#include <QEventLoop>
#include <QFile>
#include <QFileInfo>

namespace plc::editor {

namespace {
constexpr int kPauseMs = 15;        // after a keystroke, before a check starts
constexpr int kAutosaveMs = 10'000; // between side files
std::string toStd(const QString& text) { return text.toStdString(); }

/// Root may write everything: the mode says what is meant.
bool hasNoWrite(const QString& absolute) {
    const QFileInfo info(absolute);
    constexpr QFile::Permissions kAny = QFile::WriteOwner | QFile::WriteGroup | QFile::WriteOther;
    return info.exists() && (!info.isWritable() || !(info.permissions() & kAny));
}

} // namespace

Workspace::Workspace(QObject* parent) : QObject(parent), m_isReadOnly(hasNoWrite) {
    m_pause.setSingleShot(true);
    m_pause.setInterval(kPauseMs);
    connect(&m_pause, &QTimer::timeout, this, &Workspace::startCheck);
    m_autosave.setInterval(kAutosaveMs);
    connect(&m_autosave, &QTimer::timeout, this, &Workspace::autosave);
    connect(&m_watcher, &QFileSystemWatcher::fileChanged, this, &Workspace::readDiskChange);
    connect(&m_watcher, &QFileSystemWatcher::directoryChanged, this, &Workspace::readFolderChange);
    m_worker = std::thread([this] { workerLoop(); });
}

Workspace::~Workspace() {
    {
        const std::lock_guard lock(m_mutex);
        m_quit = true;
    }
    m_wake.notify_one();
    m_worker.join();
}

Result<void> Workspace::open(const QString& folder) {
    auto project = projects::openProject({toStd(folder)});
    if (!project) return project.error();
    close();
    m_project = std::move(*project);
    for (const auto* list : {&m_project->sources, &m_project->tests})
        for (const driver::SourceFile& file : *list) takeFile(QString::fromStdString(file.path), file.text);
    watchFiles();
    m_autosave.start();
    emit opened();
    tellEncodings();
    startCheck();
    return {};
}

void Workspace::takeFile(const QString& file, const std::string& text) { m_files[file] = {text, text}; }

void Workspace::tellEncodings() {
    for (const auto& [path, encoding] : m_project->encodings)
        emit encodingFound(QString::fromStdString(path), QString::fromStdString(encoding));
}

void Workspace::close() {
    if (!m_project) return;
    m_autosave.stop();
    m_pause.stop();
    if (!m_watcher.files().isEmpty()) m_watcher.removePaths(m_watcher.files());
    if (!m_watcher.directories().isEmpty()) m_watcher.removePaths(m_watcher.directories());
    m_project.reset();
    m_files.clear();
    m_model.reset();
    ++m_revision; // whatever the worker still computes is old
    emit closed();
}

QString Workspace::folder() const { return m_project ? QString::fromStdString(m_project->folder) : QString(); }

QString Workspace::absolutePath(const QString& file) const {
    return folder().isEmpty() ? QFileInfo(file).absoluteFilePath() : folder() + "/" + file;
}

void Workspace::watchFiles() {
    QStringList paths;
    for (const auto& [file, content] : m_files) paths << absolutePath(file);
    for (const char* part : {"src", "tests"})
        if (QDir(folder() + "/" + part).exists()) paths << folder() + "/" + part;
    if (QFile::exists(folder() + "/project.json")) paths << folder() + "/project.json";
    if (!paths.isEmpty()) m_watcher.addPaths(paths);
}

QStringList Workspace::files() const {
    QStringList out;
    for (const auto& [file, content] : m_files) out << file;
    return out;
}

driver::BuildInput Workspace::buildInput() const {
    driver::BuildInput input;
    if (!m_project) return input;
    input.libraries = m_project->libraries;
    input.defines = m_project->defines;
    input.addressing = m_project->addressing;
    input.memoryForNew = m_project->memoryForNew;
    input.strings = m_project->strings;
    input.companions = m_project->companions;
    for (const auto& [file, content] : m_files)
        if (isTestFile(file))
            input.companions.push_back(content.text);
        else
            input.files.push_back({toStd(file), content.text});
    return input;
}

std::string Workspace::text(const QString& file) const {
    const auto it = m_files.find(file);
    return it == m_files.end() ? std::string() : it->second.text;
}

std::string Workspace::savedText(const QString& file) const {
    const auto it = m_files.find(file);
    return it == m_files.end() ? std::string() : it->second.onDisk;
}

void Workspace::announce() {
    if (m_model) emit analysed(m_model);
}

void Workspace::setText(const QString& file, std::string text) {
    const auto it = m_files.find(file);
    if (it == m_files.end() || it->second.text == text) return;
    const bool was = isModified(file);
    it->second.text = std::move(text);
    if (was != isModified(file)) emit modificationChanged(file, !was);
    m_pause.start();
}

bool Workspace::isModified(const QString& file) const {
    const auto it = m_files.find(file);
    return it != m_files.end() && it->second.text != it->second.onDisk;
}

QStringList Workspace::modifiedFiles() const {
    QStringList out;
    for (const auto& [file, content] : m_files)
        if (content.text != content.onDisk) out << file;
    return out;
}

bool Workspace::isReadOnly(const QString& file) const { return m_isReadOnly(absolutePath(file)); }

Result<void> Workspace::makeWritable(const QString& file) {
    const QString path = absolutePath(file);
    if (!QFile::setPermissions(path, QFileInfo(path).permissions() | QFile::WriteOwner | QFile::WriteUser))
        return Error{errors::PermissionsNotChanged(), toStd(file)};
    emit accessChanged(file, isReadOnly(file));
    return {};
}

Result<void> Workspace::save(const QString& file, ReadOnly readOnly) {
    const auto it = m_files.find(file);
    if (it == m_files.end()) return Error{errors::NoSuchFileInProject(), toStd(file)};
    if (readOnly == ReadOnly::Keep && it->second.text != it->second.onDisk && isReadOnly(file))
        return Error{errors::FileReadOnly(), toStd(file)};
    if (isNewerOnDisk(file)) { // the watcher has not said so yet
        readDiskChange(absolutePath(file));
        return Error{errors::FileChangedOutside(), toStd(file)};
    }
    if (isProjectGone(*m_project)) {
        QDir().mkpath(QFileInfo(absolutePath(file)).path());
        if (auto written = projects::saveProjectFile(*m_project); !written) return written;
    }
    if (auto written = projects::writeSourceText(toStd(absolutePath(file)), it->second.text); !written) return written;
    const bool was = isModified(file);
    it->second.onDisk = it->second.text;
    QFile::remove(sideFile(file));
    m_watcher.addPath(absolutePath(file)); // the exchanged file is a new one to the watcher
    if (was) emit modificationChanged(file, false);
    emit saved(file);
    return {};
}

Result<void> Workspace::saveAll() {
    for (const QString& file : modifiedFiles())
        if (auto done = save(file); !done) return done;
    return {};
}

void Workspace::revert(const QString& file) {
    const auto it = m_files.find(file);
    if (it == m_files.end()) return;
    it->second.text = it->second.onDisk;
    QFile::remove(sideFile(file));
    emit textReplaced(file);
    emit modificationChanged(file, isModified(file));
    m_pause.start();
}

Result<void> Workspace::addFile(const QString& file, const std::string& text) {
    if (m_files.contains(file) || QFile::exists(absolutePath(file))) return Error{errors::FileNameInUse(), toStd(file)};
    QDir().mkpath(QFileInfo(absolutePath(file)).path());
    if (auto written = projects::writeFileAtomically(toStd(absolutePath(file)), text); !written) return written;
    m_files[file] = {text, text};
    watchFiles();
    emit filesChanged();
    startCheck();
    return {};
}

Result<void> Workspace::removeFile(const QString& file) {
    if (!m_files.contains(file)) return Error{errors::NoSuchFileInProject(), toStd(file)};
    if (!kit::removeToTrash(absolutePath(file))) return Error{errors::FileNotRemoved(), toStd(file)};
    QFile::remove(sideFile(file));
    m_files.erase(file);
    emit filesChanged();
    startCheck();
    return {};
}

Result<void> Workspace::renameFile(const QString& from, const QString& to) {
    if (!m_files.contains(from)) return Error{errors::NoSuchFileInProject(), toStd(from)};
    if (m_files.contains(to) || QFile::exists(absolutePath(to))) return Error{errors::FileNameInUse(), toStd(to)};
    if (!QFile::rename(absolutePath(from), absolutePath(to))) return Error{errors::FileNotRenamed(), toStd(from)};
    m_files[to] = m_files[from];
    QFile::remove(sideFile(from));
    m_files.erase(from);
    watchFiles();
    emit filesChanged();
    startCheck();
    return {};
}

Result<void> Workspace::rereadProject() {
    auto project = projects::openProject({toStd(folder())});
    if (!project) return project.error();
    m_project = std::move(*project);
    emit filesChanged();
    return {};
}

Result<void> Workspace::saveProjectFile(const nlohmann::ordered_json& json) {
    if (folder().isEmpty()) return Error{errors::SingleFilesHaveNoSettings(), ""};
    projects::Project changed = *m_project;
    if (QFile::exists(absolutePath(QStringLiteral("project.json")))) {
        auto onDisk = projects::readProjectJson(changed.folder);
        if (!onDisk) return onDisk.error();
        changed.json = std::move(*onDisk);
        projects::carryChanges(m_project->json, json, changed.json);
    } else {
        changed.json = json; // gone: it is written whole
    }
    if (auto read = projects::readSettings(changed, changed.folder + "/project.json"); !read) return read;
    if (auto saved = projects::saveProjectFile(changed); !saved) return saved;
    takeSettings(std::move(changed));
    return {};
}

void Workspace::takeSettings(projects::Project changed) {
    m_project = std::move(changed);
    watchFiles(); // project.json was replaced, or is new
    emit settingsChanged();
    startCheck();
}

// ------------------------------------------------------------------ changes from outside

bool Workspace::isNewerOnDisk(const QString& file) const {
    const auto it = m_files.find(file);
    if (it == m_files.end()) return false;
    const auto disk = projects::readSourceText(toStd(absolutePath(file)));
    return disk && disk->text != it->second.onDisk;
}

void Workspace::lookAtDisk() {
    if (!m_project) return;
    for (const QString& file : files())
        if (isNewerOnDisk(file)) readDiskChange(absolutePath(file));
    readFolderChange();
}

void Workspace::readDiskChange(const QString& absolute) {
    const QString file = QDir(folder()).relativeFilePath(absolute);
    const auto it = m_files.find(file);
    if (it == m_files.end()) return file == QLatin1String("project.json") ? readFolderChange() : void();
    const auto read = projects::readSourceText(toStd(absolute));
    if (!read) { // moved away, or about to be replaced by another program
        readFolderChange();
        return;
    }
    m_watcher.addPath(absolute);
    emit accessChanged(file, isReadOnly(file));
    const std::string& now = read->text;
    if (now == it->second.onDisk) return;
    const bool editedHere = isModified(file);
    it->second.onDisk = now;
    if (editedHere && it->second.text != now) {
        emit changedOnDiskAndHere(file);
        return;
    }
    it->second.text = now;
    emit textReplaced(file);
    emit modificationChanged(file, isModified(file));
    if (read->isGuessed) emit encodingFound(file, QString::fromUtf8(projects::nameOf(read->encoding).data()));
    m_pause.start();
}

void Workspace::readFolderChange() {
    if (!m_project) return;
    if (isProjectGone(*m_project)) { // what is open is all that is left of it
        for (auto& [file, content] : m_files) {
            if (QFile::exists(absolutePath(file)) || content.onDisk.empty()) continue;
            content.onDisk.clear();
            emit modificationChanged(file, isModified(file));
        }
        return;
    }
    const auto project = projects::openProject({toStd(folder())});
    if (!project) return; // half-written; the next change tells
    if (project->json != m_project->json) {
        projects::Project changed = *m_project;
        changed.json = project->json;
        if (projects::readSettings(changed, changed.folder + "/project.json")) takeSettings(std::move(changed));
    }
    bool changed = false;
    std::map<QString, bool> there;
    for (const auto* list : {&project->sources, &project->tests})
        for (const driver::SourceFile& source : *list) {
            const QString file = QString::fromStdString(source.path);
            there[file] = true;
            if (m_files.contains(file)) continue;
            takeFile(file, source.text);
            changed = true;
        }
    for (auto it = m_files.begin(); it != m_files.end();) {
        if (!there.contains(it->first) && it->second.text == it->second.onDisk &&
            !QFile::exists(absolutePath(it->first))) {
            it = m_files.erase(it);
            changed = true;
        } else {
            ++it;
        }
    }
    if (!changed) return;
    m_project->encodings = project->encodings;
    tellEncodings();
    watchFiles();
    emit filesChanged();
    startCheck();
}

// ------------------------------------------------------------------ side files

QString Workspace::sideFile(const QString& file) const {
    const QFileInfo path(absolutePath(file));
    return path.path() + "/." + path.fileName() + ".autosave";
}

void Workspace::autosave() {
    for (const auto& [file, content] : m_files) {
        const QString side = sideFile(file);
        if (content.text == content.onDisk) {
            if (QFile::exists(side)) QFile::remove(side);
            continue;
        }
        (void)projects::writeFileAtomically(toStd(side), content.text); // a full disk is reported by the real save
    }
}

std::map<QString, std::string> Workspace::recoverable() const {
    std::map<QString, std::string> out;
    for (const auto& [file, content] : m_files) {
        QFile side(sideFile(file));
        if (!side.open(QIODevice::ReadOnly)) continue;
        std::string text = side.readAll().toStdString();
        if (text != content.onDisk) out[file] = std::move(text);
    }
    return out;
}

void Workspace::discardRecovery() {
    for (const auto& [file, content] : m_files) QFile::remove(sideFile(file));
}

// ------------------------------------------------------------------ checking

void Workspace::checkNow() {
    m_pause.stop();
    startCheck();
}

std::shared_ptr<const analysis::CodeModel> Workspace::presentModel() {
    if (!m_project) return nullptr;
    if (m_pause.isActive()) checkNow();
    if (m_model && m_model->revision() == m_revision) return m_model;
    QEventLoop loop;
    connect(this, &Workspace::analysed, &loop, &QEventLoop::quit);
    connect(this, &Workspace::closed, &loop, &QEventLoop::quit);
    QTimer::singleShot(5000, &loop, &QEventLoop::quit);
    loop.exec(QEventLoop::ExcludeUserInputEvents);
    return m_model && m_model->revision() == m_revision ? m_model : nullptr;
}

void Workspace::startCheck() {
    if (!m_project) return;
    Job job{buildInput(), m_project->folder, ++m_revision};
    if (!job.folder.empty()) // the worker reads them again
        job.input.companions.erase(job.input.companions.begin(),
                                   job.input.companions.begin() +
                                       static_cast<std::ptrdiff_t>(m_project->companions.size()));
    for (const auto& [file, content] : m_files) // the program never holds them, the editor knows them
        if (isTestFile(file)) job.input.files.push_back({toStd(file), content.text});
    {
        const std::lock_guard lock(m_mutex);
        m_job = std::move(job);
    }
    m_wake.notify_one();
}

void Workspace::takeAnswer(Answer answer) {
    if (!m_project || answer.model->revision() < m_revision) return; // overtaken
    m_model = std::move(answer.model);
    if (!m_project->folder.empty()) m_project->companions = std::move(answer.companions);
    emit analysed(m_model);
}

void Workspace::workerLoop() {
    driver::KeptFiles kept; // a keystroke reads the file it is in
    for (;;) {
        Job job;
        {
            std::unique_lock lock(m_mutex);
            m_wake.wait(lock, [this] { return m_quit || m_job; });
            if (m_quit) return;
            job = std::move(*m_job);
            m_job.reset();
        }
        Answer answer;
        if (!job.folder.empty()) { // a panel may have been saved since
            answer.companions = projects::readCompanions(job.folder);
            job.input.companions.insert(job.input.companions.begin(), answer.companions.begin(),
                                        answer.companions.end());
        }
        answer.model = analysis::CodeModel::make(job.input, job.revision, kept);
        kit::post(this, [this, answer = std::move(answer)]() mutable { takeAnswer(std::move(answer)); });
    }
}

} // namespace plc::editor
