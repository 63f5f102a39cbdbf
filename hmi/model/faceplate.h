// Faceplates: a panel with parameters that other panels place as an element and give arguments. Inside, `$valve.Open`
// names a member of what the parameter `valve` is given. Pure functions over panels; any thread.
#pragma once
#include "hmi/model/panel.h"

#include <QMap>

#include <functional>

namespace plc::hmi {

/// The panel of that name, or null. Names are those of the files without ".panel.json".
using PanelLookup = std::function<const Panel*(const QString& name)>;

/// What a faceplate (or a pop-up) is given: a row of the panel's property "parameters".
struct Parameter {
    QString name;
    QString type;     // a block, a structure, BOOL, REAL…, "text" for what people read; empty: anything
    QString fallback; // the argument where none is given; may name parameters before it

    bool isText() const { return type.compare(QStringLiteral("text"), Qt::CaseInsensitive) == 0; }
    /// The type a value must have as bindings ask for it: "bool", "number", "text", "array"; empty for a named type.
    std::string_view wanted() const;
};
std::vector<Parameter> parametersOf(const Panel& panel);

/// Name of the parameter in lower case → ST expression, or the text of a text parameter.
using Arguments = QMap<QString, QString>;
/// The arguments as they stand in a file: {"valve": "Valves[1]"}.
Arguments argumentsOf(const Json& fields);
/// With the defaults of those that are not given.
Arguments completed(const std::vector<Parameter>& parameters, Arguments given);

/// `$name` in an ST expression, in order, outside of its texts.
QStringList parameterNames(const QString& expression);
/// The expression with its parameters replaced; empty where one of them is given nothing.
QString withArguments(const QString& expression, const Arguments& arguments);
/// The same in a text, a colour, a name of a file…: the argument takes the place as it is written.
QString textWithArguments(const QString& text, const Arguments& arguments);
/// All fields of an element (or panel) with their parameters replaced.
Json substituted(const ElementDescriptor& descriptor, const Json& fields, const Arguments& arguments);
/// The panel as it is shown with these arguments.
Panel withArguments(const Panel& panel, const Arguments& arguments);

/// What a faceplate shows at its place, in drawing order, what is in nested ones included. Ids begin with the
/// faceplate's ("valve3/lamp1"), places are those in the faceplate's panel.
std::vector<Element> contentsOf(const Element& faceplate, const PanelLookup& panels);
/// The same for an element that is given its panel and arguments: the area of a frame.
std::vector<Element> contentsOf(const Element& area, const QString& panel, const Arguments& arguments,
                                const PanelLookup& panels);
/// The panel places `name`, itself or through others.
bool placesPanel(const Panel& panel, const QString& name, const PanelLookup& panels);

} // namespace plc::hmi
