#include "app/cli/command.h"

#include "app/cli/errors.h"
#include "projects/analysis/conversion.h"
#include "projects/storage/project_file.h"
#include "runtime/base/text.h"

#include <filesystem>
#include <iostream>

namespace plc::cli {

namespace {

/// Where a file of the project lies on disk.
std::string onDisk(const Arguments& arguments, const std::string& path) {
    std::error_code problem;
    const std::string& first = arguments.paths().front();
    if (arguments.paths().size() == 1 && std::filesystem::is_directory(first, problem))
        return (std::filesystem::path(first) / path).string();
    return path;
}

int convert(const Arguments& arguments) {
    if (arguments.paths().empty()) return wrongUse({errors::NeedsProject(Verbatim("convert")), ""});
    const auto wanted = arguments.value("--to");
    if (!wanted || (!equalsIgnoringCase(*wanted, "st") && !equalsIgnoringCase(*wanted, "il")))
        return wrongUse({errors::ConvertTo(), wanted.value_or("")});
    const analysis::TextLanguage to =
        equalsIgnoringCase(*wanted, "st") ? analysis::TextLanguage::St : analysis::TextLanguage::Il;
    const auto unit = arguments.value("--unit");
    if (!unit && to == analysis::TextLanguage::Il) return wrongUse({errors::ConvertNeedsUnit(), ""});
    const auto project = openNamedProject(arguments);
    if (!project) return wrongUse(project.error());
    driver::BuildInput input = project->buildInput();
    bool known = false, refused = false;
    size_t done = 0;
    for (driver::SourceFile& file : input.files) {
        bool changed = false;
        for (const analysis::BodyPlace& place : analysis::bodiesOf(file.text)) {
            if (unit ? !equalsIgnoringCase(*unit, place.unit) : place.language == to) continue;
            known = true;
            const auto converted = analysis::convertBody(input, file.path, place.unit, to);
            if (!converted) {
                std::cerr << "stepwise: " << place.unit << ": " << converted.error().english() << "\n";
                refused = true;
                continue;
            }
            file.text = converted->text;
            changed = true;
            ++done;
        }
        if (!changed) continue;
        if (!arguments.has("--write")) {
            std::cout << file.text;
            continue;
        }
        const std::string path = onDisk(arguments, file.path);
        if (auto written = projects::writeFileAtomically(path, file.text); !written) return wrongUse(written.error());
        std::cerr << "converted " << path << "\n";
    }
    if (unit && !known) return wrongUse({errors::NoUnitToConvert(), *unit});
    if (done == 0 && !refused) std::cerr << "nothing to convert\n";
    return refused ? kProgramWrong : kGood;
}

} // namespace

Command convertCommand() {
    return {{"convert",
             "PATH… --to st|il [OPTIONS]",
             "Shows instruction lists as ST, and ST as instruction lists.",
             {{"--to", "st|il", "the language that comes out; the file that changes is printed"},
              {"--unit", "NAME",
               "only this program, function, block, Unit.Method or Unit.Action (needed for il; st: every list)"},
              {"--library", "NAME", "a library the files use, besides the standard (repeatable)"},
              {"--write", "", "change the files instead of printing them"}},
             "stepwise convert projects/examples/weigh --to st --unit NetWeightIl"},
            convert};
}

} // namespace plc::cli
