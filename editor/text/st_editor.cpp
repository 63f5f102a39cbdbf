#include "editor/text/st_editor.h"

#include "editor/kit/icons.h"
#include "editor/kit/inputs/variable_picker.h"
#include "editor/kit/message_text.h"
#include "editor/kit/own_keys.h"
#include "editor/kit/theme.h"
#include "editor/text/line_ground.h"
#include "editor/text/st_marks.h"
#include "runtime/base/text.h"

#include <QHelpEvent>
#include <QMimeData>
#include <QRegularExpression>
#include <QToolTip>

#include <algorithm>

namespace plc::editor {

using S = QsciScintillaBase;

namespace {
/// Before a completion in the list.
kit::Icon iconOf(analysis::ItemKind kind) {
    using analysis::ItemKind;
    switch (kind) {
    case ItemKind::Keyword:
        return kit::Icon::Command;
    case ItemKind::Snippet:
        return kit::Icon::Lightbulb;
    case ItemKind::Variable:
        return kit::Icon::Variable;
    case ItemKind::Constant:
        return kit::Icon::Constant;
    case ItemKind::EnumValue:
        return kit::Icon::Enumeration;
    case ItemKind::Type:
        return kit::Icon::Type;
    case ItemKind::Function:
        return kit::Icon::Function;
    case ItemKind::Block:
        return kit::Icon::Block;
    case ItemKind::Program:
        return kit::Icon::Program;
    case ItemKind::Method:
        return kit::Icon::Method;
    case ItemKind::Property:
        return kit::Icon::Property;
    case ItemKind::Parameter:
        return kit::Icon::Input;
    case ItemKind::Namespace:
        return kit::Icon::Namespace;
    }
    return kit::Icon::Variable;
}

} // namespace

StEditor::StEditor(QWidget* parent) : QsciScintilla(parent), m_lexer(new StLexer(this)) {
    setUtf8(true);
    setEolMode(EolUnix);
    setLexer(m_lexer);
    setMarginType(kLineNumbers, NumberMargin);
    setMarginType(kMarks, SymbolMargin);
    setMarginWidth(kMarks, 18);
    setMarginSensitivity(kMarks, true);
    setMarginSensitivity(kLineNumbers, true);
    setMarginMarkerMask(kMarks, (1 << kBreakpoint) | (1 << kBreakpointOff) | (1 << kErrorMark) | (1 << kWarningMark) |
                                    (1 << kExecutedArrow) | (1 << kFaultArrow) | (1 << kBookmark));
    setMarginType(kChanges, SymbolMargin);
    setMarginWidth(kChanges, 4);
    setMarginMarkerMask(kChanges, (1 << kChangedLine) | (1 << kAddedLine));
    setFolding(BoxedTreeFoldStyle, kFolds);
    setMarginWidth(kFolds, 14);
    markerDefine(Circle, kBreakpoint);
    markerDefine(Circle, kBreakpointOff);
    markerDefine(Background, kExecuted);
    markerDefine(Background, kFault);
    markerDefine(Invisible, kAutomaticEnd);
    markerDefine(FullRectangle, kChangedLine);
    markerDefine(FullRectangle, kAddedLine);
    setMargins(kCoverage + 1);
    setMarginType(kCoverage, SymbolMargin);
    setMarginWidth(kCoverage, 0);
    setMarginMarkerMask(kCoverage, (1 << kCovered) | (1 << kPartlyCovered) | (1 << kNotCovered));
    for (const int marker : {int(kCovered), int(kPartlyCovered), int(kNotCovered)}) markerDefine(FullRectangle, marker);
    indicatorDefine(SquiggleIndicator, kErrorSquiggle);
    indicatorDefine(SquiggleIndicator, kWarningSquiggle);
    indicatorDefine(DotsIndicator, kInfoDots);
    indicatorDefine(StraightBoxIndicator, kSameWord);
    indicatorDefine(FullBoxIndicator, kBlockWords);
    indicatorDefine(FullBoxIndicator, kFound);
    indicatorDefine(TextColorIndicator, kNotRun);
    indicatorDefine(FullBoxIndicator, kHeld);
    indicatorDefine(FullBoxIndicator, kNotHeld);
    setTabWidth(4);
    setIndentationsUseTabs(false);
    setBackspaceUnindents(true);
    setBraceMatching(SloppyBraceMatch);
    setCaretLineVisible(true);
    setScrollWidth(1);
    setScrollWidthTracking(true);
    SendScintilla(S::SCI_SETMULTIPLESELECTION, 1ul);
    SendScintilla(S::SCI_SETADDITIONALSELECTIONTYPING, 1ul);
    SendScintilla(S::SCI_SETMULTIPASTE, 1ul);
    SendScintilla(S::SCI_SETVIRTUALSPACEOPTIONS, 1ul);
    SendScintilla(S::SCI_AUTOCSETIGNORECASE, 1ul);
    SendScintilla(S::SCI_AUTOCSETORDER, 2ul); // keep our order
    SendScintilla(S::SCI_AUTOCSETMAXHEIGHT, 12ul);
    SendScintilla(S::SCI_AUTOCSETSEPARATOR, static_cast<unsigned long>('\n'));
    SendScintilla(S::SCI_AUTOCSETTYPESEPARATOR, static_cast<unsigned long>('\x1f'));
    SendScintilla(S::SCI_SETENDATLASTLINE, 0ul);
    setAccessibleName(tr("Structured Text editor"));
    applyTheme();
    connect(&kit::Theme::current(), &kit::Theme::changed, this, &StEditor::applyTheme);

    m_afterEdit.setSingleShot(true);
    m_afterEdit.setInterval(120);
    connect(&m_afterEdit, &QTimer::timeout, this, [this] {
        updateFolding();
        updateChangedLines();
    });
    m_afterMove.setSingleShot(true);
    m_afterMove.setInterval(80);
    connect(&m_afterMove, &QTimer::timeout, this, &StEditor::highlightAroundCursor);
    connect(this, &QsciScintilla::textChanged, this, &StEditor::onTextChanged);
    connect(this, &QsciScintilla::cursorPositionChanged, this, [this](int line, int column) {
        m_afterMove.start();
        emit cursorMoved(m_file, line + 1, column + 1);
    });
    connect(this, &QsciScintilla::marginClicked, this, [this](int margin, int line, Qt::KeyboardModifiers) {
        if (margin == kMarks || margin == kLineNumbers) emit breakpointToggled(m_file, line + 1);
    });
    connect(this, &QsciScintillaBase::SCN_CHARADDED, this, &StEditor::afterCharacter);
    connect(this, &QsciScintilla::userListActivated, this, [this](int id, const QString& text) {
        if (id != kListId) return;
        const auto chosen = std::find(m_listed.begin(), m_listed.end(), text);
        if (chosen != m_listed.end()) insertCompletion(m_completion.items[size_t(chosen - m_listed.begin())]);
    });
}

void StEditor::applyTheme() {
    const kit::ThemeColors& c = kit::colors();
    m_lexer->applyTheme();
    const QList<int> folded = contractedFolds();
    setLexer(m_lexer); // forgets the folds
    updateFolding();
    setContractedFolds(folded);
    SendScintilla(S::SCI_STYLESETFORE, static_cast<unsigned long>(S::STYLE_DEFAULT), c.text); // the lexer's first stays
    setCaretForegroundColor(c.text);
    QColor line = c.accent;
    line.setAlpha(c.dark ? 28 : 16);
    setCaretLineBackgroundColor(line);
    setMarginsBackgroundColor(c.window);
    setMarginsForegroundColor(c.muted);
    setMarginsFont(m_lexer->defaultFont(0));
    setFoldMarginColors(c.window, c.window);
    setSelectionBackgroundColor(c.selection);
    resetSelectionForegroundColor();
    setMatchedBraceBackgroundColor(c.hover);
    setMatchedBraceForegroundColor(c.accent);
    setUnmatchedBraceForegroundColor(c.bad);
    setMarkerBackgroundColor(c.breakpoint, kBreakpoint);
    setMarkerForegroundColor(c.breakpoint, kBreakpoint);
    setMarkerBackgroundColor(c.window, kBreakpointOff);
    setMarkerForegroundColor(c.breakpoint, kBreakpointOff);
    setMarkerBackgroundColor(c.current, kExecuted);
    setMarkerBackgroundColor(lineGround(c.base, c.bad, c.dark ? 0.35 : 0.24), kFault);
    const auto drawn = [](kit::Icon which) { return kit::icon(which).pixmap(QSize(14, 14), 1.0).toImage(); };
    markerDefine(drawn(kit::Icon::Error), kErrorMark);
    markerDefine(drawn(kit::Icon::Warning), kWarningMark);
    markerDefine(drawn(kit::Icon::CurrentLine), kExecutedArrow);
    markerDefine(drawn(kit::Icon::Error), kFaultArrow);
    markerDefine(drawn(kit::Icon::Marker), kBookmark);
    clearRegisteredImages();
    for (int kind = 0; kind <= static_cast<int>(analysis::ItemKind::Namespace); ++kind)
        registerImage(kind, drawn(iconOf(static_cast<analysis::ItemKind>(kind))));
    setMarkerBackgroundColor(c.warning, kChangedLine);
    setMarkerBackgroundColor(c.good, kAddedLine);
    setMarkerBackgroundColor(c.good, kCovered);
    setMarkerBackgroundColor(c.warning, kPartlyCovered);
    setMarkerBackgroundColor(c.bad, kNotCovered);
    for (int marker = int(SC_MARKNUM_FOLDEREND); marker <= int(SC_MARKNUM_FOLDEROPEN); ++marker) {
        SendScintilla(S::SCI_MARKERSETFORE, static_cast<unsigned long>(marker), c.window);
        SendScintilla(S::SCI_MARKERSETBACK, static_cast<unsigned long>(marker), c.muted);
    }
    setIndicatorForegroundColor(c.bad, kErrorSquiggle);
    setIndicatorForegroundColor(c.warning, kWarningSquiggle);
    setIndicatorForegroundColor(c.info, kInfoDots);
    const auto tint = [&](QColor colour, int alpha) {
        colour.setAlpha(alpha);
        return colour;
    };
    setIndicatorForegroundColor(tint(c.accent, 70), kSameWord);
    setIndicatorForegroundColor(tint(c.accent, 60), kBlockWords);
    setIndicatorForegroundColor(tint(c.warning, 90), kFound);
    setIndicatorForegroundColor(c.disabled, kNotRun);
    setIndicatorForegroundColor(tint(c.good, 60), kHeld);
    setIndicatorForegroundColor(tint(c.muted, 60), kNotHeld);
    setMarginWidth(kLineNumbers, QString(" %1").arg(std::max(999, lines())));
}

void StEditor::setSettings(const EditorSettings& settings) {
    m_settings = settings;
    setTabWidth(settings.indent);
    setIndentationWidth(settings.indent);
    zoomTo(settings.zoom);
    refreshOnlineValues();
}

std::optional<FileId> StEditor::fileId() const {
    return m_model ? m_model->fileOf(m_file.toStdString()) : std::nullopt;
}

void StEditor::load(const std::string& text) {
    m_isLoading = true;
    setEolMode(text.find("\r\n") != std::string::npos ? EolWindows : EolUnix); // as the file has it
    const bool wasReadOnly = isReadOnly();
    setReadOnly(false);
    SendScintilla(S::SCI_CLEARALL); // setText would end at the first byte of zero, and a save lose what is behind it
    SendScintilla(S::SCI_APPENDTEXT, static_cast<unsigned long>(text.size()), text.data());
    setReadOnly(wasReadOnly);
    SendScintilla(S::SCI_EMPTYUNDOBUFFER);
    m_isLoading = false;
    m_savedText = text;
    updateFolding();
    updateChangedLines();
    setMarginWidth(kLineNumbers, QString(" %1").arg(std::max(999, lines())));
}

std::string StEditor::textRange(uint32_t begin, uint32_t end) const { return utf8().substr(begin, end - begin); }

std::string StEditor::utf8() const {
    const auto length = static_cast<size_t>(SendScintilla(S::SCI_GETLENGTH));
    std::string text(length + 1, '\0');
    SendScintilla(S::SCI_GETTEXT, static_cast<unsigned long>(length + 1), text.data());
    text.resize(length);
    return text;
}

void StEditor::shareDocumentOf(StEditor& other) {
    setDocument(other.document());
    setFile(other.file());
    m_savedText = other.m_savedText; // both mark the same lines
    updateFolding();
}

void StEditor::onTextChanged() {
    m_isAsAnalysed = false;
    if (m_exact) setExactText(std::nullopt); // its offsets are of the text before
    if (m_isLoading || m_isApplying) return;
    m_afterEdit.start();
    emit edited(m_file);
}

void StEditor::updateFolding() {
    const std::vector<FoldLine> folds = foldLines(utf8());
    for (size_t line = 0; line < folds.size(); ++line) {
        const int level = S::SC_FOLDLEVELBASE + folds[line].level;
        SendScintilla(S::SCI_SETFOLDLEVEL, static_cast<unsigned long>(line),
                      static_cast<long>(level | (folds[line].isHeader ? S::SC_FOLDLEVELHEADERFLAG : 0)));
    }
}

void StEditor::setSavedText(const std::string& text) {
    m_savedText = text;
    updateChangedLines();
}

/// Lines between the common begin and end of both texts are changed; where the saved text has none there, added.
void StEditor::updateChangedLines() {
    markerDeleteAll(kChangedLine);
    markerDeleteAll(kAddedLine);
    const QStringList now = QString::fromStdString(utf8()).split('\n'),
                      saved = QString::fromStdString(m_savedText).split('\n');
    int begin = 0;
    while (begin < now.size() && begin < saved.size() && now[begin] == saved[begin]) ++begin;
    int nowEnd = static_cast<int>(now.size()), savedEnd = static_cast<int>(saved.size());
    while (nowEnd > begin && savedEnd > begin && now[nowEnd - 1] == saved[savedEnd - 1]) --nowEnd, --savedEnd;
    for (int line = begin; line < nowEnd; ++line) {
        // Inside the changed stretch, lines that stand unchanged in the saved stretch keep no mark.
        const bool same =
            savedEnd - begin < 2000 &&
            std::find(saved.begin() + begin, saved.begin() + savedEnd, now[line]) != saved.begin() + savedEnd &&
            !now[line].trimmed().isEmpty();
        if (!same) markerAdd(line, savedEnd == begin ? kAddedLine : kChangedLine);
    }
}

void StEditor::setModel(std::shared_ptr<const analysis::CodeModel> model) {
    m_model = std::move(model);
    const auto file = fileId();
    m_analysedText = file ? std::string(m_model->sources()[*file].text()) : std::string();
    m_lexer->setModel(m_model, file, m_analysedText);
    findDeclared();
    m_accumulators = file ? m_model->accumulators(*file) : std::vector<analysis::AccumulatorPlace>();
    m_diagnostics.clear();
    if (file)
        for (const diagnostics::Diagnostic& d : m_model->diagnostics())
            if (d.range.file == *file) m_diagnostics.push_back(d);
    m_isAsAnalysed = file && utf8() == m_analysedText;
    // What is below the view is coloured when it comes into sight.
    const long below = SendScintilla(S::SCI_GETFIRSTVISIBLELINE) + SendScintilla(S::SCI_LINESONSCREEN) + 1;
    recolor(0, static_cast<int>(SendScintilla(S::SCI_GETLINEENDPOSITION,
                                              static_cast<unsigned long>(SendScintilla(
                                                  S::SCI_DOCLINEFROMVISIBLE, static_cast<unsigned long>(below))))));
    showDiagnostics();
}

void StEditor::showDiagnostics() {
    const auto length = static_cast<unsigned long>(SendScintilla(S::SCI_GETLENGTH));
    for (const int indicator : {kErrorSquiggle, kWarningSquiggle, kInfoDots}) {
        SendScintilla(S::SCI_SETINDICATORCURRENT, static_cast<unsigned long>(indicator));
        SendScintilla(S::SCI_INDICATORCLEARRANGE, 0ul, static_cast<long>(length));
    }
    markerDeleteAll(kErrorMark);
    markerDeleteAll(kWarningMark);
    for (const diagnostics::Diagnostic& d : m_diagnostics) {
        const bool error = d.severity == diagnostics::Severity::Error,
                   warning = d.severity == diagnostics::Severity::Warning;
        const auto begin = std::min<unsigned long>(d.range.begin, length);
        auto end = std::clamp<unsigned long>(d.range.end, begin, length);
        if (end == begin) end = std::min<unsigned long>(begin + 1, length);
        SendScintilla(S::SCI_SETINDICATORCURRENT, static_cast<unsigned long>(error     ? kErrorSquiggle
                                                                             : warning ? kWarningSquiggle
                                                                                       : kInfoDots));
        SendScintilla(S::SCI_INDICATORFILLRANGE, begin, static_cast<long>(end - begin));
        if (error || warning)
            markerAdd(static_cast<int>(SendScintilla(S::SCI_LINEFROMPOSITION, begin)),
                      error ? kErrorMark : kWarningMark);
    }
}

uint32_t StEditor::cursorOffset() const { return static_cast<uint32_t>(SendScintilla(S::SCI_GETCURRENTPOS)); }

void StEditor::goTo(uint32_t offset, uint32_t length) {
    SendScintilla(S::SCI_AUTOCCANCEL); // a list of names belongs to where they were typed
    SendScintilla(S::SCI_ENSUREVISIBLEENFORCEPOLICY, static_cast<unsigned long>(SendScintilla(
                                                         S::SCI_LINEFROMPOSITION, static_cast<unsigned long>(offset))));
    SendScintilla(S::SCI_SETSEL, static_cast<unsigned long>(offset), static_cast<long>(offset + length));
    const long line = SendScintilla(S::SCI_LINEFROMPOSITION, static_cast<unsigned long>(offset));
    SendScintilla(S::SCI_SETFIRSTVISIBLELINE,
                  static_cast<unsigned long>(
                      std::max(0L, SendScintilla(S::SCI_VISIBLEFROMDOCLINE, static_cast<unsigned long>(line)) -
                                       SendScintilla(S::SCI_LINESONSCREEN) / 3)));
    setFocus();
}

void StEditor::goToLine(int line) {
    goTo(static_cast<uint32_t>(SendScintilla(
        S::SCI_POSITIONFROMLINE, static_cast<unsigned long>(std::clamp(line - 1, 0, std::max(0, lines() - 1))))));
}

uint32_t StEditor::offsetOf(int line, int column) const {
    const long begin = SendScintilla(S::SCI_POSITIONFROMLINE, static_cast<unsigned long>(std::max(0, line - 1)));
    return static_cast<uint32_t>(SendScintilla(S::SCI_POSITIONRELATIVE, static_cast<unsigned long>(begin),
                                               static_cast<long>(std::max(0, column - 1))));
}

void StEditor::applyEdits(std::vector<diagnostics::TextEdit> edits) {
    // From the end, so that the places of those to come hold; what is put in before a stretch comes after it.
    std::sort(edits.begin(), edits.end(), [](const auto& a, const auto& b) {
        return std::pair(a.range.begin, a.range.end) > std::pair(b.range.begin, b.range.end);
    });
    if (edits.empty()) return;
    m_isApplying = true; // one change to those who listen, however many places
    beginUndoAction();
    for (diagnostics::TextEdit& edit : edits) {
        if (eolMode() == EolWindows) // new lines end as those of the file
            for (size_t at = 0; (at = edit.text.find('\n', at)) != std::string::npos; ++at)
                if (at == 0 || edit.text[at - 1] != '\r') edit.text.insert(at++, 1, '\r');
        SendScintilla(S::SCI_SETTARGETSTART, static_cast<unsigned long>(edit.range.begin));
        SendScintilla(S::SCI_SETTARGETEND, static_cast<unsigned long>(edit.range.end));
        SendScintilla(S::SCI_REPLACETARGET, static_cast<unsigned long>(edit.text.size()), edit.text.c_str());
    }
    endUndoAction();
    m_isApplying = false;
    onTextChanged();
}

QMimeData* StEditor::toMimeData(const QByteArray& text, bool rectangular) const {
    QMimeData* mime = QsciScintilla::toMimeData(text, rectangular);
    const QString name = QString::fromUtf8(text).trimmed();
    static const QRegularExpression variable(QStringLiteral("^[A-Za-z_][\\w.\\[\\],]*$"));
    const auto file = fileId();
    if (!m_pathOf || !file || rectangular || !variable.match(name).hasMatch()) return mime;
    const auto at = static_cast<uint32_t>(SendScintilla(S::SCI_GETSELECTIONSTART));
    if (const QString path = m_pathOf(name, QString::fromStdString(m_model->pouAt(*file, at))); !path.isEmpty())
        mime->setData(kit::VariableMime, path.toUtf8());
    return mime;
}

QString StEditor::selectedText() const {
    const long main = SendScintilla(S::SCI_GETMAINSELECTION);
    const long begin = SendScintilla(S::SCI_GETSELECTIONNSTART, main),
               end = SendScintilla(S::SCI_GETSELECTIONNEND, main);
    return begin < end ? text(static_cast<int>(begin), static_cast<int>(end)) : QString();
}

QString StEditor::wordUnderCursor() const {
    const auto at = static_cast<unsigned long>(cursorOffset());
    const auto begin = static_cast<uint32_t>(SendScintilla(S::SCI_WORDSTARTPOSITION, at, 1L)),
               end = static_cast<uint32_t>(SendScintilla(S::SCI_WORDENDPOSITION, at, 1L));
    return QString::fromStdString(textRange(begin, end));
}

// ------------------------------------------------------------------ marks

void StEditor::setBreakpoints(const std::set<int>& lines, const std::set<int>& disabled) {
    markerDeleteAll(kBreakpoint);
    markerDeleteAll(kBreakpointOff);
    m_breakpointMarks.clear();
    for (const int line : lines)
        m_breakpointMarks[markerAdd(line - 1, disabled.contains(line) ? kBreakpointOff : kBreakpoint)] = line;
}

std::map<int, int> StEditor::movedBreakpoints() const {
    std::map<int, int> moved;
    for (const auto& [mark, line] : m_breakpointMarks)
        if (const int now = markerLine(mark) + 1; now > 0 && now != line) moved[line] = now;
    return moved;
}

void StEditor::setExecutedLine(int line) {
    markerDeleteAll(kExecuted);
    markerDeleteAll(kExecutedArrow);
    if (line <= 0) return;
    markerAdd(line - 1, kExecuted);
    markerAdd(line - 1, kExecutedArrow);
}

void StEditor::setFaultLine(int line) {
    markerDeleteAll(kFault);
    markerDeleteAll(kFaultArrow);
    if (line <= 0) return;
    markerAdd(line - 1, kFault);
    markerAdd(line - 1, kFaultArrow);
}

// ------------------------------------------------------------------ menus, tips

bool StEditor::event(QEvent* event) {
    if (event->type() == QEvent::KeyPress && isReadOnly()) { // Tab writes nothing here: it goes on to the next field
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Tab || key == Qt::Key_Backtab) return QWidget::focusNextPrevChild(key == Qt::Key_Tab);
    }
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        showToolTip(help->pos());
        return true;
    }
    // Scintilla has a command of its own on many keys (Ctrl+T swaps two lines); the window's shortcut is meant.
    if (event->type() == QEvent::ShortcutOverride && kit::actionOfKey(this, *static_cast<QKeyEvent*>(event))) {
        event->ignore();
        return false;
    }
    return QsciScintilla::event(event);
}

