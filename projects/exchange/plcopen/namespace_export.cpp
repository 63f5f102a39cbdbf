#include "projects/exchange/plcopen/namespace_export.h"

#include "runtime/base/text.h"
#include "runtime/compiler/parse/parser.h"
#include "runtime/library/signatures.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace plc::exchange {

namespace {

using lex::Token;
using lex::TokenKind;
using syntax::Decl;
using syntax::DeclKind;

std::string foldedPath(const syntax::Path& path, const std::string& outer = {}) {
    std::string out = outer;
    for (const syntax::Name& part : path) out += (out.empty() ? "" : ".") + foldCase(part.text);
    return out;
}
std::string firstPart(const std::string& path) { return path.substr(0, path.find('.')); }

std::vector<std::string_view> namesOf(const Decl& decl) {
    std::vector<std::string_view> out;
    if (decl.kind == DeclKind::Pou) out.push_back(decl.pou->name.text);
    if (decl.kind == DeclKind::Type) out.push_back(decl.type->name.text);
    if (decl.kind == DeclKind::Globals)
        for (const syntax::VarDecl* variable : decl.globals->section->declarations)
            for (const syntax::Name& name : variable->names) out.push_back(name.text);
    return out;
}

/// A part of a text that goes; a whole line when nothing else is on it.
struct Cut {
    size_t begin = 0, end = 0;
    bool takesLine = false;
};

class Flattening {
public:
    Flattening(const std::vector<driver::SourceFile>& sources, Report& report) : m_sources(sources), m_report(report) {}

    std::vector<driver::SourceFile> run() {
        for (size_t i = 0; i < m_sources.size(); ++i) {
            diagnostics::Sink sink;
            m_trees.push_back(parse::parseFile(FileId(i), m_sources[i].text, sink));
            const auto& all = sink.all();
            if (std::any_of(all.begin(), all.end(),
                            [](const auto& each) { return each.severity == diagnostics::Severity::Error; }))
                return m_sources; // the export says where
        }
        for (size_t i = 0; i < m_trees.size(); ++i)
            for (const Decl* decl : m_trees[i]->declarations) gather(*decl, "", i);
        if (m_paths.empty()) return m_sources;
        findConflicts();
        std::vector<driver::SourceFile> out = m_sources;
        for (size_t i = 0; i < out.size(); ++i) flatten(i, out[i].text);
        for (const auto& [folded, space] : m_paths)
            if (!m_kept.count(firstPart(folded)) && !space.shown.empty())
                m_report.add(m_sources[space.file].path, remarks::NamespaceDropped(space.shown));
        return out;
    }

private:
    struct Space {
        std::string shown; // "" of a path that is only a part of another one's
        size_t file = 0;
    };
    struct Region { // of a NAMESPACE in a file
        SourceRange range;
        std::string path;
    };

    void gather(const Decl& decl, const std::string& outer, size_t file) {
        for (const std::string_view name : namesOf(decl))
            m_owners[foldCase(name)].push_back({outer, std::string(name)});
        if (decl.kind != DeclKind::Namespace) return;
        const std::string path = foldedPath(decl.space->path, outer);
        std::string shown = outer.empty() ? "" : m_paths[outer].shown;
        for (const syntax::Name& part : decl.space->path) {
            shown += (shown.empty() ? "" : ".") + std::string(part.text);
            m_paths.try_emplace(foldCase(shown), Space{});
        }
        if (m_paths[path].shown.empty()) m_paths[path] = {shown, file};
        m_regions[file].push_back({decl.range, path});
        for (const Decl* inner : decl.space->declarations) gather(*inner, path, file);
    }

