#include "hmi/model/faceplate.h"

#include "hmi/model/layout.h"
#include "hmi/model/property_literals.h"

#include <QRegularExpression>
#include <QSet>

namespace plc::hmi {

namespace {

constexpr int kDeepest = 8;

bool isNameStart(QChar c) { return c.isLetter() || c == u'_'; }
bool isNamePart(QChar c) { return c.isLetterOrNumber() || c == u'_'; }

/// The end of the name that begins at `from`.
qsizetype nameEnd(const QString& text, qsizetype from) {
    while (from < text.size() && isNamePart(text[from])) ++from;
    return from;
}

/// The end of the ST text (in quotes of one kind) that begins at `from`; `$` escapes within it.
qsizetype quoteEnd(const QString& text, qsizetype from) {
    const QChar quote = text[from++];
    while (from < text.size() && text[from] != quote) from += text[from] == u'$' ? 2 : 1;
    return std::min(from + 1, text.size());
}

/// Goes over an expression: pieces as they are, and the names behind `$`.
void forEachPiece(const QString& expression, bool hasQuotes, const std::function<void(const QString&)>& plain,
                  const std::function<void(const QString& name)>& parameter) {
    qsizetype begin = 0, i = 0;
    const auto flush = [&](qsizetype end) {
        if (end > begin) plain(expression.mid(begin, end - begin));
    };
    while (i < expression.size()) {
        if (hasQuotes && (expression[i] == u'\'' || expression[i] == u'"')) {
            i = quoteEnd(expression, i);
        } else if (expression[i] == u'$' && i + 1 < expression.size() && isNameStart(expression[i + 1])) {
            flush(i);
            begin = nameEnd(expression, i + 1);
            parameter(expression.mid(i + 1, begin - i - 1));
            i = begin;
        } else {
            ++i;
        }
    }
    flush(expression.size());
}

/// A variable's path or a plain number needs no brackets around it.
bool isSimple(const QString& argument) {
    static const QRegularExpression path(
        QStringLiteral("^[\\p{L}\\p{N}_%#][\\p{L}\\p{N}_.%#]*(\\[[^\\[\\]]*\\]|\\^|\\.[\\p{L}\\p{N}_.]+)*$"));
    return path.match(argument).hasMatch();
}

} // namespace

std::string_view Parameter::wanted() const {
    const QString word = type.section(u'(', 0, 0).section(u'[', 0, 0).section(u' ', 0, 0).toUpper();
    static const QSet<QString> numbers{"SINT", "INT",   "DINT",  "LINT", "USINT", "UINT", "UDINT", "ULINT", "BYTE",
                                       "WORD", "DWORD", "LWORD", "REAL", "LREAL", "TIME", "LTIME", "NUMBER"};
    if (word == QStringLiteral("BOOL")) return "bool";
    if (numbers.contains(word)) return "number";
    if (word == QStringLiteral("STRING") || word == QStringLiteral("WSTRING")) return "text";
    if (word == QStringLiteral("ARRAY")) return "array";
    return {};
}

std::vector<Parameter> parametersOf(const Panel& panel) {
    std::vector<Parameter> out;
    const Json& rows = panel.at("parameters"_field);
    if (!rows.is_array()) return out;
    const auto field = [](const Json& row, const char* key) {
        const auto found = row.find(key);
        return found == row.end() ? QString() : toQString(*found).trimmed();
    };
    for (const Json& row : rows)
        if (row.is_object() && !field(row, "name").isEmpty())
            out.push_back({field(row, "name"), field(row, "type"), field(row, "value")});
    return out;
}

Arguments argumentsOf(const Json& fields) {
    Arguments out;
    if (!fields.is_object()) return out;
    for (const auto& [name, value] : fields.items()) {
        const QString text =
            value.is_number() || value.is_boolean() ? QString::fromStdString(value.dump()) : toQString(value).trimmed();
        if (!text.isEmpty()) out.insert(QString::fromStdString(name).toLower(), text);
    }
    return out;
}

Arguments completed(const std::vector<Parameter>& parameters, Arguments given) {
    for (const Parameter& parameter : parameters) {
        const QString key = parameter.name.toLower();
        if (given.contains(key)) continue;
        given.insert(key, parameter.isText() ? textWithArguments(parameter.fallback, given)
                                             : withArguments(parameter.fallback, given));
    }
    return given;
}

QStringList parameterNames(const QString& expression) {
    QStringList out;
    forEachPiece(
        expression, true, [](const QString&) {}, [&](const QString& name) { out += name; });
    return out;
}

QString withArguments(const QString& expression, const Arguments& arguments) {
    if (!expression.contains(u'$')) return expression;
    QString out;
    bool isMissing = false;
    const QString alone = expression.trimmed().mid(1);
    forEachPiece(
        expression, true, [&](const QString& piece) { out += piece; },
        [&](const QString& name) {
            const auto found = arguments.constFind(name.toLower());
            if (found == arguments.constEnd())
                out += u'$' + name; // the front end will say that nothing is called so
            else if (found->isEmpty())
                isMissing = true;
            else
                out += alone == name || isSimple(*found) ? *found : u'(' + *found + u')';
        });
    return isMissing ? QString() : out;
}

QString textWithArguments(const QString& text, const Arguments& arguments) {
    if (!text.contains(u'$')) return text;
    QString out;
    forEachPiece(
        text, false, [&](const QString& piece) { out += piece; },
        [&](const QString& name) { out += arguments.value(name.toLower(), u'$' + name); });
    return out;
}

namespace {

Json textValue(const QString& text) { return toUtf8(text); }

/// A number, a truth value or the like that the file writes as "$limit".
Json literalValue(const Json& value, const PropertyDescriptor& property, const Arguments& arguments) {
    if (!value.is_string()) return value;
    const QString text = textWithArguments(toQString(value), arguments).trimmed();
    bool isNumber = false;
    const double number = text.toDouble(&isNumber);
    if (property.type != PropertyType::Bool) return isNumber ? canonicalNumbers(Json(number)) : property.fallback;
    if (text.compare(QStringLiteral("TRUE"), Qt::CaseInsensitive) == 0) return true;
    return isNumber && number != 0;
}

Json substitutedValue(const PropertyDescriptor& property, const Json& value, const Arguments& arguments);

Json substitutedRecords(const PropertyDescriptor& property, const Json& rows, const Arguments& arguments) {
    if (!rows.is_array()) return rows;
    Json out = rows;
    for (Json& row : out) {
        if (!row.is_object()) continue;
        for (const PropertyDescriptor& field : recordFields(property.hint))
            if (const auto found = row.find(std::string(field.key)); found != row.end())
                *found = substitutedValue(field, *found, arguments);
    }
    return out;
}

Json substitutedBindings(const Json& value, const Arguments& arguments) {
    if (!value.is_object()) return value;
    Json out = value;
    for (Json& one : out)
        if (one.is_string()) {
            const QString text = toQString(one);
            one =
                textValue(text.startsWith(u'@') ? textWithArguments(text, arguments) : withArguments(text, arguments));
        }
    return out;
}

Json substitutedValue(const PropertyDescriptor& property, const Json& value, const Arguments& arguments) {
    switch (property.type) {
    case PropertyType::Name:
    case PropertyType::Element:
    case PropertyType::Rect:
    case PropertyType::Size:
    case PropertyType::Points:
        return value;
    case PropertyType::Bool:
    case PropertyType::Integer:
    case PropertyType::Number:
        return literalValue(value, property, arguments);
    case PropertyType::Choice:
    case PropertyType::Symbol:
    case PropertyType::Color:
    case PropertyType::String:
    case PropertyType::Text:
    case PropertyType::TextList:
    case PropertyType::File:
    case PropertyType::Panel:
        return value.is_string() ? textValue(textWithArguments(toQString(value), arguments)) : value;
    case PropertyType::Expression:
    case PropertyType::Target:
        return value.is_string() ? textValue(withArguments(toQString(value), arguments)) : value;
    case PropertyType::Bindings:
    case PropertyType::Arguments:
        return substitutedBindings(value, arguments);
    case PropertyType::Records:
        return substitutedRecords(property, value, arguments);
    }
    return value;
}

} // namespace

Json substituted(const ElementDescriptor& descriptor, const Json& fields, const Arguments& arguments) {
    Json out = fields;
    for (const PropertyDescriptor& property : descriptor.properties)
        if (const auto found = out.find(std::string(property.key)); found != out.end())
            *found = substitutedValue(property, *found, arguments);
    return out;
}

Panel withArguments(const Panel& panel, const Arguments& arguments) {
    if (arguments.isEmpty()) return panel;
    Panel out = panel;
    const Json fields = substituted(panelDescriptor(), panel.fields(), arguments);
    for (const auto& [key, value] : fields.items())
        if (key != "parameters" && value != panel.at(key)) out.set(key, value);
    for (Element& element : out.elements())
        element = Element(substituted(element.descriptor(), element.fields(), arguments));
    return out;
}

namespace {

void appendContents(const Element& faceplate, const QString& name, const Arguments& given, const PanelLookup& panels,
                    QStringList& open, std::vector<Element>& out) {
    const Panel* panel = panels && !name.isEmpty() ? panels(name) : nullptr;
    if (!panel || open.contains(name) || open.size() >= kDeepest) return;
    open += name;
    const Arguments arguments = completed(parametersOf(*panel), given);
    const Panel shown = laidOut(*panel, sizeFor(*panel, faceplate.rect().size()));
    const QString prefix = faceplate.id() + u'/';
    for (const Element& inner : shown.elements()) {
        Element placed(substituted(inner.descriptor(), inner.fields(), arguments));
        const ElementId parent = inner.parent();
        placed.set("id"_field, toUtf8(prefix + inner.id()));
        placed.set("parent"_field, toUtf8(parent.isEmpty() ? faceplate.id() : prefix + parent));
        out.push_back(std::move(placed));
        if (inner.kind() == ElementKind::Faceplate) {
            const Element nested = out.back();
            appendContents(nested, nested.text("panel"_text), argumentsOf(nested.at("arguments"_field)), panels, open,
                           out);
        }
    }
    open.removeLast();
}

bool reaches(const Panel& panel, const QString& name, const PanelLookup& panels, QSet<QString>& seen) {
    for (const Element& element : panel.elements()) {
        if (element.kind() != ElementKind::Faceplate) continue;
        const QString placed = element.text("panel"_text);
        if (placed == name) return true;
        if (placed.isEmpty() || seen.contains(placed)) continue;
        seen += placed;
        const Panel* next = panels ? panels(placed) : nullptr;
        if (next && reaches(*next, name, panels, seen)) return true;
    }
    return false;
}

} // namespace

std::vector<Element> contentsOf(const Element& faceplate, const PanelLookup& panels) {
    return contentsOf(faceplate, faceplate.text("panel"_text), argumentsOf(faceplate.at("arguments"_field)), panels);
}

std::vector<Element> contentsOf(const Element& area, const QString& panel, const Arguments& arguments,
                                const PanelLookup& panels) {
    std::vector<Element> out;
    QStringList open;
    appendContents(area, panel, arguments, panels, open, out);
    return out;
}

bool placesPanel(const Panel& panel, const QString& name, const PanelLookup& panels) {
    QSet<QString> seen;
    return reaches(panel, name, panels, seen);
}

} // namespace plc::hmi
