// Reads files of other tools one after the other into one project. One use per project, any thread.
#pragma once
#include "projects/exchange/base/tasks.h"
#include "projects/exchange/base/xml.h"
#include "projects/exchange/tree.h"

namespace plc::exchange {

class FileReader {
public:
    /// `codePage`: of files that are neither in Unicode nor say what they are in; without one it is guessed.
    explicit FileReader(std::optional<Encoding> codePage = {}) : m_codePage(codePage) {}

    /// `folder` is where a file without one of its own goes in the project.
    Result<void> readFile(const std::filesystem::path& path, const std::string& place, const std::string& folder);
    /// The files of a group; one that cannot be read is a line of the report. An error: it was cancelled.
    Result<void> readGroup(const Tree& tree, const TreeGroup& group, Progress* progress);
    /// What all files together are; `path` gives the name when none of them has one.
    Result<Imported> finish(const std::string& path);

    /// Folded names of units → the parts of the tree they are in; for readGroup.
    std::map<std::string, std::set<int>> unitNames;

private:
    void noteEncoding(Encoding encoding, bool isGuessed, const std::string& place);
    Result<void> readXml(const std::string& bytes, const std::string& place, const std::string& folder);
    void readProject(const std::filesystem::path& path, const std::filesystem::path& root);
    void readPart(const std::filesystem::path& file, const Tree& tree, const TreePart* part, bool hasOthers);
    void dropProgramsOf(const TreePart& library, size_t firstFile, size_t firstTask);
    void gatherNames(size_t firstFile, int part);

    Imported m_out;
    ForeignTasks m_tasks;
    std::optional<Encoding> m_codePage;
};

} // namespace plc::exchange
