// stepwise texts: the operators' texts out to translators and back.
#include "app/cli/panels/commands.h"

#include "app/cli/kit/errors.h"
#include "app/cli/panels/panel_findings.h"
#include "hmi/player/text_pictures.h"
#include "hmi/station/text_exchange.h"
#include "projects/storage/project_file.h"

#include <iostream>

namespace plc::cli {

namespace {

bool isCsv(const std::string& path) { return path.ends_with(".csv") || path.ends_with(".txt"); }

Result<hmi::XliffOptions> optionsOf(const Arguments& arguments, const hmi::PanelProject& project) {
    hmi::XliffOptions options;
    const QStringList& languages = project.texts.settings().languages;
    options.source = QString::fromStdString(arguments.value("--from").value_or(languages.value(0).toStdString()));
    options.target = QString::fromStdString(arguments.value("--language").value_or(""));
    options.original = project.placeOf(project.textsPath());
    options.places = hmi::placesOfTexts(project);
    options.onlyMissing = arguments.has("--missing");
    const std::string version = arguments.value("--xliff").value_or("2");
    if (version != "2" && version != "2.0" && version != "1.2") return Error{errors::XliffIs(), version};
    if (version == "1.2") options.version = hmi::XliffVersion::V12;
    if (options.target.isEmpty()) return Error{errors::TextsNeedLanguage(), ""};
    if (project.texts.table().columnOf(options.source) < 0)
        return Error{errors::NoTextsIn(options.source.toStdString()), ""};
    return options;
}

/// A picture of the place of each text, in the language that is translated from; by key, their files.
Result<QMap<QString, QStringList>> makePictures(const Arguments& arguments, const hmi::PanelProject& project) {
    QMap<QString, QStringList> files;
    const auto folder = arguments.value("--pictures");
    if (!folder) return files;
    needApplication();
    const QString first = project.texts.settings().languages.value(0);
    const auto made =
        hmi::writeTextPictures(project, QString::fromStdString(*folder),
                               QString::fromStdString(arguments.value("--from").value_or(hmi::toUtf8(first))));
    if (!made) return made.error();
    for (const hmi::TextPicture& one : *made) files[one.key] += one.file;
    std::cerr << made->size() << " pictures in " << *folder << "\n";
    return files;
}

int exportTexts(const Arguments& arguments, const hmi::PanelProject& project, const std::string& path,
                const QMap<QString, QStringList>& pictures) {
    std::string bytes;
    if (isCsv(path)) {
        bytes = project.texts.table().write();
    } else {
        auto options = optionsOf(arguments, project);
        if (!options) return wrongUse(options.error());
        for (auto one = pictures.cbegin(); one != pictures.cend(); ++one) options->places[one.key()] += one.value();
        bytes = hmi::writeXliff(project.texts.table(), *options);
    }
    if (auto written = projects::writeFileAtomically(path, bytes); !written) return wrongUse(written.error());
    return kGood;
}

int importTexts(const Arguments& arguments, hmi::PanelProject& project, const std::string& path) {
    const auto bytes = projects::readFile(path);
    if (!bytes) return wrongUse(bytes.error());
    const auto file = hmi::readXliff(*bytes, QString::fromStdString(path));
    if (!file) return wrongUse(file.error());
    hmi::TextTable table = project.texts.table();
    const hmi::XliffReport report = hmi::takeXliff(table, *file, QString::fromStdString(path));
    std::cout << hmi::reportText(report);
    if (!arguments.has("--preview") && report.taken > 0) {
        project.texts.setTable(std::move(table));
        if (auto saved = hmi::saveTexts(project); !saved) return wrongUse(saved.error());
    }
    return report.remarks.empty() ? kGood : kProgramWrong;
}

int runTexts(const Arguments& arguments) {
    if (arguments.paths().size() != 1) return wrongUse({errors::TextsNeedProject(), ""});
    const auto project = openNamedProject(arguments);
    if (!project) return wrongUse(project.error());
    hmi::PanelProject panels = hmi::loadPanelProject(*project);
    if (!panels.hasTexts) return wrongUse({errors::NoTextTable(), project->name});
    const auto pictures = makePictures(arguments, panels);
    if (!pictures) return wrongUse(pictures.error());
    if (const auto path = arguments.value("--export")) return exportTexts(arguments, panels, *path, *pictures);
    if (arguments.has("--pictures")) return kGood;
    if (const auto path = arguments.value("--import")) return importTexts(arguments, panels, *path);
    return wrongUse({errors::TextsNeedProject(), ""});
}

} // namespace

Command textsCommand() {
    return {{"texts",
             "PROJECT --export FILE | --import FILE | --pictures DIR [OPTIONS]",
             "Exports the operators' texts as XLIFF for translators and imports their translations.",
             {{"--export", "FILE", "writes the texts: XLIFF, or the whole table where FILE ends with .csv"},
              {"--import", "FILE", "takes the translations of an XLIFF file and reports what does not fit"},
              {"--language", "TAG", "the target language of the translation"},
              {"--from", "TAG", "the source language of the translation (default: the first of the project)"},
              {"--xliff", "2|1.2", "the XLIFF version to write"},
              {"--pictures", "DIR", "a picture of the context of each text, and index.html; --export refers to them"},
              {"--missing", "", "only texts that have no translation yet"},
              {"--preview", "", "with --import: report only, write nothing"}},
             "stepwise texts projects/examples/alarm_texts --export alarm_texts.de.xlf --language de"},
            runTexts};
}

} // namespace plc::cli
