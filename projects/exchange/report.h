// What an import or an export has to say: one note for each thing that could not be kept or is kept in another form,
// with its place, and the figures. Values, any thread.
#pragma once
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace plc::exchange {

enum class NoteKind : uint8_t {
#define PLC_EXCHANGE_NOTE(Name, Severity, Text) Name,
#include "projects/exchange/notes.def"
};
enum class NoteSeverity : uint8_t { Info, Loss };

struct Note {
    NoteKind kind = NoteKind::ElementNotRead;
    std::vector<std::string> arguments;
    std::string place; // "plc.xml:12", "plc.xml:12 (Main)"
    bool operator==(const Note&) const = default;
};

[[nodiscard]] NoteSeverity severityOf(NoteKind kind);
/// The sentence in English with {0}, to be translated where it is shown.
[[nodiscard]] const char* templateOf(NoteKind kind);
[[nodiscard]] std::string_view nameOf(NoteKind kind);
/// The sentence in English.
[[nodiscard]] std::string textOf(const Note& note);

struct Report {
    std::vector<Note> notes;
    int filesRead = 0;
    std::map<std::string, int> units;  // by kind: "PROGRAM", "FUNCTION", "TYPE", …
    std::map<std::string, int> bodies; // by language as found: "ST", "IL", "SFC", "LD", "FBD", "CFC"
    void add(NoteKind kind, std::string place, std::vector<std::string> arguments = {});
    [[nodiscard]] size_t losses() const;
    /// Lines "place: sentence", then the figures.
    [[nodiscard]] std::string toText() const;
};

} // namespace plc::exchange
