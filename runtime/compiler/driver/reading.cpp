#include "runtime/compiler/driver/reading.h"

#include "runtime/base/text.h"
#include "runtime/compiler/driver/definitions.h"
#include "runtime/compiler/driver/driver.h"
#include "runtime/compiler/driver/dynamic_memory.h"
#include "runtime/compiler/lower/lower.h"
#include "runtime/compiler/parse/parser.h"
#include "runtime/compiler/sema/kept_bodies.h"
#include "runtime/library/sources.h"

#include <algorithm>

namespace plc::driver {

namespace {

bool isWanted(std::string_view library, const std::vector<std::string>& wanted) {
    if (equalsIgnoringCase(library, "standard")) return true;
    return std::any_of(wanted.begin(), wanted.end(),
                       [&](const std::string& name) { return equalsIgnoringCase(name, library); });
}

} // namespace

std::vector<LibraryText> libraryTextsOf(const BuildInput& input) {
    std::vector<LibraryText> all;
    for (const auto& [name, text] : input.libraryTexts) all.push_back({name, text});
    if (!all.empty()) return all;
    for (const library::Source& source : library::sources())
        if (isWanted(source.library, input.libraries))
            all.push_back({std::string(source.library) + "/" + std::string(source.fileName), source.text});
    return all;
}

struct KeptFiles::Reading {
    std::string path;
    std::string_view text;
    std::string library;
    std::optional<SourceText> source;
    std::unique_ptr<syntax::SyntaxFile> fresh; // null: kept
    diagnostics::Sink sink;
};

KeptFiles::KeptFiles() : m_bodies(std::make_shared<sema::KeptBodies>()) {}

size_t KeptFiles::checkedLast() const { return m_bodies->checkedLast(); }

bool KeptFiles::isKept(size_t index, const Reading& wanted) const {
    if (index >= m_files.size()) return false;
    const File& file = m_files[index];
    // what its conditions ask for may be in another file
    return !file.tree->asksForNames && file.text.path() == wanted.path && file.library == wanted.library &&
           file.text.text() == wanted.text;
}

std::optional<ReadFiles> KeptFiles::read(const BuildInput& input, Progress* progress) {
    constexpr double kShare = 0.1; // of a build
    if (m_defines != input.defines || m_keepsEveryResult != input.keepsEveryResult) {
        m_files.clear();
        *m_bodies = {}; // the same text declares something else
    }
    m_defines = input.defines;
    m_keepsEveryResult = input.keepsEveryResult;
    const std::vector<LibraryText> libraries = libraryTextsOf(input);
    std::vector<Reading> all;
    all.reserve(input.files.size() + libraries.size());
    for (const SourceFile& file : input.files) all.push_back({file.path, file.text, {}, {}, {}, {}});
    for (const LibraryText& each : libraries)
        all.push_back({"library/" + each.name,
                       each.text,
                       library::namespaceOf(each.name.substr(0, each.name.find('/'))),
                       {},
                       {},
                       {}});
    const std::string memory = input.memoryForNew ? dynamicMemoryText(input.memoryForNew) : std::string();
    if (!memory.empty())
        all.push_back({"library/standard/dynamic_memory.st", memory, library::namespaceOf("standard"), {}, {}, {}});

    const parse::Definitions defines = definitionsOf(input.defines);
    bool asks = false;
    for (size_t i = 0; i < all.size(); ++i) {
        if (!goesOn(progress, kShare * static_cast<double>(i) / static_cast<double>(all.size()))) return {};
        Reading& each = all[i];
        if (isKept(i, each)) continue;
        each.source.emplace(each.path, std::string(each.text));
        each.fresh = parse::parseFile(FileId(i), each.source->text(), each.sink, &defines);
        asks = asks || each.fresh->asksForNames;
    }
    if (asks) { // read again, once the names of all files are known
        parse::Definitions names = defines;
        for (size_t i = 0; i < all.size(); ++i)
            addNames(all[i].fresh ? *all[i].fresh : *m_files[i].tree, all[i].text, names);
        for (size_t i = 0; i < all.size(); ++i) {
            Reading& each = all[i];
            if (!each.fresh || !each.fresh->asksForNames) continue;
            parse::Definitions known = names;
            addVariables(*each.fresh, each.source->text(), known);
            each.sink = {};
            each.fresh = parse::parseFile(FileId(i), each.source->text(), each.sink, &known);
        }
    }

    ReadFiles out;
    auto sources = std::make_shared<SourceSet>();
    std::vector<File> files;
    m_readLast = 0;
    for (size_t i = 0; i < all.size(); ++i) {
        Reading& each = all[i];
        if (each.fresh) {
            ++m_readLast;
            each.fresh->library = each.library;
            lower::lowerFile(*each.fresh, each.sink, m_keepsEveryResult ? lower::Keep::Every : lower::Keep::Needed);
            files.push_back(
                {std::move(*each.source), std::move(each.library), std::move(each.fresh), each.sink.take()});
        } else {
            files.push_back(std::move(m_files[i]));
        }
        const File& file = files.back();
        sources->files.push_back(file.text);
        out.trees.push_back(file.tree);
        out.diagnostics.insert(out.diagnostics.end(), file.diagnostics.begin(), file.diagnostics.end());
    }
    m_files = std::move(files);
    out.sources = std::move(sources);
    return out;
}

} // namespace plc::driver
