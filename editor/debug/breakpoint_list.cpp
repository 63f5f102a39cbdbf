#include "editor/debug/breakpoint_list.h"

#include "editor/debug/line_map.h"
#include "runtime/debug/sites.h"

#include <algorithm>

namespace plc::editor {

bool BreakpointList::has(const QString& place) const {
    return std::any_of(m_all.begin(), m_all.end(), [&](const EditorBreakpoint& each) {
        return each.isEnabled && QString("%1:%2").arg(each.file).arg(each.line) == place;
    });
}

void BreakpointList::toggle(const QString& file, int line) {
    const auto it = std::find_if(m_all.begin(), m_all.end(),
                                 [&](const EditorBreakpoint& b) { return b.file == file && b.line == line; });
    if (it != m_all.end())
        m_all.erase(it);
    else
        m_all.push_back({file, line});
}

bool BreakpointList::move(const QString& file, const std::map<int, int>& lines) {
    std::vector<EditorBreakpoint> moved;
    for (EditorBreakpoint each : m_all) {
        if (const auto it = lines.find(each.line); each.file == file && it != lines.end()) each.line = it->second;
        const bool isDouble = std::any_of(moved.begin(), moved.end(), [&](const EditorBreakpoint& other) {
            return other.file == each.file && other.line == each.line;
        });
        if (!isDouble) moved.push_back(std::move(each));
    }
    if (moved == m_all) return false;
    m_all = std::move(moved); // in the program that runs they are where they were
    return true;
}

std::vector<debug::Breakpoint> BreakpointList::forProgram(const image::CompiledProgram& program,
                                                          const TextNow& textNow) {
    struct Maps {
        LineMap toProgram, toText;
    };
    std::map<QString, Maps> maps;
    std::vector<debug::Breakpoint> posted;
    for (EditorBreakpoint& each : m_all) {
        const FileId file = debug::fileOfPath(program, each.file.toStdString());
        each.hasCode = false;
        if (!file.isValid()) continue;
        const SourceText& built = program.sources[file];
        if (!maps.contains(each.file)) {
            const std::string now = textNow(each.file, built);
            maps.emplace(each.file, Maps{{now, built.text()}, {built.text(), now}});
        }
        const Maps& map = maps.at(each.file);
        auto line = static_cast<uint32_t>(map.toProgram.nearest(each.line));
        const debug::SitesOfLine found = debug::sitesOfLine(program, file, line);
        each.hasCode = !found.sites.empty();
        if (!each.hasCode) continue;
        line = found.line;
        if (map.toProgram.exact(each.line)) // a new line waits for its build
            each.line = map.toText.exact(static_cast<int>(line)).value_or(each.line);
        posted.push_back({file, line, each.condition.toStdString(), static_cast<uint32_t>(each.hitCount),
                          each.instance.toStdString(), each.isEnabled});
    }
    return posted;
}

} // namespace plc::editor
