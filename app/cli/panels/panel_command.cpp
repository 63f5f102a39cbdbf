#include "app/cli/panels/commands.h"

#include "app/cli/kit/errors.h"
#include "app/cli/panels/panel_findings.h"
#include "app/cli/run/timed_write.h"
#include "editor/kit/theme.h"
#include "hmi/alarms/alarm_export.h"
#include "hmi/check/standard_check.h"
#include "hmi/model/errors.h"
#include "hmi/player/panel_player.h"
#include "hmi/station/range_check.h"

#include <QApplication>
#include <QFileInfo>

#include <algorithm>
#include <array>
#include <iostream>

namespace plc::cli {

namespace {

/// What leaves the range of its bar or chart while the project runs as the options say.
Result<std::vector<hmi::Finding>> rangesInARun(const Arguments& arguments, const projects::Project& project,
                                               const hmi::PanelProject& panels) {
    driver::Built built = driver::build(project.buildInput());
    if (!built.program) return Error{built.failure.isEmpty() ? errors::NothingToRun() : built.failure, project.name};
    catchInterrupt();
    session::Settings settings;
    settings.historyBudget = size_t(1) << 30;
    session::Session session(std::move(built), settings);
    if (auto ran = runProject(arguments, session.built(), session, std::chrono::nanoseconds(0), "--at"); !ran)
        return ran.error();
    return hmi::checkRanges(panels, session);
}

/// Every rule with its code, name, level and why.
int listRules() {
    for (const hmi::StandardRuleRow& row : hmi::standardRules()) {
        static constexpr std::array kLevels = {"off", "basic", "standard", "strict"};
        std::cout << "H" << 1101 + static_cast<int>(row.rule) << "  " << row.name << " ("
                  << kLevels[static_cast<size_t>(row.level)] << ")\n       " << row.why.english() << "\n";
    }
    return kGood;
}

/// Corrects what can be corrected without a decision, in the panels' files.
int fix(const hmi::PanelProject& panels, const std::vector<hmi::Finding>& findings) {
    size_t count = 0;
    for (hmi::NamedPanel panel : panels.panels) {
        const QString file = panels.placeOf(panels.panelPath(panel.name));
        const hmi::Edit edit = hmi::fixesOf(findings, file, panel.panel);
        if (edit.isEmpty()) continue;
        (void)hmi::applyTo(panel.panel, edit);
        if (const auto saved = hmi::savePanel(panels, panel); !saved) return wrongUse(saved.error());
        const auto fixed = std::count_if(findings.begin(), findings.end(), [&](const hmi::Finding& one) {
            return one.file == file && !one.fix.isEmpty();
        });
        count += static_cast<size_t>(fixed);
        std::cout << file.toStdString() << ": " << fixed << " fixed\n";
    }
    std::cout << count << " of " << findings.size() << " findings fixed\n";
    return kGood;
}

int check(const Arguments& arguments, const projects::Project& project) {
    needApplication();
    hmi::PanelProject panels = hmi::loadPanelProject(project);
    if (const auto level = arguments.value("--level")) {
        const auto known = hmi::checkLevelOf(*level);
        if (!known) return wrongUse({errors::CheckLevelIs(), *level});
        panels.standard.level = *known;
    }
    const driver::BuildInput input = project.buildInput();
    const driver::Checked checked = hmi::checkedForPanels(input, driver::check(input), panels.panels);
    QStringList languages;
    for (const std::string& language : arguments.values("--language"))
        if (language != "all") languages += QString::fromStdString(language);
    if (arguments.has("--pseudo")) languages += hmi::kPseudoTag;
    std::vector<hmi::Finding> findings = hmi::checkPanels(panels, checked, languages);
    if (arguments.has("--at") && !checked.analysis->hasErrors) {
        auto ranges = rangesInARun(arguments, project, panels);
        if (!ranges) return wrongUse(ranges.error());
        findings.insert(findings.end(), ranges->begin(), ranges->end());
    }
    if (arguments.has("--fix")) return fix(panels, findings);
    if (arguments.wantsJson()) {
        std::string out;
        for (const hmi::Finding& one : findings) out += (out.empty() ? "[" : ",\n ") + renderJson(one);
        std::cout << (out.empty() ? "[]" : out + "]") << "\n";
    } else {
        printFindings(findings, std::cout);
        if (findings.empty()) std::cout << project.name << ": panels, texts and alarms are good\n";
    }
    for (const hmi::Finding& one : findings)
        if (one.isError) return kProgramWrong;
    return kGood;
}

int pictures(const Arguments& arguments, const projects::Project& project, const std::string& folder) {
    driver::Built built = driver::build(project.buildInput());
    printDiagnostics(built.checked, false, false);
    if (built.checked.analysis->hasErrors) return kProgramWrong;
    if (!built.program)
        return wrongUse({built.failure.isEmpty() ? errors::NothingToRun() : built.failure, project.name});
    hmi::PictureOptions options;
    options.folder = QString::fromStdString(folder);
    for (const std::string& language : arguments.values("--language"))
        if (language != "all") options.languages += QString::fromStdString(language);
    for (const std::string& panel : arguments.values("--panel")) options.panels += QString::fromStdString(panel);
    if (const auto text = arguments.value("--scale")) {
        options.scale = std::atof(text->c_str());
        if (!(options.scale >= 0.25 && options.scale <= 8)) return wrongUse({errors::PanelScaleRange(), *text});
    }
    catchInterrupt();
    session::Settings settings;
    settings.historyBudget = size_t(1) << 30;
    session::Session session(std::move(built), settings);
    if (auto ran = runProject(arguments, session.built(), session, std::chrono::nanoseconds(0), "--at"); !ran)
        return wrongUse(ran.error());
    needApplication();
    hmi::PanelProject panels = hmi::loadPanelProject(project);
    for (const Error& problem : panels.problems) std::cerr << problem.english() << "\n";
    if (auto chosen = hmi::chooseTheme(panels, arguments.value("--theme").value_or("")); !chosen)
        return wrongUse(chosen.error());
    const auto paths = hmi::renderPanels(panels, &session, options);
    if (!paths) return wrongUse(paths.error());
    for (const QString& path : *paths) std::cout << path.toStdString() << "\n";
    return panels.problems.empty() ? kGood : kProgramWrong;
}

int play(const Arguments& arguments, const projects::Project& project) {
    if (qEnvironmentVariableIsEmpty("DISPLAY") && qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY") &&
        qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM"))
        return wrongUse({errors::NoDisplay(), ""});
    driver::Built built = driver::build(project.buildInput());
    printDiagnostics(built.checked, false, false);
    if (built.checked.analysis->hasErrors) return kProgramWrong;
    if (!built.program)
        return wrongUse({built.failure.isEmpty() ? errors::NothingToRun() : built.failure, project.name});
    if (auto optimised = driver::optimise(built); !optimised) return wrongUse(optimised.error());
    static int count = 1;
    static char name[] = "stepwise";
    static char* words[] = {name, nullptr};
    QApplication application(count, words);
    kit::Theme::install(application, kit::ThemeChoice::System);
    session::Session session(std::move(built));
    hmi::PanelProject panels = hmi::loadPanelProject(project);
    for (const Error& problem : panels.problems) std::cerr << problem.english() << "\n";
    if (auto chosen = hmi::chooseTheme(panels, arguments.value("--theme").value_or("")); !chosen)
        return wrongUse(chosen.error());
    if (panels.panels.empty()) return wrongUse({errors::NoPanelInProject(), project.name});
    const hmi::PlayOptions options{QString::fromStdString(arguments.value("--panel").value_or("")),
                                   QString::fromStdString(arguments.value("--language").value_or("")),
                                   arguments.has("--full-screen")};
    if (!options.panel.isEmpty() && !panels.find(options.panel))
        return wrongUse({errors::NoSuchPanel(), options.panel.toStdString()});
    if (!options.language.isEmpty() && !panels.texts.settings().languages.contains(options.language))
        return wrongUse({errors::NoTextsIn(options.language.toStdString()), project.name});
    return hmi::playPanels(panels, session, options);
}

/// The alarm history that a player has kept in the project, as a table on the standard output.
int alarmHistory(const Arguments& arguments, const projects::Project& project) {
    needApplication();
    const hmi::PanelProject panels = hmi::loadPanelProject(project);
    const QString path = hmi::OperatorStation::alarmStoreOf(panels);
    hmi::AlarmBook book;
    book.setFile(panels.alarms);
    if (QFileInfo::exists(path))
        if (const auto opened = book.openStore(path); !opened) return wrongUse(opened.error());
    const QStringList& known = panels.texts.settings().languages;
    const QString language =
        QString::fromStdString(arguments.value("--language").value_or(known.front().toStdString()));
    constexpr int Everything = 25'000;
    std::cout << hmi::alarmsAsCsv(book.history({}, Everything), panels.texts, language);
    return kGood;
}

int format(const projects::Project& project) {
    const hmi::PanelProject panels = hmi::loadPanelProject(project);
    for (const Error& problem : panels.problems) std::cerr << problem.english() << "\n";
    if (!panels.problems.empty()) return kProgramWrong;
    const auto done = hmi::formatPanels(panels);
    return done ? kGood : wrongUse(done.error());
}

int runPanel(const Arguments& arguments) {
    if (arguments.has("--rules")) return listRules();
    if (arguments.paths().size() != 1) return wrongUse({errors::PanelNeedsProject(), ""});
    const auto project = openNamedProject(arguments);
    if (!project) return wrongUse(project.error());
    if (!hasPanels(*project)) return wrongUse({errors::NoPanelInProject(), project->name});
    if (arguments.has("--format-files")) return format(*project);
    if (arguments.has("--alarm-history")) return alarmHistory(arguments, *project);
    if (const auto folder = arguments.value("--pictures")) return pictures(arguments, *project, *folder);
    if (arguments.has("--play")) return play(arguments, *project);
    return check(arguments, *project);
}

} // namespace

Command panelCommand() {
    return {
        {"panel",
         "PROJECT [OPTIONS]",
         "Checks the operator panels, makes pictures of them in every language, or runs them.",
         {{"--check", "", "what is wrong with panels, texts and alarms (this is what happens without options)"},
          {"--level", "off|basic|standard|strict",
           "how strictly ISA-101 and ISA-18.2 are checked, instead of the level in project.json"},
          {"--rules", "", "list the rules of that check: code, name, level, why"},
          {"--fix", "", "correct what needs no decision"},
          {"--pseudo", "", "measure the texts of the pseudo-language too: longer and accented"},
          {"--format", "text|json", "how findings are printed"},
          {"--pictures", "DIR", "a PNG of every panel in every language"},
          {"--language", "TAG", "only this language, or all (repeatable); with --play the one to begin with"},
          {"--panel", "NAME", "only this panel (repeatable); with --play the one to begin with"},
          {"--at", "10s", "the pictures show this time in a run; the check compares bars and charts with that run"},
          {"--set", "PATH=VALUE[@TIME]", "write before the first scan at or after TIME (repeatable)"},
          {"--force", "PATH=VALUE[@TIME]", "force likewise (repeatable)"},
          {"--theme", "NAME", "another theme than the panel's own: light, dark, contrast, or one of hmi/themes"},
          {"--scale", "1", "pixels of the picture per pixel of the panel"},
          {"--alarm-history", "", "print what was raised, gone and acknowledged while the panels were played, as CSV"},
          {"--play", "", "run the controller and show the panel in a window"},
          {"--full-screen", "", "play on the whole screen"},
          {"--format-files", "", "write panels, texts and alarms in the canonical order"},
          {"--library", "NAME", "a library the files use, in addition to the standard library (repeatable)"}},
         "stepwise panel projects/examples/alarm_texts --pictures out --language all --at 10s --set Panel.Start=TRUE"},
        runPanel};
}

} // namespace plc::cli
