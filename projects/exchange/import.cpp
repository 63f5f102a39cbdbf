#include "projects/exchange/import.h"

#include "projects/exchange/base/xml.h"
#include "projects/exchange/file_reader.h"
#include "projects/storage/project_file.h"
#include "runtime/base/messages.h"
#include "runtime/base/text.h"

#include <algorithm>
#include <filesystem>

namespace plc::exchange {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* kForeign[] = {".tcpou", ".tcdut", ".tcgvl", ".tcio", ".tctto", ".exp", ".export", ".plcproj"};

} // namespace

bool isForeignFile(const std::string& path) {
    std::error_code problem;
    if (!fs::is_regular_file(path, problem)) return false;
    const std::string end = endingOf(path);
    if (std::find(std::begin(kForeign), std::end(kForeign), end) != std::end(kForeign)) return true;
    if (end != ".xml") return false;
    const auto bytes = projects::readFile(path);
    return bytes && looksLikeXml(*bytes);
}

namespace {

Note noteOf(std::string place, Remark remark) { return {remark.kind, std::move(remark.message), std::move(place)}; }

Result<Imported> importGroup(const Tree& tree, const TreeGroup& group, const ImportOptions& options) {
    FileReader reader(options.codePage);
    if (auto done = reader.readGroup(tree, group, options.progress); !done) return done.error();
    const bool isRest = group.front() < 0;
    return reader.finish(isRest || tree.parts.size() < 2 ? tree.root.string() : nameOf(tree, group));
}

/// A unit that several projects have, where dividing the tree keeps them apart.
std::string sharedName(const std::map<std::string, std::set<int>>& names, const std::vector<TreeGroup>& groups) {
    for (const auto& [name, parts] : names) {
        const bool isInOne = std::any_of(groups.begin(), groups.end(), [&](const TreeGroup& group) {
            return std::all_of(parts.begin(), parts.end(),
                               [&](int part) { return std::find(group.begin(), group.end(), part) != group.end(); });
        });
        if (!isInOne) return name;
    }
    return {};
}

/// Each group a project; names that differ in nothing a folder's name shows get a number.
Result<std::vector<Imported>> importDivided(const Tree& tree, const std::vector<TreeGroup>& groups,
                                            const std::string& shared, const ImportOptions& options) {
    Progress* const progress = options.progress;
    std::vector<Imported> out;
    std::set<std::string> taken;
    for (size_t i = 0; i < groups.size(); ++i) {
        const auto shareAt = [&](size_t at) {
            return 0.5 + 0.5 * static_cast<double>(at) / static_cast<double>(groups.size());
        };
        if (progress) progress->enter(shareAt(i), shareAt(i + 1));
        auto imported = importGroup(tree, groups[i], options);
        if (isCancelled(progress)) return Error{errors::Cancelled(), ""};
        if (!imported) continue; // nothing in it that is a program
        const std::string name = nameOf(tree, groups[i]);
        imported->name = name;
        for (int number = 2; !taken.insert(foldCase(fileNameOf(imported->name))).second; ++number)
            imported->name = name + "_" + std::to_string(number);
        imported->report.notes.insert(imported->report.notes.begin(),
                                      noteOf(imported->name, remarks::TreeDivided(shared, imported->name)));
        out.push_back(std::move(*imported));
    }
    if (out.empty()) return Error{errors::ImportNothing(), tree.root.string()};
    return out;
}

Result<std::vector<Imported>> only(Result<Imported> imported) {
    if (!imported) return imported.error();
    std::vector<Imported> out;
    out.push_back(std::move(*imported));
    return out;
}

Result<std::vector<Imported>> importNamed(const Tree& tree, const ImportOptions& options) {
    std::string known;
    for (size_t i = 0; i < tree.parts.size(); ++i) {
        if (equalsIgnoringCase(tree.parts[i].name, options.only))
            return only(importGroup(tree, withUsed(tree, static_cast<int>(i)), options));
        known += (known.empty() ? "" : ", ") + tree.parts[i].name;
    }
    return Error{remarks::NoSuchProject(options.only, known.empty() ? "–" : known).message, tree.root.string()};
}

Result<std::vector<Imported>> importTree(const fs::path& root, const ImportOptions& options) {
    const Tree tree = surveyTree(root, options.progress);
    if (isCancelled(options.progress)) return Error{errors::Cancelled(), ""};
    if (!options.only.empty()) return importNamed(tree, options);
    TreeGroup all;
    for (size_t i = 0; i < tree.parts.size(); ++i) all.push_back(static_cast<int>(i));
    if (!tree.rest.empty() || all.empty()) all.push_back(-1);
    const std::vector<TreeGroup> groups = groupsOf(tree);
    if (groups.size() == 1) all = groups.front(); // a project with its libraries, in this order
    const bool mayDivide = groups.size() > 1 && options.division == TreeDivision::IfNeeded;
    if (options.progress) options.progress->enter(0, mayDivide ? 0.5 : 1);
    FileReader reader(options.codePage);
    if (auto done = reader.readGroup(tree, all, options.progress); !done) return done.error();
    const std::string shared = mayDivide ? sharedName(reader.unitNames, groups) : std::string();
    if (!shared.empty()) return importDivided(tree, groups, shared, options);
    return only(reader.finish(root.string()));
}

/// The project of that file, with what it uses of the projects below its folder.
Result<std::vector<Imported>> importPlcproj(const fs::path& path, const ImportOptions& options) {
    const auto bytes = projects::readFile(path.string());
    if (!bytes) return bytes.error();
    if (const auto file = XmlFile::parse(*bytes, path.filename().string()); !file) return file.error();
    const fs::path folder = path.parent_path();
    const Tree tree = surveyTree(folder.empty() ? fs::path(".") : folder, options.progress);
    for (size_t i = 0; i < tree.parts.size(); ++i)
        if (tree.parts[i].projectFile.filename() == path.filename())
            return only(importGroup(tree, withUsed(tree, static_cast<int>(i)), options));
    return Error{errors::ImportXmlUnknown(), path.filename().string()};
}

} // namespace

