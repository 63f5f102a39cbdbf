#include "hmi/station/panel_project.h"

#include "hmi/check/unread_panels.h"
#include "hmi/model/errors.h"
#include "hmi/model/layout.h"
#include "projects/storage/project_file.h"

#include <QDir>
#include <QFileInfo>

#include <algorithm>
#include <functional>

namespace plc::hmi {

const NamedPanel* PanelProject::find(const QString& name) const {
    for (const NamedPanel& one : panels)
        if (one.name == name) return &one;
    return nullptr;
}

NamedPanel* PanelProject::find(const QString& name) {
    for (NamedPanel& one : panels)
        if (one.name == name) return &one;
    return nullptr;
}

QString PanelProject::startOrFirst() const {
    const auto showsSomething = [&](const NamedPanel& panel) { // a faceplate shows nothing by itself
        return parametersOf(panel.panel).empty() && panel.name != frame;
    };
    if (const NamedPanel* start = find(startPanel); start && showsSomething(*start)) return startPanel;
    const auto first = std::find_if(panels.begin(), panels.end(), showsSomething);
    if (first != panels.end()) return first->name;
    return find(startPanel) || panels.empty() ? startPanel : panels.front().name;
}

CheckInput PanelProject::checkInput() const {
    CheckInput input;
    input.panels = panels;
    for (NamedPanel& one : input.panels)
        one.panel = laidOut(one.panel, one.panel.size()); // a file may leave places out
    input.texts = texts;
    input.alarms = alarms;
    input.hasAlarms = hasAlarms;
    input.folder = folder;
    input.picturesOutside = picturesOutside;
    input.frame = frame;
    input.themes = themes;
    input.startPanel = startOrFirst();
    input.standard = standard;
    for (const Role& role : people.roles()) input.roles += role.name;
    for (const Recipe& recipe : recipes.recipes()) {
        if (isTextKey(recipe.title)) input.keysUsedElsewhere += keyOf(recipe.title);
        for (const RecipeVariable& one : recipe.variables)
            if (isTextKey(one.title)) input.keysUsedElsewhere += keyOf(one.title);
    }
    for (const Role& role : people.roles())
        if (isTextKey(role.title)) input.keysUsedElsewhere += keyOf(role.title);
    input.hasPeople = !people.isEmpty();
    for (const Role& role : people.roles()) input.startPanels += role.startPanel;
    for (const User& user : people.users()) input.startPanels += user.startPanel;
    return input;
}

QString PanelProject::panelPath(const QString& name) const {
    return QDir(folder).filePath(QStringLiteral("hmi/%1.panel.json").arg(name));
}
QString PanelProject::textsPath() const { return QDir(folder).filePath(QStringLiteral("hmi/texts.csv")); }
QString PanelProject::recipesPath() const { return QDir(folder).filePath(QStringLiteral("hmi/recipes.json")); }
QString PanelProject::peoplePath() const { return QDir(folder).filePath(QStringLiteral("hmi/people.json")); }
QString PanelProject::themePath(const QString& name) const {
    return QDir(folder).filePath(QStringLiteral("hmi/themes/%1.json").arg(name));
}
QString PanelProject::alarmsPath() const { return QDir(folder).filePath(QStringLiteral("hmi/alarms.json")); }

QString PanelProject::placeOf(const QString& path) const { return QDir(folder).relativeFilePath(path); }

namespace {

/// The bytes of a file where they can be read and `take` understands them; what is wrong replaces what was wrong with
/// this file before.
bool readInto(PanelProject& project, const QString& path,
              const std::function<Result<void>(const std::string& bytes, const QString& place)>& take) {
    const QString place = project.placeOf(path);
    std::erase_if(project.problems, [&](const Error& each) {
        const QString of = QString::fromStdString(each.place);
        return of == place || of.startsWith(place + u':') || of == path;
    });
    if (project.disk) project.disk->forget(path);
    const auto bytes = projects::readFile(path.toStdString());
    Result<void> taken = bytes ? take(*bytes, place) : Result<void>(bytes.error());
    if (!taken) project.problems.push_back(taken.error());
    if (taken && project.disk) project.disk->taken(path, *bytes);
    return static_cast<bool>(taken);
}

} // namespace

bool PanelProject::readPanel(const QString& name) {
    return readInto(*this, panelPath(name), [&](const std::string& bytes, const QString& place) -> Result<void> {
        auto panel = Panel::parse(bytes, place, &problems);
        if (!panel) return panel.error();
        if (NamedPanel* known = find(name)) {
            known->panel = std::move(*panel);
            return {};
        }
        const auto at =
            std::find_if(panels.begin(), panels.end(), [&](const NamedPanel& each) { return each.name > name; });
        panels.insert(at, {name, std::move(*panel)});
        return {};
    });
}

bool PanelProject::readTexts() {
    return readInto(*this, textsPath(), [&](const std::string& bytes, const QString& place) -> Result<void> {
        auto table = TextTable::parse(bytes, place, &problems);
        if (!table) return table.error();
        for (const QString& tag : texts.settings().languages) table->addLanguage(tag);
        texts.setTable(std::move(*table));
        hasTexts = true;
        return {};
    });
}

bool PanelProject::readAlarms() {
    return readInto(*this, alarmsPath(), [&](const std::string& bytes, const QString& place) -> Result<void> {
        auto parsed = AlarmFile::parse(bytes, place, &problems);
        if (!parsed) return parsed.error();
        alarms = std::move(*parsed);
        hasAlarms = true;
        return {};
    });
}

bool PanelProject::readRecipes() {
    return readInto(*this, recipesPath(), [&](const std::string& bytes, const QString& place) -> Result<void> {
        auto parsed = RecipeFile::parse(bytes, place);
        if (!parsed) return parsed.error();
        recipes = std::move(*parsed);
        return {};
    });
}

void PanelProject::readThemes() {
    const PanelThemes before = std::exchange(themes, {});
    std::erase_if(problems, [](const Error& each) { return each.place.starts_with("hmi/themes/"); });
    const QDir at(folder + QStringLiteral("/hmi/themes"));
    for (const QString& file : at.entryList({QStringLiteral("*.json")}, QDir::Files, QDir::Name))
        readInto(*this, at.filePath(file), [&](const std::string& bytes, const QString& place) -> Result<void> {
            const QString name = file.chopped(5);
            auto theme = PanelTheme::parse(bytes, place);
            // While somebody writes it, panels keep the look that they had.
            if (const auto had = before.own().find(name); !theme && had != before.own().end())
                themes.set(name, *had->second);
            if (!theme) return theme.error();
            themes.set(name, std::move(*theme));
            return {};
        });
}

bool PanelProject::readPeople() {
    const bool isGood =
        readInto(*this, peoplePath(), [&](const std::string& bytes, const QString& place) -> Result<void> {
            auto parsed = PeopleFile::parse(bytes, place);
            if (!parsed) return parsed.error();
            people = std::move(*parsed);
            return {};
        });
    if (!isGood) people = PeopleFile::nobody();
    return isGood;
}

Result<void> chooseTheme(PanelProject& project, const std::string& name) {
    std::vector<std::string> names;
    for (const QString& one : project.themes.names()) names.push_back(toUtf8(one));
    if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end())
        return Error{errors::NoSuchTheme(name, names), project.folder.toStdString()};
    project.theme = QString::fromStdString(name);
    return {};
}

