#include "projects/session/value_text.h"

#include "runtime/types/conversion.h"

namespace plc::session {

using types::Value;

Result<Value> parseValue(const driver::Checked& checked, types::TypeId type, const std::string& text,
                         const std::string& path) {
    const types::TypeTable& types = *checked.analysis->program->types;
    const std::string typeName = types[type].name;
    auto expression = driver::compileExpression(checked, text);
    if (!expression && types.kind(type) == types::TypeKind::Enum) { // the bare name of one of its values
        expression = driver::compileExpression(checked, typeName + "." + text);
    }
    const Error wrong{text + " is not a value for " + path + ", which is " + typeName, ""};
    if (!expression) return wrong;
    const expression::Outcome outcome = expression->evaluate(std::span<const std::byte>());
    if (!outcome.hasValue()) return wrong;
    if (expression->type() == type || types.isAggregate(type))
        return expression->type() == type ? Result<Value>(outcome.value) : Result<Value>(wrong);
    const bool fromText = types.isText(expression->type()), toText = types.isText(type);
    const bool toBool = types.storageKind(type) == types::TypeKind::Bool,
               fromBool = types.storageKind(expression->type()) == types::TypeKind::Bool;
    if (fromText != toText || (fromBool && !toBool)) return wrong;
    bool ok = true;
    Value value = types::convert(types, outcome.value, type, &ok);
    if (!ok) return wrong;
    const auto family = types.family(type);
    if (types::isInteger(family) && std::holds_alternative<int64_t>(outcome.value.data) &&
        std::holds_alternative<int64_t>(value.data) && value.integer() != outcome.value.integer())
        return Error{text + " does not fit into " + path + ", which is " + typeName, ""};
    return value;
}

} // namespace plc::session
