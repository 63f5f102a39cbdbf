// What StEditor does at a command: highlights names and finds, comments out, selects blocks, formats, fixes findings.
#include "editor/text/st_editor.h"

#include "editor/kit/message_text.h"
#include "editor/kit/texts.h"
#include "editor/text/st_marks.h"
#include "runtime/compiler/format/format.h"

#include <QMenu>
#include <QRegularExpression>
#include <QToolTip>

#include <algorithm>
#include <map>

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
    qsizetype counted = 0, begin = 0; // characters whose bytes are in `begin`
    for (auto matches = pattern.globalMatch(all); matches.hasNext();) {
        const auto match = matches.next();
        if (match.capturedLength() == 0) continue;
        begin += QStringView(all).mid(counted, match.capturedStart() - counted).toUtf8().size();
        counted = match.capturedStart();
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

void StEditor::selectNextOccurrence() {
    SendScintilla(S::SCI_TARGETWHOLEDOCUMENT);
    SendScintilla(S::SCI_SETSEARCHFLAGS, static_cast<unsigned long>(S::SCFIND_WHOLEWORD)); // names of any case
    SendScintilla(S::SCI_MULTIPLESELECTADDNEXT);
    SendScintilla(S::SCI_SCROLLCARET);
}

void StEditor::goToMatchingWord() {
    const uint32_t at = cursorOffset();
    for (const BlockPair& pair : findBlocks(utf8())) {
        if (at >= pair.open.begin && at <= pair.open.end) return goTo(pair.close.begin);
        if (at >= pair.close.begin && at <= pair.close.end) return goTo(pair.open.begin);
    }
    moveToMatchingBrace();
}

namespace {
/// The stretch in which two texts differ; characters are never cut.
std::optional<diagnostics::TextEdit> difference(const std::string& before, const std::string& after) {
    if (after == before) return std::nullopt;
    const auto isInside = [](const std::string& text, size_t at) {
        return at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0) == 0x80;
    };
    size_t begin = 0;
    while (begin < before.size() && begin < after.size() && before[begin] == after[begin]) ++begin;
    while (begin > 0 && (isInside(before, begin) || isInside(after, begin))) --begin;
    size_t endBefore = before.size(), endAfter = after.size();
    while (endBefore > begin && endAfter > begin && before[endBefore - 1] == after[endAfter - 1])
        --endBefore, --endAfter;
    while (isInside(before, endBefore)) ++endBefore, ++endAfter;
    return diagnostics::TextEdit{{FileId(), static_cast<uint32_t>(begin), static_cast<uint32_t>(endBefore)},
                                 after.substr(begin, endAfter - begin)};
}
} // namespace

void StEditor::takeText(const std::string& text) {
    const auto edit = difference(utf8(), text);
    if (!edit) return;
    int line = 0, column = 0;
    getCursorPosition(&line, &column);
    const bool wasLoading = std::exchange(m_isLoading, true);
    applyEdits({*edit});
    m_isLoading = wasLoading;
    setCursorPosition(std::min(line, lines() - 1), column);
    m_isAsAnalysed = false;
    updateFolding();
    updateChangedLines();
}

void StEditor::formatText() {
    format::FormatOptions options;
    options.indentWidth = m_settings.indent;
    // One edit between the common begin and end keeps cursor and marks where nothing changed.
    const std::string before = utf8();
    const auto edit = difference(before, format::format(before, options));
    if (!edit) return;
    int line = 0, column = 0;
    getCursorPosition(&line, &column);
    applyEdits({*edit});
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

/// An unknown name can become a local, an input, an output or a global; an unknown member an input or a field of its
/// owner.
void StEditor::addDeclarations(const diagnostics::Diagnostic& d,
                               const std::function<void(const QString&, const diagnostics::TextEdit&)>& add) const {
    const auto file = fileId();
    if (!m_model || !file || d.message.name(0).empty()) return;
    using diagnostics::Kind;
    const auto declared = [](const std::string& text) { // "x : INT" of the lines that are put in
        const QString line = QString::fromStdString(text).section(';', 0, 0).section('\n', -1).trimmed();
        return line;
    };
    if (d.kind == Kind::UndeclaredName) {
        using syntax::SectionKind;
        const std::pair<SectionKind, QString> choices[] = {
            {SectionKind::Var, tr("Declare %1")},
            {SectionKind::Input, tr("Declare %1 as an input")},
            {SectionKind::Output, tr("Declare %1 as an output")},
            {SectionKind::Global, tr("Declare %1 as a global variable")}};
        for (const auto& [section, title] : choices)
            if (const auto edit = m_model->autoDeclare(*file, d.range.begin, d.message.name(0), section))
                add(title.arg(declared(edit->text)), *edit);
    } else if ((d.kind == Kind::UnknownMember || d.kind == Kind::UnknownParameter)) {
        const std::string_view owner = d.message.name(0), member = d.message.name(1);
        if (const auto edit = m_model->declareMember(*file, d.range.begin, owner, member))
            add(tr("Declare %1 in %2").arg(declared(edit->text), kit::fromView(owner)), *edit);
    }
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
        for (const diagnostics::Fix& fix : d.fixes) choices.push_back({kit::messageText(fix.title), fix.edits});
        addDeclarations(d, [&](const QString& title, const diagnostics::TextEdit& edit) {
            choices.push_back({title, {edit}});
        });
    }
    if (utf8() != m_analysedText) return; // the analysis is on its way; its places would not fit
    if (choices.empty()) {
        QToolTip::showText(mapToGlobal(QPoint(40, 10)),
                           tr("There is no fix for this line; press F1 for an explanation"), this);
        return;
    }
    const auto apply = [this](const Choice& choice) {
        std::map<FileId, std::vector<diagnostics::TextEdit>> byFile;
        for (const diagnostics::TextEdit& edit : choice.edits)
            byFile[edit.range.file.isValid() ? edit.range.file : *fileId()].push_back(edit);
        if (byFile.size() == 1 && byFile.begin()->first == *fileId()) return applyEdits(choice.edits);
        std::vector<analysis::FileEdits> all;
        for (auto& [file, edits] : byFile) all.push_back({file, std::move(edits)});
        emit projectEditsRequested(all);
    };
    if (choices.size() == 1) return apply(choices[0]);
    QMenu menu(this);
    menu.setObjectName("fixes");
    for (const Choice& choice : choices)
        connect(menu.addAction(choice.title), &QAction::triggered, this, [apply, choice] { apply(choice); });
    menu.setActiveAction(menu.actions().first()); // Enter takes the first
    menu.exec(mapToGlobal(
        QPoint(static_cast<int>(SendScintilla(S::SCI_POINTXFROMPOSITION, 0ul, static_cast<long>(at))),
               static_cast<int>(SendScintilla(S::SCI_POINTYFROMPOSITION, 0ul, static_cast<long>(at))) + 18)));
}

} // namespace plc::editor
