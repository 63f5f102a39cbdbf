// Sections of variables and the declarations in them, also those of VAR_CONFIG and VAR_ACCESS.
#include "runtime/compiler/parse/parser_state.h"

#include "runtime/base/text.h"

namespace plc::parse {

using messages::Thing;

namespace {

SectionKind sectionOf(TokenKind kind) {
    switch (kind) {
    case TokenKind::VarInput:
        return SectionKind::Input;
    case TokenKind::VarOutput:
        return SectionKind::Output;
    case TokenKind::VarInOut:
        return SectionKind::InOut;
    case TokenKind::VarTemp:
        return SectionKind::Temp;
    case TokenKind::VarStat:
        return SectionKind::Stat;
    case TokenKind::VarInst:
        return SectionKind::Inst;
    case TokenKind::VarGlobal:
        return SectionKind::Global;
    case TokenKind::VarExternal:
        return SectionKind::External;
    case TokenKind::VarAccess:
        return SectionKind::Access;
    case TokenKind::VarConfig:
        return SectionKind::Config;
    default:
        return SectionKind::Var;
    }
}

/// What the word says of a section; null: it is no qualifier.
bool* qualifierOf(VarSection& section, SoftWord word) {
    switch (word) {
    case SoftWord::Constant:
        return &section.constant;
    case SoftWord::Retain:
        return &section.retain;
    case SoftWord::NonRetain:
        return &section.nonRetain;
    case SoftWord::Persistent:
        return &section.persistent;
    case SoftWord::Public:
        return &section.isPublic;
    case SoftWord::Private:
        return &section.isPrivate;
    case SoftWord::Protected:
        return &section.isProtected;
    case SoftWord::Internal:
        return &section.isInternal;
    default:
        return nullptr;
    }
}

} // namespace

bool Parser::atVarSection() const {
    switch (kind()) {
    case TokenKind::Var:
    case TokenKind::VarInput:
    case TokenKind::VarOutput:
    case TokenKind::VarInOut:
    case TokenKind::VarTemp:
    case TokenKind::VarStat:
    case TokenKind::VarInst:
    case TokenKind::VarGlobal:
    case TokenKind::VarExternal:
    case TokenKind::VarAccess:
    case TokenKind::VarConfig:
        return true;
    default:
        return atGenericSection();
    }
}

/// VAR_GENERIC CONSTANT of CODESYS, constants whose values each declaration of an instance gives: Buffer<100>. A name
/// anywhere else.
bool Parser::atGenericSection() const {
    return at(TokenKind::Identifier) && kind(1) == TokenKind::Identifier && isWord(textOf(peek()), "VAR_GENERIC") &&
           peek(1).soft == SoftWord::Constant;
}

/// CONSTANT, RETAIN, …; a variable may have such a name.
void Parser::parseQualifiers(VarSection& section) {
    while (at(TokenKind::Identifier) && kind(1) != TokenKind::Colon && kind(1) != TokenKind::Comma &&
           kind(1) != TokenKind::At) {
        bool* qualifier = qualifierOf(section, peek().soft);
        if (!qualifier) return;
        *qualifier = true;
        advance();
    }
}

/// Is there an END_VAR for the open section further on, before another section or the end of the unit?
bool Parser::isSectionClosed() const {
    for (size_t i = m_at; i < m_tokens.size(); ++i) {
        const TokenKind k = m_tokens[i].kind;
        if (k == TokenKind::EndVar) return true;
        if (k >= TokenKind::Var && k <= TokenKind::VarConfig) return false;
        if (k == TokenKind::EndProgram || k == TokenKind::EndFunction || k == TokenKind::EndFunctionBlock ||
            k == TokenKind::EndClass || k == TokenKind::EndMethod || k == TokenKind::EndTest)
            return false;
    }
    return false;
}

/// What stands here ends a section whose END_VAR is missing.
bool Parser::atOpenSectionsEnd() const {
    const bool isCode = startsStatement() && !atName();
    const bool isAssigned = atName() && kind(1) == TokenKind::Assign;
    const bool ends = atEnd() || atStatementEnd() || atVarSection() || isCode || atDeclaration() ||
                      (isAssigned && m_lastErrorAt != m_at);
    return ends && !((isAssigned || isCode) && isSectionClosed());
}

VarSection* Parser::parseVarSection() {
    VarSection* section = make<VarSection>();
    section->pragmas = pragmasHere();
    const size_t first = mark();
    const Token opening = peek();
    section->kind = sectionOf(kind());
    if (atGenericSection()) section->pragmas.push_back({rangeOf(peek()), textOf(peek()), "VAR_GENERIC", {}, false});
    advance();
    parseQualifiers(*section);
    while (!at(TokenKind::EndVar)) {
        if (take(TokenKind::Semicolon)) continue;
        if (atOpenSectionsEnd()) {
            section->range = rangeFrom(first);
            insertFix(report(rangeOf(opening), findings::MissingEnd(Verbatim("END_VAR"), shown(opening))), "\nEND_VAR");
            return section;
        }
        const size_t before = mark();
        VarDecl* declaration = section->kind == SectionKind::Access || section->kind == SectionKind::Config
                                   ? parseConfigDecl(section->kind)
                                   : parseVarDecl();
        if (declaration) section->declarations.push_back(declaration);
        if (mark() == before) advance();
    }
    advance();
    take(TokenKind::Semicolon);
    section->range = rangeFrom(first);
    return section;
}

/// AT %IX0.0, before or after the colon.
void Parser::parseAddress(VarDecl& decl) {
    if (!take(TokenKind::At)) return;
    if (!at(TokenKind::DirectAddress)) return expected(phrases::AnAddress());
    decl.address = textOf(peek());
    decl.addressRange = rangeOf(peek());
    advance();
}

/// Goes on behind a declaration that went wrong: at its semicolon, or at the line on which the next one begins.
void Parser::skipVarDecl(size_t first) {
    while (!atEnd() && !atAny({TokenKind::Semicolon, TokenKind::EndVar, TokenKind::EndStruct, TokenKind::EndUnion}) &&
           !atVarSection()) {
        if (peek().afterNewline && m_at != first &&
            (atStatementEnd() || (atName() && (kind(1) == TokenKind::Colon || kind(1) == TokenKind::Comma))))
            break;
        advance();
    }
    take(TokenKind::Semicolon);
    m_lastErrorAt = SIZE_MAX;
}

/// The colon before a type. A missing one and `x := INT;` are reported with a fix, and the declaration goes on.
bool Parser::parseColon() {
    if (take(TokenKind::Colon)) return true;
    const bool typeFollows =
        at(TokenKind::Array) || at(TokenKind::Struct) ||
        (at(TokenKind::Identifier) && (kind(1) == TokenKind::Semicolon || kind(1) == TokenKind::Assign ||
                                       kind(1) == TokenKind::LeftParen || kind(1) == TokenKind::To));
    if (typeFollows) {
        if (auto* d =
                report(afterPrevious().begin > 0 ? rangeOf(previous()) : rangeOf(peek()), findings::MissingColon()))
            d->fixes.push_back({fixes::Insert(Verbatim(":")), {{afterPrevious(), " :"}}});
        m_lastErrorAt = SIZE_MAX;
        return true;
    }
    if (at(TokenKind::Assign) && kind(1) == TokenKind::Identifier &&
        (kind(2) == TokenKind::Semicolon || kind(2) == TokenKind::Assign)) { // x := INT;
        takeMistaken(Verbatim(":"), Verbatim(":="));
        return true;
    }
    const bool mayBeList = atName() && !peek().afterNewline && kind(1) == TokenKind::Colon;
    expected(mayBeList ? Thing(phrases::OneOf({{","}}, Verbatim(":"))) : Thing(Verbatim(":")));
    return false;
}

/// One sign in the place of another: reported with its fix, and taken for it.
void Parser::takeMistaken(Verbatim meant, Verbatim written) {
    const SourceRange range = rangeOf(peek());
    if (auto* d = report(range, findings::Expected(meant, written)))
        d->fixes.push_back({fixes::Write(meant), {{range, std::string(meant.text)}}});
    advance();
}

/// The semicolon, or the best place to go on.
void Parser::endVarDecl(size_t first) {
    if (take(TokenKind::Semicolon)) {
        m_lastErrorAt = SIZE_MAX;
        return;
    }
    if (m_lastErrorAt == m_at) return skipVarDecl(first);
    const bool another = atName() && (kind(1) == TokenKind::Colon || kind(1) == TokenKind::Comma);
    if (onNewLine() || atStatementEnd() || atVarSection() || another) return missingSemicolon(false);
    report(rangeOf(peek()), findings::UnexpectedToken(shown(peek())));
    skipVarDecl(first);
}

/// a, b AT %IX0.0 : BOOL := TRUE;
VarDecl* Parser::parseVarDecl() {
    VarDecl* decl = make<VarDecl>();
    decl->pragmas = pragmasHere();
    const size_t first = mark();
    if (!at(TokenKind::At)) {
        if (!atName() && !atKeywordAsName()) {
            expected(phrases::AVariablesName());
            skipVarDecl(first);
            return nullptr;
        }
        do decl->names.push_back(takeName(phrases::AVariablesName()));
        while (take(TokenKind::Comma));
    }
    parseAddress(*decl);
    if (!parseColon()) {
        skipVarDecl(first);
        return nullptr;
    }
    parseAddress(*decl); // L1 : AT %IX0.0 BOOL
    decl->type = parseTypeSpec(false);
    parseEdge(*decl);
    if (at(TokenKind::Equal)) {
        takeMistaken(Verbatim(":="), Verbatim("="));
        decl->initial = parseInitialiser(decl->type);
    } else if (take(TokenKind::Assign) || take(TokenKind::RefAssign)) {
        decl->initial = parseInitialiser(decl->type);
    }
    endVarDecl(first);
    decl->range = rangeFrom(first);
    decl->comment = commentBehind(sourceIndex(m_at - 1));
    if (decl->comment.empty()) decl->comment = docCommentAbove(sourceIndex(first));
    return decl;
}

/// R_EDGE or F_EDGE behind the type of an input.
void Parser::parseEdge(VarDecl& decl) {
    if (!at(TokenKind::Identifier)) return;
    if (isWord(textOf(peek()), "R_EDGE")) decl.edge = VarEdge::Rising;
    if (isWord(textOf(peek()), "F_EDGE")) decl.edge = VarEdge::Falling;
    if (decl.edge != VarEdge::None) advance();
}

/// R1.P1.values[3], or %QX0.0.
void Parser::parseConfigTarget(VarDecl& decl) {
    while (atName()) {
        const Name name = takeName();
        while (at(TokenKind::LeftBracket))
            skipTo({TokenKind::RightBracket, TokenKind::Semicolon, TokenKind::EndVar}), take(TokenKind::RightBracket);
        const SourceRange whole = joined(name.range, rangeOf(previous())); // an element: values[3]
        decl.configPath.push_back(
            whole.end == name.range.end ? name : Name{m_text.substr(whole.begin, whole.end - whole.begin), whole});
        if (!take(TokenKind::Dot)) return;
    }
    if (!at(TokenKind::DirectAddress)) return expected(phrases::AVariablesPath());
    decl.address = textOf(peek());
    decl.addressRange = rangeOf(peek());
    advance();
}

/// VAR_CONFIG:  R1.P1.x AT %QX0.0 : BOOL := TRUE;      VAR_ACCESS:  name : R1.P1.y : REAL READ_WRITE;
VarDecl* Parser::parseConfigDecl(SectionKind section) {
    VarDecl* decl = make<VarDecl>();
    decl->pragmas = pragmasHere();
    const size_t first = mark();
    if (section == SectionKind::Access) {
        const Name name = takeName(phrases::AnAccessName());
        if (name.isValid()) decl->names.push_back(name);
        expect(TokenKind::Colon);
    }
    parseConfigTarget(*decl);
    parseAddress(*decl);
    if (expect(TokenKind::Colon)) decl->type = parseTypeSpec(false);
    if (take(SoftWord::ReadOnly))
        decl->isReadOnly = true;
    else
        take(SoftWord::ReadWrite);
    if (take(TokenKind::Assign)) decl->initial = parseInitialiser(decl->type);
    if (!take(TokenKind::Semicolon)) {
        if (m_lastErrorAt != m_at && (onNewLine() || at(TokenKind::EndVar)))
            missingSemicolon(false);
        else {
            if (m_lastErrorAt != m_at) report(rangeOf(peek()), findings::UnexpectedToken(shown(peek())));
            skipTo({TokenKind::Semicolon, TokenKind::EndVar});
            take(TokenKind::Semicolon);
        }
    }
    decl->range = rangeFrom(first);
    decl->comment = commentBehind(sourceIndex(m_at - 1));
    return decl;
}

/// Also the form of edition 1 for arrays, without brackets: `:= 1, 2, 3(0)`.
Expr* Parser::parseInitialiser(const TypeSpec* type) {
    const bool outer = std::exchange(m_inInitialiser, true);
    Expr* value = parseExpression();
    const bool isArray = type && (type->kind == TypeSpecKind::Array || type->kind == TypeSpecKind::OpenArray);
    if (!isArray) decimalComma(value);
    if (isArray && value->kind != ExprKind::ArrayInit && (at(TokenKind::Comma) || value->kind == ExprKind::Repeat)) {
        Expr* list = make<Expr>();
        list->kind = ExprKind::ArrayInit;
        list->arguments.push_back({.value = value, .range = value->range});
        while (take(TokenKind::Comma)) {
            Expr* element = parseExpression();
            list->arguments.push_back({.value = element, .range = element->range});
        }
        list->range = joined(value->range, rangeOf(previous()));
        setHeight(*list);
        value = list;
    }
    m_inInitialiser = outer;
    return value;
}

} // namespace plc::parse
