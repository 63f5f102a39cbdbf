#include "app/cli/program/commands.h"

#include "app/cli/kit/errors.h"
#include "projects/exchange/import.h"

#include <iostream>

namespace plc::cli {

namespace {

std::string reportJson(const exchange::Report& report) {
    std::string notes;
    for (const exchange::Note& note : report.notes) {
        const bool isLoss = exchange::severityOf(note.kind) == exchange::NoteSeverity::Loss;
        notes += std::string(notes.empty() ? "" : ",\n ") + "{\"place\":" + jsonString(note.place) +
                 ",\"kind\":" + jsonString(exchange::nameOf(note.kind)) + ",\"kept\":" + (isLoss ? "false" : "true") +
                 ",\"message\":" + jsonString(note.message.english()) + "}";
    }
    const auto figures = [](const std::map<std::string, int>& counts) {
        std::string out;
        for (const auto& [name, count] : counts)
            out += (out.empty() ? "" : ",") + jsonString(name) + ":" + std::to_string(count);
        return "{" + out + "}";
    };
    return "{\"files\":" + std::to_string(report.filesRead) + ",\"units\":" + figures(report.units) +
           ",\"bodies\":" + figures(report.bodies) + ",\"notKept\":" + std::to_string(report.losses()) +
           ",\"notes\":[" + notes + "]}";
}

void print(const std::vector<exchange::Imported>& projects, const std::string& folder, bool asJson) {
    const bool areSeveral = projects.size() > 1;
    if (asJson && areSeveral) std::cout << "{\"projects\":[";
    for (size_t i = 0; i < projects.size(); ++i) {
        const exchange::Imported& each = projects[i];
        const std::string own = exchange::folderOf(projects, i, folder);
        if (asJson && areSeveral)
            std::cout << (i > 0 ? ",\n" : "") << "{\"name\":" << jsonString(each.name)
                      << ",\"folder\":" << jsonString(own) << ",\"report\":" << reportJson(each.report) << "}";
        else if (asJson)
            std::cout << reportJson(each.report);
        else
            std::cout << (areSeveral ? "project " + each.name + ": " + own + "\n" : "") << each.report.toText();
    }
    if (asJson) std::cout << (areSeveral ? "]}\n" : "\n");
}

int importProject(const Arguments& arguments) {
    if (arguments.paths().size() != 1) return wrongUse({errors::ImportNeedsOne(), ""});
    const auto to = arguments.value("--to");
    if (!to && !arguments.has("--preview")) return wrongUse({errors::ImportNeedsTarget(), ""});
    exchange::ImportOptions options;
    if (arguments.has("--together")) options.division = exchange::TreeDivision::Together;
    options.only = arguments.value("--project").value_or("");
    if (const auto name = arguments.value("--encoding")) {
        const auto encoding = projects::parseCodePage(*name);
        if (!encoding) return wrongUse(encoding.error());
        options.codePage = *encoding;
    }
    const auto imported = [&] {
        const Busy busy("importing " + arguments.paths().front());
        return exchange::importProjects(arguments.paths().front(), options);
    }();
    if (!imported) return wrongUse(imported.error());
    if (!arguments.has("--preview"))
        if (auto written = exchange::writeProjects(*imported, *to, nullptr); !written) return wrongUse(written.error());
    print(*imported, to.value_or("."), arguments.wantsJson());
    return kGood;
}

} // namespace

Command importCommand() {
    return {{"import",
             "FILE|FOLDER --to PROJECT [OPTIONS]",
             "Makes a project of PLCopen XML, TwinCAT files or text exports of CODESYS; of a folder with several "
             "projects that share names, one each.",
             {{"--to", "PROJECT", "the folder of the new project; it must not exist or must be empty"},
              {"--project", "NAME", "only this one of several projects in a folder, with the libraries it uses"},
              {"--together", "", "one project of all, even where units of equal names meet"},
              {"--encoding", "NAME",
               "of files that do not say theirs: Windows-1251, Windows-1250 …; otherwise it is guessed"},
              {"--preview", "", "write nothing, only report"},
              {"--format", "text|json", "text (default), or an object with the figures and a list of notes"}},
             "stepwise import plc.xml --to machine"},
            importProject};
}

} // namespace plc::cli
