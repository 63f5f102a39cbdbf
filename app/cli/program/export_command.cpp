#include "app/cli/program/commands.h"

#include "app/cli/kit/errors.h"
#include "projects/exchange/plcopen/plcopen_export.h"
#include "projects/storage/project_file.h"

#include <chrono>
#include <cstdio>
#include <iostream>

namespace plc::cli {

namespace {

std::string now() {
    using namespace std::chrono;
    const auto time = floor<seconds>(system_clock::now());
    const auto day = floor<days>(time);
    const year_month_day date(day);
    const hh_mm_ss clock(time - day);
    char out[32];
    std::snprintf(out, sizeof out, "%04d-%02u-%02uT%02d:%02d:%02d", static_cast<int>(date.year()),
                  static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                  static_cast<int>(clock.hours().count()), static_cast<int>(clock.minutes().count()),
                  static_cast<int>(clock.seconds().count()));
    return out;
}

int exportProject(const Arguments& arguments) {
    if (arguments.paths().empty()) return wrongUse({errors::NeedsProject(Verbatim("export")), ""});
    const auto to = arguments.value("--to");
    if (!to) return wrongUse({errors::ExportNeedsTarget(), ""});
    exchange::ExportOptions options;
    const std::string version = arguments.value("--version").value_or("0200");
    if (version != "0200" && version != "0201") return wrongUse({errors::ExportVersionIs(), version});
    if (version == "0201") options.edition = exchange::Edition::Plain0201;
    options.time = now();
    const auto project = openNamedProject(arguments);
    if (!project) return wrongUse(project.error());
    const auto exported = exchange::exportPlcopen(*project, options);
    if (!exported) return wrongUse(exported.error());
    if (auto written = projects::writeFileAtomically(*to, exported->text); !written) return wrongUse(written.error());
    std::cout << exported->report.toText();
    return kGood;
}

} // namespace

Command exportCommand() {
    return {{"export",
             "PATH… --to FILE [OPTIONS]",
             "Writes a project as PLCopen XML and reports what the format does not support.",
             {{"--to", "FILE", "the file to write"},
              {"--version", "0200|0201", "0200 (default) for CODESYS and TwinCAT, 0201 for Beremiz and OpenPLC"}},
             "stepwise export projects/examples/motor --to motor.xml"},
            exportProject};
}

} // namespace plc::cli
