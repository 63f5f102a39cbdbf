// What StEditor does at a command: highlights names and finds, comments out, selects blocks, formats, mends findings.
#include "editor/text/st_editor.h"

#include "editor/text/st_marks.h"
#include "runtime/compiler/format/format.h"

#include <QMenu>
#include <QRegularExpression>
#include <QToolTip>

#include <algorithm>

namespace plc::editor {

using S = QsciScintillaBase;

void StEditor::highlightAroundCursor() {
    const std::string text = utf8();
    const auto clear = [&](int indicator) {
        SendScintilla(S::SCI_SETINDICATORCURRENT, static_cast<unsigned long>(indicator));
        SendScintilla(S::SCI_INDICATORCLEARRANGE, 0ul, static_cast<long>(text.size()));
    };
    const auto fill = [&](uint32_t begin, uint32_t end) {
        SendScintilla(S::SCI_INDICATORFILLRANGE, static_cast<unsigned long>(begin), static_cast<long>(end - begin));
    };
    clear(kBlockWords);
    const uint32_t at = cursorOffset();
    for (const BlockPair& pair : findBlocks(text)) {
        std::vector<BlockMark> marks = pair.middle;
        marks.push_back(pair.open);
        marks.push_back(pair.close);
        if (std::none_of(marks.begin(), marks.end(), [&](const BlockMark& m) { return at >= m.begin && at <= m.end; }))
            continue;
        for (const BlockMark& mark : marks) fill(mark.begin, mark.end);
    }
    clear(kSameWord);
    const auto file = fileId();
    if (!file || text != m_analysedText) return;
    for (const analysis::Use& use : m_model->uses(*file, at))
        if (use.range.file == *file) fill(use.range.begin, use.range.end);
}

void StEditor::highlightAll(const QString& wanted, bool regex, bool caseSensitive) {
    const std::string text = utf8();
    SendScintilla(S::SCI_SETINDICATORCURRENT, static_cast<unsigned long>(kFound));
    SendScintilla(S::SCI_INDICATORCLEARRANGE, 0ul, static_cast<long>(text.size()));
    if (wanted.isEmpty()) return;
    QRegularExpression pattern(regex ? wanted : QRegularExpression::escape(wanted),
                               caseSensitive
                                   ? QRegularExpression::MultilineOption
                                   : QRegularExpression::MultilineOption | QRegularExpression::CaseInsensitiveOption);
    if (!pattern.isValid()) return;
    const QString all = QString::fromStdString(text);
    for (auto matches = pattern.globalMatch(all); matches.hasNext();) {
        const auto match = matches.next();
        if (match.capturedLength() == 0) continue;
        const auto begin = all.left(match.capturedStart()).toUtf8().size();
        SendScintilla(S::SCI_INDICATORFILLRANGE, static_cast<unsigned long>(begin),
                      static_cast<long>(match.captured().toUtf8().size()));
    }
}

void StEditor::toggleComment() {
    int first = 0, last = 0, column = 0, lastColumn = 0;
    if (hasSelectedText())
        getSelection(&first, &column, &last, &lastColumn);
    else
        getCursorPosition(&first, &column), last = first;
    if (last > first && lastColumn == 0) --last;
    bool all = true;
    for (int line = first; line <= last; ++line)
        all = all && (text(line).trimmed().isEmpty() || text(line).trimmed().startsWith("//"));
    beginUndoAction();
    for (int line = first; line <= last; ++line) {
        const QString content = text(line);
        if (content.trimmed().isEmpty()) continue;
        int at = 0;
        while (content[at].isSpace()) ++at;
        if (all) {
            const int length = content.mid(at).startsWith("// ") ? 3 : 2;
            setSelection(line, at, line, at + length);
            replaceSelectedText("");
        } else {
            insertAt("// ", line, at);
        }
    }
    endUndoAction();
    if (last > first)
        setSelection(first, 0, last, static_cast<int>(text(last).size()) - (text(last).endsWith('\n') ? 1 : 0));
}

void StEditor::duplicateLine() { SendScintilla(S::SCI_SELECTIONDUPLICATE); }
void StEditor::moveLines(int direction) {
    SendScintilla(direction < 0 ? S::SCI_MOVESELECTEDLINESUP : S::SCI_MOVESELECTEDLINESDOWN);
}

void StEditor::selectBlock() {
    const auto begin = static_cast<uint32_t>(SendScintilla(S::SCI_GETSELECTIONSTART)),
               end = static_cast<uint32_t>(SendScintilla(S::SCI_GETSELECTIONEND));
    const BlockPair* best = nullptr;
    const std::vector<BlockPair> pairs = findBlocks(utf8());
    for (const BlockPair& pair : pairs)
        if (pair.open.begin <= begin && pair.close.end >= end && (pair.open.begin < begin || pair.close.end > end) &&
            (!best || pair.open.begin >= best->open.begin))
            best = &pair;
    if (best)
        SendScintilla(S::SCI_SETSEL, static_cast<unsigned long>(best->open.begin), static_cast<long>(best->close.end));
}

void StEditor::goToMatchingWord() {
    const uint32_t at = cursorOffset();
    for (const BlockPair& pair : findBlocks(utf8())) {
        if (at >= pair.open.begin && at <= pair.open.end) return goTo(pair.close.begin);
        if (at >= pair.close.begin && at <= pair.close.end) return goTo(pair.open.begin);
    }
    moveToMatchingBrace();
}

void StEditor::formatText() {
    format::FormatOptions options;
    options.indentWidth = m_settings.indent;
    const std::string before = utf8();
    const std::string after = format::format(before, options);
    if (after == before) return;
    // One edit between the common begin and end keeps cursor and marks where nothing changed.
    size_t begin = 0;
    while (begin < before.size() && begin < after.size() && before[begin] == after[begin]) ++begin;
    while (begin > 0 && (static_cast<unsigned char>(before[begin]) & 0xC0) == 0x80) --begin;
    size_t endBefore = before.size(), endAfter = after.size();
    while (endBefore > begin && endAfter > begin && before[endBefore - 1] == after[endAfter - 1])
        --endBefore, --endAfter;
    while (endBefore < before.size() && (static_cast<unsigned char>(before[endBefore]) & 0xC0) == 0x80)
        ++endBefore, ++endAfter;
    int line = 0, column = 0;
    getCursorPosition(&line, &column);
    applyEdits({{{FileId(), static_cast<uint32_t>(begin), static_cast<uint32_t>(endBefore)},
                 after.substr(begin, endAfter - begin)}});
    setCursorPosition(std::min(line, lines() - 1), column);
}

bool StEditor::goToDiagnostic(int direction) {
    const uint32_t at = cursorOffset();
    const diagnostics::Diagnostic* best = nullptr;
    for (const diagnostics::Diagnostic& d : m_diagnostics) {
        if (d.severity == diagnostics::Severity::Info) continue;
        if (direction > 0 && d.range.begin > at && (!best || d.range.begin < best->range.begin)) best = &d;
        if (direction < 0 && d.range.begin < at && (!best || d.range.begin > best->range.begin)) best = &d;
    }
    if (!best) return false;
    goTo(best->range.begin);
    return true;
}

void StEditor::applyFix() {
    const uint32_t at = cursorOffset();
    const long line = SendScintilla(S::SCI_LINEFROMPOSITION, static_cast<unsigned long>(at));
    struct Choice {
        QString title;
        std::vector<diagnostics::TextEdit> edits;
    };
    std::vector<Choice> choices;
    for (const diagnostics::Diagnostic& d : m_diagnostics) {
        const bool isHere = at >= d.range.begin && at <= d.range.end;
        if (!isHere && SendScintilla(S::SCI_LINEFROMPOSITION, static_cast<unsigned long>(d.range.begin)) != line)
            continue;
        for (const diagnostics::Fix& fix : d.fixes) choices.push_back({QString::fromStdString(fix.title), fix.edits});
        if (d.kind == diagnostics::Kind::UndeclaredName && m_model && !d.arguments.empty())
            if (const auto file = fileId())
                if (const auto edit = m_model->autoDeclare(*file, d.range.begin, d.arguments[0]))
                    choices.push_back({tr("Declare %1").arg(QString::fromStdString(edit->text).trimmed()), {*edit}});
    }
    if (utf8() != m_analysedText) return; // the analysis is on its way; its places would not fit
    if (choices.empty()) {
        QToolTip::showText(mapToGlobal(QPoint(40, 10)), tr("There is no fix for this line"), this);
        return;
    }
    const auto apply = [this](const Choice& choice) {
        std::vector<diagnostics::TextEdit> edits;
        for (const diagnostics::TextEdit& edit : choice.edits)
            if (!edit.range.file.isValid() || edit.range.file == *fileId()) edits.push_back(edit);
        applyEdits(edits);
    };
    if (choices.size() == 1) return apply(choices[0]);
    QMenu menu(this);
    for (const Choice& choice : choices)
        connect(menu.addAction(choice.title), &QAction::triggered, this, [apply, choice] { apply(choice); });
    menu.exec(mapToGlobal(
        QPoint(static_cast<int>(SendScintilla(S::SCI_POINTXFROMPOSITION, 0ul, static_cast<long>(at))),
               static_cast<int>(SendScintilla(S::SCI_POINTYFROMPOSITION, 0ul, static_cast<long>(at))) + 18)));
}

} // namespace plc::editor
