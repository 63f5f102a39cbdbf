// What an import or an export has to say: one note for each thing that could not be kept or is kept in another form,
// with its place, and the figures. Values, any thread.
#pragma once
#include "runtime/base/message.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace plc::exchange {

enum class NoteKind : uint8_t {
#define PLC_EXCHANGE_NOTE(Name, Severity, Text, ...) Name,
#include "projects/exchange/base/notes.def"
};
enum class NoteSeverity : uint8_t { Info, Loss };

/// What is said, without its place.
struct Remark {
    NoteKind kind{};
    Message message;
};
struct Note {
    NoteKind kind{};
    Message message;
    std::string place; // "plc.xml:12", "plc.xml:12 (Main)"
};

[[nodiscard]] NoteSeverity severityOf(NoteKind kind);
[[nodiscard]] std::string_view nameOf(NoteKind kind);

/// A row of notes.def with the types of its parameters.
template <NoteKind kind, class... Parameters> struct RemarkForm : messages::TypedForm<Parameters...> {
    using messages::TypedForm<Parameters...>::TypedForm;
    [[nodiscard]] Remark operator()(Parameters... arguments) const {
        return {kind, messages::TypedForm<Parameters...>::operator()(std::move(arguments)...)};
    }
};
namespace remarks {
using messages::Name, messages::Nested, messages::Path;
#define PLC_EXCHANGE_NOTE(Row, Severity, Text, ...)                                                                    \
    inline constexpr RemarkForm<NoteKind::Row __VA_OPT__(, ) __VA_ARGS__> Row{"Exchange", #Row, Text};
#include "projects/exchange/base/notes.def"
} // namespace remarks

struct Report {
    std::vector<Note> notes;
    int filesRead = 0;
    std::map<std::string, int> units;  // by kind: "PROGRAM", "FUNCTION", "TYPE", …
    std::map<std::string, int> bodies; // by language as found: "ST", "IL", "SFC", "LD", "FBD", "CFC"
    void add(std::string place, Remark remark);
    [[nodiscard]] size_t losses() const;
    /// Lines "place: sentence" in English, then the figures.
    [[nodiscard]] std::string toText() const;
};

} // namespace plc::exchange
