#include "runtime/debug/sites.h"

namespace plc::debug {

SitesOfLine sitesOfLine(const image::CompiledProgram& program, FileId file, uint32_t line) {
    SitesOfLine found;
    if (!file.isValid() || file.index() >= program.sources.files.size()) return found;
    const SourceText& text = program.sources[file];
    if (line == 0 || line > text.lineCount()) return found;
    const uint32_t from = text.lineBegin(line);
    SourceRange best;
    for (uint32_t site = 1; site < program.sites.size(); ++site) {
        const SourceRange& range = program.sites[site].range;
        // A line without a statement (a comment, END_IF) stands for the next one below it.
        if (range.file != file || range.begin < from) continue;
        const bool isBetter =
            found.sites.empty() || range.begin < best.begin || (range.begin == best.begin && range.end < best.end);
        if (isBetter) {
            best = range;
            found.sites.clear();
        }
        // One statement has several sites where its code was made more than once: in a base and in what extends it.
        if (range == best) found.sites.push_back(site);
    }
    if (!found.sites.empty()) found.line = text.lineColumn(best.begin).line;
    return found;
}

FileId fileOfPath(const image::CompiledProgram& program, std::string_view path) {
    for (size_t i = 0; i < program.sources.files.size(); ++i)
        if (program.sources.files[i].path() == path) return FileId(i);
    return {};
}

} // namespace plc::debug
