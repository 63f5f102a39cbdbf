// What StEditor does while the user types: completion, parameter help, indentation, closing of blocks.
#include "editor/text/st_editor.h"

#include "editor/kit/own_keys.h"
#include "editor/text/st_marks.h"
#include "runtime/base/text.h"
#include "runtime/compiler/lex/token.h"

#include <QGuiApplication>
#include <QKeyEvent>
#include <QScreen>

#include <algorithm>

namespace plc::editor {

using S = QsciScintillaBase;

namespace {
bool isWord(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || static_cast<unsigned char>(c) >= 0x80;
}

QString nameOf(const analysis::CompletionItem& item) {
    return QString::fromStdString(item.kind == analysis::ItemKind::Snippet ? item.detail : item.text).trimmed();
}

/// What stands in the list: name, and in a column of its own the type or parameters with the first line of the comment.
std::vector<QString> listed(const std::vector<analysis::CompletionItem>& items) {
    constexpr qsizetype kWidestName = 30, kWidest = 76;
    qsizetype width = 0;
    for (const analysis::CompletionItem& item : items)
        if (const qsizetype size = nameOf(item).size(); size <= kWidestName) width = std::max(width, size);
    std::vector<QString> out;
    for (const analysis::CompletionItem& item : items) {
        QString beside = item.kind == analysis::ItemKind::Snippet ? QString() : QString::fromStdString(item.detail);
        const QString comment = QString::fromStdString(item.comment).section('\n', 0, 0).trimmed();
        if (!comment.isEmpty()) beside += (beside.isEmpty() ? "" : "  ") + comment;
        QString line = nameOf(item);
        if (!beside.isEmpty()) line = line.leftJustified(width) + "  " + beside.simplified();
        if (line.size() > kWidest) line = line.left(kWidest - 1) + "…";
        out.push_back(line);
    }
    return out;
}

/// Ctrl+/, for which many keyboards need Shift, or Ctrl+#, which has a key of its own on German ones.
bool isCommentKey(const QKeyEvent& event) {
    const Qt::KeyboardModifiers more = event.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier);
    return more == Qt::ControlModifier && (event.key() == Qt::Key_Slash || event.key() == Qt::Key_NumberSign);
}
} // namespace

void StEditor::keyPressEvent(QKeyEvent* event) {
    if (kit::actionOfKey(this, *event)) return event->ignore(); // it is disabled now, or it would not have come here
    if (event->matches(QKeySequence::Undo) && m_undo) return m_undo();
    if ((event->matches(QKeySequence::Redo) ||
         (event->key() == Qt::Key_Y && event->modifiers() == Qt::ControlModifier)) &&
        m_redo)
        return m_redo();
    if (SendScintilla(S::SCI_GETSELECTIONS) > 1 && event->modifiers() == Qt::NoModifier)
        return QsciScintilla::keyPressEvent(event); // typing in a column
    bool listOpen = SendScintilla(S::SCI_AUTOCACTIVE) != 0;
    if (listOpen && (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) && isWordComplete()) {
        SendScintilla(S::SCI_AUTOCCANCEL); // what is typed is a whole word already: Enter ends the line
        listOpen = false;
    }
    if ((event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) && !listOpen) {
        if (event->modifiers() == Qt::AltModifier) return applyFix();
        if (event->modifiers() == Qt::NoModifier) {
            SendScintilla(S::SCI_CALLTIPCANCEL);
            return enterPressed();
        }
    }
    if (event->key() == Qt::Key_Space && event->modifiers() == Qt::ControlModifier) return triggerCompletion();
    if (event->key() == Qt::Key_Space && event->modifiers() == (Qt::ControlModifier | Qt::ShiftModifier))
        return showParameterHelp();
    if (isCommentKey(*event)) return toggleComment();
    if ((event->key() == Qt::Key_Up || event->key() == Qt::Key_Down) && event->modifiers() == Qt::AltModifier)
        return moveLines(event->key() == Qt::Key_Up ? -1 : 1);
    if (typeOverSemicolon(event->text())) return;
    QsciScintilla::keyPressEvent(event);
}

/// Enter between END_IF and the ";" that came with it ends the line behind both.
void StEditor::passAutomaticSemicolon() {
    int line = 0, column = 0;
    getCursorPosition(&line, &column);
    if (hasSelectedText() || text(line).mid(column).trimmed() != ";") return;
    (void)typeOverSemicolon(QStringLiteral(";"));
}

