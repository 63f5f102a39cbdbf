#include "runtime/compiler/sema/calls/variable_info.h"

#include "runtime/compiler/sema/calls/any_inputs.h"
#include "runtime/compiler/sema/calls/special_calls.h"
#include "runtime/compiler/sema/names/lookup.h"
#include "runtime/compiler/sema/names/names.h"
#include "runtime/compiler/sema/names/places.h"
#include "runtime/compiler/sema/statements/statements.h"
#include "runtime/compiler/sema/types/type_specs.h"
#include "runtime/compiler/sema/values/expressions.h"

namespace plc::sema {
namespace {

TypeId infoType(Context& context) {
    const Found found = lookupPath(context.world, context.scope, {{"__SYSTEM", {}}, {"VAR_INFO", {}}});
    return found.entity.type ? resolveDeclared(context, *found.entity.type) : TypeId();
}

/// The one variable between the parentheses, or null: it was reported.
const syntax::Expr* onlyArgument(Context& context, const syntax::Expr& e) {
    if (e.arguments.size() == 1 && e.arguments[0].value) return e.arguments[0].value;
    const Verbatim name("__VARINFO");
    if (e.arguments.size() > 1)
        context.emit(e.arguments[1].range, findings::TooManyArguments(name, 1));
    else
        context.emit(e.base->range, findings::MissingArgument(name, Verbatim("IN")));
    return nullptr;
}

/// What the members of VAR_INFO hold of a type.
struct Measures {
    int64_t bits = 0, elements = 1, elementBits = 0;
    TypeId element;
};
Measures measuresOf(const types::TypeTable& types, TypeId type) {
    Measures out;
    const auto bitsOf = [&](TypeId each) {
        return types.family(each) == types::Family::Bool ? int64_t{1} : int64_t{types[each].size} * 8;
    };
    out.element = type;
    out.bits = bitsOf(type);
    while (types.kind(out.element) == TypeKind::Array) {
        for (const types::Dimension& each : types[out.element].dimensions) out.elements *= each.high - each.low + 1;
        out.element = types[out.element].element;
    }
    out.elementBits = bitsOf(out.element);
    return out;
}

} // namespace

///   ok:    info := __VARINFO(motor.speed);      wrong: __VARINFO()  (P2010)
Operand variableInfo(Context& context, const syntax::Expr& e) {
    const syntax::Expr* argument = onlyArgument(context, e);
    if (!argument) return unknown(context, e.range);
    if (!context.function) {
        context.emit(e.range, context.isExpression ? findings::NotAllowedInExpression(context.textOf(e.base->range))
                                                   : findings::NotConstant());
        return unknown(context, e.range);
    }
    const Denoted denoted = denote(context, *argument, Access::Read);
    if (denoted.kind == Denoted::Kind::Nothing) return unknown(context, e.range);
    const TypeId type = infoType(context);
    if (denoted.kind != Denoted::Kind::Place || !type.isValid()) {
        context.emit(argument->range, findings::TemporaryReference());
        return unknown(context, e.range);
    }
    tree::Place* place = denoted.place;
    if (context.isKind(place->type, TypeKind::Unknown)) return unknown(context, e.range);

    tree::Expr* sequence = newSequence(context, type, e.range);
    tree::Place* made = localPlace(context, newLocal(context, "info", type), type, e.range);
    const auto set = [&](const char* name, const auto& valueOf) {
        const types::Field* field = context.types[type].findField(name);
        tree::Place* at = fieldPlace(context, made, field->offset, field->type, -1, e.range);
        sequence->statements.push_back(assignStmt(context, at, valueOf(field->type).expr, {}));
    };
    const auto setNumber = [&](const char* name, int64_t number) {
        set(name, [&](TypeId t) { return constant(context, {t, number}, e.range); });
    };
    const auto setText = [&](const char* name, const std::string& text) {
        set(name, [&](TypeId t) {
            return constant(context, types::Value{t, text.substr(0, context.types[t].capacity)}, e.range);
        });
    };
    const Measures measures = measuresOf(context.types, place->type);
    if (hasAddress(place))
        set("ByteAddress", [&](TypeId t) { return addressOf(context, place, t, e.range); });
    else
        setNumber("ByteAddress", 0);
    setNumber("BitNr", place->bit);
    setNumber("BitSize", place->bit >= 0 ? 1 : measures.bits);
    setNumber("TypeClass", typeClassOf(context.types, place->type));
    setText("TypeName", context.nameOf(place->type));
    setNumber("NumElements", measures.elements);
    setNumber("BaseTypeClass", typeClassOf(context.types, measures.element));
    setNumber("ElemBitSize", measures.elementBits);
    setText("Symbol", std::string(context.textOf(argument->range)));
    sequence->a = load(context, made, e.range).expr;
    return {sequence, &context.types};
}

} // namespace plc::sema
