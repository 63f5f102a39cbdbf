#include "tests/pictures/online_value.h"

#include "runtime/controller/controller.h"

namespace plc::pictures {

editor::GraphValue onlineValue(session::Session& session, const QString& expression, const std::string& instance) {
    editor::GraphValue out;
    const auto compiled = session.expression(expression.toStdString(), instance);
    if (!compiled) return out;
    const auto outcome = compiled->evaluate(session.controller().image());
    if (!outcome.hasValue()) return out;
    out.text = QString::fromStdString(types::toText(compiled->types(), outcome.value));
    const types::TypeKind kind = compiled->types().storageKind(compiled->type());
    out.isTrue = kind == types::TypeKind::Bool && outcome.value.isTrue();
    if (kind == types::TypeKind::Time) out.nanoseconds = outcome.value.integer();
    return out;
}

} // namespace plc::pictures
