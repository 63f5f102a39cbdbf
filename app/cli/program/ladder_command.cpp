#include "app/cli/program/commands.h"

#include "app/cli/kit/errors.h"
#include "projects/storage/project_file.h"
#include "runtime/base/text.h"
#include "runtime/compiler/ladder/picture.h"
#include "runtime/compiler/parse/parser.h"

#include <cstdio>
#include <iostream>

namespace plc::cli {

namespace {

/// A file of the project with its own tree: the one of the check is lowered already.
struct Parsed {
    const driver::SourceFile* source = nullptr;
    std::unique_ptr<syntax::SyntaxFile> file;
};

std::vector<Parsed> parseAll(const driver::BuildInput& input) {
    std::vector<Parsed> out;
    for (const driver::SourceFile& source : input.files) {
        diagnostics::Sink sink;
        out.push_back({&source, parse::parseFile(FileId(out.size()), source.text, sink)});
    }
    return out;
}

ladder::DeclaredTypes typesOf(const std::vector<Parsed>& files, const driver::Checked& checked) {
    std::vector<const syntax::SyntaxFile*> all;
    for (const Parsed& parsed : files) all.push_back(parsed.file.get());
    for (const auto& file : checked.analysis->files)
        if (!file->library.empty()) all.push_back(file.get());
    return ladder::DeclaredTypes(all);
}

std::string percent(size_t part, size_t whole) {
    char buffer[16];
    std::snprintf(buffer, sizeof buffer, "%.1f %%",
                  whole ? 100.0 * static_cast<double>(part) / static_cast<double>(whole) : 0);
    return buffer;
}

/// How much of a project has a picture, file by file.
int printShares(const std::vector<Parsed>& files, const ladder::DeclaredTypes& types) {
    ladder::Share all;
    size_t units = 0;
    for (const Parsed& parsed : files) {
        ladder::Share share;
        for (const ladder::Unit& unit : ladder::unitsOf(*parsed.file)) {
            share += ladder::project(parsed.source->text, *parsed.file, unit, types, ladder::Form::Ladder).share;
            ++units;
        }
        if (share.total() == 0) continue;
        std::cout << parsed.source->path << ": " << share.total() << " statements, "
                  << percent(share.drawn, share.total()) << " drawn, " << percent(share.framed, share.total())
                  << " frames, " << percent(share.text, share.total()) << " text\n";
        all += share;
    }
    std::cout << "total: " << units << " units, " << all.total() << " statements, " << percent(all.drawn, all.total())
              << " drawn, " << percent(all.framed, all.total()) << " frames, " << percent(all.text, all.total())
              << " text\n";
    return kGood;
}

int unknownUnit(const std::vector<Parsed>& files, const std::string& name) {
    std::vector<std::string> names;
    for (const Parsed& parsed : files)
        for (const ladder::Unit& unit : ladder::unitsOf(*parsed.file)) names.push_back(unit.name);
    const auto near = nearestName(name, names);
    return wrongUse({near ? errors::NoUnitToDrawSuggest(name, *near) : errors::NoUnitToDraw(name), ""});
}

Result<ladder::Symbols> symbolsOf(const Arguments& arguments) {
    const std::string wanted = arguments.value("--symbols").value_or("bars");
    if (wanted == "bars") return ladder::Symbols::Bars;
    if (wanted == "circuit") return ladder::Symbols::Circuit;
    return Error{errors::SymbolsIs(), wanted};
}

Result<ladder::LayoutOptions> optionsOf(const Arguments& arguments) {
    ladder::LayoutOptions options;
    options.showsComments = arguments.has("--comments");
    const std::string wanted = arguments.value("--show").value_or("names");
    if (wanted == "addresses")
        options.naming = ladder::Naming::Addresses;
    else if (wanted == "both")
        options.naming = ladder::Naming::Both;
    else if (wanted != "names")
        return Error{errors::ShowIs(), wanted};
    return options;
}

int draw(const Arguments& arguments, const Parsed& parsed, const ladder::Unit& unit,
         const ladder::DeclaredTypes& types) {
    const bool asBlocks = arguments.has("--fbd") || (!arguments.has("--ld") && equalsIgnoringCase(unit.view, "fbd"));
    const ladder::Diagram diagram = ladder::project(parsed.source->text, *parsed.file, unit, types,
                                                    asBlocks ? ladder::Form::Blocks : ladder::Form::Ladder);
    const auto symbols = symbolsOf(arguments);
    if (!symbols) return wrongUse(symbols.error());
    const auto options = optionsOf(arguments);
    if (!options) return wrongUse(options.error());
    const ladder::Layout layout = ladder::computeLayout(diagram, *options);
    const auto picture = arguments.value("--picture");
    if (picture) {
        if (!picture->ends_with(".svg")) return wrongUse({errors::PictureIsSvg(), *picture});
        const std::string svg = ladder::asSvg(layout, unit.name, *symbols);
        if (auto written = projects::writeFileAtomically(*picture, svg); !written) return wrongUse(written.error());
    }
    if (!picture || arguments.has("--text")) std::cout << ladder::asText(layout);
    return kGood;
}

int ladderDiagram(const Arguments& arguments) {
    if (arguments.paths().empty()) return wrongUse({errors::NeedsProject(Verbatim("ladder")), ""});
    const auto name = arguments.value("--pou");
    if (!name && !arguments.has("--share")) return wrongUse({errors::LadderNeedsUnit(), ""});
    const auto project = openNamedProject(arguments);
    if (!project) return wrongUse(project.error());
    const driver::BuildInput input = project->buildInput();
    const driver::Checked checked = driver::check(input);
    const std::vector<Parsed> files = parseAll(input);
    const ladder::DeclaredTypes types = typesOf(files, checked);
    if (!name) return printShares(files, types);
    for (const Parsed& parsed : files)
        if (const ladder::Unit unit = ladder::findUnit(*parsed.file, *name); unit.body)
            return draw(arguments, parsed, unit, types);
    return unknownUnit(files, *name);
}

} // namespace

Command ladderCommand() {
    return {
        {"ladder",
         "PATH… --pou NAME [OPTIONS]",
         "Draws ST as a ladder or function block diagram.",
         {{"--pou", "NAME", "the program, function, block, Unit.Method or Unit.Action to draw"},
          {"--fbd", "", "as a function block diagram"},
          {"--ld", "", "as a ladder, also where the unit prefers function blocks"},
          {"--picture", "FILE.svg", "write a picture instead of printing characters"},
          {"--text", "", "print characters, also besides a picture"},
          {"--symbols", "bars|circuit", "contacts as bars (IEC 61131-3, ANSI) or as in circuit diagrams (IEC 60617)"},
          {"--show", "names|addresses|both", "what is shown above contacts and coils"},
          {"--comments", "", "the variables' comments above their contacts and coils"},
          {"--share", "", "print how many statements of the project have a picture, and how many are shown as text"},
          {"--library", "NAME", "a library the files use, in addition to the standard library (repeatable)"}},
         "stepwise ladder projects/examples/motor --pou Main"},
        ladderDiagram};
}

} // namespace plc::cli
