// Tokens of the one front end (D3): the compiler, the editor's colours and the formatter read the same list.
// A TokenList owns nothing but offsets; the SourceText must outlive it. Built by one thread, then immutable.
#pragma once
#include "runtime/base/source.h"
#include "runtime/diagnostics/diagnostic.h"

#include <string_view>
#include <vector>

namespace plc::lex {

enum class TokenKind : uint8_t {
#define PLC_TOKEN(Name, Spelling) Name,
#include "runtime/compiler/lex/tokens.def"
};

/// Words that are keywords only where the grammar expects them.
enum class SoftWord : uint8_t {
    None,
#define PLC_SOFT(Name, Spelling) Name,
#include "runtime/compiler/lex/tokens.def"
};

struct Token {
    TokenKind kind = TokenKind::EndOfFile;
    SoftWord soft = SoftWord::None; // of an Identifier
    bool afterNewline = false;      // first token of its line
    uint32_t begin = 0;
    uint32_t end = 0;
};

enum class TriviaKind : uint8_t { LineComment, BlockComment };
struct Comment {
    TriviaKind kind;
    uint32_t begin = 0;
    uint32_t end = 0;
    uint32_t beforeToken = 0; // index of the token that follows
};

struct TokenList {
    std::vector<Token> tokens; // ends with EndOfFile
    std::vector<Comment> comments;
};

[[nodiscard]] std::string_view spelling(TokenKind kind);
[[nodiscard]] std::string_view spelling(SoftWord word);
[[nodiscard]] bool isKeyword(TokenKind kind);
/// A number, time, date or text as it stands, TRUE or FALSE; not the prefix of `INT#5`.
[[nodiscard]] bool isLiteral(TokenKind kind);
/// Of a binary operator, by IEC 61131-3 (3.3.1, table 55; ed. 3 table 71): 1 OR … 8 `**`; 0: no binary operator.
[[nodiscard]] int precedenceOf(TokenKind kind);

/// Never fails: what it does not know becomes an Error token with a diagnostic in `sink`.
[[nodiscard]] TokenList tokenize(FileId file, std::string_view text, diagnostics::Sink& sink);

} // namespace plc::lex
