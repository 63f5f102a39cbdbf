#include "projects/exchange/file_reader.h"

#include "projects/exchange/base/addresses.h"
#include "projects/exchange/base/assemble.h"
#include "projects/exchange/base/beremiz_extension.h"
#include "projects/exchange/base/c_code.h"
#include "projects/exchange/base/own_namespaces.h"
#include "projects/exchange/base/string_encoding.h"
#include "projects/exchange/base/tool_types.h"
#include "projects/exchange/base/xml.h"
#include "projects/exchange/codesys/codesys2_import.h"
#include "projects/exchange/codesys/codesys3_export.h"
#include "projects/exchange/plcopen/plcopen_import.h"
#include "projects/exchange/plcopen/standard_xml.h"
#include "projects/exchange/twincat/twincat_import.h"
#include "projects/storage/project_file.h"
#include "runtime/base/messages.h"
#include "runtime/base/text.h"

#include <algorithm>

namespace plc::exchange {
namespace {

namespace fs = std::filesystem;

std::string placeIn(const fs::path& path, const fs::path& root) {
    std::error_code problem;
    return fs::relative(path, root, problem).generic_string();
}

/// What is no text and no XML, by its first bytes. A text without words has nothing to lose.
std::optional<Error> refused(std::string_view bytes, const std::string& end, const std::string& place) {
    if (bytes.empty() && end != ".exp" && end != ".st") return Error{remarks::FileEmpty().message, place};
    if (bytes.starts_with("PK\x03\x04") || bytes.starts_with("PK\x05\x06"))
        return Error{remarks::FileIsArchive().message, place};
    return std::nullopt;
}

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

/// Of Beremiz and OpenPLC: one file stays one file.
void importLooseText(const std::string& text, const std::string& place, const std::string& folder,
                     const std::string& name, Imported& imported) {
    std::string kept = text;
    if (commentOutC(kept)) imported.report.add(place, remarks::CodeSkipped());
    if (!kept.ends_with('\n')) kept += '\n';
    ++imported.report.units["file"];
    addFile(imported, folder, name, std::move(kept));
}

} // namespace

Result<void> FileReader::readFile(const fs::path& path, const std::string& place, const std::string& folder) {
    const auto bytes = projects::readFile(path.string());
    if (!bytes) return bytes.error();
    const std::string end = endingOf(path);
    if (auto error = refused(*bytes, end, place)) return *error;
    if (looksLikeXml(*bytes)) return readXml(*bytes, place, folder);
    if (end != ".exp" && end != ".st" && end != ".txt") return Error{errors::ImportFileUnknown(), place};
    const DecodedText text = projects::decodeText(*bytes, m_codePage);
    noteEncoding(text.encoding, text.isGuessed, place);
    const std::string lines = withUnixLines(text.text);
    if (end == ".exp" || isCodesys2Text(lines))
        importCodesys2Text(lines, place, m_out, m_tasks);
    else
        importLooseText(lines, place, folder, path.stem().string(), m_out);
    ++m_out.report.filesRead;
    return {};
}

void FileReader::noteEncoding(Encoding encoding, bool isGuessed, const std::string& place) {
    if (encoding == Encoding::Utf8 || encoding == Encoding::Utf8Bom) return;
    const std::string name(projects::nameOf(encoding));
    m_out.report.add(place, isGuessed ? remarks::EncodingGuessed(name) : remarks::EncodingRead(name));
}

Result<void> FileReader::readXml(const std::string& bytes, const std::string& place, const std::string& folder) {
    const Result<XmlFile> file = XmlFile::parse(bytes, place, m_codePage);
    if (!file) return file.error();
    if (isPlcopen(*file)) {
        importPlcopen(*file, m_out);
    } else if (isStandardXml(*file)) {
        importPlcopen(asPlcopen(*file, m_out.report), m_out);
    } else if (isTwinCat(*file)) {
        importTwinCat(*file, folder, m_out, m_tasks);
    } else if (isCodesysExport(*file)) {
        importCodesysExport(*file, m_out);
    } else if (isTwinCatProject(*file)) {
        readTwinCatProject(*file, m_out);
    } else if (isBeremizExtension(*file)) {
        readBeremizExtension(*file, m_out);
    } else {
        return Error{errors::ImportXmlUnknown(), place};
    }
    noteEncoding(file->encoding(), file->isEncodingGuessed(), place);
    ++m_out.report.filesRead;
    return {};
}

void FileReader::readProject(const fs::path& path, const fs::path& root) {
    const std::string place = placeIn(path, root);
    if (auto done = readFile(path, place, ""); !done)
        m_out.report.add(place, remarks::FileNotRead(done.error().message));
}

/// A file is in the folder it has in its project, below the name of the project when there are several.
void FileReader::readPart(const fs::path& file, const Tree& tree, const TreePart* part, bool hasOthers) {
    const bool isOfProject = part && !part->projectFile.empty();
    std::string folder = placeIn(file.parent_path(), isOfProject ? part->folder : tree.root);
    if (folder == "." || folder.starts_with("..")) folder.clear();
    if (isOfProject && hasOthers) folder = part->projectFile.stem().string() + (folder.empty() ? "" : "/" + folder);
    const std::string place = placeIn(file, tree.root);
    if (auto done = readFile(file, place, folder); !done) {
        const bool isOther = done.error().message == errors::ImportXmlUnknown();
        m_out.report.add(place, isOther ? remarks::FileSkipped() : remarks::FileNotRead(done.error().message));
    }
}

void FileReader::gatherNames(size_t firstFile, int part) {
    for (size_t i = firstFile; i < m_out.files.size(); ++i) {
        const ImportedFile& file = m_out.files[i];
        const bool isText = file.text.find("{gvl ") == std::string::npos && file.name != "configuration";
        if (!isText) unitNames[foldCase(file.name)].insert(part);
        if (isText)
            for (const std::string& name : declaredNames(file.text)) unitNames[name].insert(part);
    }
}

/// What runs in the project is up to the project: a library's tasks stay out, and its programs where names meet.
void FileReader::dropProgramsOf(const TreePart& library, size_t firstFile, size_t firstTask) {
    m_tasks.resize(firstTask);
    std::set<std::string> names;
    for (size_t i = 0; i < firstFile; ++i) names.insert(foldCase(m_out.files[i].name));
    for (size_t i = m_out.files.size(); i-- > firstFile;) {
        const ImportedFile& file = m_out.files[i];
        if (!names.count(foldCase(file.name)) || kindOfDeclaration(file.text) != PieceKind::Program) continue;
        m_out.report.add(file.path, remarks::LibraryProgramLeftOut(file.name, library.name));
        m_out.files.erase(m_out.files.begin() + static_cast<std::ptrdiff_t>(i));
    }
}

Result<void> FileReader::readGroup(const Tree& tree, const TreeGroup& group, Progress* progress) {
    size_t count = 0, done = 0;
    const auto partOf = [&](int index) { return index < 0 ? nullptr : &tree.parts[static_cast<size_t>(index)]; };
    for (const int index : group) count += index < 0 ? tree.rest.size() : partOf(index)->files.size();
    const bool hasOthers = std::count_if(group.begin(), group.end(),
                                         [&](int each) { return each >= 0 && !partOf(each)->projectFile.empty(); }) > 1;
    const bool areUsed = group == withUsed(tree, group.front());
    for (const int index : group)
        if (const TreePart* part = partOf(index); part && !part->projectFile.empty())
            readProject(part->projectFile, tree.root);
    for (const int index : group) {
        const TreePart* part = partOf(index);
        const size_t firstFile = m_out.files.size(), firstTask = m_tasks.size();
        for (const fs::path& file : part ? part->files : tree.rest) {
            if (!goesOn(progress, static_cast<double>(done++) / static_cast<double>(count)))
                return Error{errors::Cancelled(), ""};
            const size_t first = m_out.files.size();
            readPart(file, tree, part, hasOthers);
            if (group.size() > 1) gatherNames(first, index);
        }
        if (!part) continue;
        if (areUsed && index != group.front()) dropProgramsOf(*part, firstFile, firstTask);
        for (const fs::path& file : part->leftOut)
            m_out.report.add(placeIn(file, tree.root), remarks::FileNotListed(part->name));
    }
    return {};
}

Result<Imported> FileReader::finish(const std::string& path) {
    addConfiguration(m_tasks, m_out);
    if (m_out.files.empty()) return Error{errors::ImportNothing(), path};
    if (m_out.name.empty()) {
        fs::path named = fs::path(path).lexically_normal();
        if (named.filename().empty()) named = named.parent_path();
        m_out.name = named.stem().string();
    }
    dropOwnNamespaces(m_out);
    addToolTypes(m_out);
    chooseStringEncoding(m_out);
    noteAddressing(m_out);
    setMemoryAside(m_out);
    return std::move(m_out);
}

} // namespace plc::exchange
