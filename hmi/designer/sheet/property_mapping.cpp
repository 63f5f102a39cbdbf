#include "hmi/designer/sheet/property_mapping.h"

#include "editor/kit/texts.h"
#include "hmi/designer/sheet/choice_titles.h"
#include "hmi/model/property_literals.h"
#include "hmi/view/paint/panel_theme.h"

#include <QCoreApplication>

namespace plc::hmi {

namespace {

class Hmi {
    Q_DECLARE_TR_FUNCTIONS(Hmi)
};

kit::PropertyDescriptor base(const PropertyDescriptor& property, const std::string& prefix, const QString& part = {}) {
    kit::PropertyDescriptor row;
    row.id = QString::fromStdString(prefix) + kit::fromView(property.key) + part;
    row.group = titleOf(property.group);
    row.label = Hmi::tr(property.title);
    row.toolTip = toolTipOf(property);
    return row;
}

kit::PropertyDescriptor numberRow(const PropertyDescriptor& property, const std::string& prefix, const QString& part,
                                  const QString& label) {
    kit::PropertyDescriptor row = base(property, prefix, part);
    row.kind = kit::PropertyKind::Number;
    row.decimals = 2;
    row.label = label;
    row.suffix = QStringLiteral(" px");
    return row;
}

/// What a parameter of a faceplate can be: the blocks and types of the program, then simple types.
QStringList parameterTypes(const driver::Checked& checked) {
    QStringList out;
    if (checked.analysis)
        for (const sema::Symbol& symbol : checked.analysis->symbols)
            if (symbol.owner.empty() &&
                (symbol.kind == sema::SymbolKind::FunctionBlock || symbol.kind == sema::SymbolKind::Type))
                out << QString::fromStdString(symbol.name);
    out.removeDuplicates();
    out.sort(Qt::CaseInsensitive);
    for (const char* simple : {"BOOL", "INT", "DINT", "UINT", "REAL", "LREAL", "TIME", "STRING", "text"})
        out << QString::fromLatin1(simple);
    return out;
}

/// What the project has by name is offered.
void stringRow(kit::PropertyDescriptor& row, const PropertyDescriptor& property, const DesignContext& context) {
    row.kind = kit::PropertyKind::Text;
    if (property.key == "access") {
        row.placeholder = Hmi::tr("everybody");
        for (const Role& role : context.project().people.roles()) row.choices.push_back({role.name, role.name, {}});
    } else if (property.key == "recipe" && !context.project().recipes.recipes().empty()) {
        row.kind = kit::PropertyKind::Enumeration;
        row.choices.push_back({QString(), Hmi::tr("none"), {}});
        for (const Recipe& one : context.project().recipes.recipes()) row.choices.push_back({one.name, one.name, {}});
    } else if (property.key == "theme") { // of a button: what the panel's own Theme offers, too
        row.kind = kit::PropertyKind::Enumeration;
        row.choices.push_back({QString(), Hmi::tr("none"), {}});
        const PanelThemes& themes = context.project().themes;
        for (const QString& name : themes.names())
            row.choices.push_back(
                {name, themes.own().count(name) ? name : choiceTitle(property.key, name.toStdString()), {}});
    } else if (property.key == "type") {
        row.words = parameterTypes(context.checked());
    }
}

std::vector<kit::PropertyChoice> colorChoices(const PanelTheme& theme) {
    std::vector<kit::PropertyChoice> out{{QStringLiteral(""), Hmi::tr("as it is"), {}},
                                         {QStringLiteral("none"), Hmi::tr("none"), {}}};
    for (const QString& role : PanelTheme::roles()) out.push_back({role, roleTitle(role), {}, theme.color(role)});
    out.push_back({QStringLiteral("?"), Hmi::tr("Other…"), {}});
    return out;
}

} // namespace

QString toolTipOf(const PropertyDescriptor& property) {
    if (property.type == PropertyType::Expression || property.type == PropertyType::Target) {
        const QString what =
            property.type == PropertyType::Target ? Hmi::tr("A variable that is written") : Hmi::tr("An ST expression");
        return property.hint.empty() ? what : QStringLiteral("%1 (%2)").arg(what, valueKindTitle(property.hint));
    }
    if (property.type == PropertyType::Text)
        return Hmi::tr("Shown to the operator. A typed text gets its key automatically; @key uses an existing one.");
    return {};
}

QString summaryOf(const PropertyDescriptor& property, const Json& value) {
    if (!value.is_structured() || value.empty()) return Hmi::tr("none");
    QStringList names;
    for (const auto& [key, item] : value.items()) {
        if (property.type == PropertyType::Bindings)
            names += QString::fromStdString(key);
        else if (item.is_object() && !item.empty() && item.begin().value().is_string())
            names += toQString(item.begin().value());
    }
    const QString list = names.join(QStringLiteral(", "));
    const QString count = QString::number(value.size());
    return list.isEmpty() ? count : QStringLiteral("%1: %2").arg(count, list.size() > 40 ? list.left(38) + u'…' : list);
}

namespace {

const Panel* placedBy(const Element& element, const DesignContext& context) {
    return context.project().panelLookup()(element.text("panel"_text));
}

} // namespace

std::vector<kit::PropertyDescriptor> argumentRows(const PropertyDescriptor& property, const Element& element,
                                                  const DesignContext& context) {
    std::vector<kit::PropertyDescriptor> out;
    const Panel* placed = placedBy(element, context);
    if (!placed) return out;
    for (const Parameter& parameter : parametersOf(*placed)) {
        kit::PropertyDescriptor row = base(property, {}, u'.' + parameter.name);
        row.label = u'$' + parameter.name;
        row.kind = parameter.isText() ? kit::PropertyKind::Text : kit::PropertyKind::Expression;
        if (!parameter.type.isEmpty() && !parameter.isText()) row.toolTip = parameter.type;
        row.placeholder = parameter.fallback;
        row.defaultValue = QString();
        out.push_back(std::move(row));
    }
    return out;
}

std::optional<Parameter> parameterOf(const Element& element, const QString& gridId, const DesignContext& context) {
    const Panel* placed = gridId.startsWith(QLatin1String("arguments.")) ? placedBy(element, context) : nullptr;
    if (!placed) return {};
    for (const Parameter& parameter : parametersOf(*placed))
        if (gridId.section(u'.', 1).compare(parameter.name, Qt::CaseInsensitive) == 0) return parameter;
    return {};
}

std::vector<kit::PropertyDescriptor> gridRows(const PropertyDescriptor& property, const DesignContext& context,
                                              const std::string& prefix, bool hasParameters, const QString& theme) {
    kit::PropertyDescriptor row = base(property, prefix);
    switch (property.type) {
    case PropertyType::Name:
    case PropertyType::Element:
    case PropertyType::Points:
        return {};
    case PropertyType::Rect:
        return {numberRow(property, prefix, QStringLiteral(".x"), Hmi::tr("X")),
                numberRow(property, prefix, QStringLiteral(".y"), Hmi::tr("Y")),
                numberRow(property, prefix, QStringLiteral(".w"), Hmi::tr("Width")),
                numberRow(property, prefix, QStringLiteral(".h"), Hmi::tr("Height"))};
    case PropertyType::Size: {
        kit::PropertyDescriptor preset = base(property, prefix, QStringLiteral(".preset"));
        preset.kind = kit::PropertyKind::Enumeration;
        for (const auto& [w, h] : {std::pair{800, 480},
                                   {1024, 600},
                                   {1024, 768},
                                   {1280, 800},
                                   {1366, 768},
                                   {1920, 1080},
                                   {480, 800},
                                   {600, 1024},
                                   {800, 1280},
                                   {1080, 1920}})
            preset.choices.push_back({QSize(w, h), QStringLiteral("%1 × %2").arg(w).arg(h), {}});
        auto width = numberRow(property, prefix, QStringLiteral(".w"), Hmi::tr("Width")),
             height = numberRow(property, prefix, QStringLiteral(".h"), Hmi::tr("Height"));
        width.minimum = height.minimum = 16;
        width.maximum = height.maximum = 16384;
        return {preset, width, height};
    }
    case PropertyType::Bool:
        row.kind = kit::PropertyKind::Bool;
        break;
    case PropertyType::Integer:
    case PropertyType::Number:
        row.kind = property.isOptional() || hasParameters   ? kit::PropertyKind::Text
                   : property.type == PropertyType::Integer ? kit::PropertyKind::Integer
                                                            : kit::PropertyKind::Number;
        if (property.isOptional()) row.placeholder = Hmi::tr("none");
        if (const auto range = property.range()) {
            row.minimum = range->first;
            row.maximum = range->second;
        }
        break;
    case PropertyType::Choice:
    case PropertyType::Symbol:
        row.kind = kit::PropertyKind::Enumeration;
        for (const std::string_view choice : property.choices()) {
            const QString word = kit::fromView(choice);
            const bool isSymbol = property.type == PropertyType::Symbol;
            row.choices.push_back({word, isSymbol ? symbolTitle(word) : choiceTitle(property.key, choice), {}});
        }
        if (property.key == "theme")
            for (const auto& [name, theme] : context.project().themes.own()) row.choices.push_back({name, name, {}});
        break;
    case PropertyType::Color:
        row.kind = kit::PropertyKind::Enumeration;
        row.choices = colorChoices(context.project().themes.named(theme));
        break;
    case PropertyType::String:
        stringRow(row, property, context);
        break;
    case PropertyType::Text:
        row.kind = kit::PropertyKind::Text;
        break;
    case PropertyType::TextList:
        row.kind = kit::PropertyKind::Enumeration;
        row.choices.push_back({QString(), Hmi::tr("none"), {}});
        for (const QString& list : context.project().texts.table().listPrefixes())
            row.choices.push_back({list, list, {}});
        break;
    case PropertyType::File:
        row.kind = kit::PropertyKind::File;
        row.fileFilter = Hmi::tr("Pictures (*.png *.jpg *.svg)");
        break;
    case PropertyType::Panel:
        row.kind = kit::PropertyKind::Enumeration;
        row.choices.push_back({QString(), Hmi::tr("none"), {}});
        for (const NamedPanel& panel : context.project().panels) row.choices.push_back({panel.name, panel.name, {}});
        if (property.hint == "faceplate")
            for (const NamedPanel& panel : readyFaceplates()) row.choices.push_back({panel.name, panel.name, {}});
        break;
    case PropertyType::Expression:
    case PropertyType::Target:
        row.kind = kit::PropertyKind::Expression;
        break;
    case PropertyType::Arguments:
        return {}; // argumentRows
    case PropertyType::Bindings:
    case PropertyType::Records:
        row.kind = kit::PropertyKind::Action;
        break;
    }
    row.defaultValue = gridValue(property, property.fallback, row.id, context);
    return {row};
}

QVariant gridValue(const PropertyDescriptor& property, const Json& value, const QString& id,
                   const DesignContext& context) {
    const QString part = id.section(u'.', 1);
    switch (property.type) {
    case PropertyType::Rect: {
        if (!value.is_array() || value.size() != 4) return 0.0;
        const size_t index = part == QStringLiteral("x")   ? 0
                             : part == QStringLiteral("y") ? 1
                             : part == QStringLiteral("w") ? 2
                                                           : 3;
        return value[index].is_number() ? value[index].get<double>() : 0.0;
    }
    case PropertyType::Size: {
        if (!value.is_array() || value.size() != 2) return {};
        const QSize size(value[0].get<int>(), value[1].get<int>());
        return part == QStringLiteral("w")   ? QVariant(double(size.width()))
               : part == QStringLiteral("h") ? QVariant(double(size.height()))
                                             : QVariant(size);
    }
    case PropertyType::Bool:
        return value.is_boolean() && value.get<bool>();
    case PropertyType::Integer:
        if (value.is_string()) return toQString(value);
        return value.is_number() ? QVariant(static_cast<int>(value.get<double>())) : QVariant(0);
    case PropertyType::Number:
        if (value.is_string()) return toQString(value); // a parameter
        if (!property.isOptional()) return value.is_number() ? value.get<double>() : 0.0;
        return value.is_number() ? QString::number(value.get<double>(), 'g', 9) : QString();
    case PropertyType::Text:
        return context.shownText(toQString(value));
    case PropertyType::Arguments: {
        const QString argument = argumentsOf(value).value(part.toLower());
        return argument.startsWith(u'@') ? context.shownText(argument) : argument;
    }
    case PropertyType::Bindings:
    case PropertyType::Records:
        return summaryOf(property, value);
    case PropertyType::Name:
    case PropertyType::Element:
    case PropertyType::Points:
    case PropertyType::Choice:
    case PropertyType::Symbol:
    case PropertyType::Color:
    case PropertyType::String:
    case PropertyType::TextList:
    case PropertyType::File:
    case PropertyType::Panel:
    case PropertyType::Expression:
    case PropertyType::Target:
        return toQString(value);
    }
    return {};
}

Json fromGrid(const PropertyDescriptor& property, const Json& present, const QString& id, const QVariant& edited) {
    const QString part = id.section(u'.', 1);
    switch (property.type) {
    case PropertyType::Rect: {
        Json rect = present.is_array() && present.size() == 4 ? present : Json::array({0, 0, 10, 10});
        const size_t index = part == QStringLiteral("x")   ? 0
                             : part == QStringLiteral("y") ? 1
                             : part == QStringLiteral("w") ? 2
                                                           : 3;
        rect[index] = index >= 2 ? std::max(1.0, edited.toDouble()) : edited.toDouble();
        return canonicalNumbers(rect);
    }
    case PropertyType::Size: {
        if (part == QStringLiteral("preset")) return Json::array({edited.toSize().width(), edited.toSize().height()});
        Json size = present.is_array() && present.size() == 2 ? present : Json::array({1024, 600});
        size[part == QStringLiteral("w") ? 0 : 1] = static_cast<int>(edited.toDouble());
        return size;
    }
    case PropertyType::Bool:
        return edited.toBool();
    case PropertyType::Integer:
        if (edited.toString().startsWith(u'$')) return toUtf8(edited.toString());
        return edited.toInt();
    case PropertyType::Arguments: {
        Json arguments = Json::object();
        if (present.is_object())
            for (const auto& [name, argument] : present.items())
                if (QString::fromStdString(name).compare(part, Qt::CaseInsensitive) != 0) arguments[name] = argument;
        if (!edited.toString().isEmpty()) arguments[part.toStdString()] = toUtf8(edited.toString());
        return arguments;
    }
    case PropertyType::Number: {
        if (edited.toString().startsWith(u'$')) return toUtf8(edited.toString());
        bool ok = false;
        const double number = edited.toDouble(&ok);
        if (ok) return canonicalNumbers(Json(number));
        return property.isOptional() ? Json() : present;
    }
    case PropertyType::Bindings:
    case PropertyType::Records:
    case PropertyType::Name:
    case PropertyType::Element:
    case PropertyType::Points:
        return present;
    case PropertyType::Choice:
    case PropertyType::Symbol:
    case PropertyType::Color:
    case PropertyType::String:
    case PropertyType::Text:
    case PropertyType::TextList:
    case PropertyType::File:
    case PropertyType::Panel:
    case PropertyType::Expression:
    case PropertyType::Target:
        return toUtf8(edited.toString());
    }
    return present;
}

std::string propertyOf(const QString& gridId) { return gridId.section(u'.', 0, 0).toStdString(); }

} // namespace plc::hmi
