// Calls of standard functions and conversions: the overload is chosen by the rule of the signature
// (runtime/library/signatures.h).
#include "runtime/compiler/sema/calls/standard_calls.h"

#include "runtime/compiler/sema/calls/calls.h"
#include "runtime/compiler/sema/calls/operators_of_codesys.h"
#include "runtime/compiler/sema/calls/special_calls.h"
#include "runtime/compiler/sema/context.h"
#include "runtime/compiler/sema/names/lookup.h"
#include "runtime/compiler/sema/names/places.h"
#include "runtime/compiler/sema/operators/operators.h"
#include "runtime/compiler/sema/types/conversions.h"
#include "runtime/compiler/sema/types/type_specs.h"
#include "runtime/compiler/sema/values/expressions.h"

#include "runtime/base/text.h"
#include "runtime/types/conversion.h"

#include <numeric>

namespace plc::sema {

using library::BinaryOp;
using library::Generic;
using library::Rule;
using library::Signature;
using syntax::ArgumentKind;
using types::Family;

static bool accepts(Context& context, const library::Parameter& parameter, const Operand& operand,
                    std::string_view function);
static Operand makeCommon(Context& context, std::vector<Operand>& operands, size_t first,
                          const library::Signature& signature, TypeId hint);
static Operand operatorCall(Context& context, const library::Signature& signature, std::vector<Operand> operands,
                            const syntax::Expr& e, TypeId hint);
static Operand signatureCall(Context& context, const library::Signature& signature, const syntax::Expr& e, TypeId hint);
static std::vector<tree::Stmt*> holdAsWritten(Context& context, std::vector<Operand>& operands,
                                              const std::vector<const syntax::Argument*>& inputs);
static Operand signatureResult(Context& context, const library::Signature& signature, std::vector<Operand> operands,
                               const syntax::Expr& e, TypeId hint);
static bool suitsConversion(const Context& context, const Operand& literal, TypeId from);
static Operand conversionCall(Context& context, const library::Conversion& conversion, std::string_view name,
                              const syntax::Expr& e, TypeId hint);

namespace {
/// Bounded by the height of the expression, which the parser limits.
bool containsCall(const syntax::Expr& e) {
    if (e.kind == syntax::ExprKind::Call) return true;
    const auto inArgument = [](const syntax::Argument& a) { return a.value && containsCall(*a.value); };
    return (e.base && containsCall(*e.base)) || (e.right && containsCall(*e.right)) ||
           std::any_of(e.arguments.begin(), e.arguments.end(), inArgument);
}
} // namespace

Operand standardCall(Context& context, std::string_view name, const syntax::Expr& e, TypeId hint) {
    if (const Signature* signature = library::findSignature(name)) return signatureCall(context, *signature, e, hint);
    if (const auto conversion = library::findConversion(name))
        return conversionCall(context, *conversion, name, e, hint);
    return unknown(context, e.range);
}

/// Arguments of a standard function, by name (tables 22 to 36) or by position.
///   ok:    LIMIT(MN := 1.0, IN := r, MX := 2.0)      wrong: LIMIT(MN := 1.0, INN := r, MX := 2.0)  (P2009)
///          SIN(1.0, 2.0)  (P2011)   SIN()  (P2010)   SEL(G := b, G := b, IN0 := 1, IN1 := 2)  (P2012)
StandardArguments standardArguments(Context& context, const Signature& signature, const syntax::Expr& e) {
    StandardArguments out;
    const size_t count = signature.parameters.size();
    out.inputs.resize(count);
    size_t next = 0;
    const auto put = [&](size_t index, const syntax::Argument& argument) {
        if (index >= out.inputs.size()) out.inputs.resize(index + 1);
        if (out.inputs[index]) {
            context.emit(argument.name.isValid() ? argument.name.range : argument.range,
                         findings::ArgumentTwice(index < count ? std::string(signature.parameters[index].name)
                                                               : std::string(argument.name.text)));
            out.isGood = false;
        }
        out.inputs[index] = &argument;
    };
    for (const syntax::Argument& argument : e.arguments) {
        if (argument.kind == ArgumentKind::Positional) {
            if (!argument.value) continue;
            if (next >= count && !signature.isExtensible) {
                context.emit(argument.range, findings::TooManyArguments(signature.name, count));
                out.isGood = false;
                break;
            }
            put(next++, argument);
            continue;
        }
        if (argument.kind == ArgumentKind::Output) {
            if (equalsIgnoringCase(argument.name.text, "ENO"))
                out.eno = &argument;
            else {
                context.emit(argument.name.range, findings::UnknownParameter(signature.name, argument.name.text));
                out.isGood = false;
            }
            continue;
        }
        if (equalsIgnoringCase(argument.name.text, "EN")) {
            out.en = &argument;
            continue;
        }
        std::optional<size_t> index;
        for (size_t i = 0; i < count && !index; ++i)
            if (equalsIgnoringCase(signature.parameters[i].name, argument.name.text)) index = i;
        for (size_t i = 0; i < count && !index; ++i)
            for (const std::string_view other : signature.parameters[i].otherNames)
                if (!index && equalsIgnoringCase(other, argument.name.text)) index = i;
        if (!index && signature.isExtensible && count) { // IN3, IN4, … behind the last
            const std::string_view last = signature.parameters.back().name;
            const size_t digits = last.find_first_of("0123456789");
            if (digits != std::string_view::npos && argument.name.text.size() > digits &&
                equalsIgnoringCase(last.substr(0, digits), argument.name.text.substr(0, digits))) {
                const int first = std::atoi(std::string(last.substr(digits)).c_str());
                const int number = std::atoi(std::string(argument.name.text.substr(digits)).c_str());
                if (number > first && number < first + 1000) index = count - 1 + static_cast<size_t>(number - first);
            }
        }
        if (!index) {
            std::vector<std::string> candidates;
            for (const library::Parameter& parameter : signature.parameters) candidates.emplace_back(parameter.name);
            suggest(context,
                    context.emit(argument.name.range, findings::UnknownParameter(signature.name, argument.name.text)),
                    argument.name.range, argument.name.text, candidates);
            out.isGood = false;
            continue;
        }
        put(*index, argument);
    }
    for (size_t i = 0; i < out.inputs.size(); ++i) {
        if (out.inputs[i] && out.inputs[i]->value) continue;
        if (!out.isGood) break;
        context.emit(e.base->range, findings::MissingArgument(i < count ? std::string(signature.parameters[i].name)
                                                                        : "IN" + std::to_string(i + 1),
                                                              signature.name));
        out.isGood = false;
    }
    return out;
}

/// The generic types of the standard (edition 3, 6.4.3).
///   ok:    ABS(i)      wrong: ABS(s)  with s : STRING (P2006)
bool accepts(Context& context, const library::Parameter& parameter, const Operand& operand,
             std::string_view functionName) {
    const TypeId type = operand.type();
    const Family family = context.types.family(type);
    const bool text = context.types.isText(type);
    const bool elementaryType = family != Family::Other || text;
    const bool isTime = family == Family::Duration;
    bool good = true;
    switch (parameter.generic) {
    case Generic::Fixed:
    case Generic::Any:
        good = !context.isKind(type, TypeKind::Void);
        break;
    case Generic::AnyElementary:
        good = elementaryType;
        break;
    case Generic::AnyMagnitude:
        good = isNumeric(context, type) || isTime || family == Family::Date || family == Family::TimeOfDay ||
               family == Family::DateTime || context.isKind(type, TypeKind::Pointer) || family == Family::Character;
        break;
    case Generic::AnyNum:
    case Generic::AnyReal:
        good = isNumeric(context, type);
        break;
    case Generic::AnyInt:
        good = types::isInteger(family);
        break;
    case Generic::AnyBit:
        good = types::isInteger(family) || family == Family::Bool;
        break;
    case Generic::AnyText:
        good = text || family == Family::Character;
        break;
    case Generic::AnyDate:
        good = family == Family::Date || family == Family::DateTime || family == Family::TimeOfDay;
        break;
    case Generic::AnyDuration:
        good = isTime;
        break;
    case Generic::AnyNumOrDuration:
        good = isNumeric(context, type) || isTime;
        break;
    }
    if (good) return true;
    if (context.isKind(type, TypeKind::Void))
        context.emit(operand.expr->range, findings::NoValue(context.textOf(operand.expr->range)));
    else
        context.emit(operand.expr->range,
                     findings::OperatorNotForType(
                         functionName, context.nameOf(operand.isFlexible ? smallestType(context, operand) : type)));
    return false;
}

/// Makes the operands from `first` on equal in type; the first of them is returned (for its type), unknown when they do
/// not combine.
Operand makeCommon(Context& context, std::vector<Operand>& operands, size_t first, const Signature& signature,
                   TypeId hint) {
    const SourceRange range = operands[first].expr->range;
    const bool anyText = std::any_of(operands.begin() + static_cast<std::ptrdiff_t>(first), operands.end(),
                                     [&](const Operand& o) { return context.types.isText(o.type()); });
    if (anyText) {
        TypeId type;
        for (size_t i = first; i < operands.size(); ++i)
            if (context.isKind(operands[i].type(), TypeKind::Wstring) &&
                (!type.isValid() || context.types[operands[i].type()].capacity > context.types[type].capacity))
                type = operands[i].type();
        for (size_t i = first; i < operands.size() && (!type.isValid() || !context.isKind(type, TypeKind::Wstring));
             ++i)
            if (context.types.isText(operands[i].type()) &&
                (!type.isValid() || context.types[operands[i].type()].capacity > context.types[type].capacity))
                type = operands[i].type();
        for (size_t i = first; i < operands.size(); ++i) {
            if (context.types.kind(operands[i].type()) != context.types.kind(type))
                operands[i] = converted(context, operands[i], type);
            if (operands[i].isUnknown()) return unknown(context, range);
        }
        Operand out = operands[first];
        for (size_t i = first; i < operands.size(); ++i)
            if (context.types[operands[i].type()].capacity > context.types[out.type()].capacity) out = operands[i];
        return out;
    }
    std::optional<Operand> strongest;
    for (size_t i = first; i < operands.size(); ++i) {
        const Operand& operand = operands[i];
        if (operand.isFlexible) continue;
        if (!strongest) {
            strongest = operand;
            continue;
        }
        if (sameType(context.world, strongest->type(), operand.type())) continue;
        const TypeId type = commonType(context, *strongest, operand);
        if (!type.isValid()) {
            context.emit(operand.expr->range,
                         findings::OperandsDoNotMatch(signature.name, context.nameOf(strongest->type()),
                                                      context.nameOf(operand.type())));
            return unknown(context, range);
        }
        Operand probe = load(context, absolutePlace(context, 0, type, -1, range), range);
        strongest = probe;
    }
    TypeId type;
    if (strongest) {
        type = strongest->type();
        if (context.types.family(type) != Family::Other && !context.isKind(type, TypeKind::Enum))
            type = context.types.storage(type);
        for (size_t i = first; i < operands.size(); ++i) {
            if (!operands[i].isFlexible) continue;
            const bool numeric = isNumeric(context, type);
            if (!numeric || fits(context, operands[i].expr->value, type)) continue; // converted below, with its message
            Operand probe = load(context, absolutePlace(context, 0, type, -1, range), range);
            const TypeId wider = commonType(context, probe, operands[i]);
            if (wider.isValid()) type = wider;
            if (context.types.family(type) == Family::Real && hint.isValid() &&
                context.types.family(hint) == Family::Real)
                type = context.types.storage(hint);
        }
    } else {
        const bool real =
            std::any_of(operands.begin() + static_cast<std::ptrdiff_t>(first), operands.end(),
                        [](const Operand& o) { return std::holds_alternative<double>(o.expr->value.data); });
        bool hintFits =
            hint.isValid() && isNumeric(context, hint) && (!real || context.types.family(hint) == Family::Real);
        for (size_t i = first; hintFits && i < operands.size(); ++i)
            hintFits = fits(context, operands[i].expr->value, hint);
        if (hintFits)
            type = context.types.storage(hint);
        else if (real)
            type = context.elementary(TypeKind::Lreal);
        else {
            type = context.elementary(TypeKind::Int);
            for (size_t i = first; i < operands.size(); ++i)
                if (context.types[smallestType(context, operands[i])].size > context.types[type].size ||
                    context.types.kind(smallestType(context, operands[i])) == TypeKind::Ulint)
                    type = smallestType(context, operands[i]);
        }
    }
    for (size_t i = first; i < operands.size(); ++i) {
        Operand& operand = operands[i];
        if (context.types.isAggregate(type) || context.isKind(type, TypeKind::Interface) ||
            context.isKind(type, TypeKind::Pointer))
            operand = converted(context, operand, type);
        else
            operand = operand.isFlexible || !isNumeric(context, type) ? converted(context, operand, type)
                                                                      : convertNode(context, operand, type);
        if (operand.isUnknown()) return unknown(context, range);
    }
    return operands[first];
}

Operand operatorCall(Context& context, const Signature& signature, std::vector<Operand> operands, const syntax::Expr& e,
                     TypeId hint) {
    const std::string_view name = signature.operatorName;
    const SourceRange at = e.base->range;
    if (operands.size() == 1) {
        if (signature.selector >= 0) {
            const Operand one =
                constant(context, {context.elementary(TypeKind::Lint), signature.selector}, e.range, true);
            return combine(context, name == "+" ? BinaryOp::Add : BinaryOp::Subtract, signature.name,
                           settled(context, operands[0], hint), one, e.range, at, hint);
        }
        if (name == "NOT")
            return inverted(context, operands[0].isFlexible ? settled(context, operands[0], hint) : operands[0],
                            e.range);
        return negated(context, operands[0], e.range);
    }
    static constexpr std::pair<std::string_view, BinaryOp> kOperators[] = {
        {"+", BinaryOp::Add},       {"-", BinaryOp::Subtract},     {"*", BinaryOp::Multiply},
        {"/", BinaryOp::Divide},    {"MOD", BinaryOp::Modulo},     {"AND", BinaryOp::And},
        {"OR", BinaryOp::Or},       {"XOR", BinaryOp::Xor},        {"=", BinaryOp::Equal},
        {"<>", BinaryOp::NotEqual}, {"<", BinaryOp::Less},         {"<=", BinaryOp::LessEqual},
        {">", BinaryOp::Greater},   {">=", BinaryOp::GreaterEqual}};
    BinaryOp op = BinaryOp::Add;
    for (const auto& [spelling, code] : kOperators)
        if (spelling == name) op = code;
    if (signature.rule == Rule::Compare) {
        Operand all;
        for (size_t i = 0; i + 1 < operands.size(); ++i) {
            const Operand next = compare(context, op, signature.name, operands[i], operands[i + 1], e.range, at);
            if (next.isUnknown()) return unknown(context, e.range);
            all = i == 0 ? next
                         : makeBinary(context, BinaryOp::And, context.elementary(TypeKind::Bool), all, next, e.range);
        }
        return all;
    }
    Operand result = operands[0];
    for (size_t i = 1; i < operands.size() && !result.isUnknown(); ++i)
        result = combine(context, op, signature.name, result, operands[i], e.range, at, hint);
    return result;
}

Operand signatureCall(Context& context, const Signature& signature, const syntax::Expr& e, TypeId hint) {
    if (signature.rule == Rule::Special) return specialCall(context, signature, e, hint);
    const StandardArguments arguments = standardArguments(context, signature, e);
    const bool compares = signature.rule == Rule::Compare;
    const bool passesHint = !compares && signature.rule != Rule::FixedResult && hint.isValid();
    std::vector<Operand> operands;
    bool good = arguments.isGood;
    for (size_t i = 0; i < arguments.inputs.size(); ++i) {
        if (!arguments.inputs[i] || !arguments.inputs[i]->value) continue;
        const library::Parameter& parameter = signature.parameters[std::min(i, signature.parameters.size() - 1)];
        const bool isFixed = parameter.generic == Generic::Fixed;
        TypeId wanted = isFixed && parameter.fixed != TypeKind::String && parameter.fixed != TypeKind::Wstring
                            ? context.elementary(parameter.fixed)
                            : TypeId();
        if (isFixed && parameter.fixed == TypeKind::Wstring) wanted = textType(context, 80, true);
        if (!isFixed && compares && !operands.empty() && !operands[0].isUnknown() && !operands[0].isFlexible)
            wanted = operands[0].type();
        if (!isFixed && passesHint && parameter.generic != Generic::AnyInt) wanted = hint;
        Operand operand = expression(context, *arguments.inputs[i]->value, wanted);
        if (!operand.isUnknown() && arguments.inputs[i]->negated)
            operand = inverted(context, operand, operand.expr->range);
        if (!operand.isUnknown()) {
            if (isFixed)
                operand = converted(context, operand,
                                    parameter.fixed == TypeKind::String ? textType(context, 80, false) : wanted);
            else if (!accepts(context, parameter, operand, signature.name))
                operand = unknown(context, e.range);
            else if (parameter.generic == Generic::AnyText && context.types.family(operand.type()) == Family::Character)
                operand =
                    convertNode(context, operand,
                                textType(context, 1, context.types.storageKind(operand.type()) == TypeKind::Wchar));
        }
        good = good && !operand.isUnknown();
        operands.push_back(operand);
    }
    if (!good) return unknown(context, e.range);
    std::vector<tree::Stmt*> before = holdAsWritten(context, operands, arguments.inputs);
    Operand out = signatureResult(context, signature, std::move(operands), e, hint);
    if (!before.empty() && !out.isUnknown()) {
        tree::Expr* sequence = context.arena.make<tree::Expr>();
        sequence->kind = tree::ExprKind::Sequence;
        sequence->range = e.range;
        sequence->type = out.type();
        sequence->statements = std::move(before);
        sequence->a = out.expr;
        out = {sequence, &context.types};
    }
    return withEnable(context, out, arguments, e.range);
}

/// Arguments given by name in another order than the parameters' are evaluated as written where one of them is a call,
/// which may change what another one reads.
///   SEL(IN1 := Next(), IN0 := Next(), G := b): IN1 has the first number
std::vector<tree::Stmt*> holdAsWritten(Context& context, std::vector<Operand>& operands,
                                       const std::vector<const syntax::Argument*>& inputs) {
    if (!context.function || std::is_sorted(inputs.begin(), inputs.end())) return {};
    if (std::none_of(inputs.begin(), inputs.end(), [](const syntax::Argument* a) { return containsCall(*a->value); }))
        return {};
    std::vector<size_t> written(operands.size());
    std::iota(written.begin(), written.end(), size_t(0));
    std::sort(written.begin(), written.end(), [&](size_t a, size_t b) { return inputs[a] < inputs[b]; });
    std::vector<tree::Stmt*> before;
    for (const size_t i : written)
        if (!operands[i].isFlexible) operands[i].expr = held(context, operands[i].expr, before);
    return before;
}

/// What the rule of the signature makes of the operands, which are all good.
Operand signatureResult(Context& context, const Signature& signature, std::vector<Operand> operands,
                        const syntax::Expr& e, TypeId hint) {
    if (!signature.operatorName.empty()) {
        Operand out = operatorCall(context, signature, operands, e, hint);
        if (!out.isUnknown() && signature.rule == Rule::FixedResult && signature.result != TypeKind::Unknown &&
            out.type() != context.elementary(signature.result))
            out = sameBits(context, out, context.elementary(signature.result));
        return out;
    }
    using library::Intrinsic;
    const Intrinsic code = *signature.intrinsic;
    TypeId result;
    switch (signature.rule) {
    case Rule::Common: {
        const Operand common = makeCommon(context, operands, 0, signature, hint);
        if (common.isUnknown()) return unknown(context, e.range);
        result = common.type();
        if (code == Intrinsic::Concat) {
            size_t sum = 0;
            for (const Operand& operand : operands) sum += context.types[operand.type()].capacity;
            const bool wide = context.isKind(result, TypeKind::Wstring);
            if (sum > context.types[result].capacity)
                result = textType(context, std::max<size_t>(context.types[result].capacity, std::min<size_t>(sum, 255)),
                                  wide);
        }
        break;
    }
    case Rule::FirstOperand: {
        for (size_t i = 0; i < operands.size(); ++i)
            operands[i] = settled(context, operands[i], i == 0 ? hint : TypeId());
        result = operands[0].type();
        if (context.isKind(result, TypeKind::Subrange)) result = context.types.storage(result);
        if ((code == Intrinsic::Insert || code == Intrinsic::Replace) && operands.size() > 1) {
            if (context.types.kind(operands[1].type()) != context.types.kind(result))
                operands[1] = converted(context, operands[1], result);
            if (operands[1].isUnknown()) return unknown(context, e.range);
            const size_t sum = context.types[result].capacity + context.types[operands[1].type()].capacity;
            result = textType(context, std::max<size_t>(context.types[result].capacity, std::min<size_t>(sum, 255)),
                              context.isKind(result, TypeKind::Wstring));
        }
        break;
    }
    case Rule::FixedResult: {
        for (Operand& operand : operands) operand = settled(context, operand);
        if (code == Intrinsic::Find &&
            context.types.kind(operands[0].type()) != context.types.kind(operands[1].type())) {
            Operand& narrow = context.isKind(operands[0].type(), TypeKind::String) ? operands[0] : operands[1];
            narrow = convertedText(context, narrow,
                                   context.isKind(operands[0].type(), TypeKind::Wstring) ? operands[0].type()
                                                                                         : operands[1].type());
            if (narrow.isUnknown()) return unknown(context, e.range);
        }
        result = signature.result == TypeKind::String    ? textType(context, 1, false)
                 : signature.result == TypeKind::Wstring ? textType(context, 1, true)
                                                         : context.elementary(signature.result);
        const bool cuts = code == Intrinsic::Trunc || code == Intrinsic::Floor || code == Intrinsic::Ceil;
        if (cuts) {
            if (signature.name == "TRUNC" && hint.isValid() && types::isInteger(context.types.family(hint)))
                result = context.types.storage(hint);
            if (context.types.family(operands[0].type()) != Family::Real)
                return convertNode(context, operands[0], result);
        }
        break;
    }
    case Rule::RealOperand: {
        TypeKind kind = TypeKind::Unknown;
        bool onlyFlexible = true;
        for (const Operand& operand : operands) {
            if (operand.isFlexible) continue;
            onlyFlexible = false;
            const TypeKind own = context.types.storageKind(operand.type());
            const bool wide = own == TypeKind::Lreal ||
                              (types::isInteger(context.types.family(operand.type())) && types::bitsOf(own) > 16);
            if (wide)
                kind = TypeKind::Lreal;
            else if (kind == TypeKind::Unknown)
                kind = TypeKind::Real;
        }
        if (onlyFlexible)
            kind =
                hint.isValid() && context.types.storageKind(hint) == TypeKind::Real ? TypeKind::Real : TypeKind::Lreal;
        // an integer argument is computed in the real type that is wanted
        const bool wholeOnly = std::all_of(operands.begin(), operands.end(), [&](const Operand& o) {
            return context.types.family(o.type()) != Family::Real;
        });
        if (wholeOnly && hint.isValid() && context.types.family(hint) == Family::Real)
            kind = context.types.storageKind(hint);
        result = context.elementary(kind);
        for (Operand& operand : operands) {
            operand = operand.isFlexible ? converted(context, operand, result) : convertNode(context, operand, result);
            if (operand.isUnknown()) return unknown(context, e.range);
        }
        break;
    }
    case Rule::SecondOperand: {
        operands[0] = settled(context, operands[0]);
        const Operand common = makeCommon(context, operands, 1, signature, hint);
        if (common.isUnknown()) return unknown(context, e.range);
        result = common.type();
        break;
    }
    case Rule::Compare:
    case Rule::Special:
        return unknown(context, e.range);
    }
    if (context.isExpression && code == Intrinsic::Move) return operands[0];
    return intrinsic(context, code, result, operands, e.range, signature.selector);
}

/// A literal as the argument of a conversion named by types.
///   ok:    INT_TO_STRING(5); BOOL_TO_INT(TRUE);      wrong: STRING_TO_INT(5); INT_TO_STRING('x'); TIME_TO_INT(5);
bool suitsConversion(const Context& context, const Operand& literal, TypeId from) {
    const Family family = context.types.family(from);
    const bool isNumber = std::holds_alternative<int64_t>(literal.expr->value.data) ||
                          std::holds_alternative<double>(literal.expr->value.data);
    const bool isText =
        context.types.isText(literal.type()) || context.types.family(literal.type()) == Family::Character;
    if (isText || !isNumber) return context.types.isText(from) || family == Family::Character;
    return types::isInteger(family) || family == Family::Real;
}

///   ok:    INT_TO_REAL(i)      wrong: INT_TO_REAL(s)  with s : STRING (P2003)
Operand conversionCall(Context& context, const library::Conversion& conversion, std::string_view name,
                       const syntax::Expr& e, TypeId hint) {
    Signature signature;
    signature.name = name;
    signature.parameters.push_back({"IN", {"IN1", "STR", "X"}, Generic::Any});
    const StandardArguments arguments = standardArguments(context, signature, e);
    if (!arguments.isGood || arguments.inputs.empty() || !arguments.inputs[0]) return unknown(context, e.range);
    using How = library::Conversion::How;
    const auto idOf = [&](TypeKind kind) -> TypeId {
        if (kind != TypeKind::String && kind != TypeKind::Wstring) return context.elementary(kind);
        const bool wide = kind == TypeKind::Wstring;
        if (!context.isExpression && hint.isValid() && context.types.kind(hint) == kind &&
            context.types[hint].capacity > 80)
            return hint;
        return textType(context, 80, wide);
    };
    const TypeId from = conversion.from == TypeKind::Unknown ? TypeId() : idOf(conversion.from);
    const syntax::Expr& value = *arguments.inputs[0]->value;
    const bool isTextLiteral =
        value.kind == syntax::ExprKind::Literal && !value.prefix.isValid() &&
        (value.op == lex::TokenKind::StringLiteral || value.op == lex::TokenKind::WstringLiteral);
    const bool takesText =
        !from.isValid() || context.types.isText(from) || context.types.family(from) == Family::Character;
    Operand operand = expression(context, value, isTextLiteral && !takesText ? TypeId() : from);
    if (isTextLiteral && !takesText && !operand.isUnknown()) { // 'x' is no number here
        context.emit(value.range, findings::TypeMismatch(context.textOf(value.range), context.nameOf(from)));
        return unknown(context, e.range);
    }
    if (operand.isUnknown()) return unknown(context, e.range);
    if (context.isKind(operand.type(), TypeKind::Void)) {
        context.emit(operand.expr->range, findings::NoValue(context.textOf(operand.expr->range)));
        return unknown(context, e.range);
    }
    const bool isAddress = context.isKind(operand.type(), TypeKind::Pointer) ||
                           context.isKind(operand.type(), TypeKind::Reference) ||
                           context.isKind(operand.type(), TypeKind::Interface);
    if (isAddress) operand = sameBits(context, operand, context.elementary(TypeKind::Lword));
    if (from.isValid() && !isAddress) {
        if (operand.isFlexible && conversion.how == How::Convert && types::isInteger(context.types.family(from)) &&
            !fits(context, operand.expr->value, from) && std::holds_alternative<int64_t>(operand.expr->value.data))
            operand = converted(context, operand, from);
        else if (operand.isFlexible && suitsConversion(context, operand, from))
            operand = convertNode(context, operand, context.types.isText(from) ? smallestType(context, operand) : from);
        else if (context.types.isText(from) && context.types.isText(operand.type()))
            operand = convertedText(context, operand, from);
        else
            operand = converted(context, operand, from);
    } else {
        operand = settled(context, operand);
    }
    if (operand.isUnknown()) return unknown(context, e.range);
    const Family family = context.types.family(operand.type());
    if (family == Family::Other && !context.types.isText(operand.type())) {
        context.emit(operand.expr->range, findings::OperatorNotForType(name, context.nameOf(operand.type())));
        return unknown(context, e.range);
    }
    TypeId to = idOf(conversion.to);
    switch (conversion.how) {
    case How::Convert: {
        if (const auto named = nameOfValue(context, operand, to, e.range))
            return withEnable(context, *named, arguments, e.range);
        Operand out = convertNode(context, operand, to);
        out.expr->range = e.range;
        if (out.expr == operand.expr && out.expr->kind != tree::ExprKind::Constant) { // same type: nothing to do
            if (arguments.eno)
                return withEnable(context, intrinsic(context, library::Intrinsic::Move, to, {operand}, e.range),
                                  arguments, e.range);
        }
        return withEnable(context, out, arguments, e.range);
    }
    case How::Truncate:
        return withEnable(context, intrinsic(context, library::Intrinsic::Trunc, to, {operand}, e.range), arguments,
                          e.range);
    case How::FromBcd:
    case How::ToBcd: {
        if (!types::isInteger(family)) {
            context.emit(operand.expr->range, findings::OperatorNotForType(name, context.nameOf(operand.type())));
            return unknown(context, e.range);
        }
        const bool toBcd = conversion.how == How::ToBcd;
        const std::string upper = foldCase(name);
        const bool open = toBcd && upper.ends_with("_bcd"); // INT_TO_BCD takes the bit string that is wanted
        if (open && hint.isValid() && context.types.family(hint) == Family::Bits) to = context.types.storage(hint);
        return withEnable(
            context,
            intrinsic(context, toBcd ? library::Intrinsic::ToBcd : library::Intrinsic::BcdTo, to, {operand}, e.range),
            arguments, e.range);
    }
    }
    return unknown(context, e.range);
}

} // namespace plc::sema
