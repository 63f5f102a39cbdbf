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

} // namespace

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

/// <100> or <2 * cCount, 3> behind the name of a block with VAR_GENERIC CONSTANT.
void Parser::parseGenericValues(TypeSpec& spec) {
    const int sum = lex::precedenceOf(TokenKind::Plus); // a comparison would take the closing >
    advance();
    do {
        Bounds value;
        value.low = parseBinary(sum);
        spec.bounds.push_back(value);
    } while (take(TokenKind::Comma));
    expect(TokenKind::Greater);
}

TypeSpec* Parser::parseNamedSpec(bool inTypeBlock) {
    TypeSpec* spec = make<TypeSpec>();
    spec->kind = TypeSpecKind::Named;
    const size_t first = mark();
    spec->path = takePath();
    if (at(TokenKind::Less)) parseGenericValues(*spec);
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
        if (VarDecl* field = parseVarDecl()) spec->fields.push_back(field);
        if (mark() == before) advance();
    }
    expectEnd(end, opening);
    return spec;
}

/// EXTENDS Base behind the name of a structure.
TypeSpec* Parser::parseBaseType() {
    if (!take(SoftWord::Extends)) return nullptr;
    TypeSpec* base = make<TypeSpec>();
    base->kind = TypeSpecKind::Named;
    const size_t first = mark();
    base->path = takePath();
    base->range = rangeFrom(first);
    return base;
}

/// The colon behind a type's name; exports write a pragma in its place: "Data" VERSION : 0.1 STRUCT.
bool Parser::parseTypeColon() {
    const bool isExported = at(TokenKind::Struct) && sourceIndex(m_at) > 0 &&
                            m_list.tokens[sourceIndex(m_at) - 1].kind == TokenKind::Pragma;
    if (take(TokenKind::Colon) || isExported) return true;
    const bool typeFollows = at(TokenKind::Struct) || at(TokenKind::Array) || at(TokenKind::LeftParen) ||
                             at(SoftWord::Union) || (at(TokenKind::Identifier) && kind(1) == TokenKind::Semicolon);
    if (typeFollows) {
        if (auto* d = report(rangeOf(previous()), findings::MissingColon()))
            d->fixes.push_back({fixes::Insert(Verbatim(":")), {{afterPrevious(), " :"}}});
        m_lastErrorAt = SIZE_MAX;
        return true;
    }
    expected(Verbatim(":"));
    while (!atEnd() && !atAny({TokenKind::Semicolon, TokenKind::EndType}) && !atVarSection() && !atDeclaration())
        advance();
    m_lastErrorAt = m_at;
    return false;
}

/// Structures and unions have their own END and need no semicolon.
void Parser::endTypeDecl(const TypeSpec& spec) {
    if (take(TokenKind::Semicolon)) return;
    const bool isBlock = spec.kind == TypeSpecKind::Struct || spec.kind == TypeSpecKind::Union;
    if (m_lastErrorAt == m_at)
        skipTo({TokenKind::Semicolon, TokenKind::EndType});
    else if (!isBlock && at(TokenKind::EndType))
        missingSemicolon(true);
    else if (!isBlock && onNewLine())
        missingSemicolon(false);
    else if (!isBlock) {
        report(rangeOf(peek()), findings::UnexpectedToken(shown(peek())));
        skipTo({TokenKind::Semicolon, TokenKind::EndType});
    }
}

/// One type of a block: `Name EXTENDS Base : specification := value;`. Null when there is none to be made of it.
TypeDecl* Parser::parseTypeDecl(std::string_view blocksComment) {
    const size_t first = mark();
    TypeDecl* type = make<TypeDecl>();
    type->pragmas = pragmasHere();
    type->comment = docCommentAbove(sourceIndex(first) - static_cast<uint32_t>(type->pragmas.size()));
    if (type->comment.empty()) type->comment = blocksComment;
    type->name = takeName(phrases::ATypesName());
    if (!type->name.isValid()) {
        skipTo({TokenKind::Semicolon, TokenKind::EndType, TokenKind::EndStruct});
        if (!at(TokenKind::EndType)) advance();
        return nullptr;
    }
    TypeSpec* base = parseBaseType();
    if (!parseTypeColon()) return nullptr;
    type->spec = parseTypeSpec(true);
    if (base && !type->spec->extends) type->spec->extends = base;
    if (take(TokenKind::Assign)) type->initial = parseInitialiser(type->spec);
    endTypeDecl(*type->spec);
    type->range = rangeFrom(first);
    if (type->comment.empty()) type->comment = commentBehind(sourceIndex(m_at - 1));
    return type;
}

/// TYPE a : … ; b : … ; END_TYPE: a declaration for each. What stands above TYPE belongs to the first.
void Parser::parseTypeBlock(std::vector<Decl*>& out) {
    const Token opening = peek();
    const std::vector<Pragma> outer = pragmasHere();
    const std::string_view comment =
        docCommentAbove(outer.empty() ? sourceIndex(m_at) : sourceIndex(m_at) - static_cast<uint32_t>(outer.size()));
    Access access = Access::Default;
    advance();
    const OpenBlock open(*this, TokenKind::EndType);
    bool isFirst = true;
    if (kind(1) == TokenKind::Identifier) parseModifiers(access, nullptr, nullptr, nullptr);
    while (!at(TokenKind::EndType) && !atEnd()) {
        if (take(TokenKind::Semicolon)) continue;
        if (atStatementEnd() || atVarSection() || (atDeclaration() && kind(1) != TokenKind::Colon)) break;
        TypeDecl* type = parseTypeDecl(isFirst ? comment : std::string_view());
        if (!type) continue;
        type->access = access;
        if (isFirst) type->pragmas.insert(type->pragmas.begin(), outer.begin(), outer.end());
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
