#include "hmi/player/panel_project.h"

#include "projects/storage/project_file.h"

#include <QDir>
#include <QFileInfo>

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

CheckInput PanelProject::checkInput() const {
    CheckInput input;
    input.panels = panels;
    input.texts = texts;
    input.alarms = alarms;
    input.hasAlarms = hasAlarms;
    input.folder = folder;
    return input;
}

QString PanelProject::panelPath(const QString& name) const {
    return QDir(folder).filePath(QStringLiteral("hmi/%1.panel.json").arg(name));
}
QString PanelProject::textsPath() const { return QDir(folder).filePath(QStringLiteral("hmi/texts.csv")); }
QString PanelProject::alarmsPath() const { return QDir(folder).filePath(QStringLiteral("hmi/alarms.json")); }

PanelProject loadPanelProject(const projects::Project& project) {
    PanelProject out;
    out.folder = QString::fromStdString(project.folder);
    LanguageSettings settings;
    if (const auto hmi = project.json.find("hmi"); hmi != project.json.end())
        settings = LanguageSettings::fromJson(*hmi);
    out.startPanel = QString::fromStdString(project.startPanel);
    const QDir folder(out.folder + QStringLiteral("/hmi"));
    TextTable table;
    if (QFileInfo::exists(out.textsPath())) {
        const auto bytes = projects::readFile(out.textsPath().toStdString());
        if (!bytes)
            out.problems.push_back(bytes.error());
        else if (auto parsed = TextTable::parse(*bytes, QStringLiteral("hmi/texts.csv"))) {
            table = std::move(*parsed);
            out.hasTexts = true;
        } else {
            out.problems.push_back(parsed.error());
        }
    }
    for (const QString& tag : settings.languages) table.addLanguage(tag);
    out.texts = TextCatalog(std::move(table), std::move(settings));
    if (QFileInfo::exists(out.alarmsPath())) {
        const auto bytes = projects::readFile(out.alarmsPath().toStdString());
        if (!bytes)
            out.problems.push_back(bytes.error());
        else if (auto parsed = AlarmFile::parse(*bytes, QStringLiteral("hmi/alarms.json"))) {
            out.alarms = std::move(*parsed);
            out.hasAlarms = true;
        } else {
            out.problems.push_back(parsed.error());
        }
    }
    for (const QString& file : folder.entryList({QStringLiteral("*.panel.json")}, QDir::Files, QDir::Name)) {
        const auto bytes = projects::readFile(folder.filePath(file).toStdString());
        if (!bytes) {
            out.problems.push_back(bytes.error());
            continue;
        }
        auto panel = Panel::parse(*bytes, QStringLiteral("hmi/") + file);
        if (panel)
            out.panels.push_back({file.chopped(11), std::move(*panel)});
        else
            out.problems.push_back(panel.error());
    }
    if (out.startPanel.endsWith(QStringLiteral(".panel.json"))) out.startPanel.chop(11);
    if (!out.find(out.startPanel) && !out.panels.empty()) out.startPanel = out.panels.front().name;
    return out;
}

Result<void> savePanel(const PanelProject& project, const NamedPanel& panel) {
    QDir(project.folder).mkpath(QStringLiteral("hmi"));
    return projects::writeFileAtomically(project.panelPath(panel.name).toStdString(), panel.panel.write());
}

Result<void> saveTexts(const PanelProject& project) {
    QDir(project.folder).mkpath(QStringLiteral("hmi"));
    return projects::writeFileAtomically(project.textsPath().toStdString(), project.texts.table().write());
}

Result<void> saveAlarms(const PanelProject& project) {
    QDir(project.folder).mkpath(QStringLiteral("hmi"));
    return projects::writeFileAtomically(project.alarmsPath().toStdString(), project.alarms.write());
}

} // namespace plc::hmi
