#include "projects/analysis/library_reference.h"

#include "runtime/base/messages.h"
#include "runtime/base/text.h"
#include "runtime/compiler/parse/parser.h"
#include "runtime/library/signatures.h"
#include "runtime/library/sources.h"
#include "runtime/types/type.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

namespace plc::analysis {
namespace {

using namespace syntax;

struct LibraryText {
    std::string_view library, title, purpose;
};
constexpr LibraryText libraryTexts[] = {
    {"analog", "Analog", "Analog signal processing and the example blocks of IEC 61131-3 Annex F."},
    {"plant", "Plant",
     "Processes to control, for the simulation programs of a project. All of them use the controller's clock, "
     "whatever the cycle time."},
    {"standard", "Standard", "The standard function blocks and functions of IEC 61131-3. Every project has them."},
    {"toolbox", "Toolbox",
     "Bit, control, monitoring, filter, conversion, mathematics, operation and valve blocks, with the names, pins and "
     "error numbers of the SoMachine Toolbox."},
    {"util", "Util",
     "Signal generators, characteristic curve, ramps, statistics, controllers and bit functions, with the names and "
     "pins of CODESYS Util. "
     "Its BCD functions (BCD_TO_INT, INT_TO_BCD and so on) are standard functions here."},
    {"workshop", "Workshop",
     "Small blocks like those in books on Structured Text: edges, timing, buffers, random numbers, waves."},
};

std::string escaped(std::string_view text) {
    std::string out;
    for (const char c : text) {
        if (c == '*' || c == '|') out += '\\';
        if (c == '<')
            out += "&lt;";
        else
            out += c;
    }
    return out;
}

/// White space runs become one blank.
std::string collapsed(std::string_view text) {
    std::string out;
    for (const char c : text) {
        const bool blank = c == ' ' || c == '\t' || c == '\n' || c == '\r';
        if (!blank)
            out += c;
        else if (!out.empty() && out.back() != ' ')
            out += ' ';
    }
    while (!out.empty() && out.back() == ' ') out.pop_back();
    return out;
}

/// A doc comment: purpose, then paragraphs that start with Errors, Example and Corrected.
struct DocComment {
    std::string purpose, errors, example, corrected;
};

DocComment readDocComment(std::string_view comment) {
    DocComment doc;
    std::string* part = &doc.purpose;
    std::istringstream lines{std::string(comment)};
    for (std::string line; std::getline(lines, line);) {
        std::string text = collapsed(line);
        while (text.starts_with('/') || text.starts_with(' ')) text.erase(0, 1);
        if (text.starts_with("Errors")) part = &doc.errors;
        if (text.starts_with("Example:")) part = &doc.example;
        if (text.starts_with("Corrected:")) part = &doc.corrected;
        if (!part->empty()) *part += ' ';
        *part += text;
    }
    return doc;
}

struct Pin {
    std::string name, type, initial, comment;
    std::vector<std::string> aliases;
};

std::vector<std::string> aliasesOf(const std::vector<Pragma>& pragmas) {
    std::vector<std::string> names;
    for (const Pragma& pragma : pragmas) {
        if (!pragma.isAttribute || !equalsIgnoringCase(pragma.key, "alias")) continue;
        std::istringstream list{std::string(pragma.value)};
        for (std::string name; std::getline(list, name, ',');)
            names.push_back(collapsed(
                name.substr(name.find_first_not_of(' ') == std::string::npos ? 0 : name.find_first_not_of(' '))));
    }
    return names;
}

std::string slice(std::string_view text, SourceRange range) {
    return collapsed(text.substr(range.begin, range.length()));
}

std::vector<Pin> pinsOf(const std::vector<VarDecl*>& declarations, std::string_view text) {
    std::vector<Pin> pins;
    for (const VarDecl* declaration : declarations) {
        for (const Name& name : declaration->names) {
            Pin pin;
            pin.name = name.text;
            if (declaration->type) pin.type = slice(text, declaration->type->range);
            if (declaration->edge == VarEdge::Rising) pin.type += " R_EDGE";
            if (declaration->edge == VarEdge::Falling) pin.type += " F_EDGE";
            if (declaration->initial) pin.initial = slice(text, declaration->initial->range);
            pin.comment = collapsed(declaration->comment);
            pin.aliases = aliasesOf(declaration->pragmas);
            pins.push_back(std::move(pin));
        }
    }
    return pins;
}

void writePins(std::ostream& out, std::string_view heading, const std::vector<Pin>& pins) {
    if (pins.empty()) return;
    out << "| " << heading << " | Type | Meaning |\n|---|---|---|\n";
    for (const Pin& pin : pins) {
        out << "| `" << pin.name << "`";
        for (const std::string& alias : pin.aliases) out << ", `" << alias << "`";
        out << " | " << escaped(pin.type);
        if (!pin.initial.empty()) out << " := " << escaped(pin.initial);
        out << " | " << escaped(pin.comment) << " |\n";
    }
    out << '\n';
}

bool isHidden(const std::vector<Pragma>& pragmas) {
    return std::ranges::any_of(
        pragmas, [](const Pragma& pragma) { return pragma.isAttribute && equalsIgnoringCase(pragma.key, "hide"); });
}

void writeDoc(std::ostream& out, const DocComment& doc) {
    if (!doc.errors.empty()) out << "**Errors**" << escaped(std::string_view(doc.errors).substr(6)) << "\n\n";
    if (!doc.example.empty())
        out << "**Example**\n\n```iecst\n" << collapsed(std::string_view(doc.example).substr(8)) << "\n```\n\n";
    if (!doc.corrected.empty()) out << "**Corrected**" << escaped(std::string_view(doc.corrected).substr(9)) << "\n\n";
}

void writePou(std::ostream& out, const Pou& pou, std::string_view text) {
    if (isHidden(pou.pragmas)) return;
    const DocComment doc = readDocComment(pou.comment);
    out << "### " << pou.name.text << "\n\n";
    out << (pou.kind == PouKind::Function ? "Function" : "Function block");
    if (pou.result) out << " : " << escaped(slice(text, pou.result->range));
    out << ". " << escaped(doc.purpose) << "\n\n";
    constexpr std::pair<SectionKind, std::string_view> sections[] = {
        {SectionKind::Input, "Input"}, {SectionKind::Output, "Output"}, {SectionKind::InOut, "In-out"}};
    for (const auto& [kind, heading] : sections) {
        std::vector<Pin> pins;
        for (const VarSection* section : pou.sections)
            if (section->kind == kind) std::ranges::move(pinsOf(section->declarations, text), std::back_inserter(pins));
        writePins(out, heading, pins);
    }
    writeDoc(out, doc);
}

void writeType(std::ostream& out, const TypeDecl& type, std::string_view text) {
    const DocComment doc = readDocComment(type.comment);
    out << "### " << type.name.text << "\n\n";
    const TypeSpec& spec = *type.spec;
    if (spec.kind == TypeSpecKind::Struct) {
        out << "Structure. " << escaped(doc.purpose) << "\n\n";
        writePins(out, "Member", pinsOf(spec.fields, text));
    } else if (spec.kind == TypeSpecKind::Enum) {
        out << "Enumeration. " << escaped(doc.purpose) << " Values:";
        for (size_t i = 0; i < spec.enumerators.size(); ++i)
            out << (i ? ", " : " ") << '`' << spec.enumerators[i].name.text << '`';
        out << ".\n\n";
    } else {
        out << "Type `" << slice(text, spec.range) << "`. " << escaped(doc.purpose) << "\n\n";
    }
}

/// "physical_conversion.st" -> "Physical conversion"
std::string familyOf(std::string_view fileName) {
    std::string name(fileName.substr(0, fileName.rfind('.')));
    std::ranges::replace(name, '_', ' ');
    if (!name.empty() && name[0] >= 'a' && name[0] <= 'z') name[0] = static_cast<char>(name[0] - 'a' + 'A');
    return name;
}

std::string familyPage(const library::Source& source) {
    diagnostics::Sink sink;
    const auto file = parse::parseFile(FileId{}, source.text, sink);
    std::ostringstream out;
    for (const Decl* declaration : file->declarations) {
        if (declaration->kind == DeclKind::Type && declaration->type) writeType(out, *declaration->type, source.text);
        if (declaration->kind == DeclKind::Pou && declaration->pou) writePou(out, *declaration->pou, source.text);
    }
    return out.str();
}

std::string_view genericName(const library::Parameter& parameter) {
    switch (parameter.generic) {
    case library::Generic::Fixed:
        return types::spelling(parameter.fixed);
    case library::Generic::Any:
        return "ANY";
    case library::Generic::AnyElementary:
        return "ANY_ELEMENTARY";
    case library::Generic::AnyMagnitude:
        return "ANY_MAGNITUDE";
    case library::Generic::AnyNum:
        return "ANY_NUM";
    case library::Generic::AnyInt:
        return "ANY_INT";
    case library::Generic::AnyReal:
        return "ANY_REAL";
    case library::Generic::AnyBit:
        return "ANY_BIT";
    case library::Generic::AnyText:
        return "ANY_CHARS";
    case library::Generic::AnyDate:
        return "ANY_DATE";
    case library::Generic::AnyDuration:
        return "ANY_DURATION";
    case library::Generic::AnyNumOrDuration:
        return "ANY_NUM, ANY_DURATION";
    }
    return {};
}

void writeFunctions(std::ostream& out) {
    out << "## Functions\n\n| Function | Parameters | Meaning |\n|---|---|---|\n";
    std::map<std::string_view, const library::Signature*> byName;
    for (const library::Signature& signature : library::signatures()) byName.emplace(signature.name, &signature);
    for (const auto& [name, signature] : byName) {
        out << "| `" << name << "` | ";
        for (size_t i = 0; i < signature->parameters.size(); ++i) {
            const library::Parameter& parameter = signature->parameters[i];
            out << (i ? ", " : "") << '`' << parameter.name << "` " << genericName(parameter)
                << (parameter.isOutput ? " (output)" : "");
        }
        out << (signature->isExtensible ? ", …" : "") << " | " << escaped(signature->summary) << " |\n";
    }
    out << "\nConversions go from every elementary type to every other: `INT_TO_REAL`, `TO_STRING`, `TRUNC_INT`, "
           "`BCD_TO_UINT`, `WORD_TO_BCD` and so on.\n\n";
}

std::string libraryPage(const LibraryText& about) {
    std::ostringstream out;
    out << "# " << about.title << "\n\n" << about.purpose << "\n\n";
    if (about.library == "standard") writeFunctions(out);
    for (const library::Source& source : library::sourcesOf(about.library)) {
        const std::string family = familyPage(source);
        if (!family.empty()) out << "## " << familyOf(source.fileName) << "\n\n" << family;
    }
    std::string text = std::move(out).str();
    while (text.ends_with("\n\n")) text.pop_back();
    return text;
}

std::string indexPage() {
    std::ostringstream out;
    out << "# Libraries\n\nA project names its libraries in `project.json`, for example `\"libraries\": [\"toolbox\", "
           "\"util\"]`; the standard is always there. "
           "Where two libraries have the same name, the namespace tells them apart: `Util.PID`, `Analog.PID`.\n\n"
           "`stepwise doc library` writes these pages from the comments in the libraries' own ST texts.\n\n| Library | "
           "Namespace | What is in it |\n|---|---|---|\n";
    for (const LibraryText& about : libraryTexts)
        out << "| [" << about.library << "](" << about.library << ".md) | `" << about.title << "` | " << about.purpose
            << " |\n";
    return out.str();
}

std::string readWhole(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

} // namespace

std::vector<ReferencePage> libraryReference() {
    std::vector<ReferencePage> pages{{"README.md", indexPage()}};
    for (const LibraryText& about : libraryTexts)
        pages.push_back({std::string(about.library) + ".md", libraryPage(about)});
    return pages;
}

Result<int> writeLibraryReference(const std::string& folder) {
    std::error_code failed;
    std::filesystem::create_directories(folder, failed);
    if (failed) return Error{errors::FolderNotCreated(errors::ofSystem(failed)), folder};
    int written = 0;
    for (const ReferencePage& page : libraryReference()) {
        const std::filesystem::path path = std::filesystem::path(folder) / page.fileName;
        if (std::filesystem::exists(path, failed) && readWhole(path) == page.markdown) continue;
        std::ofstream file(path, std::ios::binary | std::ios::trunc);
        file << page.markdown;
        file.close();
        if (!file) return Error{errors::PageNotWritten(), path.string()};
        ++written;
    }
    return written;
}

} // namespace plc::analysis