bool StEditor::typeOverSemicolon(const QString& typed) {
    int line = 0, column = 0;
    getCursorPosition(&line, &column);
    const bool isAutomatic = markersAtLine(line) & (1U << kAutomaticEnd);
    if (typed != ";" || !isAutomatic || hasSelectedText() || text(line).mid(column, 1) != ";") return false;
    markerDelete(line, kAutomaticEnd);
    setCursorPosition(line, column + 1);
    return true;
}

bool StEditor::typeOverEnd() {
    int line = 0, column = 0;
    getCursorPosition(&line, &column);
    const QString typed = text(line).left(column).trimmed(), behind = text(line).mid(column).trimmed();
    if (!typed.startsWith("END_", Qt::CaseInsensitive)) return false;
    int end = line; // the line with the automatic one: this one, or the next that is not empty
    if (behind.isEmpty())
        for (++end; end < lines() && text(end).trimmed().isEmpty();) ++end;
    if (end >= lines() || !(markersAtLine(end) & (1U << kAutomaticEnd))) return false;
    QString word = end == line ? behind : text(end).trimmed();
    if (word.endsWith(';')) word.chop(1);
    if (word.compare(typed, Qt::CaseInsensitive) != 0) return false;
    const std::string all = utf8();
    const auto lineBegin = [this](int of) {
        return static_cast<uint32_t>(SendScintilla(S::SCI_POSITIONFROMLINE, static_cast<unsigned long>(of)));
    };
    const uint32_t at = cursorOffset();
    const auto wordBegin = static_cast<uint32_t>(all.find_first_not_of(" \t\r\n", at));
    for (const BlockPair& pair : findBlocks(all))
        if (pair.close.begin == wordBegin && end != line) return false; // it closes another block
    const uint32_t from = end == line ? at - static_cast<uint32_t>(typed.size()) : lineBegin(line);
    const uint32_t to = end == line ? at : lineBegin(end);
    applyEdits({{{FileId(), from, to}, ""}});
    SendScintilla(S::SCI_GOTOPOS,
                  static_cast<unsigned long>(wordBegin - (to - from) + static_cast<uint32_t>(word.size())));
    return true;
}

bool StEditor::isWordComplete() const {
    const std::string text = utf8();
    const uint32_t end = cursorOffset();
    uint32_t begin = end;
    while (begin > 0 && isWord(text[begin - 1])) --begin;
    const std::string_view typed = std::string_view(text).substr(begin, end - begin);
    return std::any_of(m_completion.items.begin(), m_completion.items.end(),
                       [&](const analysis::CompletionItem& item) { return equalsIgnoringCase(item.text, typed); });
}

void StEditor::afterCharacter(int character) {
    if (SendScintilla(S::SCI_GETSELECTIONS) > 1) return; // help with one word would end the column
    const std::string text = utf8();
    const uint32_t at = cursorOffset();
    // Behind ")" the call around goes on, if there is one; behind ":=" and "=>" the named parameter is the current one.
    if (character == '(' || character == ',' || character == ')' ||
        (SendScintilla(S::SCI_CALLTIPACTIVE) && (character == '=' || character == '>')))
        showParameterHelp();
    const bool isLetter = character > 0x7f || isWord(static_cast<char>(character));
    if (!isLetter && m_settings.upperCaseKeywords) upperCaseWordBefore();
    outdentClosingWord();
    if (typeOverEnd()) return SendScintilla(S::SCI_AUTOCCANCEL), void();
    if (character == '.') return triggerCompletion();
    if (!isLetter) return;
    // A list after the second letter of a word, or refreshed while it is open.
    uint32_t begin = at;
    while (begin > 0 && isWord(text[begin - 1])) --begin;
    if (at - begin >= 2 || SendScintilla(S::SCI_AUTOCACTIVE)) triggerCompletion();
}

