#include "app/cli/command.h"

#include "app/cli/errors.h"
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

int document(const Arguments& arguments) {
    if (arguments.paths().size() != 1 || arguments.paths()[0] != "library")
        return wrongUse({errors::DocNeedsSubject(), ""});
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
             "library [OPTIONS]",
             "Writes the reference of all libraries as Markdown, from the comments of their ST texts.",
             {{"--out", "FOLDER", "where the pages go (docs/library)"},
              {"--check", "", "writes nothing; exit code 1 where a page is stale"}},
             "stepwise doc library --out /tmp/reference"},
            document};
}

} // namespace plc::cli
