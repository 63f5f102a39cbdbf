#include "editor/text/st_lexer.h"

#include "editor/kit/theme.h"
#include "runtime/base/text.h"

#include <Qsci/qsciscintilla.h>
#include <QFontDatabase>

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
    case TokenClass::Plain: return {0x1f2328, 0xd6dae0};
    case TokenClass::Keyword: return {0x0a3fa8, 0x7aa8ff, true};
    case TokenClass::Type: return {0x0b6e75, 0x5cc8cf};
    case TokenClass::Number: return {0x7a3e00, 0xe0a870};
    case TokenClass::Text: return {0x8a1c3c, 0xf08fa8};
    case TokenClass::Comment: return {0x5c6b5e, 0x8fa392, false, true};
    case TokenClass::Pragma: return {0x6b5b95, 0xb3a4dd};
    case TokenClass::Operator: return {0x444b55, 0xaab2bd};
    case TokenClass::Constant: return {0x7a3e00, 0xe0a870, true};
    case TokenClass::EnumValue: return {0x8a5a00, 0xe8c46a};
    case TokenClass::Input: return {0x116329, 0x7bd88f};
    case TokenClass::Output: return {0x9a3412, 0xff9e6d};
    case TokenClass::InOut: return {0x6d28d9, 0xc4a5ff};
    case TokenClass::Local: return {0x1f2328, 0xd6dae0};
    case TokenClass::Global: return {0x0550ae, 0x9ecbff, false, true};
    case TokenClass::Instance: return {0x57606a, 0xc3cbd6, true};
    case TokenClass::Function: return {0x5b21b6, 0xd2a8ff};
    case TokenClass::Label: return {0x8a5a00, 0xe8c46a, true};
    case TokenClass::Address: return {0x9a3412, 0xff9e6d};
    case TokenClass::Step: return {0x0b6e75, 0x5cc8cf, true};
    case TokenClass::Error: return {0xc01c28, 0xff7b72};
    }
    return {0, 0xffffff};
}
constexpr int kClasses = static_cast<int>(TokenClass::Error) + 1;
} // namespace

StLexer::StLexer(QsciScintilla* parent) : QsciLexerCustom(parent) { applyTheme(); }

QString StLexer::description(int style) const { return style >= 0 && style < kClasses ? QString::number(style) : QString(); }

QColor StLexer::colourOf(TokenClass kind) const {
    const Ink ink = inkOf(kind);
    return QColor::fromRgb(kit::colors().dark ? ink.dark : ink.light);
}

void StLexer::applyTheme() {
    QFont font = QFontDatabase::systemFont(QFontDatabase::FixedFont);
    const QFontDatabase fonts;
    for (const char* family : {"JetBrains Mono", "Noto Sans Mono", "DejaVu Sans Mono"})
        if (fonts.families().contains(QLatin1String(family))) {
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
        setColor(QColor::fromRgb(kit::colors().dark ? ink.dark : ink.light), i);
        setPaper(kit::colors().base, i);
    }
}

void StLexer::setModel(const std::shared_ptr<const analysis::CodeModel>& model, std::optional<FileId> file, std::string_view analysedText) {
    m_classOfName.clear();
    m_exact.clear();
    m_analysedText = std::string(analysedText);
    if (!model || !file) return;
    m_exact = model->colours(*file);
    for (const analysis::ColouredToken& token : m_exact)
        if (token.kind >= TokenClass::Constant || token.kind == TokenClass::Type)
            m_classOfName.emplace(foldCase(analysedText.substr(token.begin, token.end - token.begin)), token.kind);
}

void StLexer::styleText(int, int) {
    QsciScintilla* view = editor();
    if (!view) return;
    const auto length = static_cast<size_t>(view->SendScintilla(QsciScintillaBase::SCI_GETLENGTH));
    std::string text(length + 1, '\0');
    view->SendScintilla(QsciScintillaBase::SCI_GETTEXT, static_cast<unsigned long>(length + 1), text.data());
    text.resize(length);

    std::vector<analysis::ColouredToken> tokens;
    if (text == m_analysedText && !m_exact.empty()) {
        tokens = m_exact;
    } else {
        diagnostics::Sink sink;
        const lex::TokenList list = lex::tokenize(FileId(size_t(0)), text, sink);
        for (const lex::Token& token : list.tokens) {
            TokenClass kind = lex::isKeyword(token.kind) ? TokenClass::Keyword : TokenClass::Operator;
            switch (token.kind) {
            case lex::TokenKind::Identifier: {
                const auto known = m_classOfName.find(foldCase(std::string_view(text).substr(token.begin, token.end - token.begin)));
                kind = known != m_classOfName.end() ? known->second : token.soft != lex::SoftWord::None ? TokenClass::Keyword : TokenClass::Plain;
                break;
            }
            case lex::TokenKind::IntegerLiteral:
            case lex::TokenKind::RealLiteral:
            case lex::TokenKind::DurationLiteral:
            case lex::TokenKind::DateLiteral:
            case lex::TokenKind::TimeOfDayLiteral:
            case lex::TokenKind::DateTimeLiteral: kind = TokenClass::Number; break;
            case lex::TokenKind::StringLiteral:
            case lex::TokenKind::WstringLiteral: kind = TokenClass::Text; break;
            case lex::TokenKind::TypedPrefix: kind = TokenClass::Type; break;
            case lex::TokenKind::DirectAddress: kind = TokenClass::Address; break;
            case lex::TokenKind::Pragma: kind = TokenClass::Pragma; break;
            case lex::TokenKind::True:
            case lex::TokenKind::False: kind = TokenClass::Constant; break;
            case lex::TokenKind::Error: kind = TokenClass::Error; break;
            case lex::TokenKind::EndOfFile: continue;
            default: break;
            }
            tokens.push_back({token.begin, token.end, kind});
        }
        for (const lex::Comment& comment : list.comments) tokens.push_back({comment.begin, comment.end, TokenClass::Comment});
        std::sort(tokens.begin(), tokens.end(), [](const auto& a, const auto& b) { return a.begin < b.begin; });
    }
    startStyling(0);
    uint32_t at = 0;
    // setStyling counts in bytes; gaps are white space.
    const auto style = [&](uint32_t upTo, TokenClass kind) {
        if (upTo <= at) return;
        view->SendScintilla(QsciScintillaBase::SCI_SETSTYLING, static_cast<unsigned long>(upTo - at), static_cast<long>(kind));
        at = upTo;
    };
    for (const analysis::ColouredToken& token : tokens) {
        style(token.begin, TokenClass::Plain);
        style(std::min<uint32_t>(token.end, static_cast<uint32_t>(text.size())), token.kind);
    }
    style(static_cast<uint32_t>(text.size()), TokenClass::Plain);
}

} // namespace plc::editor
