// Alt+Up and Alt+Down in an editor of text: the lines of every selection go past the line beside them.
// Not Scintilla's own command: with several selections that cuts lines, and may put in what lies in memory behind them.
#include "editor/text/st_editor.h"

#include <algorithm>
#include <map>

namespace plc::editor {

using S = QsciScintillaBase;

namespace {

long lineOf(const StEditor& editor, long at) {
    return editor.SendScintilla(S::SCI_LINEFROMPOSITION, static_cast<unsigned long>(at));
}
long startOf(const StEditor& editor, long line) {
    return editor.SendScintilla(S::SCI_POSITIONFROMLINE, static_cast<unsigned long>(line));
}
/// Before its line end.
long textEndOf(const StEditor& editor, long line) {
    return editor.SendScintilla(S::SCI_GETLINEENDPOSITION, static_cast<unsigned long>(line));
}

struct Place {
    long line, column; // in bytes
};
struct Selected {
    Place anchor, caret;
};

std::vector<Selected> selectionsOf(const StEditor& editor) {
    const auto placeOf = [&](unsigned int message, long selection) {
        const long at = editor.SendScintilla(message, static_cast<unsigned long>(selection)), line = lineOf(editor, at);
        return Place{line, at - startOf(editor, line)};
    };
    std::vector<Selected> selections;
    for (long i = 0, count = editor.SendScintilla(S::SCI_GETSELECTIONS); i < count; ++i)
        selections.push_back({placeOf(S::SCI_GETSELECTIONNANCHOR, i), placeOf(S::SCI_GETSELECTIONNCARET, i)});
    return selections;
}

/// First line to last of what moves together; at least one line lies between two of them.
std::map<long, long> blocksOf(const std::vector<Selected>& selections) {
    std::map<long, long> blocks;
    for (const auto& [anchor, caret] : selections) {
        const Place& end = std::pair(anchor.line, anchor.column) > std::pair(caret.line, caret.column) ? anchor : caret;
        long first = std::min(anchor.line, caret.line), last = end.line;
        if (last > first && end.column == 0) --last; // ends before that line
        for (auto each = blocks.begin(); each != blocks.end();) {
            if (each->second + 1 < first || each->first > last + 1) {
                ++each;
                continue;
            }
            first = std::min(first, each->first);
            last = std::max(last, each->second);
            each = blocks.erase(each);
        }
        blocks.emplace(first, last);
    }
    return blocks;
}

} // namespace

void StEditor::moveLines(int direction) {
    if (isReadOnly()) return;
    const std::vector<Selected> selections = selectionsOf(*this);
    const std::map<long, long> blocks = blocksOf(selections);
    const long main = SendScintilla(S::SCI_GETMAINSELECTION);
    const std::string all = utf8();
    const long end = static_cast<long>(all.size()), lines = SendScintilla(S::SCI_GETLINECOUNT);
    const long lowest = blocks.begin()->first, highest = blocks.rbegin()->second;
    // The empty line behind the last line end is none that others pass, or that moves.
    const bool endsInNewLine = startOf(*this, lines - 1) == end;
    if (direction < 0 ? lowest == 0 || (endsInNewLine && highest == lines - 1)
                      : highest >= lines - (endsInNewLine ? 2 : 1))
        return;

    std::vector<diagnostics::TextEdit> edits;
    const auto edit = [&](long from, long to, std::string text) {
        edits.push_back({{FileId(), static_cast<uint32_t>(from), static_cast<uint32_t>(to)}, std::move(text)});
    };
    // The line beside a block goes to its other side, so that what is marked on the lines of the block stays with them.
    for (const auto& [first, last] : blocks) {
        const long beside = direction < 0 ? first - 1 : last + 1;
        const long from = startOf(*this, beside), to = beside + 1 < lines ? startOf(*this, beside + 1) : end;
        const std::string line =
            all.substr(static_cast<size_t>(from), static_cast<size_t>(textEndOf(*this, beside) - from));
        const bool reachesEnd = std::max(beside, last) + 1 >= lines; // without a line end, and so it stays
        if (direction < 0) {
            const long behind = reachesEnd ? end : startOf(*this, last + 1);
            edit(from, to, "");
            edit(behind, behind, reachesEnd ? "\n" + line : line + "\n");
        } else {
            edit(startOf(*this, first), startOf(*this, first), line + "\n");
            edit(reachesEnd ? textEndOf(*this, last) : from, to, "");
        }
    }
    applyEdits(std::move(edits)); // its line ends are those of the file

    const auto moved = [&](const Place& place) {
        const long length = SendScintilla(S::SCI_GETLENGTH), line = place.line + direction;
        return line < lines ? std::min(startOf(*this, line) + place.column, length) : length;
    };
    for (size_t i = 0; i < selections.size(); ++i)
        SendScintilla(i == 0 ? S::SCI_SETSELECTION : S::SCI_ADDSELECTION,
                      static_cast<unsigned long>(moved(selections[i].caret)), moved(selections[i].anchor));
    SendScintilla(S::SCI_SETMAINSELECTION, static_cast<unsigned long>(main));
    SendScintilla(S::SCI_SCROLLCARET);
}

} // namespace plc::editor