void StEditor::showToolTip(const QPoint& position) {
    const QPoint inside = viewport()->mapFrom(this, position);
    const long at = SendScintilla(S::SCI_POSITIONFROMPOINTCLOSE, static_cast<unsigned long>(inside.x()),
                                  static_cast<long>(inside.y()));
    const long line = SendScintilla(
        S::SCI_LINEFROMPOSITION,
        static_cast<unsigned long>(SendScintilla(S::SCI_POSITIONFROMPOINT, 0ul, static_cast<long>(inside.y()))));
    const QString covered = coverageAt(static_cast<int>(line));
    const bool isMargin = at < 0 && inside.x() < SendScintilla(S::SCI_POINTXFROMPOSITION, 0ul, 0l);
    if (isMargin && !covered.isEmpty())
        return QToolTip::showText(mapToGlobal(position), covered.toHtmlEscaped().replace('\n', "<br>"), this);
    if (at < 0) return QToolTip::hideText();
    QString html;
    for (const diagnostics::Diagnostic& d : m_diagnostics)
        if (static_cast<uint32_t>(at) >= d.range.begin && static_cast<uint32_t>(at) <= d.range.end) {
            html += QString("<p><b>%1</b> %2</p>")
                        .arg(QString::fromUtf8(diagnostics::codeOf(d.kind).data(),
                                               static_cast<int>(diagnostics::codeOf(d.kind).size())),
                             kit::messageText(d.message).toHtmlEscaped());
            for (const diagnostics::Fix& fix : d.fixes)
                html +=
                    QString("<p>&nbsp;&nbsp;%1 <i>Alt+Enter</i></p>").arg(kit::messageText(fix.title).toHtmlEscaped());
        }
    if (!html.isEmpty()) return QToolTip::showText(mapToGlobal(position), html, this);
    emit hoverRequested(m_file, static_cast<uint32_t>(at), mapToGlobal(position));
}

