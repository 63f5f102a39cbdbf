// The breakpoints of a project by file and line of the text as it is written now, and as the program that runs knows
// them. Owned by RunControl; GUI thread.
#pragma once
#include <map> // first: moc cannot read <compare>, which ids.h begins with, before anything else

#include "editor/debug/text_place.h"
#include "runtime/debug/breakpoint.h"

namespace plc::editor {

struct EditorBreakpoint {
    QString file;
    int line = 1; // 1-based
    QString condition;
    int hitCount = 0;
    QString instance;
    bool isEnabled = true;
    bool hasCode = true; // false: the program that runs has none at the line or below it
    bool operator==(const EditorBreakpoint&) const = default;
};

class BreakpointList {
public:
    [[nodiscard]] const std::vector<EditorBreakpoint>& all() const { return m_all; }
    /// An enabled one at "file:line".
    [[nodiscard]] bool has(const QString& place) const;
    void set(std::vector<EditorBreakpoint> breakpoints) { m_all = std::move(breakpoints); }
    void toggle(const QString& file, int line);
    /// The text was edited: what was at the first line of a pair is at the second now; of two on one line one stays.
    /// True when something changed.
    bool move(const QString& file, const std::map<int, int>& lines);
    /// As the program knows them; moves those on lines without code to where they halt.
    [[nodiscard]] std::vector<debug::Breakpoint> forProgram(const image::CompiledProgram& program,
                                                            const TextNow& textNow);

private:
    std::vector<EditorBreakpoint> m_all;
};

} // namespace plc::editor
