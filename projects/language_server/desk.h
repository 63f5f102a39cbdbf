// One project as an editor elsewhere works on it: its files on disk, overlaid by what the editor holds, and the
// analysis of all of it. A file that belongs to no project folder is a project of its own. Owned by the server; its
// thread.
#pragma once
#include "projects/analysis/code_model.h"
#include "projects/language_server/places.h"
#include "projects/model/project.h"

#include <map>
#include <memory>
#include <set>

namespace plc::lsp {

/// The nearest folder above a file that holds a project.json; empty: none does.
[[nodiscard]] std::string projectFolderOf(const std::string& file);

class Desk {
public:
    [[nodiscard]] static Result<std::unique_ptr<Desk>> ofFolder(const std::string& folder);
    /// `libraries`: what its text may use besides the standard.
    [[nodiscard]] static std::unique_ptr<Desk> ofFile(const std::string& file, std::vector<std::string> libraries);

    [[nodiscard]] const std::string& folder() const { return m_project.folder; }
    /// Whether a file on disk is, or would become, one of its sources.
    [[nodiscard]] bool owns(const std::string& file) const;
    /// The editor holds the file with this text from now on.
    void setText(const std::string& file, std::string text);
    /// The editor gave it back: what is on disk counts.
    void release(const std::string& file);
    /// Files and settings as they are on disk now, but those that the editor holds.
    Result<void> reread();

    /// Another one after every change.
    [[nodiscard]] uint64_t revision() const { return m_revision; }
    [[nodiscard]] bool isStale() const { return !m_model || m_model->revision() != m_revision; }
    /// Of the texts as they are now.
    [[nodiscard]] const analysis::CodeModel& model();
    /// Frees the analysis before the present one: once its diagnostics are sent, as it takes a while.
    void forgetBefore() { m_before.reset(); }
    [[nodiscard]] std::optional<FileId> fileOf(const std::string& file);
    /// Absolute; a text of a library is put into a folder of its own first.
    [[nodiscard]] std::string pathOf(FileId file);
    [[nodiscard]] const Places& places(FileId file);
    [[nodiscard]] Json location(SourceRange range);
    /// Of the project's own files, tests included.
    [[nodiscard]] std::vector<FileId> ownFiles();
    /// Name, or the file's.
    [[nodiscard]] const std::string& name() const { return m_project.name; }

private:
    explicit Desk(projects::Project project);
    void takeFiles(const projects::Project& project);
    [[nodiscard]] std::string shownPath(const std::string& file) const;
    [[nodiscard]] driver::BuildInput buildInput() const;

    projects::Project m_project;
    bool m_isLoose = false;
    std::map<std::string, std::string> m_texts; // by path as shown: "src/main.st"
    std::set<std::string> m_held;               // by the editor, likewise
    uint64_t m_revision = 1;
    driver::KeptFiles m_kept;
    std::shared_ptr<const analysis::CodeModel> m_model, m_before;
    std::map<uint32_t, std::unique_ptr<Places>> m_places; // of the model's files
};

} // namespace plc::lsp