namespace {

Result<Imported> importLoose(const std::vector<std::string>& paths, const ImportOptions& options) {
    FileReader reader(options.codePage);
    for (const std::string& path : paths)
        if (auto done = reader.readFile(path, fs::path(path).filename().string(), ""); !done) return done.error();
    return reader.finish(paths.empty() ? std::string() : paths.front());
}

} // namespace

Result<std::vector<Imported>> importProjects(const std::string& path, const ImportOptions& options) {
    std::error_code problem;
    if (!fs::exists(path, problem)) return Error{errors::NoSuchFileOrFolder(), path};
    if (fs::is_directory(path, problem)) return importTree(path, options);
    if (!isSolutionName(path)) return only(importLoose({path}, options));
    if (endingOf(path) == ".plcproj") return importPlcproj(path, options);
    const fs::path folder = fs::path(path).parent_path();
    return importTree(folder.empty() ? fs::path(".") : folder, options);
}

Result<Imported> importFrom(const std::string& path) {
    ImportOptions options;
    options.division = TreeDivision::Together;
    auto imported = importProjects(path, options);
    if (!imported) return imported.error();
    return std::move(imported->front());
}

Result<Imported> importFiles(const std::vector<std::string>& paths) { return importLoose(paths, {}); }

projects::Project toProject(const Imported& imported) {
    projects::Project project;
    project.name = imported.name;
    project.languages = {"en"};
    project.json = Json::object();
    project.addressing = imported.addressing;
    project.memoryForNew = imported.memoryForNew;
    project.strings = imported.strings;
    project.libraries.assign(imported.libraries.begin(), imported.libraries.end());
    for (const ImportedFile& file : imported.files) project.sources.push_back({file.path, file.text});
    return project;
}

namespace {

Result<void> writeProject(const Imported& imported, const fs::path& root) {
    std::error_code problem;
    const auto write = [&](const std::string& path, const std::string& text) -> Result<void> {
        const fs::path file = root / path;
        fs::create_directories(file.parent_path(), problem);
        if (problem) return Error{errors::FolderNotMade(errors::ofSystem(problem)), file.parent_path().string()};
        return projects::writeNewFile(file.string(), text);
    };
    for (const ImportedFile& file : imported.files)
        if (auto done = write(file.path, file.text); !done) return done;
    Json project = Json::object();
    project["name"] = imported.name;
    project["libraries"] = Json::array();
    for (const std::string& library : imported.libraries) project["libraries"].push_back(library);
    if (imported.addressing == image::Addressing::Words) project["addressing"] = "word";
    if (imported.memoryForNew > 0) project["memoryForNew"] = imported.memoryForNew;
    if (imported.strings != types::StringCode::Latin1) project["stringEncoding"] = nameOf(imported.strings);
    if (auto done = write("exchange.json", imported.side.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
        !done)
        return done;
    // the last one makes it a project, and waits for the disk
    return projects::writeFileAtomically((root / "project.json").string(),
                                         project.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

/// A folder beside the one that is to be, so that half a project never has its name; gone unless it was kept.
class Staging {
public:
    explicit Staging(const fs::path& target) : m_target(target.lexically_normal()) {
        if (!m_target.has_filename()) m_target = m_target.parent_path();
        m_folder = m_target.parent_path() / ("." + m_target.filename().string() + ".importing");
        std::error_code ignored;
        fs::remove_all(m_folder, ignored); // of one that was killed
    }
    ~Staging() {
        std::error_code ignored;
        fs::remove_all(m_folder, ignored);
    }
    Staging(const Staging&) = delete;
    Staging& operator=(const Staging&) = delete;
    [[nodiscard]] const fs::path& folder() const { return m_folder; }
    [[nodiscard]] Result<void> keep() const {
        std::error_code problem;
        fs::rename(m_folder, m_target, problem); // an empty folder of that name gives way
        if (problem) return Error{errors::FolderNotMade(errors::ofSystem(problem)), m_target.string()};
        return {};
    }

private:
    fs::path m_target, m_folder;
};

} // namespace

std::string folderOf(const std::vector<Imported>& projects, size_t index, const std::string& folder) {
    return projects.size() == 1 ? folder : (fs::path(folder) / fileNameOf(projects[index].name)).string();
}

Result<void> writeProjects(const std::vector<Imported>& projects, const std::string& folder, Progress* progress) {
    std::error_code problem;
    const fs::path root(folder);
    if (fs::exists(root, problem) && (!fs::is_directory(root, problem) || !fs::is_empty(root, problem)))
        return Error{errors::ImportFolderNotEmpty(), folder};
    const Staging staging(root);
    for (size_t i = 0; i < projects.size(); ++i) {
        if (!goesOn(progress, static_cast<double>(i) / static_cast<double>(projects.size())))
            return Error{errors::Cancelled(), ""};
        if (auto done = writeProject(projects[i], folderOf(projects, i, staging.folder().string())); !done) return done;
    }
    if (isCancelled(progress)) return Error{errors::Cancelled(), ""};
    return staging.keep();
}

Result<void> writeImported(const Imported& imported, const std::string& folder) {
    return writeProjects({imported}, folder, nullptr);
}

} // namespace plc::exchange
