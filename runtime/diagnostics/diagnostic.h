// A message about the user's program: a stable code, the narrowest range, one sentence, and fixes where there are any.
// The kinds stand in diagnostics.def, the only list; {0} {1}… are the arguments. Values, any thread.
#pragma once
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
#define PLC_DIAGNOSTIC(Name, SeverityName, Code, Text) Name,
#include "runtime/diagnostics/diagnostics.def"
};

/// Replaces `range` by `text`.
struct TextEdit {
    SourceRange range;
    std::string text;
};
/// One thing that would mend it: a title for the menu and the edits that do it.
struct Fix {
    std::string title;
    std::vector<TextEdit> edits;
};
struct Related {
    SourceRange range;
    std::string text;
};

struct Diagnostic {
    Kind kind{};
    Severity severity = Severity::Error;
    SourceRange range;
    std::vector<std::string> arguments;
    std::vector<Fix> fixes;
    std::vector<Related> related;              // "first declared here"
    [[nodiscard]] std::string message() const; // English, arguments filled in
};

[[nodiscard]] std::string_view codeOf(Kind kind);     // "P2004"
[[nodiscard]] std::string_view templateOf(Kind kind); // for translation
[[nodiscard]] std::string_view nameOf(Kind kind);     // "LossyAssignment"
[[nodiscard]] Severity severityOf(Kind kind);         // the kind's own; a project may change it

/// Collects diagnostics. One thread.
class Sink {
public:
    Diagnostic& emit(SourceRange range, Kind kind, std::vector<std::string> arguments = {});
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
#pragma pop_macro("emit")
