#include "projects/exchange/imported.h"

#include "projects/exchange/addresses.h"
#include "projects/exchange/own_namespaces.h"
#include "projects/exchange/plcopen_import.h"
#include "projects/exchange/text_import.h"
#include "projects/exchange/tool_types.h"
#include "projects/exchange/twincat_import.h"
#include "projects/exchange/xml.h"
#include "projects/storage/project_file.h"
#include "runtime/base/messages.h"
#include "runtime/base/text.h"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <span>

namespace plc::exchange {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::string ending(const fs::path& path) {
    std::string text = path.extension().string();
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

constexpr const char* kSources[] = {".xml", ".tcpou", ".tcdut", ".tcgvl", ".tcio", ".tctto", ".exp", ".export", ".st"};
constexpr const char* kForeign[] = {".tcpou", ".tcdut", ".tcgvl", ".tcio", ".tctto", ".exp", ".export", ".plcproj"};

bool isOneOf(const std::string& word, std::span<const char* const> words) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

/// Reads files one after the other into one project.
class Reader {
public:
    Result<void> readFile(const fs::path& path, const std::string& place, const std::string& folder) {
        const auto bytes = projects::readFile(path.string());
        if (!bytes) return bytes.error();
        if (looksLikeXml(*bytes)) return readXml(*bytes, place, folder);
        const std::string end = ending(path);
        if (end != ".exp" && end != ".st" && end != ".txt") return Error{errors::ImportFileUnknown(), place};
        const DecodedText text = projects::decodeText(*bytes);
        noteEncoding(text.encoding, place);
        const std::string lines = withUnixLines(text.text);
        if (isCodesys2Text(lines))
            importCodesys2Text(lines, place, out);
        else
            importLooseText(lines, place, folder, path.stem().string(), out);
        ++out.report.filesRead;
        return {};
    }

    void readFolder(const fs::path& root) {
        std::error_code problem;
        std::vector<fs::path> files;
        for (auto it = fs::recursive_directory_iterator(root, fs::directory_options::skip_permission_denied, problem);
             it != fs::recursive_directory_iterator(); it.increment(problem)) {
            if (it->is_directory(problem) && isLeftOut(it->path()))
                it.disable_recursion_pending();
            else if (it->is_regular_file(problem))
                files.push_back(it->path());
        }
        std::sort(files.begin(), files.end());
        for (const fs::path& each : files)
            if (ending(each) == ".plcproj") readProject(each, root);
        for (const fs::path& each : files) {
            if (!isOneOf(ending(each), kSources)) continue;
            const std::string place = fs::relative(each, root, problem).generic_string();
            if (auto done = readFile(each, place, folderOf(each, root)); !done) {
                const bool isOther = done.error().message == errors::ImportXmlUnknown();
                out.report.add(place, isOther ? remarks::FileSkipped() : remarks::FileNotRead(done.error().message));
            }
        }
    }

    Imported out;
    TwinCatProject tasks;

private:
    /// Hidden folders, and what Beremiz generates beside its project.
    static bool isLeftOut(const fs::path& folder) {
        std::error_code problem;
        const std::string name = folder.filename().string();
        return name.starts_with(".") || (name == "build" && fs::exists(folder.parent_path() / "beremiz.xml", problem));
    }

    void noteEncoding(Encoding encoding, const std::string& place) {
        if (encoding != Encoding::Utf8 && encoding != Encoding::Utf8Bom)
            out.report.add(place, remarks::EncodingRead(std::string(projects::nameOf(encoding))));
    }

    void readProject(const fs::path& path, const fs::path& root) {
        const auto bytes = projects::readFile(path.string());
        if (!bytes) return;
        std::error_code problem;
        const Result<XmlFile> file = XmlFile::parse(*bytes, fs::relative(path, root, problem).generic_string());
        if (!file) return out.report.add(file.error().place, remarks::FileNotRead(file.error().message));
        if (!isTwinCatProject(*file)) return;
        std::set<std::string> included;
        readTwinCatProject(*file, out, included);
        m_projects.push_back({path.parent_path(), path.stem().string(), std::move(included)});
        ++out.report.filesRead;
    }

    /// Below the project it belongs to, by the project's name when there are several; else below the folder that was
    /// named.
    std::string folderOf(const fs::path& file, const fs::path& root) const {
        const TwinCatFolder* owner = nullptr;
        for (const TwinCatFolder& each : m_projects) {
            const std::string text = each.folder.string();
            const bool isNearer = !owner || owner->folder.string().size() < text.size();
            if (isNearer && file.string().starts_with(text + "/")) owner = &each;
        }
        std::error_code problem;
        std::string folder = fs::relative(file.parent_path(), owner ? owner->folder : root, problem).generic_string();
        if (folder == ".") folder.clear();
        if (!owner || m_projects.size() < 2) return folder;
        return owner->name + (folder.empty() ? "" : "/" + folder);
    }

    Result<void> readXml(const std::string& bytes, const std::string& place, const std::string& folder) {
        const Result<XmlFile> file = XmlFile::parse(bytes, place);
        if (!file) return file.error();
        if (isPlcopen(*file)) {
            importPlcopen(*file, out);
        } else if (isTwinCat(*file)) {
            importTwinCat(*file, folder, out, tasks);
        } else if (isCodesysExport(*file)) {
            importCodesysExport(*file, out);
        } else if (isTwinCatProject(*file)) {
            std::set<std::string> included;
            readTwinCatProject(*file, out, included);
        } else {
            return Error{errors::ImportXmlUnknown(), place};
        }
        noteEncoding(file->encoding(), place);
        ++out.report.filesRead;
        return {};
    }

