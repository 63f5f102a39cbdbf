#include "app/documents/file_commands.h"

#include "editor/kit/inputs/text_question.h"
#include "editor/kit/message_text.h"
#include "editor/kit/trash.h"
#include "editor/trace/setup/trace_setup.h"
#include "projects/storage/project_file.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QMessageBox>
#include <QRegularExpression>

namespace plc::app {

namespace {

bool isSource(const QString& kind) { return kind == "test" || kind == "source"; }

bool isPath(const QString& name) { return name.contains('/') || name.contains('\\'); }

/// Buttons and the like of other panels that lead to a panel.
QRegularExpression leadsTo(const QString& panel) {
    return QRegularExpression("(\"panel\"\\s*:\\s*)\"" + QRegularExpression::escape(panel) + "\"");
}

QFileInfoList panelsOf(const editor::Workspace& workspace) {
    return QDir(workspace.folder() + "/hmi").entryInfoList({"*.panel.json"}, QDir::Files);
}

/// Files of the panels that lead to one.
QStringList panelsThatLeadTo(const QString& panel, const editor::Workspace& workspace) {
    QStringList out;
    for (const QFileInfo& other : panelsOf(workspace))
        if (const auto text = projects::readFile(other.filePath().toStdString());
            text && QString::fromStdString(*text).contains(leadsTo(panel)))
            out << other.fileName();
    return out;
}

} // namespace

FileCommands::FileCommands(Parts parts, QObject* parent) : QObject(parent), m_parts(parts) {}

QString FileCommands::pathOf(const QString& kind, const QString& name) const {
    const QString folder = m_parts.workspace.folder() + "/";
    return kind == "panel"   ? folder + "hmi/" + name + ".panel.json"
           : kind == "trace" ? folder + "traces/" + name + ".trace.json"
                             : folder + name;
}

bool FileCommands::isShownTrace(const QString& path) const {
    return QFileInfo(m_parts.live.traceView().setupPath()).fileName() == QFileInfo(path).fileName();
}

bool FileCommands::report(const Result<void>& result) {
    if (!result) emit message(kit::messageText(result.error()), true);
    return static_cast<bool>(result);
}

void FileCommands::newTrace() {
    if (!m_parts.workspace.isOpen()) return;
    QString name;
    const auto add = [&](const QString& text) {
        if (isPath(text)) return tr("A file name cannot contain / or \\; choose another name");
        const QString path = pathOf("trace", text);
        if (QFile::exists(path)) return tr("A trace %1 already exists; choose another name").arg(text);
        QDir().mkpath(QFileInfo(path).path());
        name = text;
        const auto saved = trace::saveSetup({}, path.toStdString());
        return saved ? QString() : kit::messageText(saved.error());
    };
    if (!kit::TextQuestion(tr("New Trace"), tr("Name of the trace:"), tr("trace"), add, &m_parts.window).ask()) return;
    if (!report(m_parts.workspace.rereadProject())) return;
    m_parts.live.openTrace(name);
    emit traceMade();
}

void FileCommands::rename(const QString& kind, const QString& name) {
    const QString shown = isSource(kind) ? QFileInfo(name).completeBaseName() : name;
    const auto renamed = [&](const QString& to) {
        return isSource(kind) ? QFileInfo(name).path() + "/" + to + ".st" : to;
    };
    QString chosen;
    const auto choose = [&](const QString& text) {
        if (isPath(text)) return tr("A file name cannot contain / or \\; choose another name");
        chosen = text;
        const QFileInfo to(pathOf(kind, renamed(text)));
        return text != shown && to.exists() ? tr("A file %1 already exists; choose another name").arg(to.fileName())
                                            : QString();
    };
    if (!kit::TextQuestion(tr("Rename"), tr("New name of %1:").arg(shown), shown, choose, &m_parts.window).ask() ||
        chosen == shown)
        return;
    if (isSource(kind)) return renameSource(name, renamed(chosen));
    const QString from = pathOf(kind, name), to = pathOf(kind, chosen);
    if (kind == "panel" && !m_parts.designs.closeAll()) return;
    if (kind == "trace") m_parts.live.saveTrace();
    if (!QFile::rename(from, to))
        return emit message(tr("The file cannot be renamed; check the permissions of the folder"), true);
    if (kind == "panel" && !report(leadTo(name, chosen))) return;
    if (!report(m_parts.workspace.rereadProject())) return;
    if (kind == "panel")
        m_parts.live.reloadPanels();
    else if (isShownTrace(from))
        m_parts.live.openTrace(chosen);
}

Result<void> FileCommands::leadTo(const QString& panel, const QString& newName) {
    for (const QFileInfo& other : panelsOf(m_parts.workspace)) {
        const auto text = projects::readFile(other.filePath().toStdString());
        if (!text) continue;
        QString changed = QString::fromStdString(*text);
        changed.replace(leadsTo(panel), "\\1\"" + newName + "\"");
        if (auto written = projects::writeFileAtomically(other.filePath().toStdString(), changed.toStdString());
            !written)
            return written;
    }
    const projects::Project& project = m_parts.workspace.project();
    if (QString::fromStdString(project.startPanel) != panel) return {};
    nlohmann::ordered_json json = project.json;
    json["hmi"]["startPanel"] = newName.toStdString();
    return m_parts.workspace.saveProjectFile(json);
}

void FileCommands::renameSource(const QString& from, const QString& to) {
    const bool wasOpen = m_parts.tabs.pageOf(from) != nullptr;
    if (wasOpen && m_parts.workspace.isModified(from) && !report(m_parts.workspace.save(from))) return;
    if (!report(m_parts.workspace.renameFile(from, to))) return;
    std::vector<editor::EditorBreakpoint> breakpoints = m_parts.control.breakpoints();
    for (editor::EditorBreakpoint& each : breakpoints)
        if (each.file == from) each.file = to;
    m_parts.control.setBreakpoints(breakpoints);
    if (wasOpen) m_parts.tabs.openFile(to);
}

/// With what is lost and what will be wrong.
QString FileCommands::questionBefore(const QString& kind, const QString& name) const {
    QString question = tr("Delete %1?").arg(isSource(kind) ? name : QFileInfo(pathOf(kind, name)).fileName());
    if (kind == "source") {
        QStringList units;
        if (const auto model = m_parts.workspace.presentModel())
            if (const auto id = model->fileOf(name.toStdString()))
                for (const analysis::OutlineItem& item : model->outline(*id))
                    units << QString::fromStdString(item.name);
        if (!units.isEmpty()) question += "\n" + tr("It contains %1.").arg(units.join(", "));
    }
    const QStringList users = kind == "panel" ? panelsThatLeadTo(name, m_parts.workspace) : QStringList();
    if (!users.isEmpty())
        question +=
            "\n" + tr("These panels link to it; their buttons will be reported as errors: %1").arg(users.join(", "));
    return question;
}

void FileCommands::remove(const QString& kind, const QString& name) {
    if (QMessageBox::question(&m_parts.window, tr("Delete"), questionBefore(kind, name)) != QMessageBox::Yes) return;
    if (isSource(kind)) {
        report(m_parts.workspace.removeFile(name));
        return;
    }
    if (kind == "panel" && !m_parts.designs.closeAll()) return;
    const QString path = pathOf(kind, name);
    const bool isShown = kind == "trace" && isShownTrace(path);
    if (!kit::removeToTrash(path))
        return emit message(tr("The file cannot be removed; check the permissions of the folder"), true);
    if (!report(m_parts.workspace.rereadProject())) return;
    if (kind == "panel")
        m_parts.live.reloadPanels();
    else if (isShown)
        m_parts.live.openTrace({});
}

} // namespace plc::app
