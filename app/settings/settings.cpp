#include "app/settings/settings.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

namespace plc::app {

kit::ThemeChoice Settings::theme() const { return static_cast<kit::ThemeChoice>(m_store.value("theme", 0).toInt()); }
void Settings::setTheme(kit::ThemeChoice choice) { m_store.setValue("theme", static_cast<int>(choice)); }
QString Settings::language() const { return m_store.value("language").toString(); }
void Settings::setLanguage(const QString& tag) { m_store.setValue("language", tag); }

editor::EditorSettings Settings::editor() const {
    editor::EditorSettings s;
    s.indent = m_store.value("editor/indent", 4).toInt();
    s.upperCaseKeywords = m_store.value("editor/upperCaseKeywords", true).toBool();
    s.autoCloseBlocks = m_store.value("editor/autoCloseBlocks", true).toBool();
    s.showOnlineValues = m_store.value("editor/showOnlineValues", true).toBool();
    s.zoom = m_store.value("editor/zoom", 0).toInt();
    return s;
}

void Settings::setEditor(const editor::EditorSettings& s) {
    m_store.setValue("editor/indent", s.indent);
    m_store.setValue("editor/upperCaseKeywords", s.upperCaseKeywords);
    m_store.setValue("editor/autoCloseBlocks", s.autoCloseBlocks);
    m_store.setValue("editor/showOnlineValues", s.showOnlineValues);
    m_store.setValue("editor/zoom", s.zoom);
}

bool Settings::formatOnSave() const { return m_store.value("editor/formatOnSave", false).toBool(); }
void Settings::setFormatOnSave(bool on) { m_store.setValue("editor/formatOnSave", on); }
bool Settings::changeOnSave() const { return m_store.value("run/changeOnSave", true).toBool(); }
void Settings::setChangeOnSave(bool on) { m_store.setValue("run/changeOnSave", on); }
int Settings::ladderLook() const { return m_store.value("ladder/look", 0).toInt(); }
void Settings::setLadderLook(int bits) { m_store.setValue("ladder/look", bits); }
bool Settings::sawTour() const { return m_store.value("sawTour", false).toBool(); }
void Settings::setSawTour() { m_store.setValue("sawTour", true); }
bool Settings::arrangesByFile() const { return m_store.value("treeByFile", false).toBool(); }
void Settings::setArrangesByFile(bool on) { m_store.setValue("treeByFile", on); }
QString Settings::projectsFolder() const {
    const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation) + "/Stepwise";
    return m_store.value("projectsFolder", qEnvironmentVariable("STEPWISE_PROJECTS", documents)).toString();
}
void Settings::setProjectsFolder(const QString& folder) { m_store.setValue("projectsFolder", folder); }
QByteArray Settings::windowGeometry() const { return m_store.value("geometry").toByteArray(); }
void Settings::setWindowGeometry(const QByteArray& geometry) { m_store.setValue("geometry", geometry); }
int Settings::historyMegabytes() const { return m_store.value("run/historyMegabytes", 256).toInt(); }
void Settings::setHistoryMegabytes(int megabytes) { m_store.setValue("run/historyMegabytes", megabytes); }
int Settings::runsMegabytes() const { return m_store.value("run/runsMegabytes", 1024).toInt(); }
void Settings::setRunsMegabytes(int megabytes) { m_store.setValue("run/runsMegabytes", megabytes); }

QStringList Settings::recentProjects() const {
    QStringList out;
    for (const QString& folder : m_store.value("recent").toStringList())
        if (QFileInfo::exists(folder)) out << folder;
    return out;
}

void Settings::addRecent(const QString& folder) {
    QStringList list = m_store.value("recent").toStringList();
    list.removeAll(folder);
    list.prepend(folder);
    m_store.setValue("recent", list.mid(0, 20));
}

void Settings::removeRecent(const QString& folder) {
    QStringList list = m_store.value("recent").toStringList();
    list.removeAll(folder);
    m_store.setValue("recent", list);
}

QKeySequence Settings::shortcut(const QString& action, const QKeySequence& fallback) const {
    const QVariant stored = m_store.value("shortcuts/" + action);
    return stored.isValid() ? QKeySequence(stored.toString(), QKeySequence::PortableText) : fallback;
}
void Settings::setShortcut(const QString& action, const QKeySequence& keys) {
    m_store.setValue("shortcuts/" + action, keys.toString(QKeySequence::PortableText));
}

QString Settings::projectKey(const QString& folder, const QString& key) {
    return "projects/" +
           QString::fromLatin1(QCryptographicHash::hash(QDir(folder).absolutePath().toUtf8(), QCryptographicHash::Sha1)
                                   .toHex()
                                   .left(16)) +
           "/" + key;
}
QVariant Settings::projectValue(const QString& folder, const QString& key) const {
    return m_store.value(projectKey(folder, key));
}
void Settings::setProjectValue(const QString& folder, const QString& key, const QVariant& value) {
    m_store.setValue(projectKey(folder, key), value);
}

} // namespace plc::app