    void keep(const std::string& path, const std::string& name) {
        if (path.empty() || !m_kept.insert(firstPart(path)).second) return;
        for (const auto& [folded, space] : m_paths)
            if (firstPart(folded) == firstPart(path) && !space.shown.empty())
                return m_report.add(m_sources[space.file].path,
                                    remarks::NamespaceNotExported(space.shown.substr(0, firstPart(path).size()), name));
    }
    void findConflicts() {
        for (const auto& [folded, owners] : m_owners) {
            const bool isStandard = library::findSignature(owners.front().second) != nullptr;
            if (owners.size() < 2 && !isStandard) continue;
            for (const auto& [path, name] : owners) keep(path, name);
        }
        // A variable, member or unit that has the name of a namespace hides it somewhere.
        for (size_t i = 0; i < m_trees.size(); ++i) {
            const auto& tokens = m_trees[i]->tokens.tokens;
            for (size_t t = 0; t + 1 < tokens.size(); ++t)
                if (tokens[t].kind == TokenKind::Identifier &&
                    (tokens[t + 1].kind == TokenKind::Colon || tokens[t + 1].kind == TokenKind::Comma) &&
                    m_paths.count(foldCase(textAt(i, t))))
                    keep(foldCase(textAt(i, t)), std::string(textAt(i, t)));
        }
        for (const auto& [folded, owners] : m_owners)
            if (m_paths.count(folded)) keep(folded, owners.front().second);
    }

    [[nodiscard]] std::string_view textAt(size_t file, size_t token) const {
        const Token& each = m_trees[file]->tokens.tokens[token];
        return std::string_view(m_sources[file].text).substr(each.begin, each.end - each.begin);
    }

    /// The namespace that a byte is in; "" of none.
    [[nodiscard]] std::string pathAt(size_t file, size_t at) const {
        std::string out;
        const auto it = m_regions.find(file);
        if (it == m_regions.end()) return out;
        for (const Region& region : it->second) // inner ones come later
            if (region.range.begin <= at && at < region.range.end) out = region.path;
        return out;
    }
    /// A path as it is written at a place, from the outermost name on; none when it is no namespace.
    [[nodiscard]] std::optional<std::string> resolved(std::string written, std::string from) const {
        for (;;) {
            const std::string whole = from.empty() ? written : from + "." + written;
            if (m_paths.count(whole)) return whole;
            if (from.empty()) return std::nullopt;
            const size_t dot = from.rfind('.');
            from = dot == std::string::npos ? "" : from.substr(0, dot);
        }
    }