void StEditor::triggerCompletion() {
    if (!m_model) return;
    const auto file = m_model->fileOf(m_file.toStdString());
    if (!file) return;
    const std::string text = utf8();
    m_completion = m_model->complete(*file, text, cursorOffset());
    const std::string typed =
        text.substr(m_completion.replaceBegin, m_completion.replaceEnd - m_completion.replaceBegin);
    if (m_completion.items.size() == 1 && nameOf(m_completion.items[0]) == QString::fromStdString(typed))
        m_completion.items.clear(); // nothing to add
    m_completion.items.resize(std::min<size_t>(m_completion.items.size(), 200));
    m_listed = listed(m_completion.items);
    std::string list;
    for (size_t i = 0; i < m_listed.size(); ++i)
        list += (i ? "\n" : "") + m_listed[i].toStdString() + '\x1f' + // the icon's number
                std::to_string(static_cast<int>(m_completion.items[i].kind));
    if (list.empty()) {
        SendScintilla(S::SCI_AUTOCCANCEL);
        return;
    }
    // Scintilla asks the screen below the cursor for its size; a window that hangs over the edge may have none there.
    const long caret = SendScintilla(S::SCI_GETCURRENTPOS);
    const QPoint at(static_cast<int>(SendScintilla(S::SCI_POINTXFROMPOSITION, 0UL, caret)),
                    static_cast<int>(SendScintilla(S::SCI_POINTYFROMPOSITION, 0UL, caret)));
    if (!QGuiApplication::screenAt(viewport()->mapToGlobal(at))) return;
    SendScintilla(S::SCI_USERLISTSHOW, static_cast<unsigned long>(kListId), list.c_str());
}

void StEditor::insertCompletion(const analysis::CompletionItem& item) {
    const std::string text = utf8();
    uint32_t end = cursorOffset(), begin = end;
    while (begin > 0 && isWord(text[begin - 1])) --begin;
    std::string inserted = item.text;
    size_t cursor = inserted.size();
    if (item.kind == analysis::ItemKind::Snippet) {
        const size_t lineBegin = begin == 0 ? 0 : text.rfind('\n', begin - 1) + 1;
        const size_t indent = text.find_first_not_of(" \t", lineBegin);
        const std::string blanks = text.substr(lineBegin, std::min<size_t>(indent, begin) - lineBegin);
        for (size_t i = 0; (i = inserted.find('\n', i)) != std::string::npos; i += 1 + blanks.size())
            inserted.insert(i + 1, blanks);
        cursor = inserted.find('|');
        if (cursor != std::string::npos)
            inserted.erase(cursor, 1);
        else
            cursor = inserted.size();
    }
    applyEdits({{{FileId(), begin, end}, inserted}});
    SendScintilla(S::SCI_GOTOPOS, static_cast<unsigned long>(begin + cursor));
    (void)typeOverEnd();
    if (item.kind == analysis::ItemKind::Parameter) showParameterHelp();
}

void StEditor::showParameterHelp() {
    if (!m_model) return;
    const auto file = m_model->fileOf(m_file.toStdString());
    if (!file) return;
    const auto help = m_model->parameterHelp(*file, utf8(), cursorOffset());
    if (!help) {
        SendScintilla(S::SCI_CALLTIPCANCEL);
        return;
    }
    std::string tip = help->callee + "(";
    size_t highlightBegin = 0, highlightEnd = 0;
    for (size_t i = 0; i < help->parameters.size(); ++i) {
        const auto& parameter = help->parameters[i];
        if (i) tip += i % 3 == 0 ? ",\n    " : ", ";
        if (i == help->current) highlightBegin = tip.size();
        tip += parameter.name;
        if (!parameter.type.empty())
            tip += (parameter.section == types::FieldSection::Output ? " => " : " := ") + parameter.type;
        if (i == help->current) highlightEnd = tip.size();
    }
    tip += ")";
    if (help->current < help->parameters.size() && !help->parameters[help->current].comment.empty())
        tip += "\n" + help->parameters[help->current].comment;
    SendScintilla(S::SCI_CALLTIPSHOW, static_cast<unsigned long>(cursorOffset()), tip.c_str());
    SendScintilla(S::SCI_CALLTIPSETHLT, static_cast<unsigned long>(highlightBegin), static_cast<long>(highlightEnd));
}

