#include "projects/language_server/desk.h"

#include "projects/storage/project_file.h"
#include "runtime/platform/processes.h"

#include <cstdlib>
#include <filesystem>

namespace plc::lsp {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kLibrary = "library/";

bool isTest(std::string_view shown) { return shown.starts_with("tests/"); }

/// Where texts of libraries lie, so that an editor can open them.
fs::path libraryFolder() {
    const char* cache = std::getenv("XDG_CACHE_HOME");
    const char* home = std::getenv("HOME");
    fs::path base = cache && *cache ? fs::path(cache) : home && *home ? fs::path(home) / ".cache" : fs::path();
    if (base.empty()) base = fs::temp_directory_path() / ("stepwise-" + platform::userNumber());
    return base / "stepwise";
}

/// The text of a library as a file; it is written when it is missing or another version's.
std::string libraryFile(const SourceText& text) {
    const fs::path file = libraryFolder() / text.path();
    std::error_code ignored;
    fs::create_directories(file.parent_path(), ignored);
    (void)projects::writeFileAtomically(file.string(), text.text()); // not writable: the editor says that it is missing
    return file.string();
}

} // namespace

std::string projectFolderOf(const std::string& file) {
    std::error_code ignored;
    for (fs::path folder = fs::path(file).parent_path();; folder = folder.parent_path()) {
        if (fs::is_regular_file(folder / "project.json", ignored)) return folder.string();
        if (folder == folder.parent_path()) return {};
    }
}

Desk::Desk(projects::Project project) : m_project(std::move(project)) { takeFiles(m_project); }

Result<std::unique_ptr<Desk>> Desk::ofFolder(const std::string& folder) {
    auto project = projects::openProject({folder});
    if (!project) return project.error();
    return std::unique_ptr<Desk>(new Desk(std::move(*project)));
}

std::unique_ptr<Desk> Desk::ofFile(const std::string& file, std::vector<std::string> libraries) {
    projects::Project project;
    project.name = fs::path(file).stem().string();
    project.libraries = std::move(libraries);
    std::unique_ptr<Desk> desk(new Desk(std::move(project)));
    desk->m_isLoose = true;
    desk->m_texts[file] = {};
    return desk;
}

void Desk::takeFiles(const projects::Project& project) {
    std::set<std::string> there;
    for (const auto* list : {&project.sources, &project.tests})
        for (const driver::SourceFile& file : *list) {
            there.insert(file.path);
            if (!m_held.contains(file.path)) m_texts[file.path] = file.text;
        }
    std::erase_if(m_texts,
                  [&](const auto& each) { return !there.contains(each.first) && !m_held.contains(each.first); });
}

std::string Desk::shownPath(const std::string& file) const {
    if (m_isLoose) return file;
    return fs::path(file).lexically_relative(m_project.folder).generic_string();
}

bool Desk::owns(const std::string& file) const {
    const std::string shown = shownPath(file);
    if (m_texts.contains(shown)) return true;
    if (m_isLoose || shown.starts_with("..") || fs::path(shown).extension() != ".st") return false;
    return shown.starts_with("src/") || isTest(shown);
}

void Desk::setText(const std::string& file, std::string text) {
    const std::string shown = shownPath(file);
    m_held.insert(shown);
    m_texts[shown] = std::move(text);
    ++m_revision; // also of the same text: its diagnostics are expected under the new version
}

void Desk::release(const std::string& file) {
    const std::string shown = shownPath(file);
    m_held.erase(shown);
    const auto read = projects::readSourceText(file);
    if (read)
        m_texts[shown] = read->text;
    else
        m_texts.erase(shown);
    ++m_revision;
}

Result<void> Desk::reread() {
    if (m_isLoose) return {};
    auto project = projects::openProject({m_project.folder});
    if (!project) return project.error();
    m_project = std::move(*project);
    takeFiles(m_project);
    ++m_revision;
    return {};
}

driver::BuildInput Desk::buildInput() const {
    driver::BuildInput input;
    input.libraries = m_project.libraries;
    input.defines = m_project.defines;
    input.companions = m_project.companions;
    input.addressing = m_project.addressing;
    input.memoryForNew = m_project.memoryForNew;
    input.strings = m_project.strings;
    for (const auto& [path, text] : m_texts)
        if (!isTest(path) || m_isLoose) input.files.push_back({path, text});
    if (m_isLoose) return input;
    for (const auto& [path, text] : m_texts)
        if (isTest(path)) { // the program never holds them, the editor knows them
            input.companions.push_back(text);
            input.files.push_back({path, text});
        }
    return input;
}

const analysis::CodeModel& Desk::model() {
    if (!isStale()) return *m_model;
    m_before = std::move(m_model);
    m_model = analysis::CodeModel::make(buildInput(), m_revision, m_kept);
    m_places.clear();
    return *m_model;
}

std::optional<FileId> Desk::fileOf(const std::string& file) { return model().fileOf(shownPath(file)); }

std::string Desk::pathOf(FileId file) {
    const SourceText& text = model().sources()[file];
    if (text.path().starts_with(kLibrary)) return libraryFile(text);
    return m_isLoose ? text.path() : m_project.folder + "/" + text.path();
}

const Places& Desk::places(FileId file) {
    std::unique_ptr<Places>& places = m_places[static_cast<uint32_t>(file.index())];
    if (!places) places = std::make_unique<Places>(std::string(model().sources()[file].text()));
    return *places;
}

Json Desk::location(SourceRange range) {
    return {{"uri", uriOfPath(pathOf(range.file))}, {"range", places(range.file).range(range.begin, range.end)}};
}

std::vector<FileId> Desk::ownFiles() {
    std::vector<FileId> out;
    const auto& files = model().sources().files;
    for (size_t i = 0; i < files.size(); ++i)
        if (!files[i].path().starts_with(kLibrary)) out.push_back(FileId(i));
    return out;
}

} // namespace plc::lsp
