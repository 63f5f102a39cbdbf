// Sharing is exact because lexer and parser go through a text once, from left to right: what they make of its begin
// depends on nothing behind it but the few tokens they look ahead. So one whole unit in front of the edit is always
// read again, and everything that reaches further (see isSelfContained, isShareable) makes that the text is read in
// whole.
#include "runtime/compiler/parse/reparse.h"

#include "runtime/base/text.h"
#include "runtime/compiler/lex/relex.h"
#include "runtime/compiler/parse/parser_state.h"

#include <cstring>

namespace plc::parse {

namespace {

constexpr size_t kWorthIt = 16 * 1024; // bytes in front of the edit

size_t commonBegin(std::string_view a, std::string_view b) {
    constexpr size_t kStep = 4096;
    const size_t shorter = std::min(a.size(), b.size());
    size_t at = 0;
    while (at + kStep <= shorter && std::memcmp(a.data() + at, b.data() + at, kStep) == 0) at += kStep;
    while (at < shorter && a[at] == b[at]) ++at;
    return at;
}

bool isLowered(const Body& body) { return body.language == BodyLanguage::Il || body.language == BodyLanguage::Sfc; }

// Instruction lists and charts ask which names are blocks of this file, wherever it declares them.
bool isShareable(const Pou& pou) {
    if (!pou.hasEnd || isLowered(pou.body)) return false;
    for (const ActionDecl* action : pou.actions)
        if (isLowered(action->body)) return false;
    for (const Pou* method : pou.methods)
        if (!isShareable(*method)) return false;
    for (const Property* property : pou.properties)
        for (const Pou* accessor : {property->get, property->set})
            if (accessor && !isShareable(*accessor)) return false;
    return true;
}

bool isShareable(const Decl& decl) {
    // prototypes of an interface have no END of their own
    if (decl.kind == DeclKind::Pou) return decl.pou && (decl.pou->kind == PouKind::Interface || isShareable(*decl.pou));
    if (decl.kind != DeclKind::Namespace || !decl.space) return true;
    return std::all_of(decl.space->declarations.begin(), decl.space->declarations.end(),
                       [](const Decl* inner) { return isShareable(*inner); });
}

/// {gvl} names the lists behind it; what {IF} leaves out may be decided by its END_IF. A text in quotes over several
/// lines ends where the lexer finds a quote with a brace behind it.
bool isSelfContainedPragma(std::string_view pragma) {
    if (!pragma.starts_with('{') || pragma.find('\n') != std::string_view::npos) return false;
    pragma.remove_prefix(std::min(pragma.find_first_not_of("{ \t"), pragma.size()));
    const std::string_view key = pragma.substr(0, pragma.find_first_of(" \t('}"));
    for (const char* reaching : {"gvl", "IF", "ELSIF", "ELSE", "END_IF"})
        if (equalsIgnoringCase(key, reaching)) return false;
    return true;
}

/// Tokens that mean the same whatever follows, and leave nothing behind for what follows: a name in quotes is one for
/// the rest of the text, and REGION is a word only where the text has an END_REGION.
bool isSelfContained(const Token& token, std::string_view text) {
    const std::string_view word = text.substr(token.begin, token.end - token.begin);
    switch (token.kind) {
    case TokenKind::Error:
    case TokenKind::WstringLiteral:
        return false;
    case TokenKind::Pragma:
        return isSelfContainedPragma(word);
    case TokenKind::Identifier:
        return !token.afterNewline || word.size() != 6 || !equalsIgnoringCase(word, "REGION");
    default:
        return true;
    }
}

/// An inner one that is not closed does not count, and whether it is closed depends on all that follows.
bool isSelfContained(const lex::Comment& comment, std::string_view text) {
    return comment.kind == lex::TriviaKind::LineComment || text[comment.begin] != '/' ||
           text.substr(comment.begin + 2, comment.end - comment.begin - 2).find("/*") == std::string_view::npos;
}

bool beginsUnit(const Token& token) {
    return token.kind == TokenKind::Program || token.kind == TokenKind::Function ||
           token.kind == TokenKind::FunctionBlock;
}

size_t tokenAt(const lex::TokenList& list, uint32_t offset) {
    const auto at = std::lower_bound(list.tokens.begin(), list.tokens.end(), offset,
                                     [](const Token& token, uint32_t begin) { return token.begin < begin; });
    return static_cast<size_t>(at - list.tokens.begin());
}

struct Restart {
    size_t declaration = 0, token = 0; // the first that are read; 0: all
};

/// The last unit to begin with: whole and without a finding in front of the edit, and so is everything before it.
Restart restartFor(const EarlierReading& before, size_t edit) {
    for (const diagnostics::Diagnostic& each : before.diagnostics) edit = std::min<size_t>(edit, each.range.begin);
    const std::vector<Decl*>& all = before.tree.declarations;
    size_t whole = 0;
    while (whole < all.size() && all[whole]->range.end < edit && isShareable(*all[whole])) ++whole;
    for (; whole > 1; --whole) {
        const Decl& first = *all[whole - 1];
        const size_t token = tokenAt(before.tree.tokens, first.range.begin);
        if (first.kind == DeclKind::Pou && beginsUnit(before.tree.tokens.tokens[token])) return {whole - 1, token};
    }
    return {};
}

} // namespace

std::optional<Reparsed> reparseFile(const EarlierReading& before, std::string_view text, diagnostics::Sink& sink,
                                    const Definitions* known) {
    if (before.tree.asksForNames) return {};
    const Restart restart = restartFor(before, commonBegin(before.text, text));
    const std::vector<Token>& earlier = before.tree.tokens.tokens;
    if (restart.token == 0 || earlier[restart.token].begin < kWorthIt) return {};
    for (size_t i = 0; i < restart.token; ++i)
        if (!isSelfContained(earlier[i], text)) return {};
    for (const lex::Comment& comment : before.tree.tokens.comments)
        if (comment.beforeToken <= restart.token && !isSelfContained(comment, text)) return {};

    auto tree = std::make_unique<SyntaxFile>();
    tree->file = before.tree.file;
    tree->tokens = lex::tokenizeFrom(tree->file, text, before.tree.tokens, restart.token, sink);
    Conditions conditions = readConditions(tree->file, text, tree->tokens, known, sink);
    if (conditions.asksForNames) return {};
    tree->declarations.assign(before.tree.declarations.begin(),
                              before.tree.declarations.begin() + static_cast<std::ptrdiff_t>(restart.declaration));
    // Pragmas belong to the unit that they are above.
    size_t first = restart.token;
    while (first > 0 && earlier[first - 1].kind == TokenKind::Pragma) --first;
    Parser(*tree, tree->tokens, text, sink, 0, std::move(conditions), first).parseFile();
    return Reparsed{std::move(tree), restart.declaration};
}

} // namespace plc::parse
