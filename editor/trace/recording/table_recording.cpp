#include "editor/trace/recording/table_recording.h"

#include "projects/waveform/errors.h"
#include "runtime/base/text.h"
#include "runtime/compiler/lex/words.h"
#include "runtime/types/value.h"

#include <cctype>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>

namespace plc::trace {

namespace {

namespace errors = waveform::errors;

/// A part of a path as an identifier.
std::string identifierOf(const std::string& part) {
    std::string out;
    for (const char c : part) {
        const bool isPart = std::isalnum(static_cast<unsigned char>(c)) || c == '_';
        // no two underscores in a row, none at the end: 2.1.2 of the standard
        if (isPart && c != '_')
            out += c;
        else if (!out.empty() && out.back() != '_')
            out += '_';
    }
    while (!out.empty() && out.back() == '_') out.pop_back();
    if (out.empty()) out = "Column";
    if (std::isdigit(static_cast<unsigned char>(out[0]))) out = "n" + out;
    if (lex::isKeyword(lex::lookUpWord(out).kind)) out += "_1";
    return out;
}

std::vector<std::string> partsOf(const std::string& name) {
    std::vector<std::string> out(1);
    for (const char c : name)
        if (c == '.' || c == '/')
            out.emplace_back();
        else
            out.back() += c;
    std::erase(out, std::string());
    // where another tool's project hangs; the same for all of its variables
    while (out.size() > 2 && (equalsIgnoringCase(out[0], "Device") || equalsIgnoringCase(out[0], "Application")))
        out.erase(out.begin());
    if (out.empty()) out.emplace_back();
    for (std::string& part : out) part = identifierOf(part);
    return out;
}

std::string joined(const std::vector<std::string>& parts) {
    std::string out;
    for (const std::string& part : parts) out += (out.empty() ? "" : ".") + part;
    return out;
}

std::string lower(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

/// The variables below one name; by lower case, since paths ignore case.
struct Node {
    std::string name;
    const waveform::Column* column = nullptr;
    std::map<std::string, Node> parts;
};

class TableWriter {
public:
    std::string write(const Node& root) {
        std::string globals, programs;
        for (const auto& [key, node] : root.parts) {
            if (node.parts.empty()) {
                globals += variable(node);
                continue;
            }
            programs += "PROGRAM " + node.name + "\nVAR\n";
            for (const auto& [inner, part] : node.parts) programs += variable(part);
            programs += "END_VAR\nEND_PROGRAM\n";
        }
        if (!globals.empty()) globals = "VAR_GLOBAL\n" + globals + "END_VAR\n";
        if (programs.empty()) programs = "PROGRAM MeasuredValues\nEND_PROGRAM\n";
        return m_types + globals + programs;
    }

private:
    std::string variable(const Node& node) {
        if (node.parts.empty()) {
            std::string unit = node.column->unit;
            std::erase_if(unit, [](char c) { return c == '*' || c == '(' || c == ')' || c == '\n'; });
            return "    " + node.name + " : " + (node.column->isBool ? "BOOL" : "LREAL") + ";" +
                   (unit.empty() ? "" : " (* [" + unit + "] *)") + "\n";
        }
        std::string fields;
        for (const auto& [key, part] : node.parts) fields += variable(part);
        const std::string type = "Measured" + std::to_string(++m_count);
        m_types += "TYPE " + type + " : STRUCT\n" + fields + "END_STRUCT END_TYPE\n";
        return "    " + node.name + " : " + type + ";\n";
    }
    std::string m_types;
    int m_count = 0;
};

} // namespace

bool isTableFile(const std::string& path) {
    const std::string ending = lower(std::filesystem::path(path).extension().string());
    return ending == ".csv" || ending == ".tsv" || ending == ".txt" || ending == ".trace";
}

std::vector<std::string> pathsOf(const waveform::Table& table) {
    std::vector<std::string> out;
    std::set<std::string> taken; // whole paths, and what stands above others
    for (const waveform::Column& column : table.columns) {
        std::vector<std::string> parts = partsOf(column.name);
        const std::string last = parts.back();
        const auto isFree = [&] {
            if (taken.count(lower(joined(parts)) + ".") || taken.count(lower(joined(parts)))) return false;
            std::string above;
            for (size_t i = 0; i + 1 < parts.size(); ++i) {
                above += (i ? "." : "") + lower(parts[i]);
                if (taken.count(above)) return false; // a variable of its own already
            }
            return true;
        };
        for (int number = 2; !isFree() && number < 10'000; ++number) parts = {last + "_" + std::to_string(number)};
        std::string above;
        for (size_t i = 0; i + 1 < parts.size(); ++i) {
            above += (i ? "." : "") + lower(parts[i]);
            taken.insert(above + ".");
        }
        taken.insert(lower(joined(parts)));
        out.push_back(joined(parts));
    }
    return out;
}

std::string programFor(const waveform::Table& table, const std::vector<std::string>& paths) {
    Node root;
    for (size_t i = 0; i < paths.size(); ++i) {
        Node* at = &root;
        std::string part;
        for (size_t begin = 0; begin <= paths[i].size();) {
            const size_t end = std::min(paths[i].find('.', begin), paths[i].size());
            part = paths[i].substr(begin, end - begin);
            at = &at->parts[lower(part)];
            if (at->name.empty()) at->name = part;
            begin = end + 1;
        }
        at->column = &table.columns[i];
    }
    return TableWriter().write(root);
}

Result<TableRecording> recordTable(const waveform::Table& table, Progress* progress) {
    const std::vector<std::string> paths = pathsOf(table);
    driver::BuildInput input;
    input.files.push_back({"measured_values.st", programFor(table, paths)});
    TableRecording out{driver::build(input, progress), std::make_unique<history::History>(size_t(1) << 30)};
    if (!out.built.program) {
        const Message why = out.built.failure.isEmpty() ? errors::CsvNamesUnusable() : out.built.failure;
        return Error{errors::CsvNotRecorded(why), ""};
    }
    const image::CompiledProgram& program = *out.built.program;
    out.history->describeProgram(out.built.program, {{input.files[0].path, input.files[0].text}},
                                 driver::recordedSettings(input), driver::libraryTexts(input));
    out.history->beginProgram(out.built.program);
    std::vector<image::Place> places;
    for (const std::string& path : paths) {
        const auto place = program.layout.find(path);
        if (!place) return Error{errors::CsvNotRecorded(place.error().message), path};
        places.push_back(*place);
    }
    std::vector<std::byte> image = program.initialImage;
    // A date or a time since 1970 would leave a double no digits for microseconds: those start at 0.
    const double first = table.time.front();
    const double origin = first < 0 || first > 1e6 ? first : 0;
    int64_t last = -1;
    for (size_t row = 0; row < table.time.size(); ++row) {
        if (row % 4096 == 0 && !goesOn(progress, double(row) / double(table.time.size())))
            return Error{plc::errors::Cancelled(), ""};
        for (size_t c = 0; c < places.size(); ++c) {
            const double value = table.columns[c].value[row];
            types::Value held{places[c].type, value};
            if (table.columns[c].isBool) held.data = int64_t(value == 1);
            types::writeValue(*program.layout.types, places[c].type, held, std::span(image).subspan(places[c].offset),
                              places[c].bit);
        }
        last = std::max(last + 1, static_cast<int64_t>(std::llround((table.time[row] - origin) * 1e9)));
        out.history->append(image, row, history::Nanoseconds(last));
    }
    return out;
}

} // namespace plc::trace
