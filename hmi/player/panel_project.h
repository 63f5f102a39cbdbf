// The operator side of a project as it stands on disk: panels, texts, alarms, languages. Loaded by the player, the
// designer and the command line. A value, main thread.
#pragma once
#include "hmi/alarms/alarm_file.h"
#include "hmi/texts/catalog.h"
#include "hmi/view/panel_check.h"
#include "projects/model/project.h"

namespace plc::hmi {

struct PanelProject {
    QString folder;
    QString startPanel;
    std::vector<NamedPanel> panels; // by name
    TextCatalog texts;
    AlarmFile alarms;
    bool hasTexts = false, hasAlarms = false;
    std::vector<Error> problems; // files that could not be read; the rest is there

    const NamedPanel* find(const QString& name) const;
    NamedPanel* find(const QString& name);
    /// What the check needs.
    CheckInput checkInput() const;
    QString panelPath(const QString& name) const;
    QString textsPath() const;
    QString alarmsPath() const;
};

PanelProject loadPanelProject(const projects::Project& project);
/// Writes only files whose bytes changed.
Result<void> savePanel(const PanelProject& project, const NamedPanel& panel);
Result<void> saveTexts(const PanelProject& project);
Result<void> saveAlarms(const PanelProject& project);

} // namespace plc::hmi
