#include "app/cli/command.h"

#include "app/cli/errors.h"
#include "projects/exchange/imported.h"

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

int importProject(const Arguments& arguments) {
    if (arguments.paths().size() != 1) return wrongUse({errors::ImportNeedsOne(), ""});
    const auto to = arguments.value("--to");
    if (!to && !arguments.has("--preview")) return wrongUse({errors::ImportNeedsTarget(), ""});
    const auto imported = [&] {
        const Busy busy("importing " + arguments.paths().front());
        return exchange::importFrom(arguments.paths().front());
    }();
    if (!imported) return wrongUse(imported.error());
    if (!arguments.has("--preview"))
        if (auto written = exchange::writeImported(*imported, *to); !written) return wrongUse(written.error());
    if (arguments.wantsJson())
        std::cout << reportJson(imported->report) << "\n";
    else
        std::cout << imported->report.toText();
    return kGood;
}

} // namespace

Command importCommand() {
    return {{"import",
             "FILE|FOLDER --to PROJECT [OPTIONS]",
             "Makes a project of PLCopen XML, TwinCAT files or text exports of CODESYS.",
             {{"--to", "PROJECT", "the folder of the new project; it must not exist or must be empty"},
              {"--preview", "", "write nothing, only report"},
              {"--format", "text|json", "text (default), or an object with the figures and a list of notes"}},
             "stepwise import plc.xml --to machine"},
            importProject};
}

} // namespace plc::cli
