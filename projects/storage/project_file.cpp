#include "projects/storage/project_file.h"

#include "projects/storage/errors.h"
#include "projects/storage/leftovers.h"
#include "runtime/base/read_json.h"
#include "runtime/base/text.h"
#include "runtime/platform/files.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace plc::projects {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

Result<std::string> readFile(const std::string& path) {
    std::error_code ignored;
    if (fs::is_directory(path, ignored)) return Error{errors::FolderNotFile(), path};
    if (fs::is_character_file(path, ignored) || fs::is_block_file(path, ignored))
        return Error{errors::DeviceNotFile(), path};
    std::ifstream in(path, std::ios::binary);
    if (!in) return Error{errors::FileNotRead(errors::ofSystem(errno)), path};
    std::ostringstream text;
    text << in.rdbuf();
    if (in.bad()) return Error{errors::FileNotRead(errors::ofSystem(errno)), path};
    return text.str();
}

Result<void> writeNewFile(const std::string& path, std::string_view content) {
    const int file = platform::openToWrite(path, platform::Existing::Refused);
    const bool isOpen = file >= 0, isWritten = isOpen && platform::writeAll(file, content);
    const int code = errno;
    if (isOpen && !platform::closeFile(file) && isWritten)
        return Error{errors::FileNotWritten(errors::ofSystem(errno)), path};
    if (isWritten) return {};
    if (isOpen) platform::removeFile(path);
    return Error{errors::FileNotWritten(errors::ofSystem(code)), path};
}

Result<void> writeFileAtomically(const std::string& path, std::string_view content) {
    if (std::error_code ignored; fs::is_regular_file(path, ignored)) {
        if (const auto old = readFile(path); old && *old == content) return {};
    }
    std::error_code ignored;
    if (fs::exists(path, ignored) && !fs::is_regular_file(path, ignored)) return Error{errors::NotReplaceable(), path};
    // A link is followed, so that the file it names is exchanged and the link stays.
    const fs::path target = fs::is_symlink(path, ignored) ? fs::canonical(path, ignored) : fs::path(path);
    const std::string temporary = nameWhileSaving(target.string());
    const auto fail = [&](const auto& what) -> Error {
        const int code = errno;
        platform::removeFile(temporary);
        return {what(errors::ofSystem(code)), path};
    };
    const int file = platform::openToWrite(temporary, platform::Existing::Emptied);
    if (file < 0) return fail(errors::FileNotWritten);
    if (std::error_code none; fs::exists(target, none))
        fs::permissions(temporary, fs::status(target, none).permissions(), none);
    if (!platform::writeAll(file, content) || !platform::syncFile(file)) {
        const int code = errno;
        (void)platform::closeFile(file);
        errno = code;
        return fail(errors::FileNotWritten);
    }
    (void)platform::closeFile(file);
    if (!platform::replaceFile(temporary, target.string())) return fail(errors::FileNotReplaced);
    platform::syncFolder(target.parent_path().empty() ? "." : target.parent_path().string());
    return {};
}

namespace {

std::string stringField(const Json& json, const char* key, std::string fallback = {}) {
    return json.contains(key) && json[key].is_string() ? json[key].get<std::string>() : std::move(fallback);
}

std::vector<std::string> listField(const Json& json, const char* key) {
    std::vector<std::string> out;
    if (json.contains(key) && json[key].is_array())
        for (const Json& item : json[key])
            if (item.is_string()) out.push_back(item.get<std::string>());
    return out;
}

std::vector<std::string> filesIn(const fs::path& folder, std::string_view ending) {
    std::vector<std::string> out;
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(folder, ignored)) {
        const std::string name = entry.path().filename().string();
        if (entry.is_regular_file(ignored) && name.size() > ending.size() && name.ends_with(ending) && name[0] != '.')
            out.push_back(name);
    }
    std::sort(out.begin(), out.end());
    return out;
}

/// Of a folder and the folders in it, relative, sorted; those that begin with a point are left out.
std::vector<std::string> filesBelow(const fs::path& folder, std::string_view ending) {
    std::vector<std::string> out = filesIn(folder, ending);
    std::error_code ignored;
    auto it = fs::recursive_directory_iterator(folder, fs::directory_options::skip_permission_denied, ignored);
    for (; !ignored && it != fs::recursive_directory_iterator(); it.increment(ignored)) {
        if (!it->is_directory(ignored)) continue;
        const fs::path inner = it->path().lexically_relative(folder);
        if (it->path().filename().string().starts_with(".")) {
            it.disable_recursion_pending();
            continue;
        }
        for (const std::string& name : filesIn(it->path(), ending)) out.push_back((inner / name).generic_string());
    }
    std::sort(out.begin(), out.end());
    return out;
}

bool isXml(std::string_view text) {
    const size_t begin = text.find_first_not_of(" \t\r\n");
    return begin != std::string_view::npos && text[begin] == '<';
}

