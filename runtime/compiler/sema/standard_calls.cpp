// Calls of standard functions and conversions: the overload is chosen by the rule of the signature
// (runtime/library/signatures.h).
#include "runtime/compiler/sema/checker.h"

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

namespace {
/// Bounded by the height of the expression, which the parser limits.
bool containsCall(const syntax::Expr& e) {
    if (e.kind == syntax::ExprKind::Call) return true;
    const auto inArgument = [](const syntax::Argument& a) { return a.value && containsCall(*a.value); };
    return (e.base && containsCall(*e.base)) || (e.right && containsCall(*e.right)) ||
           std::any_of(e.arguments.begin(), e.arguments.end(), inArgument);
}
} // namespace

Operand Checker::standardCall(std::string_view name, const syntax::Expr& e, TypeId hint) {
    if (const Signature* signature = library::findSignature(name)) return signatureCall(*signature, e, hint);
    if (const auto conversion = library::findConversion(name)) return conversionCall(*conversion, name, e, hint);
    return unknown(e.range);
}

/// Arguments of a standard function, by name (tables 22 to 36) or by position.
///   ok:    LIMIT(MN := 1.0, IN := r, MX := 2.0)      wrong: LIMIT(MN := 1.0, INN := r, MX := 2.0)  (P2009)
///          SIN(1.0, 2.0)  (P2011)   SIN()  (P2010)   SEL(G := b, G := b, IN0 := 1, IN1 := 2)  (P2012)
Checker::StandardArguments Checker::standardArguments(const Signature& signature, const syntax::Expr& e) {
    StandardArguments out;
    const size_t count = signature.parameters.size();
    out.inputs.resize(count);
    size_t next = 0;
    const auto put = [&](size_t index, const syntax::Argument& argument) {
        if (index >= out.inputs.size()) out.inputs.resize(index + 1);
        if (out.inputs[index]) {
            emit(argument.name.isValid() ? argument.name.range : argument.range,
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
                emit(argument.range, findings::TooManyArguments(signature.name, count));
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
                emit(argument.name.range, findings::UnknownParameter(signature.name, argument.name.text));
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
            world.suggest(emit(argument.name.range, findings::UnknownParameter(signature.name, argument.name.text)),
                          argument.name.range, argument.name.text, candidates);
            out.isGood = false;
            continue;
        }
        put(*index, argument);
    }
    for (size_t i = 0; i < out.inputs.size(); ++i) {
        if (out.inputs[i] && out.inputs[i]->value) continue;
        if (!out.isGood) break;
        emit(e.base->range,
             findings::MissingArgument(
                 i < count ? std::string(signature.parameters[i].name) : "IN" + std::to_string(i + 1), signature.name));
        out.isGood = false;
    }
    return out;
}

/// The generic types of the standard (edition 3, 6.4.3).
///   ok:    ABS(i)      wrong: ABS(s)  with s : STRING (P2006)
bool Checker::accepts(const library::Parameter& parameter, const Operand& operand, std::string_view functionName) {
    const TypeId type = operand.type();
    const Family family = types.family(type);
    const bool text = types.isText(type);
    const bool elementaryType = family != Family::Other || text;
    const bool isTime = family == Family::Duration;
    bool good = true;
    switch (parameter.generic) {
    case Generic::Fixed:
    case Generic::Any:
        good = !isKind(type, TypeKind::Void);
        break;
    case Generic::AnyElementary:
        good = elementaryType;
        break;
    case Generic::AnyMagnitude:
        good = isNumeric(type) || isTime || family == Family::Date || family == Family::TimeOfDay ||
               family == Family::DateTime || isKind(type, TypeKind::Pointer) || family == Family::Character;
        break;
    case Generic::AnyNum:
    case Generic::AnyReal:
        good = isNumeric(type);
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
        good = isNumeric(type) || isTime;
        break;
    }
    if (good) return true;
    if (isKind(type, TypeKind::Void))
        emit(operand.expr->range, findings::NoValue(textOf(operand.expr->range)));
    else
        emit(operand.expr->range,
             findings::OperatorNotForType(functionName, nameOf(operand.isFlexible ? smallestType(operand) : type)));
    return false;
}

/// Makes the operands from `first` on equal in type; the first of them is returned (for its type), unknown when they do
/// not combine.
Operand Checker::makeCommon(std::vector<Operand>& operands, size_t first, const Signature& signature, TypeId hint) {
    Operand common;
    const SourceRange range = operands[first].expr->range;
    const bool anyText = std::any_of(operands.begin() + static_cast<std::ptrdiff_t>(first), operands.end(),
                                     [&](const Operand& o) { return types.isText(o.type()); });
    if (anyText) {
        TypeId type;
        for (size_t i = first; i < operands.size(); ++i)
            if (isKind(operands[i].type(), TypeKind::Wstring) &&
                (!type.isValid() || types[operands[i].type()].capacity > types[type].capacity))
                type = operands[i].type();
        for (size_t i = first; i < operands.size() && (!type.isValid() || !isKind(type, TypeKind::Wstring)); ++i)
            if (types.isText(operands[i].type()) &&
                (!type.isValid() || types[operands[i].type()].capacity > types[type].capacity))
                type = operands[i].type();
        for (size_t i = first; i < operands.size(); ++i) {
            if (types.kind(operands[i].type()) != types.kind(type)) operands[i] = converted(operands[i], type);
            if (operands[i].isUnknown()) return unknown(range);
        }
        Operand out = operands[first];
        for (size_t i = first; i < operands.size(); ++i)
            if (types[operands[i].type()].capacity > types[out.type()].capacity) out = operands[i];
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
        if (world.sameType(strongest->type(), operand.type())) continue;
        const TypeId type = commonType(*strongest, operand);
        if (!type.isValid()) {
            emit(operand.expr->range,
                 findings::OperandsDoNotMatch(signature.name, nameOf(strongest->type()), nameOf(operand.type())));
            return unknown(range);
        }
        Operand probe = load(absolutePlace(0, type, -1, range), range);
        strongest = probe;
    }
    TypeId type;
    if (strongest) {
        type = strongest->type();
        if (types.family(type) != Family::Other && !isKind(type, TypeKind::Enum)) type = types.storage(type);
        for (size_t i = first; i < operands.size(); ++i) {
            if (!operands[i].isFlexible) continue;
            const bool numeric = isNumeric(type);
            if (!numeric || fits(operands[i].expr->value, type)) continue; // converted below, with its message
            Operand probe = load(absolutePlace(0, type, -1, range), range);
            const TypeId wider = commonType(probe, operands[i]);
            if (wider.isValid()) type = wider;
            if (types.family(type) == Family::Real && hint.isValid() && types.family(hint) == Family::Real)
                type = types.storage(hint);
        }
    } else {
        const bool real =
            std::any_of(operands.begin() + static_cast<std::ptrdiff_t>(first), operands.end(),
                        [](const Operand& o) { return std::holds_alternative<double>(o.expr->value.data); });
        bool hintFits = hint.isValid() && isNumeric(hint) && (!real || types.family(hint) == Family::Real);
        for (size_t i = first; hintFits && i < operands.size(); ++i) hintFits = fits(operands[i].expr->value, hint);
        if (hintFits)
            type = types.storage(hint);
        else if (real)
            type = elementary(TypeKind::Lreal);
        else {
            type = elementary(TypeKind::Int);
            for (size_t i = first; i < operands.size(); ++i)
                if (types[smallestType(operands[i])].size > types[type].size ||
                    types.kind(smallestType(operands[i])) == TypeKind::Ulint)
                    type = smallestType(operands[i]);
        }
    }
    for (size_t i = first; i < operands.size(); ++i) {
        Operand& operand = operands[i];
        if (types.isAggregate(type) || isKind(type, TypeKind::Interface) || isKind(type, TypeKind::Pointer))
            operand = converted(operand, type);
        else
            operand = operand.isFlexible || !isNumeric(type) ? converted(operand, type) : convertNode(operand, type);
        if (operand.isUnknown()) return unknown(range);
    }
    return operands[first];
}

Operand Checker::operatorCall(const Signature& signature, std::vector<Operand> operands, const syntax::Expr& e,
                              TypeId hint) {
    const std::string_view name = signature.operatorName;
    const SourceRange at = e.base->range;
    if (operands.size() == 1) {
        if (signature.selector >= 0) {
            const Operand one = constant({elementary(TypeKind::Lint), signature.selector}, e.range, true);
            return combine(name == "+" ? BinaryOp::Add : BinaryOp::Subtract, signature.name, settled(operands[0], hint),
                           one, e.range, at, hint);
        }
        if (name == "NOT") return inverted(operands[0].isFlexible ? settled(operands[0], hint) : operands[0], e.range);
        return negated(operands[0], e.range);
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
            const Operand next = compare(op, signature.name, operands[i], operands[i + 1], e.range, at);
            if (next.isUnknown()) return unknown(e.range);
            all = i == 0 ? next : makeBinary(BinaryOp::And, elementary(TypeKind::Bool), all, next, e.range);
        }
        return all;
    }
    Operand result = operands[0];
    for (size_t i = 1; i < operands.size() && !result.isUnknown(); ++i)
        result = combine(op, signature.name, result, operands[i], e.range, at, hint);
    return result;
}