void StEditor::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton && (event->modifiers() & Qt::ControlModifier) &&
        !(event->modifiers() & Qt::ShiftModifier)) {
        const long at = SendScintilla(S::SCI_POSITIONFROMPOINTCLOSE, static_cast<unsigned long>(event->pos().x()),
                                      static_cast<long>(event->pos().y()));
        if (at >= 0) {
            emit definitionRequested(m_file, static_cast<uint32_t>(at));
            return;
        }
    }
    if (event->button() == Qt::LeftButton && event->modifiers() == Qt::NoModifier && clickPass(event->pos())) return;
    m_caretsBefore.clear();
    if (event->button() == Qt::LeftButton && event->modifiers() == Qt::AltModifier) {
        m_altClick = event->pos();
        const long count = SendScintilla(S::SCI_GETSELECTIONS);
        for (long i = 0; i < count; ++i)
            m_caretsBefore.emplace_back(SendScintilla(S::SCI_GETSELECTIONNANCHOR, static_cast<unsigned long>(i)),
                                        SendScintilla(S::SCI_GETSELECTIONNCARET, static_cast<unsigned long>(i)));
    }
    QsciScintilla::mousePressEvent(event);
}

/// A click with Alt puts one more caret; a drag with Alt selects a column, as before.
void StEditor::mouseReleaseEvent(QMouseEvent* event) {
    QsciScintilla::mouseReleaseEvent(event);
    const auto before = std::exchange(m_caretsBefore, {});
    if (before.empty() || (event->pos() - m_altClick).manhattanLength() > 4) return;
    const long at = SendScintilla(S::SCI_GETCURRENTPOS);
    SendScintilla(S::SCI_SETSELECTION, static_cast<unsigned long>(before[0].second), before[0].first);
    for (size_t i = 1; i < before.size(); ++i)
        SendScintilla(S::SCI_ADDSELECTION, static_cast<unsigned long>(before[i].second), before[i].first);
    SendScintilla(S::SCI_ADDSELECTION, static_cast<unsigned long>(at), at);
}

} // namespace plc::editor
