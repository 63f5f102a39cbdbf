// Literals: numbers in every base, durations and dates, text with $ escapes, typed literals, values of enumerations.
// The lexer has checked forms; here is what they mean. A literal without a written type stays flexible.
#include "runtime/compiler/sema/values/literals.h"

#include "runtime/compiler/sema/context.h"
#include "runtime/compiler/sema/names/lookup.h"
#include "runtime/compiler/sema/names/names.h"
#include "runtime/compiler/sema/types/conversions.h"
#include "runtime/compiler/sema/types/type_specs.h"
#include "runtime/compiler/sema/values/expressions.h"

#include "runtime/base/text.h"
#include "runtime/types/conversion.h"
#include "runtime/types/scalar_text.h"
#include "runtime/types/wide_text.h"

#include <cmath>
#include <cstdlib>

namespace plc::sema {

using lex::TokenKind;
using types::Value;

static std::optional<Operand> quotedName(Context& context, const syntax::Expr& e, TypeId hint);

namespace {

struct Integer {
    uint64_t magnitude = 0;
    bool isNegative = false;
    bool isGood = true;
    bool isTooLarge = false;
};

/// 5, 1_000, 16#FF, 2#1010, C#998, with a sign behind a type's name.
Integer parseInteger(std::string_view text) {
    Integer out;
    if (!text.empty() && (text.front() == '-' || text.front() == '+')) {
        out.isNegative = text.front() == '-';
        text.remove_prefix(1);
        // INT# - 5: the lexer lets spaces be there.
        while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
    }
    uint64_t base = 10;
    bool isBcd = false;
    if (const size_t hash = text.find('#'); hash != std::string_view::npos) {
        const std::string_view prefix = text.substr(0, hash);
        // C#998 is BCD (Siemens), each digit half a byte.
        if (equalsIgnoringCase(prefix, "C")) {
            isBcd = true;
            base = 16;
        } else {
            base = static_cast<uint64_t>(std::atoi(std::string(prefix).c_str()));
        }
        text.remove_prefix(hash + 1);
    }
    if (text.empty() || (base != 2 && base != 8 && base != 10 && base != 16)) out.isGood = false;
    for (const char c : text) {
        if (c == '_') continue;
        const int digit = c >= '0' && c <= '9'   ? c - '0'
                          : c >= 'a' && c <= 'f' ? c - 'a' + 10
                          : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                                 : 99;
        if (digit >= static_cast<int>(isBcd ? 10 : base)) {
            out.isGood = false;
            return out;
        }
        // Wide enough to notice the digit that is one too many.
        const unsigned __int128 next =
            static_cast<unsigned __int128>(out.magnitude) * base + static_cast<unsigned>(digit);
        if (next >> 64) out.isTooLarge = true;
        out.magnitude = static_cast<uint64_t>(next);
    }
    return out;
}

double parseReal(std::string_view text) {
    std::string digits;
    for (const char c : text)
        if (c != '_' && c != ' ') digits += c;
    return std::strtod(digits.c_str(), nullptr);
}

/// The characters between the quotes, `$` escapes replaced.
std::u32string parseText(std::string_view text, bool isWide) {
    std::u32string out;
    if (text.size() >= 2) text = text.substr(1, text.size() - 2);
    const auto hex = [](char c) {
        return c >= '0' && c <= '9'   ? c - '0'
               : c >= 'a' && c <= 'f' ? c - 'a' + 10
               : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                      : -1;
    };
    for (size_t i = 0; i < text.size();) {
        if (text[i] != '$' || i + 1 >= text.size()) {
            out += decodeUtf8(text, i);
            continue;
        }
        const char c = text[i + 1];
        // $0A in a STRING, $000A in a WSTRING (table 6).
        const size_t digits = isWide ? 4 : 2;
        if (i + digits < text.size() && hex(c) >= 0) {
            char32_t code = 0;
            bool good = true;
            for (size_t k = 1; k <= digits; ++k) {
                good = good && hex(text[i + k]) >= 0;
                code = code * 16 + static_cast<char32_t>(std::max(0, hex(text[i + k])));
            }
            if (good) {
                out += isWide ? code : types::kRawByte + code;
                i += digits + 1;
                continue;
            }
        }
        i += 2;
        // $N, $R, $$ …; an unknown one is the character itself, as the lexer has said.
        out += types::escapedCharacter(c).value_or(static_cast<unsigned char>(c));
    }
    return out;
}

/// A literal with what surrounds it: the type written before it (INT#5) and the one its place would like.
struct Written {
    const syntax::Expr& e;
    TypeId typed;
    TypeId hint;
};

/// The written type takes the value where it fits.
Operand inWrittenType(Context& context, const Written& written, Operand operand) {
    if (!written.typed.isValid()) return operand;
    // So that conversion looks at the value, and INT#40000 is refused.
    operand.isFlexible = true;
    Operand out = converted(context, operand, written.typed);
    out.isFlexible = false;
    return out;
}

Operand outOfRange(Context& context, const Written& written, const char* largest) {
    context.emit(written.e.range,
                 findings::ConstantOutOfRange(written.e.text, written.typed.isValid() ? context.nameOf(written.typed)
                                                                                      : std::string(largest)));
    return unknown(context, written.e.range);
}

/// INT#16#FFFF is a bit pattern of its type, so it is not too large for an INT although 65535 is.
std::optional<Operand> bitPattern(Context& context, const Written& written, const Integer& number, int64_t bits) {
    const TypeId typed = written.typed;
    const bool takesPatterns =
        typed.isValid() && isNumeric(context, typed) && context.types.family(typed) != types::Family::Real;
    const bool isBased = written.e.text.find('#') != std::string_view::npos;
    if (!takesPatterns || number.isNegative || !isBased) return {};
    const TypeKind kind = context.types.storageKind(typed);
    // Only as many bits as the type has; more are an ordinary value that is too large.
    const unsigned width = types::bitsOf(kind);
    if (width < 64 && number.magnitude >> width != 0) return {};
    return constant(context, {typed, types::wrapInteger(kind, bits)}, written.e.range);
}

Operand integerLiteral(Context& context, const Written& written) {
    const Integer number = parseInteger(written.e.text);
    if (!number.isGood) return unknown(context, written.e.range); // the lexer said so
    if (number.isTooLarge || (number.isNegative && number.magnitude > (uint64_t(1) << 63)))
        return outOfRange(context, written, "LWORD");
    const auto bits = static_cast<int64_t>(number.isNegative ? 0 - number.magnitude : number.magnitude);
    if (const auto pattern = bitPattern(context, written, number, bits)) return *pattern;
    const bool isLarge = !number.isNegative && number.magnitude > static_cast<uint64_t>(INT64_MAX);
    const TypeId type = context.elementary(isLarge ? TypeKind::Ulint : TypeKind::Lint);
    return inWrittenType(context, written, constant(context, {type, bits}, written.e.range, true));
}

Operand realLiteral(Context& context, const Written& written) {
    const double number = parseReal(written.e.text);
    // strtod gives infinity for 1.0E400.
    if (!std::isfinite(number)) return outOfRange(context, written, "LREAL");
    return inWrittenType(context, written,
                         constant(context, {context.elementary(TypeKind::Lreal), number}, written.e.range, true));
}

/// LTIME#…, LD#…: the kinds of 64 bits.
bool isLong(std::string_view text) { return !text.empty() && (text.front() == 'L' || text.front() == 'l'); }

Operand durationLiteral(Context& context, const Written& written) {
    const auto duration = types::parseDuration(written.e.text);
    if (!duration) {
        context.emit(written.e.range, findings::InvalidLiteral(written.e.text, phrases::DurationLiteral()));
        return unknown(context, written.e.range);
    }
    // T#5s for an LTIME is one: both are nanoseconds.
    const bool wantsLong = written.hint.isValid() && context.types.storageKind(written.hint) == TypeKind::Ltime;
    const TypeKind kind = isLong(written.e.text) || wantsLong ? TypeKind::Ltime : TypeKind::Time;
    return constant(context, {context.elementary(kind), *duration}, written.e.range);
}

/// DATE, TIME_OF_DAY and DATE_AND_TIME.
Operand dateLiteral(Context& context, const Written& written) {
    const syntax::Expr& e = written.e;
    const bool isDate = e.op == TokenKind::DateLiteral, isTime = e.op == TokenKind::TimeOfDayLiteral;
    const auto number = isDate   ? types::parseDate(e.text)
                        : isTime ? types::parseTimeOfDay(e.text)
                                 : types::parseDateTime(e.text);
    if (!number) {
        context.emit(e.range, findings::InvalidLiteral(e.text, isDate   ? phrases::DateLiteral()
                                                               : isTime ? phrases::TimeOfDayLiteral()
                                                                        : phrases::DateAndTimeLiteral()));
        return unknown(context, e.range);
    }
    const bool wantsLong = isLong(e.text);
    const TypeKind kind = isDate   ? (wantsLong ? TypeKind::Ldate : TypeKind::Date)
                          : isTime ? (wantsLong ? TypeKind::Ltod : TypeKind::Tod)
                                   : (wantsLong ? TypeKind::Ldt : TypeKind::Dt);
    return constant(context, {context.elementary(kind), *number}, e.range);
}

/// The characters of a text in the forms that its type may want.
struct Characters {
    std::string narrow;   // the bytes of a STRING
    std::u16string wide;  // the code units of a WSTRING
    char32_t foreign = 0; // the first that STRING does not have
};
Characters charactersOf(types::StringCode code, std::u32string_view text, bool isWide) {
    Characters out;
    out.wide = types::wideOfCharacters(text);
    // Read back: "$D83D$DE00" is one character.
    for (const char32_t c : isWide ? types::charactersOfWide(out.wide) : std::u32string(text)) {
        const bool isHalf = isWide && c >= types::kRawByte;
        if ((isHalf || !types::appendCharacter(code, out.narrow, c)) && !out.foreign) out.foreign = isHalf ? 0xFFFD : c;
    }
    // '$C6' is a byte of a STRING also where a WSTRING takes it.
    if (!isWide && !out.foreign) out.wide = types::wideOfString(code, out.narrow);
    return out;
}

Operand notInString(Context& context, const syntax::Expr& e, char32_t foreign) {
    std::string shown;
    appendUtf8(shown, foreign);
    auto& diagnostic =
        context.emit(e.range, findings::CharacterNotInString(shown, types::nameOf(context.types.strings)));
    diagnostic.fixes.push_back({fixes::WriteWstring(),
                                {{{e.range.file, e.range.begin, e.range.begin + 1}, "\""},
                                 {{e.range.file, e.range.end - 1, e.range.end}, "\""}}});
    return unknown(context, e.range);
}

/// A text takes the width that is wanted where it can: "abc" in a STRING is narrow, 'abc' in a WSTRING is wide.
Operand textLiteral(Context& context, const Written& written) {
    const syntax::Expr& e = written.e;
    const bool isWide = e.op == TokenKind::WstringLiteral;
    if (isWide && !written.typed.isValid())
        if (const auto named = quotedName(context, e, written.hint)) return *named;
    const Characters text = charactersOf(context.types.strings, parseText(e.text, isWide), isWide);
    const TypeKind wanted = written.typed.isValid()  ? context.types.storageKind(written.typed)
                            : written.hint.isValid() ? context.types.storageKind(written.hint)
                                                     : TypeKind::Unknown;
    // 'x' and "x" differ by the quotes in the standard; where the type is known it decides, since no text can be
    // misunderstood then.
    const bool toWide =
        isWide ? wanted != TypeKind::String || text.foreign : wanted == TypeKind::Wstring || wanted == TypeKind::Wchar;
    Operand out;
    if (toWide) {
        const TypeId type = textType(context, text.wide.size(), true);
        out = constant(context, {type, text.wide}, e.range);
    } else if (text.foreign) {
        return notInString(context, e, text.foreign);
    } else {
        out = constant(context, {textType(context, text.narrow.size(), false), text.narrow}, e.range);
    }
    return written.typed.isValid() ? converted(context, out, written.typed) : out;
}

} // namespace

///   ok:    16#FF, T#1s500ms      wrong: SINT#200  (P2018)   T#1x  (P1005)
Operand literal(Context& context, const syntax::Expr& e, TypeId hint) {
    Written written{e, {}, hint};
    if (e.prefix.isValid()) {
        written.typed = resolveNamed(context, {e.prefix}, context.scope, e.prefix.range);
        if (context.isKind(written.typed, TypeKind::Unknown)) return unknown(context, e.range);
    }
    switch (e.op) {
    case TokenKind::True:
    case TokenKind::False: {
        const Operand out =
            constant(context, {context.elementary(TypeKind::Bool), int64_t(e.op == TokenKind::True)}, e.range);
        return written.typed.isValid() ? converted(context, out, written.typed) : out;
    }
    case TokenKind::IntegerLiteral:
        return integerLiteral(context, written);
    case TokenKind::RealLiteral:
        return realLiteral(context, written);
    case TokenKind::DurationLiteral:
        return durationLiteral(context, written);
    case TokenKind::DateLiteral:
    case TokenKind::TimeOfDayLiteral:
    case TokenKind::DateTimeLiteral:
        return dateLiteral(context, written);
    case TokenKind::StringLiteral:
    case TokenKind::WstringLiteral:
        return textLiteral(context, written);
    default:
        return unknown(context, e.range);
    }
}

/// "Motor speed" where a variable was declared with that name in quotes.
std::optional<Operand> quotedName(Context& context, const syntax::Expr& e, TypeId hint) {
    if (e.text.size() < 3 || context.isExpression) return std::nullopt;
    // TIA Portal writes names in double quotes; only a variable that was declared so is taken for one.
    const std::string_view inner = e.text.substr(1, e.text.size() - 2);
    const NameId id = context.world.names.find(inner);
    if (!id.isValid()) return std::nullopt;
    const Found result = lookup(context.world, context.scope, id);
    const Variable* variable = result.member.variable ? result.member.variable : result.entity.variable;
    if (!variable || !variable->range.file.isValid()) return std::nullopt;
    const std::string_view written = context.world.textOf(
        {variable->range.file, variable->range.begin ? variable->range.begin - 1 : 0, variable->range.end});
    if (written.substr(0, 2).find('"') == std::string_view::npos) return std::nullopt;
    return value(context, found(context, result, {inner, e.range}, Access::Read, hint), e, hint);
}

// Its value may not be known yet: enumerations are completed when they are first asked for one.
Operand enumerator(Context& context, const EnumeratorRef& ref, SourceRange range) {
    completeEnum(context, *ref.type);
    refer(context, range, ref.type->symbols[ref.index], Access::Read);
    return constant(context, {ref.type->type, context.types[ref.type->type].enumerators[ref.index].value}, range);
}

/// Color#Red, and what reads like it.
Operand typedName(Context& context, const syntax::Expr& e) {
    const TypeId type = resolveNamed(context, {e.prefix}, context.scope, e.prefix.range);
    if (context.isKind(type, TypeKind::Unknown)) return unknown(context, e.range);
    const auto it = context.world.enumsByType.find(type);
    if (it == context.world.enumsByType.end()) {
        context.emit(e.range, findings::InvalidLiteral(context.textOf(e.range), context.nameOf(type)));
        return unknown(context, e.range);
    }
    EnumType& enumeration = *it->second;
    const NameId id = context.key(e.name.text);
    for (uint32_t i = 0; i < enumeration.spec->enumerators.size(); ++i)
        if (context.key(enumeration.spec->enumerators[i].name.text) == id)
            return enumerator(context, {&enumeration, i}, e.name.range);
    suggest(context, context.emit(e.name.range, findings::UnknownMember(context.nameOf(type), e.name.text)),
            e.name.range, e.name.text, memberNames(context.world, enumeration.type));
    return unknown(context, e.range);
}

} // namespace plc::sema
