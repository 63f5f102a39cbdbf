#include "runtime/compiler/parse/parser_state.h"

#include "runtime/base/text.h"

namespace plc::parse {

namespace {

bool isModifier(SoftWord word) {
    switch (word) {
    case SoftWord::Abstract:
    case SoftWord::Final:
    case SoftWord::Override:
    case SoftWord::Public:
    case SoftWord::Private:
    case SoftWord::Protected:
    case SoftWord::Internal:
        return true;
    default:
        return false;
    }
}

} // namespace

/// A word that begins a declaration at the top level. Soft words only where a name could not stand.
bool Parser::atDeclaration() const {
    switch (kind()) {
    case TokenKind::Program:
    case TokenKind::Function:
    case TokenKind::FunctionBlock:
    case TokenKind::TypeWord:
        return true;
    case TokenKind::VarGlobal:
    case TokenKind::VarConfig:
    case TokenKind::VarAccess:
        return !endIsOpen(TokenKind::EndConfiguration);
    case TokenKind::Identifier:
        break;
    default:
        return false;
    }
    const bool nameFollows = kind(1) == TokenKind::Identifier && !peek(1).afterNewline;
    switch (peek().soft) {
    case SoftWord::Configuration:
    case SoftWord::Interface:
    case SoftWord::Class:
        return nameFollows;
    case SoftWord::Namespace:
    case SoftWord::Using:
        return nameFollows;
    case SoftWord::Test:
        return kind(1) == TokenKind::StringLiteral;
    default:
        return false;
    }
}

/// METHOD, PROPERTY or ACTION where a statement could not begin so.
bool Parser::atPouMember() const {
    if (!at(TokenKind::Identifier)) return false;
    const bool nameFollows = kind(1) == TokenKind::Identifier && !peek(1).afterNewline;
    switch (peek().soft) {
    case SoftWord::Method:
    case SoftWord::Property:
        return nameFollows;
    case SoftWord::Action:
        return nameFollows;
    default:
        return false;
    }
}

void Parser::parseFile() { parseDeclarationsUntil(m_file.declarations, false); }

void Parser::parseDeclarationsUntil(std::vector<Decl*>& out, bool inNamespace) {
    m_lastPou = nullptr;
    while (!atEnd()) {
        if (take(TokenKind::Semicolon)) continue;
        if (inNamespace && at(TokenKind::EndNamespace)) return;
        const size_t before = mark();
        if (at(TokenKind::TypeWord)) {
            parseTypeBlock(out);
            m_lastPou = nullptr;
        } else if (atPouMember() && m_lastPou) {
            if (at(SoftWord::Action))
                m_lastPou->actions.push_back(parseAction());
            else if (at(SoftWord::Method))
                m_lastPou->methods.push_back(parseMethod(false));
            else
                m_lastPou->properties.push_back(parseProperty(false));
        } else if (Decl* decl = parseDeclaration()) {
            out.push_back(decl);
            m_lastPou = decl->kind == DeclKind::Pou ? decl->pou : nullptr;
        }
        if (mark() == before) advance();
    }
}

/// VAR_GLOBAL, VAR_CONFIG or VAR_ACCESS; {gvl} above it names the list, and those behind it.
void Parser::parseGlobals(Decl& decl) {
    const size_t first = mark();
    decl.kind = DeclKind::Globals;
    decl.globals = make<GlobalList>();
    const std::vector<Pragma> pragmas = pragmasHere();
    for (const Pragma& pragma : pragmas)
        if (equalsIgnoringCase(pragma.key, "gvl")) m_gvlName = pragma.value;
    decl.globals->name = m_gvlName;
    decl.globals->comment = docCommentAbove(sourceIndex(first) - static_cast<uint32_t>(pragmas.size()));
    decl.globals->section = parseVarSection();
    decl.range = rangeFrom(first);
}

/// CLASS of edition 3: a block without a body.
void Parser::parseClass(Decl& decl) {
    const size_t first = mark();
    decl.pou = parsePou(PouKind::FunctionBlock, TokenKind::EndClass);
    if (const Body& body = decl.pou->body; body.language != BodyLanguage::None)
        m_sink.emit(body.range, findings::NotAllowedHere(phrases::ABody(), phrases::InAClass()));
    decl.range = rangeFrom(first);
}

/// Code without a unit around it: one message, on to the next declaration.
void Parser::skipToDeclaration() {
    report(rangeOf(peek()), findings::UnexpectedToken(shown(peek())));
    if (atVarSection()) {
        (void)parseVarSection();
    } else {
        advance();
        while (!atEnd() && !atDeclaration() && !(atPouMember() && m_lastPou) && !at(TokenKind::EndNamespace) &&
               !(atVarSection() && peek().afterNewline))
            advance();
    }
    m_lastErrorAt = SIZE_MAX;
}

/// A declaration that begins with a word that may be a name elsewhere. False: it is a name here.
bool Parser::parseSoftDeclaration(Decl& decl) {
    if (!at(TokenKind::Identifier) || !atDeclaration()) return false;
    switch (peek().soft) {
    case SoftWord::Configuration:
        decl.kind = DeclKind::Configuration;
        decl.configuration = parseConfiguration();
        break;
    case SoftWord::Interface:
        decl.pou = parseInterface();
        break;
    case SoftWord::Test:
        decl.kind = DeclKind::Test;
        decl.test = parseTest();
        break;
    default:
        break;
    }
    return true;
}

Decl* Parser::parseDeclaration() {
    if (at(TokenKind::Identifier) && atDeclaration()) {
        if (at(SoftWord::Namespace)) return parseNamespace();
        if (at(SoftWord::Using)) return parseUsing();
    }
    const size_t first = mark();
    Decl* decl = make<Decl>();
    switch (kind()) {
    case TokenKind::Program:
        decl->pou = parsePou(PouKind::Program, TokenKind::EndProgram);
        break;
    case TokenKind::Function:
        decl->pou = parsePou(PouKind::Function, TokenKind::EndFunction);
        break;
    case TokenKind::FunctionBlock:
        decl->pou = parsePou(PouKind::FunctionBlock, TokenKind::EndFunctionBlock);
        break;
    case TokenKind::VarGlobal:
    case TokenKind::VarConfig:
    case TokenKind::VarAccess:
        parseGlobals(*decl);
        return decl;
    default:
        if (at(SoftWord::Class) && at(TokenKind::Identifier) && atDeclaration()) {
            parseClass(*decl);
            return decl;
        }
        if (parseSoftDeclaration(*decl)) break;
        skipToDeclaration();
        return nullptr;
    }
    decl->range = rangeFrom(first);
    m_lastErrorAt = SIZE_MAX;
    return decl;
}

/// PUBLIC ABSTRACT FINAL … before a name.
void Parser::parseModifiers(Access& access, bool* isAbstract, bool* isFinal, bool* isOverride) {
    while (at(TokenKind::Identifier) && isModifier(peek().soft) && kind(1) == TokenKind::Identifier) {
        switch (peek().soft) {
        case SoftWord::Abstract:
            if (isAbstract) *isAbstract = true;
            break;
        case SoftWord::Final:
            if (isFinal) *isFinal = true;
            break;
        case SoftWord::Override:
            if (isOverride) *isOverride = true;
            break;
        case SoftWord::Public:
            access = Access::Public;
            break;
        case SoftWord::Private:
            access = Access::Private;
            break;
        case SoftWord::Protected:
            access = Access::Protected;
            break;
        default:
            access = Access::Internal;
            break;
        }
        advance();
    }
}

/// EXTENDS Base, Base<100> of a block, or several interfaces.
void Parser::parseBases(Pou& pou) {
    advance();
    do {
        const size_t first = mark();
        pou.extends.push_back(takePath());
        if (!at(TokenKind::Less)) continue;
        TypeSpec* spec = make<TypeSpec>();
        spec->kind = TypeSpecKind::Named;
        spec->path = pou.extends.back();
        parseGenericValues(*spec);
        spec->range = rangeFrom(first);
        // EXTENDS <100>: values of nothing.
        if (pou.kind == PouKind::FunctionBlock && !spec->path.empty()) pou.result = spec;
    } while (take(TokenKind::Comma));
}

/// From the first word of the unit: pragmas, comment, name, result, EXTENDS, IMPLEMENTS.
void Parser::parsePouHeader(Pou& pou) {
    const size_t first = mark();
    pou.pragmas = pragmasHere();
    pou.comment = docCommentAbove(sourceIndex(first) - static_cast<uint32_t>(pou.pragmas.size()));
    if (pou.comment.empty() && !pou.pragmas.empty()) pou.comment = docCommentAbove(sourceIndex(first));
    advance();
    parseModifiers(pou.access, &pou.isAbstract, &pou.isFinal, &pou.isOverride);
    if (at(TokenKind::TypedPrefix))
        expected(phrases::AName());
    else
        pou.name = takeName();
    while (at(TokenKind::Dot)) advance(), (void)takeName(); // Block.Method
    if (take(TokenKind::Colon)) {
        if (at(TokenKind::Identifier) && equalsIgnoringCase(textOf(peek()), "VOID"))
            advance(); // no result
        else
            pou.result = parseTypeSpec(false);
    }
    const auto paths = [&](std::vector<Path>& out) {
        advance();
        do out.push_back(takePath());
        while (take(TokenKind::Comma));
    };
    while (atGenericSection()) pou.sections.push_back(parseVarSection()); // CODESYS writes them here
    if (at(SoftWord::Extends)) parseBases(pou);
    if (at(SoftWord::Implements)) paths(pou.implements);
    take(TokenKind::Semicolon);
    while (at(SoftWord::Using) && kind(1) == TokenKind::Identifier) {
        paths(pou.usings);
        take(TokenKind::Semicolon);
    }
    pou.header = rangeFrom(first);
}

Pou* Parser::parsePou(PouKind pouKind, TokenKind end) {
    Pou* pou = make<Pou>();
    pou->kind = pouKind;
    const size_t first = mark();
    parsePouHeader(*pou);
    const OpenBlock open(*this, end);
    parsePouParts(*pou, end);
    pou->range = rangeFrom(first);
    return pou;
}

/// A further piece of a unit's body: statements go on behind an action or a method, a chart too.
void Parser::addBody(Pou& pou, Body body, bool isFirst) {
    if (isFirst) {
        pou.body = std::move(body);
    } else if (body.chart && pou.body.chart) {
        SfcBody& chart = *pou.body.chart;
        chart.steps.insert(chart.steps.end(), body.chart->steps.begin(), body.chart->steps.end());
        chart.transitions.insert(chart.transitions.end(), body.chart->transitions.begin(),
                                 body.chart->transitions.end());
        chart.actions.insert(chart.actions.end(), body.chart->actions.begin(), body.chart->actions.end());
        chart.range = joined(chart.range, body.chart->range);
        pou.body.range = joined(pou.body.range, body.range);
    } else if (pou.body.language != BodyLanguage::None && body.language != BodyLanguage::None &&
               pou.body.language != body.language) {
        m_lastErrorAt = SIZE_MAX; // one body, one language
        report({m_file.file, body.range.begin, body.range.begin + 1},
               findings::UnexpectedToken(m_text.substr(
                   body.range.begin, m_text.find_first_of(" \t\r\n:;(", body.range.begin) - body.range.begin)));
    } else {
        if (pou.body.language == BodyLanguage::None) pou.body.language = body.language;
        pou.body.statements.insert(pou.body.statements.end(), body.statements.begin(), body.statements.end());
        pou.body.range = joined(pou.body.range, body.range);
    }
}

/// A method, property or action; false: none that this unit can have.
bool Parser::parsePouMember(Pou& pou) {
    const bool isBlock =
        pou.kind == PouKind::FunctionBlock || pou.kind == PouKind::Program || pou.kind == PouKind::Function;
    if (!isBlock) return false; // a method without its END_METHOD
    if (at(SoftWord::Method))
        pou.methods.push_back(parseMethod(false));
    else if (at(SoftWord::Property))
        pou.properties.push_back(parseProperty(false));
    else
        pou.actions.push_back(parseAction());
    return true;
}

/// An END_… that is not the one of this unit, `end`. True: the unit is closed, by the wrong word.
bool Parser::takeForeignEnd(TokenKind end) {
    const bool isUnitsEnd =
        atAny({TokenKind::EndProgram, TokenKind::EndFunction, TokenKind::EndFunctionBlock, TokenKind::EndClass,
               TokenKind::EndMethod, TokenKind::EndAction, TokenKind::EndInterface, TokenKind::EndProperty,
               TokenKind::EndGet, TokenKind::EndSet});
    const SourceRange range = rangeOf(peek());
    if (isUnitsEnd) {
        const std::string word(lex::spelling(end));
        if (auto* d = report(range, findings::Expected(word, shown(peek()))))
            d->fixes.push_back({fixes::Write(word), {{range, word}}});
    } else {
        report(range, findings::UnexpectedToken(shown(peek())));
    }
    advance();
    take(TokenKind::Semicolon);
    return isUnitsEnd;
}

/// Sections, members and the body, in any order; then the end, which may be missing (two panes in one file).
void Parser::parsePouParts(Pou& pou, TokenKind end) {
    bool hasBody = false;
    while (!atEnd() && !at(end)) {
        const size_t before = mark();
        if (atVarSection() && !(at(TokenKind::VarGlobal) && (hasBody || !pragmasHere().empty()))) {
            pou.sections.push_back(parseVarSection());
        } else if (atDeclaration() || (atVarSection() && at(TokenKind::VarGlobal))) {
            break;
        } else if (atPouMember()) {
            if (!parsePouMember(pou)) break;
        } else if (atStatementEnd()) {
            if (endIsOpen(kind()) || at(TokenKind::EndNamespace)) break; // of the unit around this one
            if (takeForeignEnd(end)) return;
        } else {
            addBody(pou, parseBody(BodyContext::Unit, pou.pragmas), !hasBody);
            hasBody = true;
        }
        if (mark() == before) advance();
    }
    if (!hasBody) pou.body.range = afterPrevious();
    if (take(end)) {
        take(TokenKind::Semicolon);
        return;
    }
    pou.hasEnd = false;
    const std::string word(lex::spelling(end));
    const SourceRange range = rangeOf(previous());
    if (m_badOffsets.empty() || !atEnd())
        insertFix(report(range, findings::MissingEndAccepted(word)), "\n" + word + "\n");
    m_lastErrorAt = SIZE_MAX;
}

/// ST, IL or SFC: the first words tell, or a {language} pragma.
Body Parser::parseBody(BodyContext context, const std::vector<Pragma>& pragmas) {
    Body body;
    bool wantIl = false, wantSt = false;
    const auto look = [&](const std::vector<Pragma>& list) {
        for (const Pragma& pragma : list)
            if (equalsIgnoringCase(pragma.key, "language")) {
                wantIl = equalsIgnoringCase(pragma.value, "IL");
                wantSt = equalsIgnoringCase(pragma.value, "ST");
            }
    };
    look(pragmas);
    look(pragmasHere());
    const size_t first = mark();
    if (atChart()) {
        body.language = BodyLanguage::Sfc;
        body.chart = parseChart();
    } else if (!wantSt && (wantIl || atInstructionList())) {
        body.language = BodyLanguage::Il;
        body.statements = parseInstructions(context);
    } else {
        body.statements = parseStatements(context);
        body.language = body.statements.empty() ? BodyLanguage::None : BodyLanguage::St;
    }
    body.range = rangeFrom(first);
    return body;
}

Pou* Parser::parseMethod(bool inInterface) {
    Pou* pou = make<Pou>();
    pou->kind = PouKind::Method;
    const size_t first = mark();
    parsePouHeader(*pou);
    const OpenBlock open(*this, TokenKind::EndMethod);
    if (inInterface) {
        while (atVarSection()) pou->sections.push_back(parseVarSection());
        if (!take(TokenKind::EndMethod)) {
            pou->hasEnd = false;
            if (at(SoftWord::Method) || at(SoftWord::Property) || at(TokenKind::EndInterface))
                insertFix(report(rangeOf(previous()), findings::MissingEndAccepted(Verbatim("END_METHOD"))),
                          "\nEND_METHOD");
            else {
                expected(Verbatim("END_METHOD"));
                while (!atEnd() && !atAny({TokenKind::EndMethod, TokenKind::EndInterface}) && !atPouMember() &&
                       !atDeclaration())
                    advance();
                take(TokenKind::EndMethod);
            }
        }
        take(TokenKind::Semicolon);
    } else {
        parsePouParts(*pou, TokenKind::EndMethod);
    }
    pou->range = rangeFrom(first);
    return pou;
}

Pou* Parser::parseAccessor(PouKind pouKind, TokenKind end, bool inInterface) {
    Pou* pou = make<Pou>();
    pou->kind = pouKind;
    pou->pragmas = pragmasHere();
    const size_t first = mark();
    pou->name = nameOf(peek());
    advance();
    parseModifiers(pou->access, &pou->isAbstract, &pou->isFinal, &pou->isOverride);
    if (at(TokenKind::Identifier) && isModifier(peek().soft) &&
        (kind(1) == end || kind(1) == TokenKind::Var)) { // GET PRIVATE END_GET
        pou->access = at(SoftWord::Private)     ? Access::Private
                      : at(SoftWord::Protected) ? Access::Protected
                      : at(SoftWord::Internal)  ? Access::Internal
                                                : Access::Public;
        advance();
    }
    pou->header = rangeFrom(first);
    const OpenBlock open(*this, end);
    // an interface may list GET and SET bare
    if (inInterface && (at(SoftWord::Get) || at(SoftWord::Set) || at(TokenKind::EndProperty)))
        pou->hasEnd = false;
    else
        parsePouParts(*pou, end);
    pou->range = rangeFrom(first);
    return pou;
}

Property* Parser::parseProperty(bool inInterface) {
    Property* property = make<Property>();
    const size_t first = mark();
    property->pragmas = pragmasHere();
    property->comment = docCommentAbove(sourceIndex(first) - static_cast<uint32_t>(property->pragmas.size()));
    advance();
    parseModifiers(property->access, &property->isAbstract, &property->isFinal, &property->isOverride);
    property->name = takeName();
    if (expect(TokenKind::Colon)) property->type = parseTypeSpec(false);
    take(TokenKind::Semicolon);
    const OpenBlock open(*this, TokenKind::EndProperty);
    while (!atEnd()) {
        if (atVarSection())
            (void)parseVarSection(); // an empty VAR END_VAR of exports
        else if (at(SoftWord::Get) && !property->get)
            property->get = parseAccessor(PouKind::PropertyGet, TokenKind::EndGet, inInterface);
        else if (at(SoftWord::Set) && !property->set)
            property->set = parseAccessor(PouKind::PropertySet, TokenKind::EndSet, inInterface);
        else
            break;
    }
    if (!take(TokenKind::EndProperty)) {
        if (inInterface || atPouMember() ||
            atAny({TokenKind::EndFunctionBlock, TokenKind::EndClass, TokenKind::EndProgram})) {
            insertFix(report(rangeOf(previous()), findings::MissingEndAccepted(Verbatim("END_PROPERTY"))),
                      "\nEND_PROPERTY");
        } else {
            expected(phrases::OneOf({{"GET", "SET"}}, Verbatim("END_PROPERTY")));
            while (!atEnd() &&
                   !atAny({TokenKind::EndProperty, TokenKind::EndFunctionBlock, TokenKind::EndClass,
                           TokenKind::EndProgram}) &&
                   !atPouMember() && !atDeclaration())
                advance();
            take(TokenKind::EndProperty);
        }
    }
    take(TokenKind::Semicolon);
    property->range = rangeFrom(first);
    return property;
}

Pou* Parser::parseInterface() {
    Pou* pou = make<Pou>();
    pou->kind = PouKind::Interface;
    const size_t first = mark();
    const Token opening = peek();
    parsePouHeader(*pou);
    const OpenBlock open(*this, TokenKind::EndInterface);
    while (!atEnd() && !at(TokenKind::EndInterface)) {
        if (at(SoftWord::Method))
            pou->methods.push_back(parseMethod(true));
        else if (at(SoftWord::Property))
            pou->properties.push_back(parseProperty(true));
        else if (atDeclaration() || atStatementEnd())
            break;
        else {
            expected(phrases::OneOf({{"METHOD", "PROPERTY"}}, Verbatim("END_INTERFACE")));
            do advance(); // an ACTION is a member too, but not of an interface
            while (!atEnd() && !atStatementEnd() && !atPouMember() && !atDeclaration());
            m_lastErrorAt = SIZE_MAX;
        }
    }
    pou->hasEnd = expectEnd(TokenKind::EndInterface, opening);
    take(TokenKind::Semicolon);
    pou->range = rangeFrom(first);
    return pou;
}

/// ACTION name : … END_ACTION; its body may be ST, IL or a chart.
ActionDecl* Parser::parseAction() {
    ActionDecl* action = make<ActionDecl>();
    const size_t first = mark();
    const Token opening = peek();
    advance();
    action->name = takeName();
    while (at(TokenKind::Dot)) advance(), action->name = takeName(); // Program.Action
    take(TokenKind::Colon);
    {
        const OpenBlock open(*this, TokenKind::EndAction);
        const bool arm = std::exchange(m_inCaseArm, false);
        while (atVarSection()) action->sections.push_back(parseVarSection());
        action->body = parseBody(BodyContext::Unit, {});
        m_inCaseArm = arm;
    }
    if (!take(TokenKind::EndAction)) {
        if (atPouMember() || atEnd() ||
            atAny({TokenKind::EndProgram, TokenKind::EndFunctionBlock, TokenKind::EndClass}) || atDeclaration() ||
            atStep() || atTransition()) {
            insertFix(report(rangeOf(previous()), findings::MissingEndAccepted(Verbatim("END_ACTION"))),
                      "\nEND_ACTION");
        } else {
            expectEnd(TokenKind::EndAction, opening);
        }
    }
    action->range = rangeFrom(first);
    action->extent = extentOf(action->range, first);
    take(TokenKind::Semicolon);
    return action;
}

Decl* Parser::parseNamespace() {
    Decl* decl = make<Decl>();
    decl->kind = DeclKind::Namespace;
    decl->space = make<NamespaceDecl>();
    const size_t first = mark();
    const Token opening = peek();
    advance();
    if (at(SoftWord::Internal) && kind(1) == TokenKind::Identifier) {
        decl->space->isInternal = true;
        advance();
    }
    decl->space->path = takePath();
    const Nesting nesting(*this);
    const OpenBlock open(*this, TokenKind::EndNamespace);
    if (nesting.tooDeep)
        skipTo({TokenKind::EndNamespace});
    else
        parseDeclarationsUntil(decl->space->declarations, true);
    expectEnd(TokenKind::EndNamespace, opening);
    take(TokenKind::Semicolon);
    decl->range = rangeFrom(first);
    return decl;
}

Decl* Parser::parseUsing() {
    Decl* decl = make<Decl>();
    decl->kind = DeclKind::Using;
    const size_t first = mark();
    advance();
    do decl->usings.push_back(takePath());
    while (take(TokenKind::Comma));
    if (!take(TokenKind::Semicolon)) missingSemicolon(false);
    decl->range = rangeFrom(first);
    return decl;
}

} // namespace plc::parse
