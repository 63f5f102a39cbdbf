#include "hmi/station/operator_names.h"

#include "hmi/model/property_literals.h"
#include "hmi/model/walk.h"
#include "runtime/inside/slice.h"

namespace plc::hmi {

namespace {

/// What stands on the element or beside it; empty: nothing that names it.
QString nameOf(const Element& element, const TextCatalog& texts, const QString& language) {
    for (const std::string_view key : {"text"_text, "label"_text, "title"_text})
        if (element.has(key))
            if (const QString text = texts.text(element.text(key), language).simplified(); !text.isEmpty()) return text;
    return {};
}

} // namespace

OperatorNames operatorNames(const PanelProject& project, const image::CompiledProgram& program,
                            const QString& language) {
    OperatorNames written, shown;
    for (const NamedPanel& panel : project.panels)
        for (const Element& element : panel.panel.elements()) {
            const QString name = nameOf(element, project.texts, language);
            if (name.isEmpty() || name.contains('{')) continue; // with values in it, it is no name
            forEachBinding(element, [&](const Found& found) {
                if (found.property != "value" && found.property != "target") return;
                const auto place = program.layout.find(found.text.trimmed().toStdString());
                if (!place) return; // an expression
                (found.type == PropertyType::Target ? written : shown)
                    .try_emplace(inside::nameOf(program.layout, *place), name.toStdString());
            });
        }
    written.merge(shown);
    return written;
}

Message inOperatorsWords(const Message& message, const OperatorNames& names) {
    if (message.isEmpty() || names.empty()) return message;
    std::vector<messages::Argument> arguments = message.arguments();
    for (messages::Argument& argument : arguments) {
        if (auto* text = std::get_if<std::string>(&argument)) {
            if (const auto name = names.find(*text); name != names.end()) *text = "“" + name->second + "”";
        } else if (auto* inner = std::get_if<std::shared_ptr<const Message>>(&argument); inner && *inner) {
            *inner = std::make_shared<const Message>(inOperatorsWords(**inner, names));
        }
    }
    return Message(*message.form(), std::move(arguments));
}

} // namespace plc::hmi
