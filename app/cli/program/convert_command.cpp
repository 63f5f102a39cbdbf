#include "app/cli/program/commands.h"

#include "app/cli/kit/errors.h"
#include "projects/analysis/conversion.h"
#include "projects/storage/project_file.h"
#include "runtime/base/text.h"
#include "runtime/compiler/ladder/units.h"
#include "runtime/compiler/parse/parser.h"

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

/// Prints the file that changed, or writes it.
int handOver(const Arguments& arguments, const driver::SourceFile& file) {
    if (!arguments.has("--write")) {
        std::cout << file.text;
        return kGood;
    }
    const std::string path = onDisk(arguments, file.path);
    if (auto written = projects::writeSourceText(path, file.text); !written) return wrongUse(written.error());
    std::cerr << "converted " << path << "\n";
    return kGood;
}

/// A diagram is a view of ST: only what the unit prefers is written.
int preferView(const Arguments& arguments, std::string_view view) {
    const auto name = arguments.value("--unit");
    if (!name) return wrongUse({errors::ViewNeedsUnit(), ""});
    const auto project = openNamedProject(arguments);
    if (!project) return wrongUse(project.error());
    for (driver::SourceFile file : project->buildInput().files) {
        diagnostics::Sink sink;
        const auto tree = parse::parseFile(FileId(size_t(0)), file.text, sink);
        const ladder::Unit unit = ladder::findUnit(*tree, *name);
        if (!unit.body) continue;
        if (unit.body->language != syntax::BodyLanguage::St && unit.body->language != syntax::BodyLanguage::None)
            return wrongUse({errors::ViewOfTextOnly(), unit.name});
        if (unit.range.begin != unit.pou->range.begin) return wrongUse({errors::ActionHasNoView(), unit.name});
        const diagnostics::Edits edits = ladder::preferView(file.text, unit, view);
        if (edits.empty()) std::cerr << "nothing to convert\n";
        if (edits.empty()) return kGood;
        file.text = diagnostics::applyEdits(file.text, edits);
        return handOver(arguments, file);
    }
    return wrongUse({errors::NoUnitToConvert(), *name});
}

int convert(const Arguments& arguments) {
    if (arguments.paths().empty()) return wrongUse({errors::NeedsProject(Verbatim("convert")), ""});
    const auto wanted = arguments.value("--to");
    if (wanted && equalsIgnoringCase(*wanted, "ld")) return preferView(arguments, "ladder");
    if (wanted && equalsIgnoringCase(*wanted, "fbd")) return preferView(arguments, "fbd");
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
        if (const int code = handOver(arguments, file); code != kGood) return code;
    }
    if (unit && !known) return wrongUse({errors::NoUnitToConvert(), *unit});
    if (done == 0 && !refused) std::cerr << "nothing to convert\n";
    return refused ? kProgramWrong : kGood;
}

} // namespace

Command convertCommand() {
    return {{"convert",
             "PATH… --to st|il|ld|fbd [OPTIONS]",
             "Shows instruction lists as ST, ST as instruction lists or as a diagram.",
             {{"--to", "st|il|ld|fbd",
               "the target language; the converted file is printed. ld and fbd set how the unit is shown"},
              {"--unit", "NAME",
               "only this program, function, block, Unit.Method or Unit.Action (st without it: every list)"},
              {"--library", "NAME", "a library the files use, in addition to the standard library (repeatable)"},
              {"--write", "", "change the files instead of printing them"}},
             "stepwise convert projects/examples/weigh --to st --unit NetWeightIl"},
            convert};
}

} // namespace plc::cli
