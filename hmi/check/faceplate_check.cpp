#include "hmi/check/faceplate_check.h"

#include "hmi/model/array_index.h"
#include "hmi/model/errors.h"
#include "hmi/model/walk.h"
#include "hmi/view/scene/faceplate_view.h"

#include <QRegularExpression>

#include <algorithm>

namespace plc::hmi {

namespace {

Finding findingIn(const NamedPanel& panel, const ElementId& element, const QString& property, Message message,
                  FindingKind kind = FindingKind::WrongArgument, bool isError = true) {
    return {kind, isError, panelFile(panel.name), 0, element, property, {}, std::move(message)};
}

/// A variable of each parameter's type takes its place where nothing is given.
Arguments sampleArguments(const CheckInput& input, const std::vector<Parameter>& parameters) {
    Arguments out;
    for (const Parameter& parameter : parameters) {
        if (parameter.isText()) {
            out.insert(parameter.name.toLower(), QString());
            continue;
        }
        if (!parameter.fallback.isEmpty() || !input.anInstance) continue;
        const QString path = input.anInstance(parameter.type);
        if (!path.isEmpty()) out.insert(parameter.name.toLower(), path);
    }
    return completed(parameters, out);
}

const Parameter* find(const std::vector<Parameter>& parameters, const QString& name) {
    const auto found = std::find_if(parameters.begin(), parameters.end(), [&](const Parameter& one) {
        return one.name.compare(name, Qt::CaseInsensitive) == 0;
    });
    return found == parameters.end() ? nullptr : &*found;
}

/// What is wrong with one argument that is an expression.
Message complaintOf(const CheckInput& input, const Parameter& parameter, const QString& argument) {
    if (!input.checkBinding || argument.isEmpty() || argument.contains(u'$')) return {};
    const std::string_view wanted = parameter.wanted();
    if (Message wrong = input.checkBinding(argument, wanted, false); !wrong.isEmpty()) return wrong;
    if (!wanted.empty() || parameter.type.isEmpty() || !input.typeNames) return {};
    const QStringList names = input.typeNames(argument);
    if (names.isEmpty() || names.contains(parameter.type, Qt::CaseInsensitive)) return {};
    return errors::ArgumentOfOtherType(toUtf8(argument), toUtf8(names.front()), "$" + toUtf8(parameter.name),
                                       toUtf8(parameter.type));
}

struct PlacementChecker {
    const CheckInput& input;
    const NamedPanel& panel;
    PanelLookup panels = input.panelLookup();
    Arguments outer = sampleArguments(input, parametersOf(panel.panel)); // of the panel it is placed in
    std::vector<Finding> found{};

    void add(const Element& element, const QString& property, Message message,
             FindingKind kind = FindingKind::WrongArgument, bool isError = true) {
        found.push_back(findingIn(panel, element.id(), property, std::move(message), kind, isError));
    }

    void check(const Element& element) {
        const QString name = element.text("panel");
        const Panel* placed = name.isEmpty() ? nullptr : panels(name);
        if (element.kind() != ElementKind::Faceplate) { // a button that leads to it
            if (placed) checkArguments(element, name, parametersOf(*placed));
            return;
        }
        if (name.isEmpty()) return add(element, QStringLiteral("panel"), errors::FaceplateWithoutPanel());
        if (!placed) return; // said for every property that names a panel
        if (name == panel.name || placesPanel(*placed, panel.name, panels))
            return add(element, QStringLiteral("panel"), errors::FaceplateContainsItself(toUtf8(name)),
                       FindingKind::FaceplateInItself);
        checkArguments(element, name, parametersOf(*placed));
    }

    void checkArguments(const Element& element, const QString& name, const std::vector<Parameter>& parameters) {
        const Json& fields = element.at("arguments");
        if (fields.is_object())
            for (const auto& [key, value] : fields.items())
                if (!find(parameters, QString::fromStdString(key)))
                    add(element, QStringLiteral("arguments.") + QString::fromStdString(key),
                        errors::NoSuchParameter(toUtf8(name), key));
        const Arguments given = argumentsOf(fields);
        for (const Parameter& parameter : parameters) {
            const QString place = QStringLiteral("arguments.") + parameter.name;
            const QString argument = given.value(parameter.name.toLower());
            if (argument.isEmpty() && parameter.fallback.isEmpty() && !parameter.isText() && isNeeded(parameter))
                add(element, place, errors::ArgumentMissing("$" + toUtf8(parameter.name), toUtf8(parameter.type)));
            if (parameter.isText()) {
                if (hasLetters(argument) && !argument.startsWith(u'@') && !argument.contains(u'$') &&
                    input.texts.settings().languages.size() > 1)
                    add(element, place, errors::TextWithoutKey(toUtf8(argument)), FindingKind::HardCodedText, false);
                continue;
            }
            if (Message wrong = complaintOf(input, parameter, withArguments(argument, outer)); !wrong.isEmpty())
                add(element, place, std::move(wrong));
        }
    }

