#include "app/cli/command_line.h"

#include "app/cli/kit/errors.h"
#include "app/cli/manual.h"
#include "projects/analysis/explanation.h"
#include "projects/analysis/library_reference.h"

#include "stepwise_version.h"

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

namespace plc::cli {

namespace {

int checkReference(const std::string& folder) {
    int stale = 0;
    for (const analysis::ReferencePage& page : analysis::libraryReference()) {
        std::ifstream file(folder + "/" + page.fileName, std::ios::binary);
        std::ostringstream text;
        text << file.rdbuf();
        if (text.str() == page.markdown) continue;
        std::cerr << folder << "/" << page.fileName << " is stale (stepwise doc library writes it)\n";
        ++stale;
    }
    return stale == 0 ? kGood : kProgramWrong;
}

int documentDiagnostics(const Arguments& arguments) {
    const std::string path = arguments.value("--out").value_or("docs") + "/diagnostics.md";
    const std::string text = analysis::diagnosticsReference();
    std::ostringstream old;
    old << std::ifstream(path, std::ios::binary).rdbuf();
    if (old.str() == text) return kGood;
    if (arguments.has("--check")) {
        std::cerr << path << " is stale (stepwise doc diagnostics writes it)\n";
        return kProgramWrong;
    }
    std::error_code ignored; // what it leads to is said below
    std::filesystem::create_directories(std::filesystem::path(path).parent_path(), ignored);
    std::ofstream file(path, std::ios::binary);
    if (!(file << text).flush()) return wrongUse({errors::OutputNotWritten(), path});
    std::cout << path << " written\n";
    return kGood;
}

int writeReference(const Arguments& arguments) {
    const std::string folder = arguments.value("--out").value_or("docs/library");
    if (arguments.has("--check")) return checkReference(folder);
    const auto written = analysis::writeLibraryReference(folder);
    if (!written) return wrongUse(written.error());
    std::cout << folder << ": " << *written << (*written == 1 ? " page" : " pages") << " written\n";
    return kGood;
}

Result<void> writeText(const std::filesystem::path& path, const std::string& text) {
    std::error_code problem;
    std::filesystem::create_directories(path.parent_path(), problem);
    std::ofstream file(path, std::ios::binary);
    file << text;
    file.close();
    if (!file) return Error{errors::BuildNotWritten(path.string(), errors::ofSystem(errno)), ""};
    return {};
}

std::vector<CommandSpec> specs() {
    std::vector<CommandSpec> out;
    for (const Command& command : commands()) out.push_back(command.spec);
    return out;
}

int writeFiles(const std::vector<std::pair<std::filesystem::path, std::string>>& files) {
    for (const auto& [path, text] : files)
        if (auto written = writeText(path, text); !written) return wrongUse(written.error());
    return kGood;
}

/// stepwise.1 and one page for each command.
int writeManual(const Arguments& arguments) {
    const std::filesystem::path folder = arguments.value("--out").value_or("man1");
    std::vector<std::pair<std::filesystem::path, std::string>> files{
        {folder / "stepwise.1", overviewPage(specs(), STEPWISE_VERSION)}};
    for (const CommandSpec& spec : specs())
        files.emplace_back(folder / ("stepwise-" + std::string(spec.name) + ".1"), manualPage(spec, STEPWISE_VERSION));
    return writeFiles(files);
}

/// As the shells look for them: bash by the name of the program, zsh with an underscore before it.
int writeCompletion(const Arguments& arguments) {
    const std::filesystem::path folder = arguments.value("--out").value_or("completion");
    return writeFiles({{folder / "stepwise", bashCompletion(specs())}, {folder / "_stepwise", zshCompletion(specs())}});
}

int document(const Arguments& arguments) {
    const std::string subject = arguments.paths().size() == 1 ? arguments.paths()[0] : "";
    if (subject == "library") return writeReference(arguments);
    if (subject == "diagnostics") return documentDiagnostics(arguments);
    if (subject == "man") return writeManual(arguments);
    if (subject == "completion") return writeCompletion(arguments);
    return wrongUse({errors::DocNeedsSubject(), ""});
}

} // namespace

Command docCommand() {
    return {{"doc",
             "library|diagnostics|man|completion [OPTIONS]",
             "Writes the reference of all libraries or of all diagnostics, the manual pages, or completions for bash "
             "and zsh.",
             {{"--out", "FOLDER", "where the files go (docs/library, docs, man1, completion)"},
              {"--check", "", "with library and diagnostics: writes nothing; exit code 1 if a page is out of date"}},
             "stepwise doc library --out /tmp/reference"},
            document};
}

} // namespace plc::cli
