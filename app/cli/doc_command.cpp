#include "app/cli/command.h"

#include "app/cli/errors.h"
#include "projects/analysis/explanation.h"
#include "projects/analysis/library_reference.h"

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
    std::ofstream file(path, std::ios::binary);
    if (!(file << text).flush()) return wrongUse({errors::OutputNotWritten(), path});
    std::cout << path << " written\n";
    return kGood;
}

int document(const Arguments& arguments) {
    const std::string subject = arguments.paths().size() == 1 ? arguments.paths()[0] : std::string();
    if (subject == "diagnostics") return documentDiagnostics(arguments);
    if (subject != "library") return wrongUse({errors::DocNeedsSubject(), ""});
    const std::string folder = arguments.value("--out").value_or("docs/library");
    if (arguments.has("--check")) return checkReference(folder);
    const auto written = analysis::writeLibraryReference(folder);
    if (!written) return wrongUse(written.error());
    std::cout << folder << ": " << *written << (*written == 1 ? " page" : " pages") << " written\n";
    return kGood;
}

} // namespace

Command docCommand() {
    return {{"doc",
             "library|diagnostics [OPTIONS]",
             "Writes the reference of all libraries (from the comments of their ST texts) or of all diagnostics.",
             {{"--out", "FOLDER", "where the pages go (docs/library, docs)"},
              {"--check", "", "writes nothing; exit code 1 where a page is stale"}},
             "stepwise doc library --out /tmp/reference"},
            document};
}

} // namespace plc::cli