namespace {

/// Lists of project.json that are none: what they were meant to say would be missing without a word.
std::vector<Error> misreadFields(const projects::Project& project) {
    std::vector<Error> out;
    const auto hmi = project.json.find("hmi");
    if (hmi == project.json.end() || !hmi->is_object()) return out;
    for (const char* field : {"languages", "fallback"})
        if (const auto found = hmi->find(field); found != hmi->end() && !found->is_array())
            out.push_back({errors::MustBeList(Verbatim(field)), "project.json"});
    return out;
}

} // namespace

void PanelProject::readSettings(const projects::Project& project) {
    LanguageSettings settings;
    standard = StandardSettings::fromJson(Json::object());
    picturesOutside = false;
    frame.clear();
    if (const auto hmi = project.json.find("hmi"); hmi != project.json.end()) {
        settings = LanguageSettings::fromJson(*hmi);
        standard = StandardSettings::fromJson(*hmi);
        picturesOutside = hmi->is_object() && hmi->contains("picturesOutside") && (*hmi)["picturesOutside"] == true;
        if (const auto named = hmi->find("frame"); hmi->is_object() && named != hmi->end() && named->is_string())
            frame = QString::fromStdString(named->get<std::string>());
    }
    startPanel = QString::fromStdString(project.startPanel);
    if (startPanel.endsWith(QStringLiteral(".panel.json"))) startPanel.chop(11);
    std::erase_if(problems, [](const Error& each) { return each.place == "project.json"; });
    for (Error& each : misreadFields(project)) problems.push_back(std::move(each));
    texts.setSettings(std::move(settings));
}

