#include "projects/exchange/base/report.h"

#include <algorithm>

namespace plc::exchange {

NoteSeverity severityOf(NoteKind kind) {
    switch (kind) {
#define PLC_EXCHANGE_NOTE(Name, Severity, Text, ...)                                                                   \
    case NoteKind::Name:                                                                                               \
        return NoteSeverity::Severity;
#include "projects/exchange/base/notes.def"
    }
    return NoteSeverity::Info;
}

std::string_view nameOf(NoteKind kind) {
    switch (kind) {
#define PLC_EXCHANGE_NOTE(Name, Severity, Text, ...)                                                                   \
    case NoteKind::Name:                                                                                               \
        return #Name;
#include "projects/exchange/base/notes.def"
    }
    return {};
}

void Report::add(std::string place, Remark remark) {
    const bool isKnown = std::any_of(notes.begin(), notes.end(), [&](const Note& note) {
        return note.kind == remark.kind && note.place == place && note.message == remark.message;
    });
    if (!isKnown) notes.push_back({remark.kind, std::move(remark.message), std::move(place)});
}

size_t Report::losses() const {
    return static_cast<size_t>(std::count_if(
        notes.begin(), notes.end(), [](const Note& note) { return severityOf(note.kind) == NoteSeverity::Loss; }));
}

std::string Report::toText() const {
    std::string out;
    for (const Note& note : notes)
        out += note.place + ": " + (severityOf(note.kind) == NoteSeverity::Loss ? "not kept: " : "note: ") +
               note.message.english() + "\n";
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
