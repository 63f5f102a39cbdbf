// A message about the user's program: a stable code, the narrowest range, one sentence, and fixes where there are any.
// The kinds are in diagnostics.def, the only list; findings::UndeclaredName(name) makes one. Values, any thread.
#pragma once
#include "runtime/base/message.h"
#include "runtime/base/phrases.h"
#include "runtime/base/source.h"

#include <string>
#include <string_view>
#include <vector>

// Qt's headers define the word emit away; this header is read before and after them.
#pragma push_macro("emit")
#undef emit

namespace plc::diagnostics {

enum class Severity : uint8_t { Error, Warning, Info };

enum class Kind : uint16_t {
#define PLC_DIAGNOSTIC(Name, SeverityName, Code, Text, ...) Name,
#include "runtime/diagnostics/diagnostics.def"
};

/// Replaces `range` by `text`.
struct TextEdit {
    SourceRange range;
    std::string text;
};
/// One thing that would fix it: a title for the menu (fixes.def) and the edits that do it.
struct Fix {
    Message title;
    std::vector<TextEdit> edits;
};
/// Another place that belongs to the finding, and what it is (notes.def).
struct Related {
    SourceRange range;
    Message note;
};

/// What is wrong, without its place.
struct Finding {
    Kind kind{};
    Message message;
};

struct Diagnostic {
    Kind kind{};
    Severity severity = Severity::Error;
    SourceRange range;
    Message message;
    std::vector<Fix> fixes;
    std::vector<Related> related; // "first declared here"
};

[[nodiscard]] std::string_view codeOf(Kind kind); // "P2004"
[[nodiscard]] std::string_view nameOf(Kind kind); // "LossyAssignment"
[[nodiscard]] Severity severityOf(Kind kind);     // the kind's own; a project may change it

/// A row of diagnostics.def with the types of its parameters.
template <Kind kind, class... Parameters> struct FindingForm : messages::TypedForm<Parameters...> {
    using messages::TypedForm<Parameters...>::TypedForm;
    [[nodiscard]] Finding operator()(Parameters... arguments) const {
        return {kind, messages::TypedForm<Parameters...>::operator()(std::move(arguments)...)};
    }
};

/// Collects diagnostics. One thread.
class Sink {
public:
    Diagnostic& emit(SourceRange range, Finding finding);
    Diagnostic& add(Diagnostic diagnostic);
    [[nodiscard]] bool hasErrors() const { return m_errors != 0; }
    [[nodiscard]] const std::vector<Diagnostic>& all() const { return m_all; }
    std::vector<Diagnostic> take() { return std::move(m_all); }
    /// By file, then place, then code; the same diagnostic twice is kept once.
    void sort();

private:
    std::vector<Diagnostic> m_all;
    size_t m_errors = 0;
};

/// "file:line:col: error P2004: message", the line and a caret beneath; with ANSI colours when asked.
[[nodiscard]] std::string renderText(const SourceSet& sources, const Diagnostic& diagnostic, bool colours);
/// One JSON object: file, range {line,column,endLine,endColumn}, code, severity, message, fixes.
[[nodiscard]] std::string renderJson(const SourceSet& sources, const Diagnostic& diagnostic);

} // namespace plc::diagnostics

namespace plc::findings {
using messages::Integer, messages::Name, messages::Names, messages::Phrase, messages::Thing;
#define PLC_DIAGNOSTIC(Row, SeverityName, Code, Text, ...)                                                             \
    inline constexpr diagnostics::FindingForm<diagnostics::Kind::Row __VA_OPT__(, ) __VA_ARGS__> Row{"Diagnostics",    \
                                                                                                     #Row, Text};
#include "runtime/diagnostics/diagnostics.def"
} // namespace plc::findings

namespace plc::fixes {
using messages::Name;
#define PLC_MESSAGE(Row, Text, ...) inline constexpr messages::TypedForm<__VA_ARGS__> Row{"Fixes", #Row, Text};
#include "runtime/diagnostics/fixes.def"
} // namespace plc::fixes

namespace plc::notes {
#define PLC_MESSAGE(Row, Text, ...) inline constexpr messages::TypedForm<__VA_ARGS__> Row{"Notes", #Row, Text};
#include "runtime/diagnostics/notes.def"
} // namespace plc::notes
#pragma pop_macro("emit")
