#include "hmi/player/panel_commands.h"
#include "editor/kit/message_text.h"

#include "hmi/model/errors.h"
#include "hmi/model/property_literals.h"
#include "hmi/player/panel_player.h"
#include "hmi/station/recipe_transfer.h"
#include "hmi/view/element_factory.h"

#include <QApplication>
#include <QCryptographicHash>
#include <QDir>
#include <QStandardPaths>

namespace plc::hmi {

QImage renderPanel(const PanelProject& project, session::Session* session, const QString& name, const QString& language,
                   double scale, const QString& theme) {
    const NamedPanel* named = project.find(name);
    if (!named) return {};
    Panel panel = withArguments(named->panel, completed(parametersOf(named->panel), {}));
    if (!theme.isEmpty()) panel.set("theme"_field, toUtf8(theme));
    std::unique_ptr<PlcValues> values;
    AlarmBook alarms;
    alarms.setFile(project.alarms);
    if (session) {
        values = std::make_unique<PlcValues>(*session);
        if (const auto clock = values->clockAtZero()) alarms.setClockAtZero(*clock);
        AlarmEvaluator evaluator(*session, alarms.definitions());
        std::vector<AlarmFindings> findings;
        while (evaluator.process(findings)) {
        }
        for (const AlarmFindings& one : findings) {
            if (one.rewindTo) alarms.rewind(*one.rewindTo);
            alarms.take(one.records);
        }
    }
    PanelScene scene{makeElementView};
    scene.setDesigning(!session);
    scene.setFolder(project.folder);
    scene.setPicturesOutside(project.picturesOutside);
    scene.setTexts(&project.texts);
    scene.setAlarms(&alarms);
    scene.setLanguage(language);
    scene.setFaceplates(project.panelLookup());
    scene.setThemes(project.themes);
    scene.setTheme(project.theme);
    scene.setRecipes(&project.recipes);
    scene.setCurrentPanel(name); // its key of a navigation bar is lit
    scene.setPanel(panel);
    scene.setValues(values.get());
    return scene.picture(scale);
}

Result<std::vector<QString>> renderPanels(const PanelProject& project, session::Session* session,
                                          const PictureOptions& options) {
    if (!QDir().mkpath(options.folder)) return Error{errors::PictureFolderNotCreated(), options.folder.toStdString()};
    std::vector<QString> out;
    for (const NamedPanel& panel : project.panels) {
        if (!options.panels.isEmpty() && !options.panels.contains(panel.name)) continue;
        for (const QString& language :
             options.languages.isEmpty() ? project.texts.settings().languages : options.languages) {
            const QString path = QDir(options.folder).filePath(QStringLiteral("%1.%2.png").arg(panel.name, language));
            if (!renderPanel(project, session, panel.name, language, options.scale, options.theme).save(path))
                return Error{errors::PictureNotWritten(), path.toStdString()};
            out.push_back(path);
        }
    }
    if (out.empty()) return Error{errors::NoSuchPanel(), project.folder.toStdString()};
    return out;
}

Result<void> formatPanels(const PanelProject& project) {
    for (const NamedPanel& panel : project.panels)
        if (auto saved = savePanel(project, panel); !saved) return saved;
    if (project.hasTexts)
        if (auto saved = saveTexts(project); !saved) return saved;
    if (project.hasAlarms)
        if (auto saved = saveAlarms(project); !saved) return saved;
    return {};
}

std::vector<Finding> checkPanels(const PanelProject& project, const driver::Checked& checked,
                                 const QStringList& languages) {
    CheckInput input = project.checkInput();
    input.languages = languages;
    askProgram(input, checked);
    std::vector<Finding> out;
    for (const Error& problem : project.problems)
        out.push_back(
            {FindingKind::UnknownKind, true, QString::fromStdString(problem.place), 0, {}, {}, {}, problem.message});
    for (Finding& finding : checkPanels(input)) out.push_back(std::move(finding));
    for (Finding& one : recipeFindings(project.recipes, checked, project.placeOf(project.recipesPath())))
        out.push_back(std::move(one));
    if (const QString variable = project.texts.settings().variable; !variable.isEmpty() && input.checkBinding) {
        Message complaint = checkBinding(checked, variable, "any", true);
        if (!complaint.isEmpty())
            out.push_back({FindingKind::WrongBinding,
                           true,
                           QStringLiteral("project.json"),
                           0,
                           {},
                           QStringLiteral("languageVariable"),
                           {},
                           std::move(complaint)});
    }
    return out;
}

int playPanels(const PanelProject& project, session::Session& session, const PlayOptions& options) {
    PanelPlayer player(project, &session);
    if (!options.panel.isEmpty()) player.showPanel(options.panel);
    if (project.hasAlarms && !player.keepAlarmsInProject()) {
        // A project that cannot be written: beside what else the program keeps of a project that is not part of it.
        const QString folder =
            QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QStringLiteral("/alarms");
        QDir().mkpath(folder);
        const QByteArray name =
            QCryptographicHash::hash(project.folder.toUtf8(), QCryptographicHash::Sha1).toHex().left(16);
        (void)player.keepAlarmsIn(folder + u'/' + QString::fromLatin1(name) + QStringLiteral(".sqlite"));
    }
    const auto showTitle = [&] {
        const QString title = project.texts.text(player.scene().panel().text("title"_text), player.language());
        player.setWindowTitle(title.isEmpty() ? QDir(QDir(project.folder).absolutePath()).dirName() : title);
    };
    QObject::connect(&player, &PanelPlayer::panelChanged, &player, showTitle);
    QObject::connect(&player, &PanelPlayer::languageChanged, &player, showTitle);
    showTitle();
    session.startThread(session::RunMode{session::Pace::Real, 1.0});
    player.keepLanguageInProject(options.language);
    if (options.isFullScreen)
        player.showFullScreen();
    else
        player.show();
    return QApplication::exec();
}

} // namespace plc::hmi
