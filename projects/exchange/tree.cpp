#include "projects/exchange/tree.h"

#include "projects/exchange/base/xml.h"
#include "projects/exchange/plcopen/standard_xml.h"
#include "projects/exchange/twincat/twincat_import.h"
#include "projects/storage/project_file.h"
#include "runtime/base/text.h"
#include "runtime/compiler/lex/token.h"
#include "runtime/diagnostics/diagnostic.h"

#include <algorithm>
#include <span>

namespace plc::exchange {
namespace {

namespace fs = std::filesystem;
using lex::TokenKind;

constexpr const char* kSources[] = {".xml",   ".tcpou", ".tcdut", ".tcgvl",  ".tcio",
                                    ".tctto", ".cfc",   ".exp",   ".export", ".st"};
constexpr const char* kSolutions[] = {".sln", ".tsproj", ".tspproj", ".plcproj"};

bool isOneOf(const std::string& word, std::span<const char* const> words) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

/// Hidden folders, and what Beremiz and OpenPLC generate beside their project.
bool isGenerated(const fs::path& folder) {
    std::error_code problem;
    const std::string name = folder.filename().string();
    if (name.starts_with(".")) return true;
    return name == "build" && (fs::exists(folder.parent_path() / "beremiz.xml", problem) ||
                               fs::exists(folder.parent_path() / "plc.xml", problem));
}

std::vector<fs::path> filesIn(const fs::path& root, Progress* progress) {
    std::error_code problem;
    std::vector<fs::path> files;
    for (auto it = fs::recursive_directory_iterator(root, fs::directory_options::skip_permission_denied, problem);
         !problem && it != fs::recursive_directory_iterator() && goesOn(progress, 0); it.increment(problem)) {
        std::error_code ignored;
        if (it->is_directory(ignored) && isGenerated(it->path()))
            it.disable_recursion_pending();
        else if (it->is_regular_file(ignored))
            files.push_back(it->path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

// ------------------------------------------------------------------ projects of TwinCAT

/// MSBuild writes "a%28b%29.TcPOU", and folders with \.
std::string unescapedPath(const std::string& text) {
    std::string out;
    for (size_t at = 0; at < text.size(); ++at) {
        const bool isEscape = text[at] == '%' && at + 2 < text.size() &&
                              std::isxdigit(static_cast<unsigned char>(text[at + 1])) &&
                              std::isxdigit(static_cast<unsigned char>(text[at + 2]));
        out += isEscape ? static_cast<char>(std::stoi(text.substr(at + 1, 2), nullptr, 16)) : text[at];
        if (isEscape) at += 2;
    }
    std::replace(out.begin(), out.end(), '\\', '/');
    return out;
}

struct PlcProject {
    TreePart part;
    std::set<std::string> listed;      // folded paths
    bool hasPattern = false;           // Include="**\*.TcPOU"
    std::vector<std::string> excluded; // folded: files and folders that are no part of the build
};

std::string folded(const fs::path& path) { return foldCase(path.lexically_normal().generic_string()); }

void readItem(pugi::xml_node item, PlcProject& out) {
    const std::string include = unescapedPath(attribute(item, "Include"));
    if (equalsIgnoringCase(trimmed(textOf(childOf(item, "ExcludeFromBuild"))), "true"))
        out.excluded.push_back(folded(out.part.folder / include));
    if (is(item, "Compile")) {
        out.hasPattern |= include.find('*') != std::string::npos;
        out.listed.insert(folded(out.part.folder / include));
    } else if (is(item, "PlaceholderReference") || is(item, "LibraryReference")) {
        out.part.uses.insert(foldCase(trimmed(include.substr(0, include.find(',')))));
    }
}

std::optional<PlcProject> plcProjectIn(const fs::path& path) {
    PlcProject out;
    out.part.folder = path.parent_path();
    out.part.projectFile = path;
    out.part.name = path.stem().string();
    const auto bytes = projects::readFile(path.string());
    if (!bytes) return out; // it takes what is in its folder, and has a line when it is read
    const Result<XmlFile> file = XmlFile::parse(*bytes, path.string());
    if (!file) return out;
    if (!isTwinCatProject(*file)) return std::nullopt;
    out.part.name.clear();
    for (const pugi::xml_node group : file->root().children())
        for (const pugi::xml_node item : group.children()) {
            const std::string text = trimmed(textOf(item));
            if (is(item, "Name") && out.part.name.empty()) out.part.name = text;
            if ((is(item, "Name") || is(item, "Title")) && !text.empty()) out.part.names.insert(foldCase(text));
            readItem(item, out);
        }
    if (out.part.name.empty()) out.part.name = path.stem().string();
    return out;
}

// ------------------------------------------------------------------ files that hold a project

bool contains(const std::string& text, std::string_view word) { return text.find(word) != std::string::npos; }

/// Objects of an export of CODESYS 2.3 end their declaration with a mark each.
bool hasSeveralObjects(const std::string& text) {
    const std::string_view mark = "(* @END_DECLARATION";
    const size_t first = text.find(mark);
    return first != std::string::npos && text.find(mark, first + 1) != std::string::npos;
}

bool declaresConfiguration(const std::string& text) {
    for (size_t at = 0; at < text.size(); at = text.find('\n', at)) {
        at = text.find_first_not_of(" \t\r\n", at);
        if (at == std::string::npos) return false;
        if (equalsIgnoringCase(std::string_view(text).substr(at, 14), "configuration ")) return true;
    }
    return false;
}

bool holdsProject(const fs::path& path) {
    const std::string end = endingOf(path);
    if (end == ".export") return true;
    if (end != ".xml" && end != ".exp" && end != ".st") return false;
    const auto bytes = projects::readFile(path.string());
    if (!bytes) return false;
    if (end == ".xml")
        return contains(bytes->substr(0, 4096), "plcopen.org/xml/tc6") ||
               contains(bytes->substr(0, 4096), kStandardNamespace);
    return end == ".exp" ? hasSeveralObjects(*bytes) : declaresConfiguration(*bytes);
}

/// Beremiz and OpenPLC call each project's file plc.xml: its folder has the name.
std::string nameOfFile(const fs::path& path) {
    const std::string stem = path.stem().string();
    return foldCase(stem) == "plc" && path.has_parent_path() ? path.parent_path().filename().string() : stem;
}

int ownerOf(const fs::path& file, const std::vector<PlcProject>& projects) {
    int owner = -1;
    for (size_t i = 0; i < projects.size(); ++i) {
        const std::string folder = projects[i].part.folder.string();
        const bool isNearer =
            owner < 0 || projects[static_cast<size_t>(owner)].part.folder.string().size() < folder.size();
        if (isNearer && file.string().starts_with(folder + "/")) owner = static_cast<int>(i);
    }
    return owner;
}

bool isExcluded(const PlcProject& project, const std::string& file) {
    return std::any_of(project.excluded.begin(), project.excluded.end(), [&](const std::string& each) {
        return file == each || file.starts_with(each.ends_with('/') ? each : each + "/");
    });
}

void sortInto(Tree& tree, std::vector<PlcProject>& projects, const std::vector<fs::path>& files, Progress* progress) {
    for (const fs::path& file : files) {
        if (!isSourceName(file) || !goesOn(progress, 0)) continue;
        bool isListed = false;
        for (PlcProject& each : projects)
            if (each.listed.count(folded(file)) && !isExcluded(each, folded(file))) {
                each.part.files.push_back(file);
                isListed = true;
            }
        if (isListed) continue;
        const int owner = ownerOf(file, projects);
        if (owner >= 0) {
            PlcProject& project = projects[static_cast<size_t>(owner)];
            const bool takesAll = (project.listed.empty() || project.hasPattern) && !isExcluded(project, folded(file));
            (takesAll ? project.part.files : project.part.leftOut).push_back(file);
        } else if (holdsProject(file)) {
            TreePart part;
            part.name = nameOfFile(file);
            part.files = {file};
            tree.parts.push_back(std::move(part));
        } else {
            tree.rest.push_back(file);
        }
    }
}

/// The project that `name` refers to, or -1.
int partNamed(const Tree& tree, const std::string& name) {
    for (size_t i = 0; i < tree.parts.size(); ++i)
        if (tree.parts[i].names.count(name)) return static_cast<int>(i);
    return -1;
}

} // namespace

std::string endingOf(const fs::path& path) { return foldCase(path.extension().string()); }
bool isSourceName(const fs::path& path) { return isOneOf(endingOf(path), kSources); }
bool isSolutionName(const fs::path& path) { return isOneOf(endingOf(path), kSolutions); }

Tree surveyTree(const fs::path& root, Progress* progress) {
    Tree tree;
    tree.root = root;
    const std::vector<fs::path> files = filesIn(root, progress);
    std::vector<PlcProject> projects;
    for (const fs::path& each : files)
        if (endingOf(each) == ".plcproj")
            if (auto project = plcProjectIn(each)) projects.push_back(std::move(*project));
    sortInto(tree, projects, files, progress);
    std::vector<TreePart> parts;
    for (PlcProject& each : projects) parts.push_back(std::move(each.part));
    tree.parts.insert(tree.parts.begin(), std::make_move_iterator(parts.begin()), std::make_move_iterator(parts.end()));
    return tree;
}

TreeGroup withUsed(const Tree& tree, int part) {
    TreeGroup group = {part};
    for (size_t at = 0; at < group.size() && part >= 0; ++at)
        for (const std::string& name : tree.parts[static_cast<size_t>(group[at])].uses) {
            const int used = partNamed(tree, name);
            if (used >= 0 && std::find(group.begin(), group.end(), used) == group.end()) group.push_back(used);
        }
    return group;
}

std::vector<TreeGroup> groupsOf(const Tree& tree) {
    std::vector<TreeGroup> groups;
    std::set<int> covered;
    const auto add = [&](int part) {
        groups.push_back(withUsed(tree, part));
        covered.insert(groups.back().begin(), groups.back().end());
    };
    const int count = static_cast<int>(tree.parts.size());
    std::set<int> used;
    for (int part = 0; part < count; ++part) {
        const TreeGroup group = withUsed(tree, part);
        used.insert(group.begin() + 1, group.end());
    }
    for (int part = 0; part < count; ++part)
        if (!used.count(part)) add(part);
    for (int part = 0; part < count; ++part) // projects that use each other
        if (!covered.count(part)) add(part);
    if (!tree.rest.empty()) groups.push_back({-1});
    return groups;
}

std::string nameOf(const Tree& tree, const TreeGroup& group) {
    if (group.front() >= 0) return tree.parts[static_cast<size_t>(group.front())].name;
    const fs::path root = tree.root.lexically_normal();
    return (root.has_filename() ? root : root.parent_path()).filename().string();
}

std::set<std::string> declaredNames(std::string_view text) {
    std::set<std::string> out;
    diagnostics::Sink ignored;
    const lex::TokenList list = lex::tokenize(FileId(0), text, ignored);
    int depth = 0; // of structures and lists of values
    bool isInTypes = false;
    for (size_t i = 0; i + 2 < list.tokens.size(); ++i) {
        const lex::Token &token = list.tokens[i], &next = list.tokens[i + 1], &after = list.tokens[i + 2];
        const auto add = [&](const lex::Token& name) {
            out.insert(foldCase(text.substr(name.begin, name.end - name.begin)));
        };
        const bool isNamed = next.kind == TokenKind::Identifier;
        if (token.kind == TokenKind::TypeWord || token.kind == TokenKind::EndType) {
            isInTypes = token.kind == TokenKind::TypeWord;
            depth = 0;
        }
        if (token.kind == TokenKind::Struct || token.kind == TokenKind::LeftParen) ++depth;
        if (token.kind == TokenKind::EndStruct || token.kind == TokenKind::RightParen) --depth;
        if (isInTypes && depth == 0 && token.kind == TokenKind::Identifier && next.kind == TokenKind::Colon) add(token);
        const bool isInstance = after.kind == TokenKind::Colon || after.soft == lex::SoftWord::With;
        if (isNamed && (token.kind == TokenKind::Function || token.kind == TokenKind::FunctionBlock ||
                        (token.kind == TokenKind::Program && !isInstance)))
            add(next);
    }
    return out;
}

} // namespace plc::exchange