Result<driver::SourceFile> readSource(const std::string& path, const std::string& shown, Project& project) {
    auto text = readSourceText(path);
    if (!text) return text.error();
    if (isXml(text->text)) return Error{errors::SourceIsXml(), path};
    if (text->encoding != Encoding::Utf8 && text->encoding != Encoding::Utf8Bom)
        project.encodings.emplace_back(shown, std::string(nameOf(text->encoding)));
    return driver::SourceFile{shown, std::move(text->text)};
}

Result<void> readSources(const fs::path& folder, const char* part, Project& project,
                         std::vector<driver::SourceFile>& out) {
    for (const std::string& name : filesBelow(folder / part, ".st")) {
        auto file = readSource((folder / part / name).string(), (fs::path(part) / name).generic_string(), project);
        if (!file) return file.error();
        out.push_back(std::move(*file));
    }
    return {};
}

} // namespace

std::vector<std::string> readCompanions(const std::string& folder) {
    std::vector<std::string> out;
    const auto add = [&](const fs::path& path) {
        if (auto text = readFile(path.string())) out.push_back(std::move(*text));
    };
    const fs::path root(folder);
    for (const std::string& name : filesIn(root / "hmi", ".json")) add(root / "hmi" / name);
    for (const std::string& name : filesIn(root / "hmi", ".csv")) add(root / "hmi" / name);
    for (const std::string& name : filesIn(root / "traces", ".trace.json")) add(root / "traces" / name);
    if (std::error_code ignored; fs::exists(root / "project.json", ignored)) add(root / "project.json");
    if (std::error_code ignored; fs::exists(root / "devices.json", ignored)) add(root / "devices.json");
    return out;
}

namespace {

bool isListOfNames(const Json& json) {
    return json.is_array() && std::all_of(json.begin(), json.end(), [](const Json& each) { return each.is_string(); });
}

/// How sources are read, and what decides where things are in the image.
Result<void> readSourceSettings(Project& project, const std::string& file) {
    const std::string addressing = stringField(project.json, "addressing", "byte");
    if (addressing != "byte" && addressing != "word") return Error{errors::AddressingUnknown(addressing), file};
    if (project.json.contains("encoding"))
        if (const auto encoding = parseCodePage(stringField(project.json, "encoding")); !encoding)
            return Error{encoding.error().message, file};
    if (project.json.contains("stringEncoding")) {
        const std::string name = stringField(project.json, "stringEncoding");
        const auto code = types::stringCodeNamed(name);
        if (!code) return Error{errors::EncodingUnknown(name, {types::stringCodeNames()}), file};
        project.strings = *code;
    }
    project.addressing = addressing == "word" ? image::Addressing::Words : image::Addressing::Bytes;
    for (const char* field : {"libraries", "defines"})
        if (project.json.contains(field) && !isListOfNames(project.json[field]))
            return Error{errors::NotAListOfNames(Verbatim(field)), file};
    if (!project.json.contains("memoryForNew")) return {};
    const Json& memory = project.json["memoryForNew"];
    if (!memory.is_number_unsigned() || memory.get<uint64_t>() > driver::kMostMemoryForNew)
        return Error{errors::MemoryForNewOutside(driver::kMostMemoryForNew), file};
    project.memoryForNew = memory.get<uint32_t>();
    return {};
}

} // namespace

Result<Json> readProjectJson(const std::string& folder) {
    const std::string file = (fs::path(folder) / "project.json").string();
    if (std::error_code ignored; !fs::exists(file, ignored)) return Json::object();
    const auto text = readFile(file);
    if (!text) return text.error();
    JsonText<Json> json = readJson<Json>(*text);
    if (!json.isGood()) return Error{errors::ProjectNotJson(), file + ":" + std::to_string(json.line)};
    if (!json.value.is_object()) return Error{errors::ProjectNotObject(), file};
    return std::move(json.value);
}

void carryChanges(const Json& before, const Json& after, Json& target) {
    static const Json none = Json::object();
    for (const auto& [field, value] : before.items())
        if (!after.contains(field)) target.erase(field);
    for (const auto& [field, value] : after.items()) {
        const auto old = before.find(field);
        if (old != before.end() && *old == value) continue;
        if (value.is_object() && target.contains(field) && target[field].is_object())
            carryChanges(old != before.end() && old->is_object() ? *old : none, value, target[field]);
        else
            target[field] = value;
    }
}

Result<void> readSettings(Project& project, const std::string& file) {
    const Json& json = project.json;
    const Project usual; // what no field says
    project.name = stringField(json, "name", fs::path(project.folder).filename().string());
    project.memoryForNew = usual.memoryForNew;
    project.startPanel = usual.startPanel;
    project.languages = usual.languages;
    project.fallback = usual.fallback;
    project.font = usual.font;
    project.languageVariable = usual.languageVariable;
    project.calendarStart = usual.calendarStart;
    project.libraries = listField(json, "libraries");
    project.defines = listField(json, "defines");
    if (auto done = readSourceSettings(project, file); !done) return done.error();
    for (std::string& library : project.libraries) {
        library = foldCase(library);
        const auto known = driver::libraryNames();
        if (library != "standard" && std::find(known.begin(), known.end(), library) == known.end()) {
            return Error{errors::NoLibrary(library, {{known.begin(), known.end()}}), file};
        }
    }
    if (json.contains("hmi") && json["hmi"].is_object()) {
        const Json& hmi = json["hmi"];
        project.startPanel = stringField(hmi, "startPanel");
        project.languages = listField(hmi, "languages");
        project.fallback = listField(hmi, "fallback");
        project.font = stringField(hmi, "font", project.font);
        project.languageVariable = stringField(hmi, "languageVariable");
    }
    if (json.contains("settings") && json["settings"].is_object())
        project.calendarStart = stringField(json["settings"], "calendarStart");
    if (project.languages.empty()) project.languages = {"en"};
    return {};
}

