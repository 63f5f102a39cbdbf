// The operator side of a project as it stands on disk: panels, texts, alarms, languages. Loaded by the player, the
// designer and the command line. A value, main thread.
#pragma once
#include "hmi/alarms/alarm_file.h"
#include "hmi/check/panel_check.h"
#include "hmi/people/people_file.h"
#include "hmi/recipes/recipe_file.h"
#include "hmi/station/disk_state.h"
#include "hmi/texts/catalog.h"
#include "projects/model/project.h"

#include <memory>

namespace plc::hmi {

struct PanelProject {
    QString folder;
    QString startPanel;
    bool picturesOutside = false;   // project.json: "hmi": {"picturesOutside": true}
    StandardSettings standard;      // project.json: "hmi": {"checks": …}
    std::vector<NamedPanel> panels; // by name
    TextCatalog texts;
    AlarmFile alarms;
    PanelThemes themes; // hmi/themes/NAME.json besides the built-in ones
    QString theme;      // shown in place of each panel's own; empty: that
    QString frame;      // the panel around the others: header, footer, navigation; empty: none
    PeopleFile people;
    RecipeFile recipes;
    bool hasTexts = false, hasAlarms = false;
    std::vector<Error> problems; // what could not be read; the rest is there
    /// What the files held; null: nobody minds what is written over.
    std::shared_ptr<DiskState> disk = std::make_shared<DiskState>();

    /// What project.json says of the panels, into the fields above; what it misses is among the problems.
    void readSettings(const projects::Project& project);
    /// The same once the panels are there. `keepsLanguages`: the texts are being edited, with languages of their own.
    void takeSettings(const projects::Project& project, bool keepsLanguages);
    /// Once the panels are there: a start panel that is none is among the problems, and another takes its place.
    void findStartPanel();
    const NamedPanel* find(const QString& name) const;
    NamedPanel* find(const QString& name);
    /// The start panel, or what takes its place as long as none is set: the first that is no faceplate and no frame.
    QString startOrFirst() const;
    /// Finds panels of the project, then ready faceplates; the project must outlive it.
    PanelLookup panelLookup() const { return lookupIn(panels); }
    /// What the check needs.
    CheckInput checkInput() const;
    QString panelPath(const QString& name) const;
    QString textsPath() const;
    QString alarmsPath() const;
    QString peoplePath() const;
    QString recipesPath() const;
    /// The place of a file in findings: "hmi/main.panel.json".
    QString placeOf(const QString& path) const;

    // A file as it is on disk now, in the place of what is here. False: it is gone or could not be understood, which
    // is among the problems then, and what is here stays.
    bool readPanel(const QString& name);
    bool readTexts();
    bool readAlarms();
    /// What could not be understood gives nobody a right.
    bool readPeople();
    bool readRecipes();
    /// All of hmi/themes; one that cannot be understood is a problem, and stays as it was read before.
    void readThemes();
    QString themePath(const QString& name) const;
};

/// Shows all panels in this theme; an empty name is each panel's own.
Result<void> chooseTheme(PanelProject& project, const std::string& name);
PanelProject loadPanelProject(const projects::Project& project);
/// Write only files whose bytes changed, and none that another program has changed since it was read.
Result<void> savePanel(const PanelProject& project, const NamedPanel& panel);
Result<void> saveTexts(const PanelProject& project);
Result<void> saveAlarms(const PanelProject& project);
Result<void> saveTheme(const PanelProject& project, const QString& name, const PanelTheme& theme);
Result<void> savePeople(const PanelProject& project);
Result<void> saveRecipes(const PanelProject& project, const RecipeFile& recipes);

} // namespace plc::hmi