    struct TwinCatFolder {
        fs::path folder;
        std::string name;
        std::set<std::string> included;
    };
    std::vector<TwinCatFolder> m_projects;
};

/// CODESYS, Beremiz and OpenPLC count %MW1 in words, and so do our own exports; the project does as its origin did.
void noteAddressing(Imported& out) {
    const std::string product = foldCase(toolOf(out));
    constexpr std::string_view kInWords[] = {"codesys", "beremiz", "openplc", "stepwise"};
    const bool isInWords = std::any_of(std::begin(kInWords), std::end(kInWords),
                                       [&](std::string_view each) { return product.find(each) != std::string::npos; });
    const auto file = std::find_if(out.files.begin(), out.files.end(),
                                   [](const ImportedFile& each) { return hasCountedAddress(each.text); });
    if (!isInWords || file == out.files.end()) return;
    out.addressing = image::Addressing::Words;
    out.report.add(file->path, remarks::WordAddresses(toolOf(out)));
}

/// A project says how much memory __NEW has; without a number there is none.
void setMemoryAside(Imported& out) {
    constexpr uint32_t kMemory = 65536;
    for (const ImportedFile& file : out.files)
        if (foldCase(file.text).find("__new") != std::string::npos) {
            out.memoryForNew = kMemory;
            return out.report.add(file.path, remarks::MemoryForNew());
        }
}

} // namespace

bool looksLikeXml(std::string_view bytes) {
    const DecodedText head = projects::decodeText(bytes.substr(0, 512));
    return trimmed(head.text).starts_with("<");
}

std::string hashOf(const std::string& text) {
    uint64_t hash = 14695981039346656037ull; // FNV-1a
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ull;
    char out[17];
    std::snprintf(out, sizeof out, "%016llx", static_cast<unsigned long long>(hash));
    return out;
}

std::string fileNameOf(const std::string& name) {
    std::string out;
    for (const char c : name) out += std::strchr("/\\:*?\"<>|", c) || static_cast<unsigned char>(c) < 0x20 ? '_' : c;
    while (!out.empty() && (out.back() == '.' || out.back() == ' ')) out.pop_back();
    if (out.empty() || out[0] == '.') out = "_" + out;
    return out;
}

void addFile(Imported& imported, const std::string& folder, const std::string& name, std::string text) {
    const std::string stem = "src/" + (folder.empty() ? "" : folder + "/") + fileNameOf(name);
    std::string path = stem + ".st";
    const auto isTaken = [&] {
        return std::any_of(imported.files.begin(), imported.files.end(),
                           [&](const ImportedFile& file) { return equalsIgnoringCase(file.path, path); });
    };
    for (int number = 2; isTaken(); ++number) path = stem + "_" + std::to_string(number) + ".st";
    if (path != stem + ".st") imported.report.add(stem + ".st", remarks::NameInUse(name, path));
    imported.files.push_back({std::move(path), std::move(text)});
}

namespace {

Result<Imported> finished(Reader& reader, const std::string& path) {
    addConfiguration(reader.tasks, reader.out);
    if (reader.out.files.empty()) return Error{errors::ImportNothing(), path};
    if (reader.out.name.empty()) {
        fs::path named = fs::path(path).lexically_normal();
        if (named.filename().empty()) named = named.parent_path();
        reader.out.name = named.stem().string();
    }
    dropOwnNamespaces(reader.out);
    addToolTypes(reader.out);
    noteAddressing(reader.out);
    setMemoryAside(reader.out);
    return std::move(reader.out);
}

} // namespace

bool isForeignFile(const std::string& path) {
    std::error_code problem;
    if (!fs::is_regular_file(path, problem)) return false;
    const std::string end = ending(path);
    if (isOneOf(end, kForeign)) return true;
    if (end != ".xml") return false;
    const auto bytes = projects::readFile(path);
    return bytes && looksLikeXml(*bytes);
}

Result<Imported> importFrom(const std::string& path) {
    std::error_code problem;
    if (!fs::exists(path, problem)) return Error{errors::NoSuchFileOrFolder(), path};
    if (!fs::is_directory(path, problem)) return importFiles({path});
    Reader reader;
    reader.readFolder(path);
    return finished(reader, path);
}

Result<Imported> importFiles(const std::vector<std::string>& paths) {
    Reader reader;
    for (const std::string& path : paths)
        if (auto done = reader.readFile(path, fs::path(path).filename().string(), ""); !done) return done.error();
    return finished(reader, paths.empty() ? std::string() : paths.front());
}

projects::Project toProject(const Imported& imported) {
    projects::Project project;
    project.name = imported.name;
    project.languages = {"en"};
    project.json = Json::object();
    project.addressing = imported.addressing;
    project.memoryForNew = imported.memoryForNew;
    project.libraries.assign(imported.libraries.begin(), imported.libraries.end());
    for (const ImportedFile& file : imported.files) project.sources.push_back({file.path, file.text});
    return project;
}

Result<void> writeImported(const Imported& imported, const std::string& folder) {
    std::error_code problem;
    const fs::path root(folder);
    if (fs::exists(root, problem) && (!fs::is_directory(root, problem) || !fs::is_empty(root, problem)))
        return Error{errors::ImportFolderNotEmpty(), folder};
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
    if (auto done = write("exchange.json", imported.side.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
        !done)
        return done;
    // the last one makes it a project, and waits for the disk
    return projects::writeFileAtomically((root / "project.json").string(),
                                         project.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

} // namespace plc::exchange
