#include "editor/text/st_lexer.h"

#include "editor/kit/contrast.h"
#include "editor/kit/theme.h"
#include "runtime/base/text.h"

#include <QFontDatabase>
#include <Qsci/qsciscintilla.h>

#include <algorithm>

namespace plc::editor {

using analysis::TokenClass;

namespace {
struct Ink {
    QRgb light, dark;
    bool bold = false, italic = false;
};
Ink inkOf(TokenClass kind) {
    switch (kind) {
    case TokenClass::Plain:
        return {0x1f2328, 0xd6dae0};
    case TokenClass::Keyword:
        return {0x0a3fa8, 0x7aa8ff, true};
    case TokenClass::Type:
        return {0x0b6e75, 0x5cc8cf};
    case TokenClass::Number:
        return {0x7a3e00, 0xe0a870};
    case TokenClass::Text:
        return {0x8a1c3c, 0xf08fa8};
    case TokenClass::Comment:
        return {0x5c6b5e, 0x8fa392, false, true};
    case TokenClass::Pragma:
        return {0x6b5b95, 0xb3a4dd};
    case TokenClass::Operator:
        return {0x444b55, 0xaab2bd};
    case TokenClass::Constant:
        return {0x7a3e00, 0xe0a870, true};
    case TokenClass::EnumValue:
        return {0x8a5a00, 0xe8c46a};
    case TokenClass::Input:
        return {0x116329, 0x7bd88f};
    case TokenClass::Output:
        return {0x9a3412, 0xff9e6d};
    case TokenClass::InOut:
        return {0x6d28d9, 0xc4a5ff};
    case TokenClass::Local:
        return {0x1f2328, 0xd6dae0};
    case TokenClass::Global:
        return {0x0550ae, 0x9ecbff, false, true};
    case TokenClass::Instance:
        return {0x57606a, 0xc3cbd6, true};
    case TokenClass::Function:
        return {0x5b21b6, 0xd2a8ff};
    case TokenClass::Label:
        return {0x8a5a00, 0xe8c46a, true};
    case TokenClass::Address:
        return {0x9a3412, 0xff9e6d};
    case TokenClass::Step:
        return {0x0b6e75, 0x5cc8cf, true};
    case TokenClass::Error:
        return {0xc01c28, 0xff7b72};
    }
    return {0, 0xffffff};
}
constexpr int kClasses = static_cast<int>(TokenClass::Error) + 1;
} // namespace

StLexer::StLexer(QsciScintilla* parent) : QsciLexerCustom(parent) { applyTheme(); }

QString StLexer::description(int style) const {
    return style >= 0 && style < kClasses ? QString::number(style) : QString();
}

QColor StLexer::colourOf(TokenClass kind) const {
    const Ink ink = inkOf(kind);
    return kit::legible(QColor::fromRgb(kit::colors().dark ? ink.dark : ink.light));
}

void StLexer::applyTheme() {
    QFont font = QFontDatabase::systemFont(QFontDatabase::FixedFont);
    const QStringList families = QFontDatabase::families();
    for (const char* family : {"JetBrains Mono", "Noto Sans Mono", "DejaVu Sans Mono"})
        if (families.contains(QLatin1String(family))) {
            font = QFont(QLatin1String(family));
            break;
        }
    font.setPointSize(10);
    font.setStyleHint(QFont::Monospace);
    setDefaultFont(font);
    setDefaultPaper(kit::colors().base);
    setDefaultColor(kit::colors().text);
    for (int i = 0; i < kClasses; ++i) {
        const Ink ink = inkOf(static_cast<TokenClass>(i));
        QFont styled = font;
        styled.setBold(ink.bold);
        styled.setItalic(ink.italic);
        setFont(styled, i);
        setColor(colourOf(static_cast<TokenClass>(i)), i);
        setPaper(kit::colors().base, i);
    }
}

void StLexer::setModel(const std::shared_ptr<const analysis::CodeModel>& model, std::optional<FileId> file,
                       std::string_view analysedText) {
    m_classOfName.clear();
    m_exact.clear();
    m_analysedText = std::string(analysedText);
    if (!model || !file) return;
    m_exact = model->colours(*file);
    for (const analysis::ColouredToken& token : m_exact)
        if (token.kind >= TokenClass::Constant || token.kind == TokenClass::Type)
            m_classOfName.emplace(foldCase(analysedText.substr(token.begin, token.end - token.begin)), token.kind);
}

namespace {

auto endsBefore(uint32_t at) {
    return [at](const analysis::ColouredToken& token) { return token.end <= at; };
}

/// What a token is by its kind alone; a name needs more, and is Plain here.
TokenClass classOf(const lex::Token& token, std::string_view words) {
    switch (token.kind) {
    case lex::TokenKind::Identifier:
        return token.soft != lex::SoftWord::None ? TokenClass::Keyword : TokenClass::Plain;
    case lex::TokenKind::IntegerLiteral:
    case lex::TokenKind::RealLiteral:
    case lex::TokenKind::DurationLiteral:
    case lex::TokenKind::DateLiteral:
    case lex::TokenKind::TimeOfDayLiteral:
    case lex::TokenKind::DateTimeLiteral:
        return TokenClass::Number;
    case lex::TokenKind::StringLiteral:
    case lex::TokenKind::WstringLiteral:
        return TokenClass::Text;
    case lex::TokenKind::TypedPrefix:
        return TokenClass::Type;
    case lex::TokenKind::DirectAddress:
        return TokenClass::Address;
    case lex::TokenKind::Pragma:
        return TokenClass::Pragma;
    case lex::TokenKind::True:
    case lex::TokenKind::False:
        return TokenClass::Constant;
    case lex::TokenKind::Error: // a comment may go on behind the piece
        return words.starts_with("(*") || words.starts_with("/*") ? TokenClass::Comment : TokenClass::Error;
    default:
        return lex::isKeyword(token.kind) ? TokenClass::Keyword : TokenClass::Operator;
    }
}

/// An instruction of a list: the first word of a line, or behind a label, and no statement.
bool isInstruction(const lex::TokenList& list, size_t i, std::string_view piece) {
    const auto kindAt = [&](size_t at) {
        return at < list.tokens.size() ? list.tokens[at].kind : lex::TokenKind::EndOfFile;
    };
    const auto isNewLine = [&](size_t at) { // first on its line
        return at == 0 ||
               piece.substr(list.tokens[at - 1].end, list.tokens[at].begin - list.tokens[at - 1].end).find('\n') !=
                   std::string_view::npos;
    };
    const lex::Token& token = list.tokens[i];
    if (!analysis::isListOperator(piece.substr(token.begin, token.end - token.begin))) return false;
    if (!isNewLine(i) && !(i >= 2 && kindAt(i - 1) == lex::TokenKind::Colon && isNewLine(i - 2))) return false;
    const lex::TokenKind next =
        isNewLine(std::min(i + 1, list.tokens.size() - 1)) ? lex::TokenKind::EndOfFile : kindAt(i + 1);
    return next != lex::TokenKind::Assign && next != lex::TokenKind::Dot && next != lex::TokenKind::Colon &&
           next != lex::TokenKind::LeftBracket;
}

} // namespace

/// Reads a piece of the text, which begins at `at`, and adds its colours.
void StLexer::addColours(std::string_view piece, uint32_t at, std::vector<analysis::ColouredToken>& tokens) const {
    diagnostics::Sink sink;
    const lex::TokenList list = lex::tokenize(FileId(size_t(0)), std::string(piece), sink);
    for (size_t i = 0; i < list.tokens.size(); ++i) {
        const lex::Token& token = list.tokens[i];
        if (token.kind == lex::TokenKind::EndOfFile) continue;
        const std::string_view words = piece.substr(token.begin, token.end - token.begin);
        TokenClass kind = classOf(token, words);
        if (token.kind == lex::TokenKind::Identifier) {
            const auto known = m_classOfName.find(foldCase(words));
            if (known != m_classOfName.end()) kind = known->second;
            if (kind == TokenClass::Plain && isInstruction(list, i, piece)) kind = TokenClass::Keyword;
        }
        tokens.push_back({at + token.begin, at + token.end, kind});
    }
    for (const lex::Comment& comment : list.comments)
        tokens.push_back({at + comment.begin, at + comment.end, TokenClass::Comment});
    std::sort(tokens.begin(), tokens.end(), [](const auto& a, const auto& b) { return a.begin < b.begin; });
}

/// The colours of what is shown from `first` to `end`, and perhaps of more before it.
std::vector<analysis::ColouredToken> StLexer::coloursOf(std::string_view text, uint32_t first, uint32_t end) const {
    std::vector<analysis::ColouredToken> tokens;
    if (text == m_analysedText && !m_exact.empty()) {
        const auto from = std::partition_point(m_exact.begin(), m_exact.end(), endsBefore(first));
        const auto to = std::partition_point(from, m_exact.end(),
                                             [&](const analysis::ColouredToken& token) { return token.begin < end; });
        tokens.assign(from, to);
        return tokens;
    }
    // What lies before the first change keeps its colours; behind it only what is asked for is read again.
    const auto same = static_cast<uint32_t>(
        std::mismatch(text.begin(), text.end(), m_analysedText.begin(), m_analysedText.end()).first - text.begin());
    const auto kept =
        same == 0 ? m_exact.begin() : std::partition_point(m_exact.begin(), m_exact.end(), endsBefore(same - 1));
    tokens.assign(std::min(kept, std::partition_point(m_exact.begin(), m_exact.end(), endsBefore(first))), kept);
    const uint32_t restart = kept == m_exact.begin() ? 0 : std::prev(kept)->end;
    const auto lineEnd = std::min(text.size(), text.find('\n', std::max<size_t>(end, restart)));
    addColours(text.substr(restart, lineEnd - restart), restart, tokens);
    return tokens;
}

void StLexer::styleText(int start, int end) {
    QsciScintilla* view = editor();
    if (!view || start < 0 || end <= start) return;
    const auto length = static_cast<size_t>(view->SendScintilla(QsciScintillaBase::SCI_GETLENGTH));
    // Scintilla's own bytes: a large text is not copied for every key.
    const auto* bytes =
        reinterpret_cast<const char*>(view->SendScintillaPtrResult(QsciScintillaBase::SCI_GETCHARACTERPOINTER));
    const auto tokens =
        coloursOf(std::string_view(bytes, length), static_cast<uint32_t>(start), static_cast<uint32_t>(end));
    startStyling(start);
    auto at = static_cast<uint32_t>(start);
    const auto last = static_cast<uint32_t>(std::min<size_t>(length, static_cast<size_t>(end)));
    // setStyling counts in bytes; gaps are white space.
    const auto style = [&](uint32_t upTo, TokenClass kind) {
        upTo = std::min(upTo, last);
        if (upTo <= at) return;
        view->SendScintilla(QsciScintillaBase::SCI_SETSTYLING, static_cast<unsigned long>(upTo - at),
                            static_cast<long>(kind));
        at = upTo;
    };
    for (const analysis::ColouredToken& token : tokens) {
        style(token.begin, TokenClass::Plain);
        style(token.end, token.kind);
    }
    style(last, TokenClass::Plain);
}

} // namespace plc::editor
