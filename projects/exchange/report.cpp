#include "projects/exchange/report.h"

#include <algorithm>

namespace plc::exchange {

NoteSeverity severityOf(NoteKind kind) {
    switch (kind) {
#define PLC_EXCHANGE_NOTE(Name, Severity, Text)                                                                        \
    case NoteKind::Name:                                                                                               \
        return NoteSeverity::Severity;
#include "projects/exchange/notes.def"
    }
    return NoteSeverity::Info;
}

const char* templateOf(NoteKind kind) {
    switch (kind) {
#define PLC_EXCHANGE_NOTE(Name, Severity, Text)                                                                        \
    case NoteKind::Name:                                                                                               \
        return Text;
#include "projects/exchange/notes.def"
    }
    return "";
}

std::string_view nameOf(NoteKind kind) {
    switch (kind) {
#define PLC_EXCHANGE_NOTE(Name, Severity, Text)                                                                        \
    case NoteKind::Name:                                                                                               \
        return #Name;
#include "projects/exchange/notes.def"
    }
    return {};
}

std::string textOf(const Note& note) {
    std::string out;
    const std::string_view form = templateOf(note.kind);
    for (size_t at = 0; at < form.size(); ++at) {
        if (form[at] != '{' || at + 2 >= form.size() || form[at + 2] != '}') {
            out += form[at];
            continue;
        }
        const size_t index = static_cast<size_t>(form[at + 1] - '0');
        if (index < note.arguments.size()) out += note.arguments[index];
        at += 2;
    }
    return out;
}

void Report::add(NoteKind kind, std::string place, std::vector<std::string> arguments) {
    Note note{kind, std::move(arguments), std::move(place)};
    if (std::find(notes.begin(), notes.end(), note) == notes.end()) notes.push_back(std::move(note));
}

size_t Report::losses() const {
    return static_cast<size_t>(std::count_if(
        notes.begin(), notes.end(), [](const Note& note) { return severityOf(note.kind) == NoteSeverity::Loss; }));
}

std::string Report::toText() const {
    std::string out;
    for (const Note& note : notes)
        out += note.place + ": " + (severityOf(note.kind) == NoteSeverity::Loss ? "not kept: " : "note: ") +
               exchange::textOf(note) + "\n";
    const auto list = [&](const std::map<std::string, int>& figures) {
        std::string text;
        for (const auto& [name, count] : figures)
            text += (text.empty() ? "" : ", ") + name + " " + std::to_string(count);
        return text.empty() ? std::string("none") : text;
    };
    out += "files " + std::to_string(filesRead) + "; units: " + list(units) + "; bodies: " + list(bodies) +
           "; not kept: " + std::to_string(losses()) + "\n";
    return out;
}

} // namespace plc::exchange
