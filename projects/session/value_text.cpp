#include "projects/session/value_text.h"

#include "runtime/base/messages.h"
#include "runtime/base/text.h"
#include "runtime/types/conversion.h"

#include <cmath>

namespace plc::session {

namespace {

using types::Family;
using types::TypeKind;
using types::Value;

Message namesOf(const types::TypeTable& types, types::TypeId type, const std::string& text) {
    std::vector<std::string> names;
    for (types::TypeId id = type; types.kind(id) == TypeKind::Enum || types.kind(id) == TypeKind::Subrange;
         id = types[id].element)
        for (const types::Enumerator& each : types[id].enumerators) names.push_back(each.name);
    if (const auto near = nearestName(text, names)) return errors::DidYouMean(*near);
    constexpr size_t kNamed = 8;
    if (names.size() > kNamed) {
        names.resize(kNamed);
        names.push_back("…");
    }
    return errors::ItsValuesAre(std::move(names));
}

/// What to write instead; empty where there is no example.
Message remedy(const types::TypeTable& types, types::TypeId type, const std::string& text) {
    if (types.kind(type) == TypeKind::Enum) return namesOf(types, type, text);
    switch (types.storageKind(type)) {
    case TypeKind::String:
        return errors::WriteString(Verbatim("'text'"));
    case TypeKind::Wstring:
        return errors::WriteQuoted(Verbatim("\"text\""));
    case TypeKind::Char:
        return errors::WriteCharacter(Verbatim("'A'"));
    case TypeKind::Wchar:
        return errors::WriteCharacter(Verbatim("\"A\""));
    case TypeKind::Array:
        return errors::WriteElements(Verbatim("[1, 2]"));
    case TypeKind::Struct:
        return errors::WriteMembers(Verbatim("(x := 1, y := 2)"));
    default:
        break;
    }
    switch (types.family(type)) {
    case Family::Bool:
        return errors::WriteOneOf(Verbatim("TRUE"), Verbatim("FALSE"));
    case Family::Duration:
        return errors::WriteForExample(Verbatim("T#1s500ms"));
    case Family::Date:
        return errors::WriteForExample(Verbatim("D#2026-01-31"));
    case Family::TimeOfDay:
        return errors::WriteForExample(Verbatim("TOD#06:30:00"));
    case Family::DateTime:
        return errors::WriteForExample(Verbatim("DT#2026-01-31-06:30:00"));
    case Family::Real:
        return errors::WriteNumber(Verbatim("1.5"));
    case Family::Bits:
    case Family::Signed:
    case Family::Unsigned:
        return errors::WriteInteger(Verbatim("5"));
    default:
        return {};
    }
}

Error withRemedy(Message message, Message remedy) {
    if (remedy.isEmpty()) return Error{std::move(message), {}};
    return Error{errors::WithRemedy(std::move(message), std::move(remedy)), {}};
}

/// What a conversion would silently lose: a fraction, the size of a number, which of many numbers a BOOL was.
bool isLost(const types::TypeTable& types, types::TypeId type, const Value& from, const Value& to) {
    const Family family = types.family(type);
    const auto* real = std::get_if<double>(&from.data);
    if (family == Family::Bool && real) return true;
    if (family == Family::Bool) return std::holds_alternative<int64_t>(from.data) && from.integer() >> 1 != 0;
    if (real && types::isInteger(family)) return std::nearbyint(*real) != *real;
    if (const auto* single = std::get_if<double>(&to.data); real && single)
        return std::isinf(*single) && !std::isinf(*real);
    return types::isInteger(family) && std::holds_alternative<int64_t>(from.data) &&
           std::holds_alternative<int64_t>(to.data) && to.integer() != from.integer();
}

} // namespace

Result<Value> parseValue(const driver::Checked& checked, types::TypeId type, const std::string& text,
                         const std::string& path) {
    const types::TypeTable& types = *checked.analysis->program->types;
    const std::string typeName = types[type].name;
    const Error wrong = withRemedy(errors::NotAValue(text, path, typeName), remedy(types, type, text));
    const auto asShown = [&]() -> Result<Value> { // as a value is printed: whole arrays, characters, NaN
        if (auto value = types::parseValue(types, type, text)) return *value;
        return wrong;
    };
    if (types.isAggregate(type) || types.family(type) == Family::Character) return asShown();
    auto expression = driver::compileExpression(checked, text);
    if (!expression && types.kind(type) == TypeKind::Enum) // the bare name of one of its values
        expression = driver::compileExpression(checked, typeName + "." + text);
    if (!expression) return types.family(type) == Family::Real ? asShown() : Result<Value>(wrong);
    const expression::Outcome outcome = expression->evaluate(std::span<const std::byte>());
    if (!outcome.hasValue()) return wrong;
    if (expression->type() == type) return outcome.value;
    const bool fromText = types.isText(expression->type()), toText = types.isText(type);
    const bool toBool = types.storageKind(type) == TypeKind::Bool,
               fromBool = types.storageKind(expression->type()) == TypeKind::Bool;
    if (fromText != toText || (fromBool && !toBool)) return wrong;
    bool ok = true;
    Value value = types::convert(types, outcome.value, type, &ok);
    if (!ok) return wrong;
    if (isLost(types, type, outcome.value, value))
        return withRemedy(errors::ValueLosesData(text, path, typeName), remedy(types, type, text));
    return value;
}

} // namespace plc::session
