#include "runtime/compiler/driver/reading.h"

#include "runtime/base/text.h"
#include "runtime/compiler/driver/definitions.h"
#include "runtime/compiler/driver/driver.h"
#include "runtime/compiler/driver/dynamic_memory.h"
#include "runtime/compiler/lower/lower.h"
#include "runtime/compiler/parse/reparse.h"
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

/// The owner of a tree whose first declarations are nodes of earlier readings of its file: it keeps those and their
/// texts, which names are views of.
struct KeepsEarlier {
    struct Earlier {
        size_t first = 0; // of its declarations in the file
        std::shared_ptr<const syntax::SyntaxFile> tree;
        SourceText text;
    };
    std::vector<Earlier> earlier; // in the order of the file
    size_t first = 0;             // of the tree's own declarations
    void operator()(const syntax::SyntaxFile* tree) {
        delete tree;
        earlier.clear(); // the deleter itself lives as long as the last weak reference
    }
};

/// Each keeps its tokens as well, so that a file edited at many places is read in whole now and then.
constexpr size_t kMostEarlier = 4;

/// Whose nodes the first `shared` declarations of a tree are.
std::vector<KeepsEarlier::Earlier> ownersOf(const std::shared_ptr<const syntax::SyntaxFile>& tree,
                                            const SourceText& text, size_t shared) {
    std::vector<KeepsEarlier::Earlier> out;
    const auto* keeps = std::get_deleter<KeepsEarlier>(tree);
    if (keeps) out = keeps->earlier;
    out.push_back({keeps ? keeps->first : 0, tree, text});
    std::erase_if(out, [&](const KeepsEarlier::Earlier& each) { return each.first >= shared; });
    return out;
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
    size_t shared = 0; // so many declarations of `fresh` are nodes of `earlier`
    std::vector<KeepsEarlier::Earlier> earlier{};

    /// Reads it; of a file that is `before` but for an edit, what is in front of that edit is shared.
    void read(FileId id, const File* before, const parse::Definitions& defines) {
        source.emplace(path, std::string(text));
        if (before) {
            auto again = parse::reparseFile({*before->tree, before->text.text(), before->diagnostics}, source->text(),
                                            sink, &defines);
            if (again) earlier = ownersOf(before->tree, before->text, again->shared);
            if (again && earlier.size() <= kMostEarlier) {
                fresh = std::move(again->tree);
                shared = again->shared;
                return;
            }
        }
        earlier.clear();
        sink = {};
        fresh = parse::parseFile(id, source->text(), sink, &defines);
    }

    [[nodiscard]] std::shared_ptr<const syntax::SyntaxFile> takeTree() {
        if (shared == 0) return std::move(fresh);
        return {fresh.release(), KeepsEarlier{std::move(earlier), shared}};
    }
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
        const bool isSameFile =
            i < m_files.size() && m_files[i].text.path() == each.path && m_files[i].library == each.library;
        each.read(FileId(i), isSameFile ? &m_files[i] : nullptr, defines);
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
            each.shared = 0;
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
            lower::lowerFile(*each.fresh, each.sink, m_keepsEveryResult ? lower::Keep::Every : lower::Keep::Needed,
                             each.shared);
            files.push_back({std::move(*each.source), std::move(each.library), each.takeTree(), each.sink.take()});
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