void StEditor::enterPressed() {
    passAutomaticSemicolon();
    const std::string before = utf8();
    const uint32_t at = cursorOffset();
    if (m_settings.upperCaseKeywords) upperCaseWordBefore();
    const int indent = indentAfter(before, at, m_settings.indent);
    const size_t lineBegin = at == 0 ? 0 : before.rfind('\n', at - 1) + 1;
    const size_t first = before.find_first_not_of(" \t", lineBegin);
    const int own = static_cast<int>(std::min<size_t>(first == std::string::npos ? at : first, at) - lineBegin);
    const bool atLineEnd = at >= before.size() || before[at] == '\n' || before[at] == '\r';
    const std::string end = m_settings.autoCloseBlocks && (indent > own || opensBlock(before, at)) && atLineEnd
                                ? missingEnd(before, at)
                                : std::string();
    const std::string newline = eolMode() == EolWindows ? "\r\n" : "\n";
    std::string inserted = newline + std::string(static_cast<size_t>(indent), ' ');
    const size_t cursor = inserted.size();
    if (!end.empty())
        inserted +=
            newline + std::string(static_cast<size_t>(own), ' ') + end +
            (end == "END_VAR" || end == "END_TYPE" || end.starts_with("END_F") || end == "END_PROGRAM" ||
                     end == "END_METHOD"
                 ? ""
             : end == "END_IF" || end == "END_CASE" || end == "END_WHILE" || end == "END_REPEAT" || end == "END_STRUCT"
                 ? ";"
                 : "");
    if (end == "END_FOR") inserted += ";";
    beginUndoAction();
    replaceSelectedText("");
    const uint32_t position = cursorOffset();
    SendScintilla(S::SCI_INSERTTEXT, static_cast<unsigned long>(position), inserted.c_str());
    SendScintilla(S::SCI_GOTOPOS, static_cast<unsigned long>(position + cursor));
    endUndoAction();
    if (!end.empty())
        markerAdd(static_cast<int>(
                      SendScintilla(S::SCI_LINEFROMPOSITION, static_cast<unsigned long>(position + inserted.size()))),
                  kAutomaticEnd);
    SendScintilla(S::SCI_SCROLLCARET);
}

/// "END_IF" typed as the first word of its line moves to its opener's column.
void StEditor::outdentClosingWord() {
    const std::string text = utf8();
    const uint32_t at = cursorOffset();
    const size_t lineBegin = at == 0 ? 0 : text.rfind('\n', at - 1) + 1;
    const std::string line = text.substr(lineBegin, at - lineBegin);
    if (!closesBlock(line) || line.find_first_not_of(" \t") == std::string::npos) return;
    const size_t wordBegin = lineBegin + line.find_first_not_of(" \t");
    if (text.find_first_of(" \t(;", wordBegin) < at) return; // only while the word itself is being typed
    const auto columnOf = [&](uint32_t offset) {
        const size_t begin = offset == 0 ? 0 : text.rfind('\n', offset - 1) + 1;
        return static_cast<int>(text.find_first_not_of(" \t", begin) - begin);
    };
    for (const BlockPair& pair : findBlocks(text)) {
        const bool ends = pair.close.begin == wordBegin;
        const bool divides = std::any_of(pair.middle.begin(), pair.middle.end(),
                                         [&](const BlockMark& m) { return m.begin == wordBegin; });
        if (!ends && !divides) continue;
        const int wanted = columnOf(pair.open.begin), now = static_cast<int>(wordBegin - lineBegin);
        if (wanted >= now) return;
        applyEdits({{{FileId(), static_cast<uint32_t>(lineBegin), static_cast<uint32_t>(wordBegin)},
                     std::string(static_cast<size_t>(wanted), ' ')}});
        SendScintilla(S::SCI_GOTOPOS, static_cast<unsigned long>(at - static_cast<uint32_t>(now - wanted)));
        return;
    }
}

void StEditor::upperCaseWordBefore() {
    const std::string text = utf8();
    uint32_t end = cursorOffset();
    while (end > 0 && !isWord(text[end - 1]) && cursorOffset() - end < 2) --end;
    uint32_t begin = end;
    while (begin > 0 && isWord(text[begin - 1])) --begin;
    if (begin == end) return;
    diagnostics::Sink sink;
    const std::string word = text.substr(begin, end - begin);
    const lex::TokenList list = lex::tokenize(FileId(size_t(0)), word, sink);
    if (list.tokens.size() != 2 || !lex::isKeyword(list.tokens[0].kind)) return;
    const lex::TokenList all = lex::tokenize(FileId(size_t(0)), text, sink);
    for (const lex::Comment& comment : all.comments)
        if (begin >= comment.begin && begin < comment.end) return;
    const auto token =
        std::find_if(all.tokens.begin(), all.tokens.end(), [&](const lex::Token& t) { return t.begin == begin; });
    if (token == all.tokens.end() || !lex::isKeyword(token->kind)) return; // inside a string or a pragma
    std::string upper = word;
    for (char& c : upper)
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 32);
    if (upper == word) return;
    const uint32_t cursor = cursorOffset();
    applyEdits({{{FileId(), begin, end}, upper}});
    SendScintilla(S::SCI_GOTOPOS, static_cast<unsigned long>(cursor));
}

} // namespace plc::editor
