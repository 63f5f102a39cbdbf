#include "runtime/compiler/parse/parser_state.h"

#include "runtime/base/text.h"

#include <array>

namespace plc::parse {

using messages::Thing;

namespace {

bool isIntegerType(std::string_view name) {
    static constexpr std::array<std::string_view, 14> types = {"SINT",  "INT",   "DINT",  "LINT", "USINT",
                                                               "UINT",  "UDINT", "ULINT", "BYTE", "WORD",
                                                               "DWORD", "LWORD", "BOOL",  "BIT"};
    for (std::string_view type : types)
        if (name.size() == type.size() && equalsIgnoringCase(name, type)) return true;
    return false;
}

bool isWord(std::string_view text, std::string_view word) {
    return text.size() == word.size() && equalsIgnoringCase(text, word);
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
        return false;
    }
}

VarSection* Parser::parseVarSection() {
    VarSection* section = make<VarSection>();
    section->pragmas = pragmasHere();
    const size_t first = mark();
    const Token opening = peek();
    switch (kind()) {
    case TokenKind::VarInput:
        section->kind = SectionKind::Input;
        break;
    case TokenKind::VarOutput:
        section->kind = SectionKind::Output;
        break;
    case TokenKind::VarInOut:
        section->kind = SectionKind::InOut;
        break;
    case TokenKind::VarTemp:
        section->kind = SectionKind::Temp;
        break;
    case TokenKind::VarStat:
        section->kind = SectionKind::Stat;
        break;
    case TokenKind::VarInst:
        section->kind = SectionKind::Inst;
        break;
    case TokenKind::VarGlobal:
        section->kind = SectionKind::Global;
        break;
    case TokenKind::VarExternal:
        section->kind = SectionKind::External;
        break;
    case TokenKind::VarAccess:
        section->kind = SectionKind::Access;
        break;
    case TokenKind::VarConfig:
        section->kind = SectionKind::Config;
        break;
    default:
        break;
    }
    advance();
    // qualifiers; a variable may have such a name
    while (at(TokenKind::Identifier) && kind(1) != TokenKind::Colon && kind(1) != TokenKind::Comma &&
           kind(1) != TokenKind::At) {
        switch (peek().soft) {
        case SoftWord::Constant:
            section->constant = true;
            break;
        case SoftWord::Retain:
            section->retain = true;
            break;
        case SoftWord::NonRetain:
            section->nonRetain = true;
            break;
        case SoftWord::Persistent:
            section->persistent = true;
            break;
        case SoftWord::Public:
            section->isPublic = true;
            break;
        case SoftWord::Private:
            section->isPrivate = true;
            break;
        case SoftWord::Protected:
            section->isProtected = true;
            break;
        case SoftWord::Internal:
            section->isInternal = true;
            break;
        default:
            goto declarations;
        }
        advance();
    }
declarations:
    while (!at(TokenKind::EndVar)) {
        if (take(TokenKind::Semicolon)) continue;
        const bool code = startsStatement() && !atName();
        const bool assigned = atName() && kind(1) == TokenKind::Assign;
        if (atEnd() || atStatementEnd() || atVarSection() || code || atDeclaration() ||
            (assigned && m_lastErrorAt != m_at)) {
            bool closed = false; // is there an END_VAR for us further on?
            if (assigned || code)
                for (size_t i = m_at; i < m_tokens.size() && !closed; ++i) {
                    const TokenKind k = m_tokens[i].kind;
                    if (k == TokenKind::EndVar)
                        closed = true;
                    else if (k >= TokenKind::Var && k <= TokenKind::VarConfig)
                        break;
                    else if (k == TokenKind::EndProgram || k == TokenKind::EndFunction ||
                             k == TokenKind::EndFunctionBlock || k == TokenKind::EndClass ||
                             k == TokenKind::EndMethod || k == TokenKind::EndTest)
                        break;
                }
            if (!closed) {
                section->range = rangeFrom(first);
                insertFix(report(rangeOf(opening), findings::MissingEnd(Verbatim("END_VAR"), shown(opening))),
                          "\nEND_VAR");
                return section;
            }
        }
        const size_t before = mark();
        VarDecl* declaration = section->kind == SectionKind::Access || section->kind == SectionKind::Config
                                   ? parseConfigDecl(section->kind)
                                   : parseVarDecl(section->kind);
        if (declaration) section->declarations.push_back(declaration);
        if (mark() == before) advance();
    }
    advance();
    take(TokenKind::Semicolon);
    section->range = rangeFrom(first);
    return section;
}

/// a, b AT %IX0.0 : BOOL := TRUE;
VarDecl* Parser::parseVarDecl(SectionKind section) {
    VarDecl* decl = make<VarDecl>();
    decl->pragmas = pragmasHere();
    const size_t first = mark();
    const auto takeAddress = [&] {
        if (!take(TokenKind::At)) return;
        if (!at(TokenKind::DirectAddress)) return expected(phrases::AnAddress());
        decl->address = textOf(peek());
        decl->addressRange = rangeOf(peek());
        advance();
    };
    const auto fail = [&] {
        while (!atEnd() &&
               !atAny({TokenKind::Semicolon, TokenKind::EndVar, TokenKind::EndStruct, TokenKind::EndUnion}) &&
               !atVarSection()) {
            if (peek().afterNewline && m_at != first &&
                (atStatementEnd() || (atName() && (kind(1) == TokenKind::Colon || kind(1) == TokenKind::Comma))))
                break;
            advance();
        }
        take(TokenKind::Semicolon);
        m_lastErrorAt = SIZE_MAX;
    };
    if (!at(TokenKind::At)) {
        if (!atName() && !atKeywordAsName()) {
            expected(phrases::AVariablesName());
            fail();
            return nullptr;
        }
        do decl->names.push_back(takeName(phrases::AVariablesName()));
        while (take(TokenKind::Comma));
    }
    takeAddress();
    if (!take(TokenKind::Colon)) {
        const bool assign = at(TokenKind::Assign);
        const bool typeFollows =
            at(TokenKind::Array) || at(TokenKind::Struct) ||
            (at(TokenKind::Identifier) && (kind(1) == TokenKind::Semicolon || kind(1) == TokenKind::Assign ||
                                           kind(1) == TokenKind::LeftParen || kind(1) == TokenKind::To));
        if (typeFollows) {
            if (auto* d =
                    report(afterPrevious().begin > 0 ? rangeOf(previous()) : rangeOf(peek()), findings::MissingColon()))
                d->fixes.push_back({fixes::Insert(Verbatim(":")), {{afterPrevious(), " :"}}});
            m_lastErrorAt = SIZE_MAX;
        } else if (assign && kind(1) == TokenKind::Identifier &&
                   (kind(2) == TokenKind::Semicolon || kind(2) == TokenKind::Assign)) { // x := INT;
            const SourceRange range = rangeOf(peek());
            if (auto* d = report(range, findings::Expected(Verbatim(":"), Verbatim(":="))))
                d->fixes.push_back({fixes::Write(Verbatim(":")), {{range, ":"}}});
            advance();
        } else {
            const bool mayBeList = atName() && !peek().afterNewline && kind(1) == TokenKind::Colon;
            expected(mayBeList ? Thing(phrases::OneOf({{","}}, Verbatim(":"))) : Thing(Verbatim(":")));
            fail();
            decl->range = rangeFrom(first);
            return nullptr;
        }
    }
    takeAddress(); // L1 : AT %IX0.0 BOOL
    decl->type = parseTypeSpec(false);
    if (at(TokenKind::Identifier)) {
        if (isWord(textOf(peek()), "R_EDGE")) decl->edge = VarEdge::Rising;
        if (isWord(textOf(peek()), "F_EDGE")) decl->edge = VarEdge::Falling;
        if (decl->edge != VarEdge::None) advance();
    }
    if (take(TokenKind::Assign) || take(TokenKind::RefAssign))
        decl->initial = parseInitialiser(decl->type);
    else if (at(TokenKind::Equal)) {
        const SourceRange range = rangeOf(peek());
        if (auto* d = report(range, findings::Expected(Verbatim(":="), Verbatim("="))))
            d->fixes.push_back({fixes::Write(Verbatim(":=")), {{range, ":="}}});
        advance();
        decl->initial = parseInitialiser(decl->type);
    }
    (void)section;
    if (!take(TokenKind::Semicolon)) {
        if (m_lastErrorAt == m_at)
            fail();
        else if (onNewLine() || atStatementEnd() || atVarSection())
            missingSemicolon(false);
        else {
            const bool another = atName() && (kind(1) == TokenKind::Colon || kind(1) == TokenKind::Comma);
            if (another)
                missingSemicolon(false);
            else {
                report(rangeOf(peek()), findings::UnexpectedToken(shown(peek())));
                fail();
            }
        }
    } else {
        m_lastErrorAt = SIZE_MAX;
    }
    decl->range = rangeFrom(first);
    decl->comment = commentBehind(sourceIndex(m_at - 1));
    if (decl->comment.empty()) {
        const uint32_t index = sourceIndex(first);
        decl->comment = docCommentAbove(index);
    }
    return decl;
}

/// VAR_CONFIG:  R1.P1.x AT %QX0.0 : BOOL := TRUE;      VAR_ACCESS:  name : R1.P1.y : REAL READ_WRITE;
VarDecl* Parser::parseConfigDecl(SectionKind section) {
    VarDecl* decl = make<VarDecl>();
    decl->pragmas = pragmasHere();
    const size_t first = mark();
    const auto takeTarget = [&] {
        while (atName()) {
            const Name name = takeName();
            while (at(TokenKind::LeftBracket))
                skipTo({TokenKind::RightBracket, TokenKind::Semicolon, TokenKind::EndVar}),
                    take(TokenKind::RightBracket);
            const SourceRange whole = joined(name.range, rangeOf(previous())); // an element: values[3]
            decl->configPath.push_back(
                whole.end == name.range.end ? name : Name{m_text.substr(whole.begin, whole.end - whole.begin), whole});
            if (!take(TokenKind::Dot)) return;
        }
        if (!at(TokenKind::DirectAddress)) return expected(phrases::AVariablesPath());
        decl->address = textOf(peek());
        decl->addressRange = rangeOf(peek());
        advance();
    };
    if (section == SectionKind::Access) {
        const Name name = takeName(phrases::AnAccessName());
        if (name.isValid()) decl->names.push_back(name);
        expect(TokenKind::Colon);
    }
    takeTarget();
    if (take(TokenKind::At)) {
        if (at(TokenKind::DirectAddress)) {
            decl->address = textOf(peek());
            decl->addressRange = rangeOf(peek());
            advance();
        } else {
            expected(phrases::AnAddress());
        }
    }
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

TypeSpec* Parser::parseTypeSpec(bool inTypeBlock) {
    const Nesting nesting(*this);
    const size_t first = mark();
    TypeSpec* spec = nullptr;
    if (nesting.tooDeep) {
        skipTo({TokenKind::EndType, TokenKind::EndVar});
        spec = make<TypeSpec>();
    } else {
        const auto pointing = [&](TypeSpecKind kind, bool takesTo) {
            advance();
            if (takesTo) expect(TokenKind::To);
            spec = make<TypeSpec>();
            spec->kind = kind;
            spec->element = parseTypeSpec(false);
        };
        switch (kind()) {
        case TokenKind::Array:
            spec = parseArraySpec();
            break;
        case TokenKind::Struct:
            spec = parseStructSpec(TypeSpecKind::Struct);
            break;
        case TokenKind::LeftParen:
            spec = make<TypeSpec>();
            parseEnumerators(*spec);
            if (at(TokenKind::Identifier) && isIntegerType(textOf(peek()))) { // (Red, Green) BYTE
                spec->element = make<TypeSpec>();
                spec->element->kind = TypeSpecKind::Named;
                spec->element->path = {nameOf(peek())};
                spec->element->range = rangeOf(peek());
                advance();
            }
            break;
        case TokenKind::Identifier:
            if (at(SoftWord::Pointer) && kind(1) == TokenKind::To)
                pointing(TypeSpecKind::Pointer, true);
            else if (at(SoftWord::Reference) && kind(1) == TokenKind::To)
                pointing(TypeSpecKind::Reference, true);
            else if (at(SoftWord::RefTo))
                pointing(TypeSpecKind::RefTo, false);
            else if (at(SoftWord::Union) && (kind(1) == TokenKind::Identifier || kind(1) == TokenKind::EndUnion))
                spec = parseStructSpec(TypeSpecKind::Union);
            else if (isWord(textOf(peek()), "STRING") || isWord(textOf(peek()), "WSTRING"))
                spec = parseStringSpec();
            else
                spec = parseNamedSpec(inTypeBlock);
            break;
        case TokenKind::WstringLiteral:
            spec = parseNamedSpec(inTypeBlock);
            break;
        default:
            expected(phrases::AType());
            spec = make<TypeSpec>();
            break;
        }
    }
    spec->range = rangeFrom(first);
    return spec;
}

/// ARRAY[3]: the count, as other languages write it.
void Parser::missingBound(const Expr* low) {
    auto* d = report(rangeOf(peek()), findings::Expected(Verbatim(".."), shown(peek())));
    if (!d || low->kind != ExprKind::Literal || low->op != TokenKind::IntegerLiteral || low->text.size() > 9 ||
        low->text.find_first_not_of("0123456789") != std::string_view::npos)
        return;
    const int count = std::stoi(std::string(low->text));
    for (const std::string& bounds : {"0.." + std::to_string(count - 1), "1.." + std::to_string(count)})
        d->fixes.push_back({fixes::Write(bounds), {{low->range, bounds}}});
}

TypeSpec* Parser::parseArraySpec() {
    TypeSpec* spec = make<TypeSpec>();
    spec->kind = TypeSpecKind::Array;
    advance();
    const bool isRound = at(TokenKind::LeftParen); // ARRAY(1..3)
    const TokenKind close = isRound ? TokenKind::RightParen : TokenKind::RightBracket;
    if (isRound) {
        size_t end = 1; // its other end
        while (end < 40 && kind(end) != TokenKind::RightParen && kind(end) != TokenKind::EndOfFile) ++end;
        if (auto* d = report(rangeOf(peek()), findings::Expected(Verbatim("["), Verbatim("(")));
            d && kind(end) == TokenKind::RightParen)
            d->fixes.push_back({fixes::Write(Verbatim("[ ]")), {{rangeOf(peek()), "["}, {rangeOf(peek(end)), "]"}}});
        advance();
        m_lastErrorAt = SIZE_MAX;
    }
    if (isRound || expect(TokenKind::LeftBracket)) {
        const Token open = previous();
        bool draft = false;
        do {
            Bounds bounds;
            if (take(TokenKind::Star)) {
                spec->kind = TypeSpecKind::OpenArray;
            } else {
                bounds.low = parseExpression();
                if (!take(TokenKind::DotDot)) {
                    // one number: the count, as other languages write it
                    missingBound(bounds.low);
                    m_lastErrorAt = m_at;
                } else if (at(TokenKind::RightBracket) || at(TokenKind::Comma)) {
                    draft = true;
                    spec->kind = TypeSpecKind::OpenArray;
                    bounds = {};
                } else {
                    bounds.high = parseExpression();
                }
            }
            spec->bounds.push_back(bounds);
        } while (take(TokenKind::Comma));
        if (!take(close))
            expected(Verbatim(isRound ? ")" : "]"));
        else if (draft) {
            std::string stars = "*";
            for (size_t i = 1; i < spec->bounds.size(); ++i) stars += ", *";
            const SourceRange inside{m_file.file, open.end, previous().begin};
            m_sink.emit(inside, findings::OpenArrayBound())
                .fixes.push_back({fixes::Write(Verbatim("ARRAY[" + stars + "]")), {{inside, stars}}});
        }
    }
    if (!take(TokenKind::Of)) {
        if (m_lastErrorAt != m_at) expected(Verbatim("OF"));
        // go on behind the OF of this line
        for (size_t ahead = 0; ahead < 20 && !(ahead > 0 && peek(ahead).afterNewline) &&
                               kind(ahead) != TokenKind::Semicolon && kind(ahead) != TokenKind::EndOfFile;
             ++ahead)
            if (kind(ahead) == TokenKind::Of) {
                m_at += ahead + 1;
                break;
            }
    }
    spec->element = parseTypeSpec(false);
    return spec;
}

TypeSpec* Parser::parseStringSpec() {
    TypeSpec* spec = make<TypeSpec>();
    spec->kind = TypeSpecKind::String;
    spec->path = {nameOf(peek())};
    advance();
    const bool bracket = at(TokenKind::LeftBracket);
    if (bracket || at(TokenKind::LeftParen)) {
        advance();
        spec->length = parseExpression();
        expect(bracket ? TokenKind::RightBracket : TokenKind::RightParen);
    }
    return spec;
}

TypeSpec* Parser::parseNamedSpec(bool inTypeBlock) {
    TypeSpec* spec = make<TypeSpec>();
    spec->kind = TypeSpecKind::Named;
    const size_t first = mark();
    spec->path = takePath();
    if (at(TokenKind::LeftBracket) &&
        kind(1) == TokenKind::LeftParen) { // ARRAY … OF Motor[(number := 1), (number := 2)]
        advance();
        while (at(TokenKind::LeftParen)) {
            advance();
            parseArguments(spec->constructors.emplace_back(), TokenKind::RightParen);
            if (!take(TokenKind::Comma)) break;
        }
        expect(TokenKind::RightBracket);
        return spec;
    }
    if (!at(TokenKind::LeftParen)) return spec;
    // INT (0..10)   INT (Red, Green)   Motor(speed := 5)
    bool range = false;
    int depth = 0;
    for (size_t ahead = 0; ahead < 200; ++ahead) {
        const TokenKind k = kind(ahead);
        if (k == TokenKind::LeftParen || k == TokenKind::LeftBracket)
            ++depth;
        else if (k == TokenKind::RightParen || k == TokenKind::RightBracket)
            --depth;
        else if (k == TokenKind::DotDot && depth == 1)
            range = true;
        if (depth == 0 || k == TokenKind::Semicolon || k == TokenKind::EndOfFile) break;
    }
    const bool enumeration = !range && spec->path.size() == 1 &&
                             (isIntegerType(spec->path[0].text) ||
                              (inTypeBlock && kind(1) == TokenKind::Identifier && kind(2) == TokenKind::Comma));
    if (range) {
        advance();
        spec->kind = TypeSpecKind::Subrange;
        Bounds bounds;
        bounds.low = parseExpression();
        expect(TokenKind::DotDot);
        bounds.high = parseExpression();
        spec->bounds.push_back(bounds);
        expect(TokenKind::RightParen);
    } else if (enumeration) {
        TypeSpec* base = make<TypeSpec>();
        *base = *spec;
        base->range = rangeFrom(first);
        spec->path.clear();
        spec->element = base;
        parseEnumerators(*spec);
    } else {
        advance();
        parseArguments(spec->constructor, TokenKind::RightParen);
    }
    return spec;
}

void Parser::parseEnumerators(TypeSpec& spec) {
    spec.kind = TypeSpecKind::Enum;
    advance();
    while (!at(TokenKind::RightParen) && !atEnd() && !atStatementEnd()) {
        const size_t first = mark();
        EnumeratorDecl enumerator;
        enumerator.name = takeName(phrases::AnEnumerationValue());
        if (!enumerator.name.isValid()) break;
        if (take(TokenKind::Assign))
            enumerator.value = parseExpression();
        else if (at(TokenKind::Equal)) {
            const SourceRange range = rangeOf(peek());
            if (auto* d = report(range, findings::Expected(Verbatim(":="), Verbatim("="))))
                d->fixes.push_back({fixes::Write(Verbatim(":=")), {{range, ":="}}});
            advance();
            enumerator.value = parseExpression();
        }
        enumerator.range = rangeFrom(first);
        const bool comma = take(TokenKind::Comma);
        enumerator.comment = commentBehind(sourceIndex(m_at - 1));
        if (enumerator.comment.empty()) enumerator.comment = docCommentAbove(sourceIndex(first));
        spec.enumerators.push_back(std::move(enumerator));
        if (comma) continue;
        if (atName() && m_lastErrorAt != m_at) {
            expected(phrases::OneOf({{","}}, Verbatim(")")));
            continue;
        }
        break;
    }
    if (take(TokenKind::RightParen)) return;
    expected(Verbatim(")"));
    while (!atEnd() && !atAny({TokenKind::RightParen, TokenKind::Semicolon}) && !atStatementEnd() && !atDeclaration())
        advance();
    take(TokenKind::RightParen);
}

TypeSpec* Parser::parseStructSpec(TypeSpecKind kind) {
    TypeSpec* spec = make<TypeSpec>();
    spec->kind = kind;
    const Token opening = peek();
    const TokenKind end = kind == TypeSpecKind::Struct ? TokenKind::EndStruct : TokenKind::EndUnion;
    const OpenBlock open(*this, end);
    advance();
    if (at(TokenKind::Identifier) && isWord(textOf(peek()), "OVERLAP") && this->kind(1) == TokenKind::Identifier) {
        spec->kind = TypeSpecKind::Union;
        advance();
    }
    if (at(SoftWord::Extends) && this->kind(1) == TokenKind::Identifier) {
        advance();
        spec->extends = make<TypeSpec>();
        spec->extends->kind = TypeSpecKind::Named;
        const size_t first = mark();
        spec->extends->path = takePath();
        spec->extends->range = rangeFrom(first);
    }
    while (!at(end) && !atEnd()) {
        if (take(TokenKind::Semicolon)) continue;
        if (atStatementEnd() || atVarSection() || (atDeclaration() && this->kind(1) != TokenKind::Colon)) break;
        const size_t before = mark();
        if (VarDecl* field = parseVarDecl(SectionKind::Var)) spec->fields.push_back(field);
        if (mark() == before) advance();
    }
    expectEnd(end, opening);
    return spec;
}

/// TYPE a : … ; b : … ; END_TYPE: a declaration for each.
void Parser::parseTypeBlock(std::vector<Decl*>& out) {
    const Token opening = peek();
    std::vector<Pragma> outer = pragmasHere();
    std::string_view comment =
        docCommentAbove(outer.empty() ? sourceIndex(m_at) : sourceIndex(m_at) - static_cast<uint32_t>(outer.size()));
    Access access = Access::Default;
    advance();
    const OpenBlock open(*this, TokenKind::EndType);
    bool isFirst = true;
    if (kind(1) == TokenKind::Identifier) parseModifiers(access, nullptr, nullptr, nullptr);
    while (!at(TokenKind::EndType) && !atEnd()) {
        if (take(TokenKind::Semicolon)) continue;
        if (atStatementEnd() || atVarSection() || (atDeclaration() && kind(1) != TokenKind::Colon)) break;
        const size_t first = mark();
        TypeDecl* type = make<TypeDecl>();
        type->access = access;
        type->pragmas = pragmasHere();
        const auto pragmaCount = static_cast<uint32_t>(type->pragmas.size());
        type->comment = docCommentAbove(sourceIndex(first) - pragmaCount);
        if (type->comment.empty() && isFirst) type->comment = comment;
        if (isFirst) type->pragmas.insert(type->pragmas.begin(), outer.begin(), outer.end());
        type->name = takeName(phrases::ATypesName());
        if (!type->name.isValid()) {
            skipTo({TokenKind::Semicolon, TokenKind::EndType, TokenKind::EndStruct});
            if (!at(TokenKind::EndType)) advance();
            continue;
        }
        TypeSpec* base = nullptr;
        if (at(SoftWord::Extends)) {
            advance();
            base = make<TypeSpec>();
            base->kind = TypeSpecKind::Named;
            const size_t baseAt = mark();
            base->path = takePath();
            base->range = rangeFrom(baseAt);
        }
        const bool isExported = at(TokenKind::Struct) && sourceIndex(m_at) > 0 &&
                                m_list.tokens[sourceIndex(m_at) - 1].kind == TokenKind::Pragma; // "Data" VERSION : 0.1
        if (!take(TokenKind::Colon) && !isExported) {
            const bool typeFollows = at(TokenKind::Struct) || at(TokenKind::Array) || at(TokenKind::LeftParen) ||
                                     at(SoftWord::Union) ||
                                     (at(TokenKind::Identifier) && kind(1) == TokenKind::Semicolon);
            if (typeFollows) {
                if (auto* d = report(rangeOf(previous()), findings::MissingColon()))
                    d->fixes.push_back({fixes::Insert(Verbatim(":")), {{afterPrevious(), " :"}}});
                m_lastErrorAt = SIZE_MAX;
            } else {
                expected(Verbatim(":"));
                while (!atEnd() && !atAny({TokenKind::Semicolon, TokenKind::EndType}) && !atVarSection() &&
                       !atDeclaration())
                    advance();
                m_lastErrorAt = m_at;
                continue;
            }
        }
        type->spec = parseTypeSpec(true);
        if (base && !type->spec->extends) type->spec->extends = base;
        if (take(TokenKind::Assign)) type->initial = parseInitialiser(type->spec);
        const bool block = type->spec->kind == TypeSpecKind::Struct || type->spec->kind == TypeSpecKind::Union;
        if (!take(TokenKind::Semicolon)) {
            if (m_lastErrorAt == m_at)
                skipTo({TokenKind::Semicolon, TokenKind::EndType});
            else if (!block && at(TokenKind::EndType))
                missingSemicolon(true);
            else if (!block && onNewLine())
                missingSemicolon(false);
            else if (!block) {
                report(rangeOf(peek()), findings::UnexpectedToken(shown(peek())));
                skipTo({TokenKind::Semicolon, TokenKind::EndType});
            }
        }
        type->range = rangeFrom(first);
        if (type->comment.empty()) type->comment = commentBehind(sourceIndex(m_at - 1));
        Decl* decl = make<Decl>();
        decl->kind = DeclKind::Type;
        decl->type = type;
        decl->range = type->range;
        if (isFirst) decl->range.begin = opening.begin;
        out.push_back(decl);
        isFirst = false;
    }
    if (expectEnd(TokenKind::EndType, opening)) {
        if (!isFirst) out.back()->range.end = previous().end;
        take(TokenKind::Semicolon);
    }
}

} // namespace plc::parse
