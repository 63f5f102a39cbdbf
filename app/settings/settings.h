// What the user set: theme, language, editor, shortcuts, recent projects; and per project what was open. Kept by
// QSettings in the user's configuration folder. GUI thread.
#pragma once
#include "editor/kit/theme.h"
#include "editor/text/st_editor.h"

#include <QKeySequence>
#include <QSettings>
#include <QStringList>

namespace plc::app {

class Settings {
public:
    [[nodiscard]] kit::ThemeChoice theme() const;
    void setTheme(kit::ThemeChoice choice);
    [[nodiscard]] QString language() const; // "en", "de", "da", "fr", "es", "zh_CN"; "" = the system's
    void setLanguage(const QString& tag);
    [[nodiscard]] editor::EditorSettings editor() const;
    void setEditor(const editor::EditorSettings& settings);
    [[nodiscard]] bool formatOnSave() const;
    void setFormatOnSave(bool on);
    [[nodiscard]] bool changeOnSave() const; // online change with every save
    void setChangeOnSave(bool on);
    [[nodiscard]] int ladderLook() const; // editor::LadderLook::bits
    void setLadderLook(int bits);
    [[nodiscard]] bool sawTour() const;
    void setSawTour();
    [[nodiscard]] bool arrangesByFile() const; // the project tree
    void setArrangesByFile(bool on);
    /// Where new projects and copies of examples are made; "…/Stepwise" among the user's documents.
    [[nodiscard]] QString projectsFolder() const;
    void setProjectsFolder(const QString& folder);
    [[nodiscard]] QByteArray windowGeometry() const;
    void setWindowGeometry(const QByteArray& geometry);
    [[nodiscard]] int historyMegabytes() const;
    void setHistoryMegabytes(int megabytes);
    [[nodiscard]] int runsMegabytes() const; // on disk, per project, for the runs that have ended
    void setRunsMegabytes(int megabytes);

    [[nodiscard]] QStringList recentProjects() const; // newest first, only those that exist
    void addRecent(const QString& folder);
    void removeRecent(const QString& folder);

    [[nodiscard]] QKeySequence shortcut(const QString& action, const QKeySequence& fallback) const;
    void setShortcut(const QString& action, const QKeySequence& keys);

    /// Values of one project: "tabs", "watches", "breakpoints", "layout".
    [[nodiscard]] QVariant projectValue(const QString& folder, const QString& key) const;
    void setProjectValue(const QString& folder, const QString& key, const QVariant& value);

private:
    [[nodiscard]] static QString projectKey(const QString& folder, const QString& key);
    QSettings m_store{"Stepwise", "Stepwise"};
};

} // namespace plc::app
