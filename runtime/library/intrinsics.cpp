// The reference of every intrinsic. Generated code emits the same or calls the same functions (text_runtime.h, libm).
#include "runtime/library/evaluate.h"
#include "runtime/library/text_runtime.h"
#include "runtime/types/conversion.h"

#include <bit>
#include <cmath>
#include <numbers>

namespace plc::library {
namespace {

using types::Family;
using types::TypeId;
using types::TypeKind;
using types::TypeTable;
using types::Value;

/// One call under evaluation: its types, operands and clock.
struct Call {
    const TypeTable& types;
    Intrinsic intrinsic;
    TypeId result;
    std::span<const Value> operands;
    const image::ImageHeader* header;
    int64_t selector;

    [[nodiscard]] TypeKind kind() const { return types.storageKind(result); }
    [[nodiscard]] TypeKind kindOf(size_t operand) const { return types.storageKind(operands[operand].type); }
    [[nodiscard]] int64_t integer(size_t operand) const {
        const auto* number = std::get_if<int64_t>(&operands[operand].data);
        return number ? *number : 0;
    }
    [[nodiscard]] bool isReal(size_t operand) const { return std::holds_alternative<double>(operands[operand].data); }
    [[nodiscard]] double real(size_t operand) const {
        if (isReal(operand)) return operands[operand].real();
        return types::convert(types, operands[operand], TypeTable::of(TypeKind::Lreal)).real();
    }
    /// A count or position: unsigned 64-bit numbers beyond the signed range are "very many".
    [[nodiscard]] int64_t count(size_t operand) const {
        const int64_t number = integer(operand);
        const bool isHuge = number < 0 && (kindOf(operand) == TypeKind::Ulint || kindOf(operand) == TypeKind::Lword);
        return isHuge ? INT64_MAX : number;
    }
};

Evaluated integerResult(const Call& call, int64_t value, bool ok = true) {
    return {{call.result, types::wrapInteger(call.kind(), value)}, ok};
}
Evaluated realResult(const Call& call, double value) {
    return {{call.result, call.kind() == TypeKind::Real ? static_cast<double>(static_cast<float>(value)) : value}};
}

template <class Single, class Wide> Evaluated realFunction(const Call& call, Single single, Wide wide) {
    if (call.kind() == TypeKind::Real)
        return realResult(call, static_cast<double>(single(static_cast<float>(call.real(0)))));
    return realResult(call, wide(call.real(0)));
}
template <class Single, class Wide> Evaluated realFunction2(const Call& call, Single single, Wide wide) {
    if (call.kind() == TypeKind::Real)
        return realResult(
            call, static_cast<double>(single(static_cast<float>(call.real(0)), static_cast<float>(call.real(1)))));
    return realResult(call, wide(call.real(0), call.real(1)));
}

/// Whole numbers of a real: into an integer type they saturate, into a real type they stay real.
template <class Round> Evaluated rounded(const Call& call, Round round) {
    if (!call.isReal(0)) return {types::convert(call.types, call.operands[0], call.result)};
    const double whole = round(call.real(0));
    if (types::familyOf(call.kind()) == Family::Real) return realResult(call, whole);
    return {types::truncate(call.types, {call.operands[0].type, whole}, call.result)};
}

// ---------------------------------------------------------------- arithmetic

Evaluated absolute(const Call& call) {
    if (call.isReal(0)) return realResult(call, std::fabs(call.real(0)));
    const int64_t value = call.integer(0);
    const Family family = types::familyOf(call.kind());
    const bool isSigned = family == Family::Signed || family == Family::Duration;
    return integerResult(call, isSigned && value < 0 ? static_cast<int64_t>(0 - static_cast<uint64_t>(value)) : value);
}

Evaluated square(const Call& call) {
    return evaluateBinary(call.types, BinaryOp::Multiply, call.result, call.operands[0], call.operands[0]);
}

Evaluated fraction(const Call& call) {
    return realFunction(
        call, [](float x) { return x - std::trunc(x); }, [](double x) { return x - std::trunc(x); });
}

Evaluated multiplyDuration(const Call& call) {
    if (call.isReal(1)) return integerResult(call, plc_multiply_duration(call.integer(0), call.real(1)));
    return integerResult(
        call, static_cast<int64_t>(static_cast<uint64_t>(call.integer(0)) * static_cast<uint64_t>(call.integer(1))));
}

Evaluated divideDuration(const Call& call) {
    if (call.isReal(1)) return integerResult(call, plc_divide_duration(call.integer(0), call.real(1)));
    const int64_t divisor = call.count(1);
    if (divisor == 0) return failed(EvaluationError::DivisionByZero);
    if (divisor == -1) return integerResult(call, static_cast<int64_t>(0 - static_cast<uint64_t>(call.integer(0))));
    return integerResult(call, call.integer(0) / divisor);
}

// ---------------------------------------------------------------- bits

Evaluated shifted(const Call& call) {
    const unsigned bits = types::bitsOf(call.kind());
    const uint64_t mask = bits >= 64 ? UINT64_MAX : (uint64_t(1) << bits) - 1;
    const uint64_t word = static_cast<uint64_t>(call.integer(0)) & mask;
    const int64_t count = call.count(1);
    const bool isRotation = call.intrinsic == Intrinsic::Rol || call.intrinsic == Intrinsic::Ror;
    if (!isRotation) {
        if (count < 0 || count >= static_cast<int64_t>(bits)) return integerResult(call, 0);
        return integerResult(
            call, static_cast<int64_t>(call.intrinsic == Intrinsic::Shl ? (word << count) & mask : word >> count));
    }
    int64_t turn = count % static_cast<int64_t>(bits);
    if (call.intrinsic == Intrinsic::Ror) turn = -turn;
    if (turn < 0) turn += bits;
    if (turn == 0) return integerResult(call, static_cast<int64_t>(word));
    return integerResult(
        call, static_cast<int64_t>(((word << turn) | (word >> (bits - static_cast<unsigned>(turn)))) & mask));
}

uint64_t bitPattern(TypeKind kind, const Value& value) {
    if (const auto* real = std::get_if<double>(&value.data)) {
        if (kind == TypeKind::Real) return std::bit_cast<uint32_t>(static_cast<float>(*real));
        return std::bit_cast<uint64_t>(*real);
    }
    return static_cast<uint64_t>(std::get<int64_t>(value.data));
}

Evaluated fromPattern(const Call& call, uint64_t pattern) {
    if (call.kind() == TypeKind::Real)
        return {{call.result, static_cast<double>(std::bit_cast<float>(static_cast<uint32_t>(pattern)))}};
    if (call.kind() == TypeKind::Lreal) return {{call.result, std::bit_cast<double>(pattern)}};
    return integerResult(call, static_cast<int64_t>(pattern));
}

Evaluated swappedBytes(const Call& call) {
    const unsigned bytes = std::max(1u, types::bitsOf(call.kind()) / 8);
    const uint64_t pattern = bitPattern(call.kind(), call.operands[0]);
    uint64_t swapped = 0;
    for (unsigned i = 0; i < bytes; ++i) swapped |= ((pattern >> (8 * i)) & 0xFF) << (8 * (bytes - 1 - i));
    return fromPattern(call, swapped);
}

uint64_t bitsOfOperand(const Call& call) {
    const unsigned bits = types::bitsOf(call.kindOf(0));
    return static_cast<uint64_t>(call.integer(0)) & (bits >= 64 ? UINT64_MAX : (uint64_t(1) << bits) - 1);
}

// ---------------------------------------------------------------- selection

Evaluated extreme(const Call& call, BinaryOp better) {
    Value best = call.operands[0];
    for (const Value& operand : call.operands.subspan(1)) {
        const Evaluated isBetter = evaluateBinary(call.types, better, call.result, operand, best);
        if (isBetter.error != EvaluationError::None) return isBetter;
        if (isBetter.value.isTrue()) best = operand;
    }
    best.type = call.result;
    return {best};
}

/// MIN(MAX(IN, MN), MX), so that MX wins where the limits cross.
Evaluated limited(const Call& call) {
    const Value atLeast[] = {call.operands[1], call.operands[0]};
    Call lower{call.types, Intrinsic::Max, call.result, atLeast, call.header, -1};
    const Evaluated raised = extreme(lower, BinaryOp::Greater);
    if (raised.error != EvaluationError::None) return raised;
    const Value atMost[] = {raised.value, call.operands[2]};
    Call upper{call.types, Intrinsic::Min, call.result, atMost, call.header, -1};
    return extreme(upper, BinaryOp::Less);
}

Evaluated selected(const Call& call, size_t operand) {
    Value value = call.operands[operand];
    value.type = call.result;
    return {std::move(value)};
}

Evaluated multiplexed(const Call& call) {
    const auto last = static_cast<int64_t>(call.operands.size()) - 2;
    return selected(call, static_cast<size_t>(std::clamp<int64_t>(call.count(0), 0, last)) + 1);
}

// ---------------------------------------------------------------- texts

uint32_t capacityOf(const Call& call) { return call.types[call.types.storage(call.result)].capacity; }

/// Runs one of the plc_text functions on the operands' characters; `run` gets the result's buffer.
template <class C, class Run> Evaluated textResult(const Call& call, Run run) {
    const uint32_t capacity = capacityOf(call);
    std::basic_string<C> buffer(capacity + 1, C(0));
    const bool ok = run(buffer.data(), capacity);
    buffer.resize(std::char_traits<C>::length(buffer.data()));
    return {{call.result, std::move(buffer)}, ok};
}

template <class C> const std::basic_string<C>& textOf(const Call& call, size_t operand) {
    return std::get<std::basic_string<C>>(call.operands[operand].data);
}
template <class C> uint32_t sizeOf(const Call& call, size_t operand) {
    return static_cast<uint32_t>(textOf<C>(call, operand).size());
}

template <class C> struct Functions;
#define PLC_FUNCTIONS_OF(C, Prefix)                                                                                    \
    template <> struct Functions<C> {                                                                                  \
        static constexpr auto left = Prefix##_left, right = Prefix##_right;                                            \
        static constexpr auto mid = Prefix##_mid, erase = Prefix##_delete;                                             \
        static constexpr auto insert = Prefix##_insert;                                                                \
        static constexpr auto replace = Prefix##_replace;                                                              \
        static constexpr auto find = Prefix##_find;                                                                    \
        static constexpr auto upper = Prefix##_upper, lower = Prefix##_lower, trim = Prefix##_trim;                    \
        static constexpr auto append = Prefix##_append;                                                                \
        static constexpr auto isNumber = Prefix##_is_number;                                                           \
        static constexpr auto fromCharacter = Prefix##_from_character;                                                 \
    };
PLC_FUNCTIONS_OF(char, plc_text)
PLC_FUNCTIONS_OF(char16_t, plc_wtext)
#undef PLC_FUNCTIONS_OF

template <class C> Evaluated textFunction(const Call& call) {
    using F = Functions<C>;
    const auto text = [&](size_t operand) { return textOf<C>(call, operand).c_str(); };
    const auto size = [&](size_t operand) { return sizeOf<C>(call, operand); };
    const auto whole = [&](auto function) {
        return textResult<C>(call, [&](C* to, uint32_t capacity) {
            function(to, capacity, text(0), size(0));
            return true;
        });
    };
    const auto counted = [&](auto function) {
        return textResult<C>(call, [&](C* to, uint32_t capacity) {
            return function(to, capacity, text(0), size(0), call.count(1)) != 0;
        });
    };
    const auto ranged = [&](auto function) {
        return textResult<C>(call, [&](C* to, uint32_t capacity) {
            return function(to, capacity, text(0), size(0), call.count(1), call.count(2)) != 0;
        });
    };
    switch (call.intrinsic) {
    case Intrinsic::Len:
        return integerResult(call, size(0));
    case Intrinsic::Left:
        return counted(F::left);
    case Intrinsic::Right:
        return counted(F::right);
    case Intrinsic::Mid:
        return ranged(F::mid);
    case Intrinsic::Delete:
        return ranged(F::erase);
    case Intrinsic::Insert:
        return textResult<C>(call, [&](C* to, uint32_t capacity) {
            return F::insert(to, capacity, text(0), size(0), text(1), size(1), call.count(2)) != 0;
        });
    case Intrinsic::Replace:
        return textResult<C>(call, [&](C* to, uint32_t capacity) {
            return F::replace(to, capacity, text(0), size(0), text(1), size(1), call.count(2), call.count(3)) != 0;
        });
    case Intrinsic::Concat:
        return textResult<C>(call, [&](C* to, uint32_t capacity) {
            for (size_t i = 0; i < call.operands.size(); ++i) F::append(to, capacity, text(i), size(i));
            return true;
        });
    case Intrinsic::Find:
        return integerResult(call, F::find(text(0), size(0), text(1), size(1)));
    case Intrinsic::ToUpper:
    case Intrinsic::ToLower: {
        const bool toUpper = call.intrinsic == Intrinsic::ToUpper;
        const types::StringCode code = call.types.strings;
        if constexpr (sizeof(C) == 1)
            if (code != types::StringCode::Latin1)
                return whole([&](char* to, uint32_t capacity, const char* from, uint32_t length) {
                    (toUpper ? plc_text_upper_by : plc_text_lower_by)(to, capacity, from, length,
                                                                      static_cast<uint32_t>(code));
                });
        return whole(toUpper ? F::upper : F::lower);
    }
    case Intrinsic::Trim:
        return whole(F::trim);
    case Intrinsic::IsNumber:
        return integerResult(call, F::isNumber(text(0), size(0)));
    case Intrinsic::AsciiOf:
        return integerResult(call, size(0) ? static_cast<std::make_unsigned_t<C>>(text(0)[0]) : 0);
    case Intrinsic::CharAt: {
        const int64_t index = call.count(1);
        if (index < 0 || index > static_cast<int64_t>(size(0))) return failed(EvaluationError::StringIndex);
        return integerResult(call, static_cast<std::make_unsigned_t<C>>(text(0)[index]));
    }
    default:
        return failed(EvaluationError::NotEvaluable);
    }
}

/// Operands that are characters count as texts of one character; all texts of a call are of one width.
Evaluated anyTextFunction(const Call& call) {
    bool isWide = false;
    for (const Value& operand : call.operands)
        isWide = isWide || std::holds_alternative<std::u16string>(operand.data) ||
                 call.types.storageKind(operand.type) == TypeKind::Wchar;
    std::vector<Value> texts(call.operands.begin(), call.operands.end());
    for (Value& text : texts) {
        if (types::familyOf(call.types.storageKind(text.type)) != Family::Character &&
            !(isWide && std::holds_alternative<std::string>(text.data)))
            continue;
        if (std::holds_alternative<std::u16string>(text.data)) continue;
        if (isWide) {
            std::u16string wide;
            if (const auto* narrow = std::get_if<std::string>(&text.data)) {
                wide = types::wideOfString(call.types.strings, *narrow);
            } else if (text.integer() != 0) {
                wide += static_cast<char16_t>(text.integer());
            }
            text.data = std::move(wide);
        } else {
            text.data = text.integer() == 0 ? std::string() : std::string(1, static_cast<char>(text.integer()));
        }
    }
    const Call prepared{call.types, call.intrinsic, call.result, texts, call.header, call.selector};
    return isWide ? textFunction<char16_t>(prepared) : textFunction<char>(prepared);
}

Evaluated characterText(const Call& call) {
    const auto code = static_cast<uint32_t>(call.integer(0));
    if (call.kind() == TypeKind::Wstring)
        return textResult<char16_t>(call, [&](char16_t* to, uint32_t capacity) {
            plc_wtext_from_character(to, capacity, code);
            return true;
        });
    return textResult<char>(call, [&](char* to, uint32_t capacity) {
        plc_text_from_character(to, capacity, code);
        return true;
    });
}

// ---------------------------------------------------------------- times

template <class Function> Evaluated withOk(const Call& call, Function function) {
    uint8_t ok = 1;
    const int64_t value = function(&ok);
    return integerResult(call, value, ok != 0);
}

/// A field of the header; only a running program has one.
template <class Field> Evaluated ofScan(const Call& call, Field image::ImageHeader::*field) {
    if (!call.header) return failed(EvaluationError::NotEvaluable);
    const bool isAsked = call.kind() == TypeKind::Bool;
    const auto value = static_cast<int64_t>(call.header->*field);
    return integerResult(call, isAsked ? value != 0 : value);
}

} // namespace

Evaluated evaluateIntrinsic(const TypeTable& types, Intrinsic intrinsic, TypeId result, std::span<const Value> operands,
                            const image::ImageHeader* header, int64_t selector) {
    const Call call{types, intrinsic, result, operands, header, selector};
    switch (intrinsic) {
#define PLC_MATH1(Name, function)                                                                                      \
    case Intrinsic::Name:                                                                                              \
        return realFunction(                                                                                           \
            call, [](float x) { return std::function(x); }, [](double x) { return std::function(x); });
#define PLC_MATH2(Name, function)                                                                                      \
    case Intrinsic::Name:                                                                                              \
        return realFunction2(                                                                                          \
            call, [](float x, float y) { return std::function(x, y); },                                                \
            [](double x, double y) { return std::function(x, y); });
#define PLC_OF_SCAN(Name, field)                                                                                       \
    case Intrinsic::Name:                                                                                              \
        return ofScan(call, &image::ImageHeader::field);
#include "runtime/library/intrinsic_meanings.def"
    case Intrinsic::Abs:
        return absolute(call);
    case Intrinsic::Sqrt:
        return realFunction(
            call, [](float x) { return std::sqrt(x); }, [](double x) { return std::sqrt(x); });
    case Intrinsic::ExptInt:
        return integerResult(call, plc_power_integer(call.integer(0), call.count(1)));
    case Intrinsic::Square:
        return square(call);
    case Intrinsic::DegToRad:
        return realResult(call, call.real(0) * (std::numbers::pi / 180));
    case Intrinsic::RadToDeg:
        return realResult(call, call.real(0) * (180 / std::numbers::pi));
    case Intrinsic::Trunc:
    case Intrinsic::TruncReal:
        return rounded(call, [](double x) { return std::trunc(x); });
    case Intrinsic::Floor:
        return rounded(call, [](double x) { return std::floor(x); });
    case Intrinsic::Ceil:
        return rounded(call, [](double x) { return std::ceil(x); });
    case Intrinsic::RoundReal:
        return rounded(call, [](double x) { return std::nearbyint(x); });
    case Intrinsic::Frac:
        return fraction(call);
    case Intrinsic::Shl:
    case Intrinsic::Shr:
    case Intrinsic::Rol:
    case Intrinsic::Ror:
        return shifted(call);
    case Intrinsic::Sel:
        return selected(call, call.operands[0].isTrue() ? 2 : 1);
    case Intrinsic::Max:
        return extreme(call, BinaryOp::Greater);
    case Intrinsic::Min:
        return extreme(call, BinaryOp::Less);
    case Intrinsic::Limit:
        return limited(call);
    case Intrinsic::Mux:
        return multiplexed(call);
    case Intrinsic::Move:
        return selected(call, 0);
    case Intrinsic::Len:
    case Intrinsic::Left:
    case Intrinsic::Right:
    case Intrinsic::Mid:
    case Intrinsic::Concat:
    case Intrinsic::Insert:
    case Intrinsic::Delete:
    case Intrinsic::Replace:
    case Intrinsic::Find:
    case Intrinsic::ToUpper:
    case Intrinsic::ToLower:
    case Intrinsic::Trim:
    case Intrinsic::IsNumber:
    case Intrinsic::CharAt:
    case Intrinsic::AsciiOf:
        return anyTextFunction(call);
    case Intrinsic::CharOf:
        return characterText(call);
    case Intrinsic::MulDuration:
        return multiplyDuration(call);
    case Intrinsic::DivDuration:
        return divideDuration(call);
    case Intrinsic::ConcatDate:
        return withOk(call,
                      [&](uint8_t* ok) { return plc_concat_date(call.count(0), call.count(1), call.count(2), ok); });
    case Intrinsic::ConcatTod:
        return withOk(call, [&](uint8_t* ok) {
            return plc_concat_tod(call.count(0), call.count(1), call.count(2), call.count(3), ok);
        });
    case Intrinsic::ConcatDt:
        return withOk(call, [&](uint8_t* ok) {
            return plc_concat_dt(call.count(0), call.count(1), call.count(2), call.count(3), call.count(4),
                                 call.count(5), call.count(6), ok);
        });
    case Intrinsic::ConcatDateTod:
        return integerResult(call, static_cast<int64_t>(static_cast<uint64_t>(call.integer(0)) +
                                                        static_cast<uint64_t>(call.integer(1))));
    case Intrinsic::DatePart:
        return integerResult(call, plc_date_part(call.integer(0), selector));
    case Intrinsic::TimePart:
        return integerResult(call, plc_time_part(call.integer(0), selector));
    case Intrinsic::BcdTo:
        return withOk(call, [&](uint8_t* ok) {
            return plc_bcd_to_integer(bitsOfOperand(call), static_cast<uint32_t>(call.kind()), ok);
        });
    case Intrinsic::ToBcd:
        return withOk(call, [&](uint8_t* ok) {
            return plc_integer_to_bcd(call.integer(0), static_cast<uint32_t>(call.kindOf(0)),
                                      static_cast<uint32_t>(call.kind()), ok);
        });
    case Intrinsic::IsValid:
        return integerResult(call, std::isfinite(call.real(0)));
    case Intrinsic::IsValidBcd:
        return integerResult(call, plc_is_valid_bcd(bitsOfOperand(call)));
    case Intrinsic::SameBits:
        return fromPattern(call, bitPattern(call.kindOf(0), call.operands[0]));
    case Intrinsic::SwapBytes:
        return swappedBytes(call);
    }
    return failed(EvaluationError::NotEvaluable);
}

} // namespace plc::library