void PanelProject::findStartPanel() {
    if (!startPanel.isEmpty() && !find(startPanel) && !unreadPanels(folder, panels).contains(startPanel))
        problems.push_back({errors::NoPanel(toUtf8(startPanel)), "project.json"});
    startPanel = startOrFirst();
}

void PanelProject::takeSettings(const projects::Project& project, bool keepsLanguages) {
    const QStringList before = texts.settings().languages;
    readSettings(project);
    findStartPanel();
    LanguageSettings settings = texts.settings();
    if (settings.languages == before) return;
    TextTable table = texts.table();
    if (keepsLanguages)
        settings.languages = before;
    else
        for (const QString& tag : settings.languages) table.addLanguage(tag);
    texts = TextCatalog(std::move(table), std::move(settings));
}

PanelProject loadPanelProject(const projects::Project& project) {
    PanelProject out;
    out.folder = QString::fromStdString(project.folder);
    out.readSettings(project);
    TextTable empty;
    for (const QString& tag : out.texts.settings().languages) empty.addLanguage(tag);
    out.texts.setTable(std::move(empty));
    if (QFileInfo::exists(out.textsPath())) out.readTexts();
    if (QFileInfo::exists(out.alarmsPath())) out.readAlarms();
    if (QFileInfo::exists(out.peoplePath())) out.readPeople();
    if (QFileInfo::exists(out.recipesPath())) out.readRecipes();
    out.readThemes();
    for (const QString& name : panelsOnDisk(out.folder)) out.readPanel(name);
    out.findStartPanel();
    return out;
}

namespace {
Result<void> write(const PanelProject& project, const QString& path, const std::string& bytes) {
    QDir().mkpath(QFileInfo(path).path());
    return project.disk ? project.disk->write(path, bytes) : projects::writeFileAtomically(path.toStdString(), bytes);
}
} // namespace

Result<void> savePanel(const PanelProject& project, const NamedPanel& panel) {
    return write(project, project.panelPath(panel.name), panel.panel.write());
}

Result<void> saveTexts(const PanelProject& project) {
    return write(project, project.textsPath(), project.texts.table().write());
}

Result<void> saveRecipes(const PanelProject& project, const RecipeFile& recipes) {
    return write(project, project.recipesPath(), recipes.write());
}

Result<void> savePeople(const PanelProject& project) {
    return write(project, project.peoplePath(), project.people.write());
}

Result<void> saveAlarms(const PanelProject& project) {
    return write(project, project.alarmsPath(), project.alarms.write());
}

Result<void> saveTheme(const PanelProject& project, const QString& name, const PanelTheme& theme) {
    return write(project, project.themePath(name), theme.write());
}

} // namespace plc::hmi