Operand Checker::signatureCall(const Signature& signature, const syntax::Expr& e, TypeId hint) {
    if (signature.rule == Rule::Special) return specialCall(signature, e, hint);
    const StandardArguments arguments = standardArguments(signature, e);
    const bool compares = signature.rule == Rule::Compare;
    const bool passesHint = !compares && signature.rule != Rule::FixedResult && hint.isValid();
    std::vector<Operand> operands;
    bool good = arguments.isGood;
    for (size_t i = 0; i < arguments.inputs.size(); ++i) {
        if (!arguments.inputs[i] || !arguments.inputs[i]->value) continue;
        const library::Parameter& parameter = signature.parameters[std::min(i, signature.parameters.size() - 1)];
        const bool isFixed = parameter.generic == Generic::Fixed;
        TypeId wanted = isFixed && parameter.fixed != TypeKind::String && parameter.fixed != TypeKind::Wstring
                            ? elementary(parameter.fixed)
                            : TypeId();
        if (isFixed && parameter.fixed == TypeKind::Wstring) wanted = textType(80, true);
        if (!isFixed && compares && !operands.empty() && !operands[0].isUnknown() && !operands[0].isFlexible)
            wanted = operands[0].type();
        if (!isFixed && passesHint && parameter.generic != Generic::AnyInt) wanted = hint;
        Operand operand = expression(*arguments.inputs[i]->value, wanted);
        if (!operand.isUnknown() && arguments.inputs[i]->negated) operand = inverted(operand, operand.expr->range);
        if (!operand.isUnknown()) {
            if (isFixed)
                operand = converted(operand, parameter.fixed == TypeKind::String ? textType(80, false) : wanted);
            else if (!accepts(parameter, operand, signature.name))
                operand = unknown(e.range);
            else if (parameter.generic == Generic::AnyText && types.family(operand.type()) == Family::Character)
                operand = convertNode(operand, textType(1, types.storageKind(operand.type()) == TypeKind::Wchar));
        }
        good = good && !operand.isUnknown();
        operands.push_back(operand);
    }
    if (!good) return unknown(e.range);
    std::vector<tree::Stmt*> before = holdAsWritten(operands, arguments.inputs);
    Operand out = signatureResult(signature, std::move(operands), e, hint);
    if (!before.empty() && !out.isUnknown()) {
        tree::Expr* sequence = arena.make<tree::Expr>();
        sequence->kind = tree::ExprKind::Sequence;
        sequence->range = e.range;
        sequence->type = out.type();
        sequence->statements = std::move(before);
        sequence->a = out.expr;
        out = {sequence, &types};
    }
    return withEnable(out, arguments, e.range);
}

