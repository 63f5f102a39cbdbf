#include "app/panels/panel_files.h"

#include "editor/kit/message_text.h"
#include "editor/workspace/project_gone.h"
#include "hmi/check/unread_panels.h"

#include <QDir>
#include <QFileInfo>

#include <algorithm>

namespace plc::app {

namespace {
constexpr int kSettleMs = 80;
constexpr QLatin1String kTexts("texts"), kAlarms("alarms"), kRecipes("recipes"), kPeople("people"), kPanel("panel:"),
    kTheme("theme:");

QStringList themesOnDisk(const hmi::PanelProject& panels) {
    return QDir(panels.folder + "/hmi/themes").entryList({"*.json"}, QDir::Files, QDir::Name);
}

/// Themes that came, went or are others now. One that could not be understood is read again when it changes.
bool areThemesOther(const hmi::PanelProject& panels, std::map<QString, std::string>& notUnderstood) {
    const QStringList files = themesOnDisk(panels);
    const auto isGone = [&](const QString& file) { return !files.contains(file); };
    bool isOther = false;
    for (const auto& [name, theme] : panels.themes.own()) isOther |= isGone(name + ".json");
    for (const Error& each : panels.problems) {
        const QString place = QString::fromStdString(each.place);
        isOther |= place.startsWith("hmi/themes/") && isGone(place.section('/', 2).section(':', 0, 0));
    }
    for (const QString& file : files) {
        const QString path = panels.folder + "/hmi/themes/" + file;
        const auto now = panels.disk->newer(path);
        if (!now || std::exchange(notUnderstood[path], *now) == *now) continue;
        isOther = true;
    }
    return isOther;
}

QString panelOf(const QString& key) { return key.startsWith(kPanel) ? key.mid(kPanel.size()) : QString(); }
} // namespace

PanelFiles::PanelFiles(editor::Workspace& workspace, LiveViews& live, Ask ask, QObject* parent)
    : QObject(parent), m_workspace(workspace), m_live(live), m_ask(std::move(ask)) {
    m_pause.setSingleShot(true);
    m_pause.setInterval(kSettleMs);
    connect(&m_pause, &QTimer::timeout, this, &PanelFiles::look);
    for (const auto signal : {&QFileSystemWatcher::fileChanged, &QFileSystemWatcher::directoryChanged})
        connect(&m_watcher, signal, &m_pause, qOverload<>(&QTimer::start));
    connect(&live, &LiveViews::panelsChanged, this, [this] {
        m_reported.clear();
        watch();
    });
    connect(&live, &LiveViews::designEdited, this, &PanelFiles::report);
    connect(&workspace, &editor::Workspace::opened, this, [this] {
        m_isGone = false;
        watch();
    });
    connect(&workspace, &editor::Workspace::saved, this, &PanelFiles::writeAgain);
}

QString PanelFiles::titleOf(const Key& key) {
    return key == kTexts     ? tr("Texts")
           : key == kAlarms  ? tr("Alarms")
           : key == kRecipes ? tr("Recipes")
           : key == kPeople  ? tr("Users and Rights")
                             : tr("Panel %1").arg(panelOf(key));
}

QString PanelFiles::pathOf(const Key& key) const {
    const hmi::PanelProject& panels = m_live.panels();
    return key == kTexts            ? panels.textsPath()
           : key == kAlarms         ? panels.alarmsPath()
           : key == kRecipes        ? panels.recipesPath()
           : key == kPeople         ? panels.peoplePath()
           : key.startsWith(kTheme) ? panels.themePath(key.mid(kTheme.size()))
                                    : panels.panelPath(panelOf(key));
}

std::vector<PanelFiles::Key> PanelFiles::known() const {
    std::vector<Key> out;
    if (!m_live.design()) return out;
    for (const hmi::NamedPanel& panel : m_live.panels().panels) out.push_back(kPanel + panel.name);
    out.push_back(kTexts);
    out.push_back(kAlarms);
    out.push_back(kRecipes);
    out.push_back(kPeople);
    return out;
}

bool PanelFiles::isChanged(const Key& key) const {
    const hmi::DesignContext* design = m_live.design();
    if (!design) return false;
    return key == kTexts     ? design->areTextsChanged()
           : key == kAlarms  ? design->areAlarmsChanged()
           : key == kRecipes ? design->areRecipesChanged()
           : key == kPeople  ? design->arePeopleChanged()
                             : design->isPanelChanged(panelOf(key));
}

std::vector<PanelFiles::Key> PanelFiles::changed() const {
    std::vector<Key> out = known();
    std::erase_if(out, [this](const Key& key) { return !isChanged(key); });
    return out;
}

std::string PanelFiles::bytesHere(const Key& key) const {
    const hmi::PanelProject& panels = m_live.panels();
    if (key == kTexts) return panels.texts.table().write();
    if (key == kAlarms) return panels.alarms.write();
    if (key == kRecipes) return panels.recipes.write();
    if (key == kPeople) return panels.people.write();
    const hmi::NamedPanel* panel = panels.find(panelOf(key));
    return panel ? panel->panel.write() : std::string();
}

/// Tells which tabs have a mark now.
void PanelFiles::report() {
    for (const Key& key : known()) {
        const bool now = isChanged(key);
        const auto [entry, isNew] = m_reported.emplace(key, now);
        if ((isNew && !now) || (!isNew && entry->second == now)) continue;
        entry->second = now;
        emit changedStateChanged(key, now);
    }
}

// ------------------------------------------------------------------ changes on disk

void PanelFiles::watch() {
    const QStringList before = m_watcher.files() + m_watcher.directories();
    if (!before.isEmpty()) m_watcher.removePaths(before);
    if (!m_workspace.isOpen()) return;
    QStringList paths{m_workspace.folder()}; // a first panel makes the folder for the panels
    for (const Key& key : known()) paths << pathOf(key);
    for (const QString& name : hmi::panelsOnDisk(m_workspace.folder())) paths << m_live.panels().panelPath(name);
    for (const QString& file : themesOnDisk(m_live.panels())) paths << m_workspace.folder() + "/hmi/themes/" + file;
    paths << m_workspace.folder() + "/hmi/themes" << m_workspace.folder() + "/hmi" << m_workspace.folder() + "/traces";
    paths.removeDuplicates();
    paths.removeIf([](const QString& path) { return !QFileInfo::exists(path); });
    m_watcher.addPaths(paths);
}

void PanelFiles::writeAgain() {
    if (!std::exchange(m_isGone, false)) return;
    const hmi::PanelProject& panels = m_live.panels();
    for (const Key& key : known()) {
        if (QFileInfo::exists(pathOf(key))) continue;
        Result<void> written;
        if (const hmi::NamedPanel* panel = panels.find(panelOf(key)))
            written = hmi::savePanel(panels, *panel);
        else if (key == kTexts && panels.hasTexts)
            written = hmi::saveTexts(panels);
        else if (key == kAlarms && panels.hasAlarms)
            written = hmi::saveAlarms(panels);
        else if (key == kRecipes && !panels.recipes.recipes().empty())
            written = hmi::saveRecipes(panels, panels.recipes);
        else if (key == kPeople && !panels.people.isEmpty())
            written = hmi::savePeople(panels);
        if (!written) emit message(kit::messageText(written.error()), true);
    }
    watch();
}

void PanelFiles::look() {
    if (!m_workspace.isOpen() || m_isAsking) return;
    if (editor::isProjectGone(m_workspace.project())) {
        if (!std::exchange(m_isGone, true))
            emit message(tr("%1 is gone or cannot be reached: what is open stays here, and Save All writes it again")
                             .arg(QDir::toNativeSeparators(m_workspace.folder())),
                         true);
        return;
    }
    m_isGone = false; // it is back
    m_isAsking = true;
    const bool isOther = lookForPanels();
    for (const Key& key : known()) lookAt(key);
    lookForThemes();
    m_isAsking = false;
    if (isOther)
        if (auto read = m_workspace.rereadProject(); !read) emit message(kit::messageText(read.error()), true);
    watch();
    report();
}

/// Files that came or went, traces included; true when the project's lists are others now.
bool PanelFiles::lookForPanels() {
    const QStringList onDisk = hmi::panelsOnDisk(m_workspace.folder());
    QStringList traces;
    for (const std::string& each : m_workspace.project().traces) traces << QString::fromStdString(each);
    const QStringList tracesOnDisk =
        QDir(m_workspace.folder() + "/traces").entryList({"*.trace.json"}, QDir::Files, QDir::Name);
    bool isOther = traces != tracesOnDisk;
    for (const hmi::NamedPanel& panel : std::vector(m_live.panels().panels)) {
        if (onDisk.contains(panel.name) || isChanged(kPanel + panel.name)) continue;
        emit panelGone(kPanel + panel.name);
        m_live.removePanel(panel.name);
        isOther = true;
    }
    for (const QString& name : onDisk) {
        if (m_live.panels().find(name)) continue;
        const QString path = m_live.panels().panelPath(name);
        if (const auto disk = m_live.panels().disk;
            m_postponed.contains(path) && m_postponed[path] == disk->newer(path))
            continue; // read before, and it could not be understood
        m_live.takePanelFile(name);
        m_postponed[path] = m_live.panels().disk->newer(path).value_or(std::string());
        isOther = true;
    }
    return isOther;
}

/// What is on disk is taken at once, and panels that are open show it.
void PanelFiles::lookForThemes() {
    if (m_live.design() && areThemesOther(m_live.panels(), m_postponed)) m_live.design()->themesReplaced();
}

void PanelFiles::lookAt(const Key& key) {
    const QString path = pathOf(key);
    const auto now = m_live.panels().disk->newer(path);
    if (!now) return;
    if (const auto asked = m_postponed.find(path); asked != m_postponed.end() && asked->second == *now) return;
    if (!isChanged(key) || bytesHere(key) == *now) return take(key);
    m_postponed[path] = *now; // a second change while the question is open asks again
    const DiskAnswer answer = m_ask(m_live.panels().placeOf(path), bytesHere(key), *now);
    if (answer.choice == DiskChoice::LoadFromDisk) return take(key);
    if (answer.choice == DiskChoice::Merged && !takeMerged(key, answer.merged)) return; // saving asks again
    m_live.panels().disk->taken(path, *now); // the next save replaces it, knowingly
}

bool PanelFiles::takeMerged(const Key& key, const std::string& text) {
    const QString place = m_live.panels().placeOf(pathOf(key));
    const auto taken = [&]() -> Result<void> {
        if (key == kTexts) {
            auto table = hmi::TextTable::parse(text, place);
            if (!table) return table.error();
            m_live.design()->setTable(std::move(*table));
        } else if (key == kAlarms) {
            auto alarms = hmi::AlarmFile::parse(text, place);
            if (!alarms) return alarms.error();
            m_live.design()->setAlarms(std::move(*alarms));
        } else if (key == kRecipes) {
            auto recipes = hmi::RecipeFile::parse(text, place);
            if (!recipes) return recipes.error();
            m_live.design()->setRecipes(std::move(*recipes));
        } else if (key == kPeople) {
            auto people = hmi::PeopleFile::parse(text, place);
            if (!people) return people.error();
            m_live.design()->setPeople(std::move(*people));
        } else {
            auto panel = hmi::Panel::parse(text, place);
            if (!panel) return panel.error();
            m_live.design()->setPanel(panelOf(key), *panel);
        }
        return {};
    }();
    if (!taken) emit message(kit::messageText(taken.error()), true);
    return static_cast<bool>(taken);
}

void PanelFiles::take(const Key& key) {
    const QString path = pathOf(key);
    const bool isGood = key == kTexts     ? m_live.takeTextsFile()
                        : key == kAlarms  ? m_live.takeAlarmsFile()
                        : key == kRecipes ? m_live.takeRecipesFile()
                        : key == kPeople  ? m_live.takePeopleFile()
                                          : m_live.takePanelFile(panelOf(key));
    if (isGood)
        m_postponed.erase(path);
    else
        m_postponed[path] = m_live.panels().disk->newer(path).value_or(std::string());
    report();
}

void PanelFiles::discard(const Key& key) { take(key); }

// ------------------------------------------------------------------ saving

Result<void> PanelFiles::write(const Key& key) {
    hmi::DesignContext* design = m_live.design();
    if (!design) return {};
    if (const QString panel = panelOf(key); !panel.isEmpty() && isChanged(key)) {
        if (auto saved = design->savePanel(panel); !saved) return saved;
    }
    if (auto saved = design->save(); !saved) return saved;
    if (m_live.player()) m_live.player()->projectChanged();
    return {};
}

Result<void> PanelFiles::save(const Key& key) {
    m_postponed.clear(); // now it must be decided
    look();
    const Result<void> saved = write(key); // a panel's texts with it
    watch();
    report();
    return saved;
}

Result<void> PanelFiles::saveAll() {
    m_postponed.clear();
    look();
    for (const Key& key : changed())
        if (auto saved = write(key); !saved) return saved;
    watch();
    report();
    return {};
}

} // namespace plc::app
