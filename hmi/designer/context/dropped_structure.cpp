#include "hmi/designer/context/dropped_structure.h"

#include "hmi/model/faceplate.h"
#include "hmi/model/property_literals.h"
#include "hmi/station/program_facts.h"

#include <algorithm>

namespace plc::hmi {

QString structureType(const QString& path, const DesignContext& context) {
    const auto compiled = driver::compileExpression(context.checked(), path.toStdString());
    if (!compiled) return {};
    const types::TypeKind kind = compiled->types().kind(compiled->type());
    if (kind != types::TypeKind::Struct && kind != types::TypeKind::Block) return {};
    const QStringList names = typeNamesOf(context.checked(), path);
    return names.isEmpty() ? QString() : names.front();
}

std::optional<Element> faceplateFor(const QString& path, const DesignContext& context) {
    const QStringList names = typeNamesOf(context.checked(), path);
    for (const NamedPanel& one : context.project().panels) {
        QString taker; // the one parameter that has to be given something
        int needed = 0;
        for (const Parameter& parameter : parametersOf(one.panel)) {
            if (!parameter.fallback.isEmpty() || parameter.isText()) continue;
            ++needed;
            if (names.contains(parameter.type, Qt::CaseInsensitive)) taker = parameter.name;
        }
        if (needed != 1 || taker.isEmpty()) continue;
        Element element = Element::make(ElementKind::Faceplate, QString(), QRectF(QPointF(), one.panel.size()));
        element.set("panel"_field, toUtf8(one.name));
        Json arguments = Json::object();
        arguments[toUtf8(taker)] = toUtf8(path);
        element.set("arguments"_field, std::move(arguments));
        element.set("name"_field, toUtf8(path.section(u'.', -1)));
        return element;
    }
    return {};
}

} // namespace plc::hmi