    /// A block or a structure; what is a plain value may be left out, then nothing is bound to it.
    static bool isNeeded(const Parameter& parameter) { return !parameter.type.isEmpty() && parameter.wanted().empty(); }
};

/// Which arguments a faceplate gets anywhere in the project: those of placements in panels without parameters.
std::vector<Arguments> argumentsGiven(const CheckInput& input, const NamedPanel& faceplate,
                                      const std::vector<Parameter>& parameters) {
    std::vector<Arguments> out;
    const PanelLookup panels = input.panelLookup();
    const auto take = [&](const Element& element) {
        if (!element.descriptor().property("arguments") || element.text("panel") != faceplate.name) return;
        const Arguments given = argumentsOf(element.at("arguments"));
        const bool isGood = std::all_of(parameters.begin(), parameters.end(), [&](const Parameter& one) {
            return one.isText() || complaintOf(input, one, given.value(one.name.toLower())).isEmpty();
        });
        if (isGood) out.push_back(completed(parameters, given));
    };
    for (const NamedPanel& panel : input.panels) {
        if (!parametersOf(panel.panel).empty()) continue;
        for (const Element& element : panel.panel.elements()) {
            take(element);
            if (element.kind() == ElementKind::Faceplate)
                for (const Element& inner : contentsOf(element, panels)) take(inner);
        }
    }
    return out;
}

std::string spelled(const QStringList& names, const Arguments& arguments) {
    QStringList out;
    for (const QString& name : names) {
        const QString one = QStringLiteral("$%1 = %2").arg(name, arguments.value(name.toLower()));
        if (!out.contains(one)) out += one;
    }
    return toUtf8(out.join(QStringLiteral(", ")));
}

struct BindingChecker {
    const CheckInput& input;
    const NamedPanel& panel;
    std::vector<Parameter> parameters = parametersOf(panel.panel);
    std::vector<Arguments> sets = argumentsGiven(input, panel, parameters);
    std::vector<Finding> found{};

    void run() {
        if (sets.empty()) sets.push_back(sampleArguments(input, parameters));
        for (size_t i = 0; i < parameters.size(); ++i)
            if (const Parameter& one = parameters[i];
                !one.isText() && !one.type.isEmpty() && one.wanted().empty() && input.isType && !input.isType(one.type))
                found.push_back(findingIn(panel, {}, QStringLiteral("parameters[%1].type").arg(i),
                                          errors::ParameterTypeUnknown(toUtf8(one.type))));
        check({}, panel.panel);
        for (const Element& element : panel.panel.elements()) check(element.id(), element);
    }

    void check(const ElementId& id, const Properties& properties) {
        const bool isElement = !id.isEmpty();
        forEachBinding(properties, [&](const Found& binding) {
            if (binding.type == PropertyType::Arguments) return; // with the placements
            QString text = binding.text;
            if (isElement && hasIndex(static_cast<const Element&>(properties))) {
                const int first = properties.integer("first");
                text = withIndex(text, first, first, first);
            }
            Message wrong = complaint(text, binding);
            if (wrong.isEmpty()) return;
            Finding finding = findingIn(panel, id, binding.place(), std::move(wrong), FindingKind::WrongBinding);
            found.push_back(std::move(finding));
        });
    }

    static bool hasIndex(const Element& element) {
        return element.kind() == ElementKind::ArrayTable || element.kind() == ElementKind::CellGrid;
    }

    Message complaint(const QString& text, const Found& binding) const {
        const QStringList names = parameterNames(text);
        for (const QString& name : names)
            if (!find(parameters, name)) return errors::NoSuchParameter(toUtf8(panel.name), toUtf8(name));
        if (!input.checkBinding) return {};
        for (const Arguments& one : sets) {
            const QString expression = withArguments(text, one);
            if (expression.isEmpty() || expression.contains(u'$')) continue; // optional, or nothing of that type
            Message wrong = input.checkBinding(expression, binding.hint, binding.type == PropertyType::Target);
            if (wrong.isEmpty()) continue;
            return names.isEmpty() ? wrong : errors::WrongForArguments(wrong, spelled(names, one));
        }
        return {};
    }
};

} // namespace

PanelLookup CheckInput::panelLookup() const { return lookupIn(panels); }

std::vector<Finding> checkPlacements(const CheckInput& input, const NamedPanel& panel) {
    PlacementChecker checker{input, panel};
    for (const Element& element : panel.panel.elements())
        if (element.descriptor().property("arguments")) checker.check(element);
    return checker.found;
}

std::vector<Finding> checkParameterBindings(const CheckInput& input, const NamedPanel& panel) {
    BindingChecker checker{input, panel};
    checker.run();
    return checker.found;
}

std::vector<Arguments> argumentsGiven(const CheckInput& input, const QString& faceplate) {
    for (const NamedPanel& panel : input.panels)
        if (panel.name == faceplate) return argumentsGiven(input, panel, parametersOf(panel.panel));
    return {};
}

bool dependsOnArguments(const PanelScene& scene, const ElementView& view, const QString& property) {
    const FaceplateView* frame = scene.faceplateOf(view);
    const Panel* panel = frame ? frame->panel() : nullptr;
    if (!panel) return true;
    const ElementId inner = view.element().id().mid(frame->element().id().size() + 1);
    const Element* source = panel->find(inner);
    if (!source) return true;
    const std::string key = toUtf8(property.section(QRegularExpression(QStringLiteral("[\\[.]")), 0, 0));
    return source->at(key).dump().find('$') != std::string::npos;
}

} // namespace plc::hmi