namespace {

Result<Project> openFolder(const fs::path& folder) {
    removeLeftovers(folder.string());
    Project project;
    project.folder = fs::absolute(folder).lexically_normal().string();
    if (project.folder.size() > 1 && project.folder.ends_with('/')) project.folder.pop_back();
    const fs::path file = folder / "project.json";
    std::error_code ignored;
    if (!fs::exists(file, ignored) && !fs::is_directory(folder / "src", ignored) && filesIn(folder, ".st").empty())
        return Error{errors::NoProjectInFolder(), folder.string()};
    auto json = readProjectJson(folder.string());
    if (!json) return json.error();
    project.json = std::move(*json);
    if (auto done = readSettings(project, file.string()); !done) return done.error();
    if (auto done = readSources(folder, "src", project, project.sources); !done) return done.error();
    if (project.sources.empty())
        for (const std::string& name : filesIn(folder, ".st")) {
            auto source = readSource((folder / name).string(), name, project);
            if (!source) return source.error();
            project.sources.push_back(std::move(*source));
        }
    if (auto done = readSources(folder, "tests", project, project.tests); !done) return done.error();
    project.panels = filesIn(folder / "hmi", ".panel.json");
    project.traces = filesIn(folder / "traces", ".trace.json");
    project.companions = readCompanions(project.folder);
    return project;
}

} // namespace

Result<Project> openProject(const std::vector<std::string>& paths) {
    if (paths.empty()) return Error{errors::NameAProject(), ""};
    std::error_code ignored;
    fs::path first = paths.front();
    if (paths.size() == 1 && first.filename() == "project.json")
        first = first.parent_path().empty() ? "." : first.parent_path();
    if (paths.size() == 1 && fs::is_directory(first, ignored)) return openFolder(first);
    Project project;
    project.name = fs::path(paths.front()).stem().string();
    project.languages = {"en"};
    project.json = Json::object();
    std::vector<fs::path> known; // a file named twice, also through a link, is one file
    for (const std::string& path : paths) {
        if (!fs::exists(path, ignored)) return Error{errors::NoSuchFileOrFolder(), path};
        if (fs::is_directory(path, ignored)) return Error{errors::NotBothFolderAndFiles(), path};
        fs::path real = fs::canonical(path, ignored);
        if (!ignored && std::find(known.begin(), known.end(), real) != known.end()) continue;
        known.push_back(std::move(real));
        auto file = readSource(path, path, project);
        if (!file) return file.error();
        project.sources.push_back(std::move(*file));
    }
    return project;
}

namespace {

/// What "encoding" in the project.json above a file says; nothing without one.
std::optional<Encoding> codePageOfProject(const std::string& path) {
    std::error_code ignored;
    for (fs::path folder = fs::absolute(path, ignored).parent_path();; folder = folder.parent_path()) {
        const fs::path file = folder / "project.json";
        if (!fs::is_regular_file(file, ignored)) {
            if (folder == folder.parent_path()) return std::nullopt;
            continue;
        }
        const auto text = readFile(file.string());
        if (!text) return std::nullopt;
        const JsonText<Json> json = readJson<Json>(*text);
        if (!json.isGood() || !json.value.is_object()) return std::nullopt;
        const auto encoding = parseCodePage(stringField(json.value, "encoding"));
        return encoding ? std::optional(*encoding) : std::nullopt;
    }
}

} // namespace

Result<DecodedText> readSourceText(const std::string& path) {
    const auto bytes = readFile(path);
    if (!bytes) return bytes.error();
    DecodedText text = decodeText(*bytes);
    if (!text.isGuessed) return text;
    const auto chosen = codePageOfProject(path);
    return chosen ? decodeText(*bytes, chosen) : text;
}

Result<void> writeSourceText(const std::string& path, std::string_view utf8, std::optional<Encoding> wanted) {
    Encoding encoding = wanted.value_or(Encoding::Utf8);
    if (std::error_code ignored; !wanted && fs::is_regular_file(path, ignored))
        if (const auto old = readSourceText(path)) encoding = old->encoding;
    const auto bytes = encodeText(utf8, encoding);
    if (!bytes) return Error{bytes.error().message, path};
    return writeFileAtomically(path, *bytes);
}

Result<void> saveProjectFile(const Project& project) {
    return writeFileAtomically(project.folder + "/project.json", project.json.dump(2) + "\n");
}

} // namespace plc::projects