/// Arguments given by name in another order than the parameters' are evaluated as written where one of them is a call,
/// which may change what another one reads.
///   SEL(IN1 := Next(), IN0 := Next(), G := b): IN1 has the first number
std::vector<tree::Stmt*> Checker::holdAsWritten(std::vector<Operand>& operands,
                                                const std::vector<const syntax::Argument*>& inputs) {
    if (!function || std::is_sorted(inputs.begin(), inputs.end())) return {};
    if (std::none_of(inputs.begin(), inputs.end(), [](const syntax::Argument* a) { return containsCall(*a->value); }))
        return {};
    std::vector<size_t> written(operands.size());
    std::iota(written.begin(), written.end(), size_t(0));
    std::sort(written.begin(), written.end(), [&](size_t a, size_t b) { return inputs[a] < inputs[b]; });
    std::vector<tree::Stmt*> before;
    for (const size_t i : written)
        if (!operands[i].isFlexible) operands[i].expr = held(operands[i].expr, before);
    return before;
}

/// What the rule of the signature makes of the operands, which are all good.
Operand Checker::signatureResult(const Signature& signature, std::vector<Operand> operands, const syntax::Expr& e,
                                 TypeId hint) {
    if (!signature.operatorName.empty()) {
        Operand out = operatorCall(signature, operands, e, hint);
        if (!out.isUnknown() && signature.rule == Rule::FixedResult && signature.result != TypeKind::Unknown &&
            out.type() != elementary(signature.result))
            out = sameBits(out, elementary(signature.result));
        return out;
    }
    using library::Intrinsic;
    const Intrinsic code = *signature.intrinsic;
    TypeId result;
    switch (signature.rule) {
    case Rule::Common: {
        const Operand common = makeCommon(operands, 0, signature, hint);
        if (common.isUnknown()) return unknown(e.range);
        result = common.type();
        if (code == Intrinsic::Concat) {
            size_t sum = 0;
            for (const Operand& operand : operands) sum += types[operand.type()].capacity;
            const bool wide = isKind(result, TypeKind::Wstring);
            if (sum > types[result].capacity)
                result = textType(std::max<size_t>(types[result].capacity, std::min<size_t>(sum, 255)), wide);
        }
        break;
    }
    case Rule::FirstOperand: {
        for (size_t i = 0; i < operands.size(); ++i) operands[i] = settled(operands[i], i == 0 ? hint : TypeId());
        result = operands[0].type();
        if (isKind(result, TypeKind::Subrange)) result = types.storage(result);
        if ((code == Intrinsic::Insert || code == Intrinsic::Replace) && operands.size() > 1) {
            if (types.kind(operands[1].type()) != types.kind(result)) operands[1] = converted(operands[1], result);
            if (operands[1].isUnknown()) return unknown(e.range);
            const size_t sum = types[result].capacity + types[operands[1].type()].capacity;
            result = textType(std::max<size_t>(types[result].capacity, std::min<size_t>(sum, 255)),
                              isKind(result, TypeKind::Wstring));
        }
        break;
    }
    case Rule::FixedResult: {
        for (Operand& operand : operands) operand = settled(operand);
        if (code == Intrinsic::Find && types.kind(operands[0].type()) != types.kind(operands[1].type())) {
            Operand& narrow = isKind(operands[0].type(), TypeKind::String) ? operands[0] : operands[1];
            narrow = convertedText(narrow, isKind(operands[0].type(), TypeKind::Wstring) ? operands[0].type()
                                                                                         : operands[1].type());
            if (narrow.isUnknown()) return unknown(e.range);
        }
        result = signature.result == TypeKind::String    ? textType(1, false)
                 : signature.result == TypeKind::Wstring ? textType(1, true)
                                                         : elementary(signature.result);
        const bool cuts = code == Intrinsic::Trunc || code == Intrinsic::Floor || code == Intrinsic::Ceil;
        if (cuts) {
            if (signature.name == "TRUNC" && hint.isValid() && types::isInteger(types.family(hint)))
                result = types.storage(hint);
            if (types.family(operands[0].type()) != Family::Real) return convertNode(operands[0], result);
        }
        break;
    }
    case Rule::RealOperand: {
        TypeKind kind = TypeKind::Unknown;
        bool onlyFlexible = true;
        for (const Operand& operand : operands) {
            if (operand.isFlexible) continue;
            onlyFlexible = false;
            const TypeKind own = types.storageKind(operand.type());
            const bool wide =
                own == TypeKind::Lreal || (types::isInteger(types.family(operand.type())) && types::bitsOf(own) > 16);
            if (wide)
                kind = TypeKind::Lreal;
            else if (kind == TypeKind::Unknown)
                kind = TypeKind::Real;
        }
        if (onlyFlexible)
            kind = hint.isValid() && types.storageKind(hint) == TypeKind::Real ? TypeKind::Real : TypeKind::Lreal;
        // an integer argument is computed in the real type that is wanted
        const bool wholeOnly = std::all_of(operands.begin(), operands.end(),
                                           [&](const Operand& o) { return types.family(o.type()) != Family::Real; });
        if (wholeOnly && hint.isValid() && types.family(hint) == Family::Real) kind = types.storageKind(hint);
        result = elementary(kind);
        for (Operand& operand : operands) {
            operand = operand.isFlexible ? converted(operand, result) : convertNode(operand, result);
            if (operand.isUnknown()) return unknown(e.range);
        }
        break;
    }
    case Rule::SecondOperand: {
        operands[0] = settled(operands[0]);
        const Operand common = makeCommon(operands, 1, signature, hint);
        if (common.isUnknown()) return unknown(e.range);
        result = common.type();
        break;
    }
    case Rule::Compare:
    case Rule::Special:
        return unknown(e.range);
    }
    if (isExpression && code == Intrinsic::Move) return operands[0];
    return intrinsic(code, result, operands, e.range, signature.selector);
}