    void flatten(size_t file, std::string& text) const {
        std::vector<Cut> cuts;
        cutHeaders(file, cuts);
        cutNames(file, cuts);
        std::sort(cuts.begin(), cuts.end(), [](const Cut& a, const Cut& b) { return a.begin > b.begin; });
        for (Cut cut : cuts) {
            if (cut.takesLine) {
                const size_t lineBegin = text.find_last_of('\n', cut.begin - (cut.begin > 0)) + 1;
                const size_t begin = cut.begin == 0 ? 0 : lineBegin;
                const size_t end = text.find_first_not_of(" \t\r", cut.end);
                const bool isAlone = text.find_first_not_of(" \t", begin) >= cut.begin &&
                                     (end == std::string::npos || text[end] == '\n');
                if (isAlone) {
                    cut.begin = begin;
                    cut.end = end == std::string::npos ? text.size() : end + 1;
                }
            }
            text.erase(cut.begin, cut.end - cut.begin);
        }
    }
    void cutHeaders(size_t file, std::vector<Cut>& cuts) const {
        const auto regions = m_regions.find(file);
        if (regions == m_regions.end()) return;
        const auto& tokens = m_trees[file]->tokens.tokens;
        for (const Region& region : regions->second) {
            if (m_kept.count(firstPart(region.path))) continue;
            size_t t = 0;
            while (tokens[t].begin < region.range.begin) ++t;
            const size_t first = t;
            // the word, INTERNAL, and the path
            for (++t; tokens[t].kind == TokenKind::Identifier || tokens[t].kind == TokenKind::Dot; ++t)
                if (tokens[t].kind == TokenKind::Identifier && tokens[t + 1].kind != TokenKind::Dot &&
                    !equalsIgnoringCase(textAt(file, t), "INTERNAL")) {
                    ++t;
                    break;
                }
            cuts.push_back({tokens[first].begin, tokens[t - 1].end, true});
            while (t < tokens.size() && tokens[t].end < region.range.end) ++t;
            while (t > first && tokens[t].kind != TokenKind::EndNamespace) --t;
            if (t > first) cuts.push_back({tokens[t].begin, region.range.end, true});
        }
    }
    /// Plant.Units.Counter, and USING Plant.Units;
    void cutNames(size_t file, std::vector<Cut>& cuts) const {
        const auto& tokens = m_trees[file]->tokens.tokens;
        const auto isHeader = [&](size_t t) {
            return std::any_of(cuts.begin(), cuts.end(), [&](const Cut& cut) {
                return cut.begin <= tokens[t].begin && tokens[t].end <= cut.end;
            });
        };
        for (size_t t = 0; t + 2 < tokens.size(); ++t) {
            if (tokens[t].kind != TokenKind::Identifier || (t > 0 && tokens[t - 1].kind == TokenKind::Dot)) continue;
            if (isHeader(t)) continue;
            const std::string here = pathAt(file, tokens[t].begin);
            if (equalsIgnoringCase(textAt(file, t), "USING") && tokens[t + 1].kind == TokenKind::Identifier) {
                t = cutUsing(file, t, here, cuts);
                continue;
            }
            std::string written;
            size_t last = t, keptFrom = t;
            for (;; last += 2) {
                written += (written.empty() ? "" : ".") + foldCase(textAt(file, last));
                if (last + 2 >= tokens.size() || tokens[last + 1].kind != TokenKind::Dot ||
                    tokens[last + 2].kind != TokenKind::Identifier)
                    break;
                if (const auto path = resolved(written, here); path && !m_kept.count(firstPart(*path)))
                    keptFrom = last + 2;
            }
            if (keptFrom != t) cuts.push_back({tokens[t].begin, tokens[keptFrom].begin, false});
            t = last;
        }
    }
    size_t cutUsing(size_t file, size_t t, const std::string& here, std::vector<Cut>& cuts) const {
        const auto& tokens = m_trees[file]->tokens.tokens;
        const size_t first = t;
        bool isDropped = true;
        std::string written;
        for (++t; t < tokens.size() && tokens[t].kind != TokenKind::Semicolon; ++t) {
            if (tokens[t].kind != TokenKind::Comma) written += foldCase(textAt(file, t));
            if (tokens[t].kind != TokenKind::Comma && t + 1 < tokens.size() &&
                (tokens[t + 1].kind == TokenKind::Identifier || tokens[t + 1].kind == TokenKind::Dot))
                continue;
            const auto path = resolved(written, here);
            isDropped = isDropped && (written.empty() || (path && !m_kept.count(firstPart(*path))));
            written.clear();
        }
        if (isDropped && t < tokens.size()) cuts.push_back({tokens[first].begin, tokens[t].end, true});
        return t;
    }

    const std::vector<driver::SourceFile>& m_sources;
    Report& m_report;
    std::vector<std::unique_ptr<syntax::SyntaxFile>> m_trees;
    std::map<std::string, Space> m_paths; // folded, with those that are only parts of others
    std::map<std::string, std::vector<std::pair<std::string, std::string>>> m_owners; // name → namespace, as written
    std::map<size_t, std::vector<Region>> m_regions;
    std::set<std::string> m_kept; // first parts of namespaces that are left out
};

} // namespace

std::vector<driver::SourceFile> withoutNamespaces(const std::vector<driver::SourceFile>& sources, Report& report) {
    const auto isNaming = [](const driver::SourceFile& each) {
        return foldCase(each.text).find("namespace") != std::string::npos;
    };
    if (std::none_of(sources.begin(), sources.end(), isNaming)) return sources;
    return Flattening(sources, report).run();
}

} // namespace plc::exchange
