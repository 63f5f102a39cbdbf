#include "runtime/compiler/lex/token.h"

namespace plc::lex {

std::string_view spelling(TokenKind kind) {
    switch (kind) {
#define PLC_TOKEN(Name, Spelling)                                                                                      \
    case TokenKind::Name:                                                                                              \
        return Spelling;
#include "runtime/compiler/lex/tokens.def"
    }
    return {};
}

std::string_view spelling(SoftWord word) {
    switch (word) {
    case SoftWord::None:
        return {};
#define PLC_SOFT(Name, Spelling)                                                                                       \
    case SoftWord::Name:                                                                                               \
        return Spelling;
#include "runtime/compiler/lex/tokens.def"
    }
    return {};
}

bool isKeyword(TokenKind kind) {
    switch (kind) {
#define PLC_TOKEN(Name, Spelling)                                                                                      \
    case TokenKind::Name:                                                                                              \
        return false;
#define PLC_KEYWORD(Name, Spelling)                                                                                    \
    case TokenKind::Name:                                                                                              \
        return true;
#include "runtime/compiler/lex/tokens.def"
    }
    return false;
}

} // namespace plc::lex