/// A literal as the argument of a conversion named by types.
///   ok:    INT_TO_STRING(5); BOOL_TO_INT(TRUE);      wrong: STRING_TO_INT(5); INT_TO_STRING('x'); TIME_TO_INT(5);
bool Checker::suitsConversion(const Operand& literal, TypeId from) const {
    const Family family = types.family(from);
    const bool isNumber = std::holds_alternative<int64_t>(literal.expr->value.data) ||
                          std::holds_alternative<double>(literal.expr->value.data);
    const bool isText = types.isText(literal.type()) || types.family(literal.type()) == Family::Character;
    if (isText || !isNumber) return types.isText(from) || family == Family::Character;
    return types::isInteger(family) || family == Family::Real;
}

///   ok:    INT_TO_REAL(i)      wrong: INT_TO_REAL(s)  with s : STRING (P2003)
Operand Checker::conversionCall(const library::Conversion& conversion, std::string_view name, const syntax::Expr& e,
                                TypeId hint) {
    Signature signature;
    signature.name = name;
    signature.parameters.push_back({"IN", {"IN1", "STR", "X"}, Generic::Any});
    const StandardArguments arguments = standardArguments(signature, e);
    if (!arguments.isGood || arguments.inputs.empty() || !arguments.inputs[0]) return unknown(e.range);
    using How = library::Conversion::How;
    const auto idOf = [&](TypeKind kind) -> TypeId {
        if (kind != TypeKind::String && kind != TypeKind::Wstring) return elementary(kind);
        const bool wide = kind == TypeKind::Wstring;
        if (!world.frozen && hint.isValid() && types.kind(hint) == kind && types[hint].capacity > 80) return hint;
        return textType(80, wide);
    };
    const TypeId from = conversion.from == TypeKind::Unknown ? TypeId() : idOf(conversion.from);
    const syntax::Expr& value = *arguments.inputs[0]->value;
    const bool isTextLiteral =
        value.kind == syntax::ExprKind::Literal && !value.prefix.isValid() &&
        (value.op == lex::TokenKind::StringLiteral || value.op == lex::TokenKind::WstringLiteral);
    const bool takesText = !from.isValid() || types.isText(from) || types.family(from) == Family::Character;
    Operand operand = expression(value, isTextLiteral && !takesText ? TypeId() : from);
    if (isTextLiteral && !takesText && !operand.isUnknown()) { // 'x' is no number here
        emit(value.range, findings::TypeMismatch(textOf(value.range), nameOf(from)));
        return unknown(e.range);
    }
    if (operand.isUnknown()) return unknown(e.range);
    if (isKind(operand.type(), TypeKind::Void)) {
        emit(operand.expr->range, findings::NoValue(textOf(operand.expr->range)));
        return unknown(e.range);
    }
    const bool isAddress = isKind(operand.type(), TypeKind::Pointer) || isKind(operand.type(), TypeKind::Reference) ||
                           isKind(operand.type(), TypeKind::Interface);
    if (isAddress) operand = sameBits(operand, elementary(TypeKind::Lword));
    if (from.isValid() && !isAddress) {
        if (operand.isFlexible && conversion.how == How::Convert && types::isInteger(types.family(from)) &&
            !fits(operand.expr->value, from) && std::holds_alternative<int64_t>(operand.expr->value.data))
            operand = converted(operand, from);
        else if (operand.isFlexible && suitsConversion(operand, from))
            operand = convertNode(operand, types.isText(from) ? smallestType(operand) : from);
        else if (types.isText(from) && types.isText(operand.type()))
            operand = convertedText(operand, from);
        else
            operand = converted(operand, from);
    } else {
        operand = settled(operand);
    }
    if (operand.isUnknown()) return unknown(e.range);
    const Family family = types.family(operand.type());
    if (family == Family::Other && !types.isText(operand.type())) {
        emit(operand.expr->range, findings::OperatorNotForType(name, nameOf(operand.type())));
        return unknown(e.range);
    }
    TypeId to = idOf(conversion.to);
    switch (conversion.how) {
    case How::Convert: {
        Operand out = convertNode(operand, to);
        out.expr->range = e.range;
        if (out.expr == operand.expr && out.expr->kind != tree::ExprKind::Constant) { // same type: nothing to do
            if (arguments.eno)
                return withEnable(intrinsic(library::Intrinsic::Move, to, {operand}, e.range), arguments, e.range);
        }
        return withEnable(out, arguments, e.range);
    }
    case How::Truncate:
        return withEnable(intrinsic(library::Intrinsic::Trunc, to, {operand}, e.range), arguments, e.range);
    case How::FromBcd:
    case How::ToBcd: {
        if (!types::isInteger(family)) {
            emit(operand.expr->range, findings::OperatorNotForType(name, nameOf(operand.type())));
            return unknown(e.range);
        }
        const bool toBcd = conversion.how == How::ToBcd;
        const std::string upper = foldCase(name);
        const bool open = toBcd && upper.ends_with("_bcd"); // INT_TO_BCD takes the bit string that is wanted
        if (open && hint.isValid() && types.family(hint) == Family::Bits) to = types.storage(hint);
        return withEnable(
            intrinsic(toBcd ? library::Intrinsic::ToBcd : library::Intrinsic::BcdTo, to, {operand}, e.range), arguments,
            e.range);
    }
    }
    return unknown(e.range);
}

} // namespace plc::sema
