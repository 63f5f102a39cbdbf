// Panels, texts and alarms as files: watched, taken from disk where nothing is unsaved here, asked about where
// something is, never written over what another program has written; which of them are changed, and saving them.
// Owned by the main window; GUI thread.
#pragma once
#include "app/pages/disk_change.h"
#include "app/panels/live_views.h"

#include <QFileSystemWatcher>
#include <QObject>
#include <QTimer>

#include <functional>
#include <map>

namespace plc::app {

class PanelFiles : public QObject {
    Q_OBJECT
public:
    /// A document: "panel:overview", "texts", "alarms", "recipes", "people"; "theme:night" has a path only.
    using Key = QString;
    using Ask = std::function<DiskAnswer(const QString& file, const std::string& here, const std::string& onDisk)>;

    PanelFiles(editor::Workspace& workspace, LiveViews& live, Ask ask, QObject* parent);

    /// Compares what is known with what is on disk, and does about it what there is to do.
    void look();
    void lookSoon() { m_pause.start(); }
    [[nodiscard]] bool isChanged(const Key& key) const;
    [[nodiscard]] std::vector<Key> changed() const;
    /// Writes it, and texts and alarms with a panel; asks first where the file has changed on disk.
    Result<void> save(const Key& key);
    Result<void> saveAll();
    /// Back to what is on disk.
    void discard(const Key& key);
    [[nodiscard]] QString pathOf(const Key& key) const;
    /// As the user reads it: "Panel overview".
    [[nodiscard]] static QString titleOf(const Key& key);

signals:
    void changedStateChanged(const QString& key, bool isChanged);
    /// A panel's file is gone and nothing here was unsaved: its page closes.
    void panelGone(const QString& key);
    void message(const QString& text, bool isError);

private:
    [[nodiscard]] std::vector<Key> known() const;
    [[nodiscard]] std::string bytesHere(const Key& key) const;
    void watch();
    void lookForThemes();
    void lookAt(const Key& key);
    void take(const Key& key);
    /// The merged text, not saved yet; false when it is none of this kind.
    bool takeMerged(const Key& key, const std::string& text);
    bool lookForPanels();
    void report();
    /// What was in a folder that is gone, once something is saved into it again.
    void writeAgain();
    Result<void> write(const Key& key);

    editor::Workspace& m_workspace;
    LiveViews& m_live;
    Ask m_ask;
    QFileSystemWatcher m_watcher;
    QTimer m_pause; // programs write a file in several steps
    std::map<Key, bool> m_reported;
    std::map<Key, std::string> m_postponed; // of these bytes all is known
    bool m_isAsking = false;
    bool m_isGone = false; // the project's folder, and nothing was written to it since
};

} // namespace plc::app
