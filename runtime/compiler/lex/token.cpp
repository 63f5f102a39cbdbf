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

bool isLiteral(TokenKind kind) {
    switch (kind) {
    case TokenKind::IntegerLiteral:
    case TokenKind::RealLiteral:
    case TokenKind::DurationLiteral:
    case TokenKind::DateLiteral:
    case TokenKind::TimeOfDayLiteral:
    case TokenKind::DateTimeLiteral:
    case TokenKind::StringLiteral:
    case TokenKind::WstringLiteral:
    case TokenKind::True:
    case TokenKind::False:
        return true;
    default:
        return false;
    }
}

int precedenceOf(TokenKind kind) {
    switch (kind) {
    case TokenKind::Or:
    case TokenKind::OrElse:
        return 1;
    case TokenKind::Xor:
        return 2;
    case TokenKind::And:
    case TokenKind::AndThen:
    case TokenKind::Ampersand:
        return 3;
    case TokenKind::Equal:
    case TokenKind::NotEqual:
        return 4;
    case TokenKind::Less:
    case TokenKind::LessEqual:
    case TokenKind::Greater:
    case TokenKind::GreaterEqual:
        return 5;
    case TokenKind::Plus:
    case TokenKind::Minus:
        return 6;
    case TokenKind::Star:
    case TokenKind::Slash:
    case TokenKind::Mod:
        return 7;
    case TokenKind::Power:
        return 8;
    default:
        return 0;
    }
}

} // namespace plc::lex
