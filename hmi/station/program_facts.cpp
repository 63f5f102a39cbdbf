#include "hmi/station/program_facts.h"

#include "hmi/model/errors.h"
#include "runtime/base/text.h"

#include <QRegularExpression>
#include <QSet>

namespace plc::hmi {

namespace {

/// The nearest name of the program for the first name in the expression that nothing is called.
QString nearMatch(const driver::Checked& checked, const QString& expression) {
    if (!checked.analysis) return {};
    std::vector<std::string> names;
    for (const sema::Symbol& symbol : checked.analysis->symbols) names.push_back(symbol.name);
    static const QRegularExpression word(QStringLiteral("[\\p{L}_][\\p{L}\\p{N}_]*"));
    for (auto it = word.globalMatch(expression); it.hasNext();) {
        const std::string name = it.next().captured().toStdString();
        const bool isKnown = std::any_of(names.begin(), names.end(),
                                         [&](const std::string& one) { return equalsIgnoringCase(one, name); });
        if (isKnown) continue;
        if (const std::optional<std::string> near = nearestName(name, names)) return QString::fromStdString(*near);
    }
    return {};
}

/// The types of an expression, which live as long as it does.
std::shared_ptr<const types::TypeTable> tableOf(const expression::Expression& expression) {
    const auto kept = std::make_shared<const expression::Expression>(expression);
    return {kept, &kept->types()};
}

} // namespace

std::optional<TypedExpression> typedExpression(const driver::Checked& checked, const QString& expression) {
    if (!checked.analysis) return {};
    const auto compiled = driver::compileExpression(checked, expression.toStdString());
    if (!compiled) return {};
    return TypedExpression{tableOf(*compiled), compiled->type(), compiled->place().has_value()};
}

std::optional<TypedExpression> typedVariable(const driver::Checked& checked, const QString& type) {
    if (!checked.analysis || !checked.analysis->program || type.isEmpty()) return {};
    const std::shared_ptr<const types::TypeTable> types = checked.analysis->program->layout.types;
    const std::string name = toUtf8(type);
    for (uint32_t i = 0; types && i < types->count(); ++i)
        if (equalsIgnoringCase((*types)[types::TypeId(i)].name, name))
            return TypedExpression{types, types::TypeId(i), true};
    // Texts of other lengths than the program's own.
    const QString word = type.section(u'(', 0, 0).section(u'[', 0, 0).trimmed().toUpper();
    if (word != QLatin1String("STRING") && word != QLatin1String("WSTRING")) return {};
    const auto own = std::make_shared<types::TypeTable>();
    const types::TypeId text = word == QLatin1String("STRING") ? own->string(80) : own->wstring(80);
    return TypedExpression{own, text, true};
}

Message complaintOn(const TypedExpression& given, const QString& expression, std::string_view wanted, bool isTarget) {
    const types::TypeTable& types = *given.types;
    const types::TypeId type = given.type;
    const std::string& name = types[type].name;
    const std::string text = toUtf8(expression);
    if (isTarget && !given.isPlace) return errors::TargetNotVariable(text);
    const types::Family family = types.family(type);
    const bool isBool = family == types::Family::Bool, isArray = types.isAggregate(type);
    const bool isNumber = types::isInteger(family) || family == types::Family::Real ||
                          family == types::Family::Duration || types.kind(type) == types::TypeKind::Enum;
    if (wanted == "bool" && !isBool) return errors::BoolNeeded(text, name);
    if (wanted == "number" && !isNumber && !isBool) return errors::NumberNeeded(text, name);
    if (wanted == "text" && !types.isText(type)) return errors::StringNeeded(text, name);
    if (wanted == "array" && !isArray) return errors::ArrayNeeded(text, name);
    if (wanted == "any" && isArray) return errors::SingleValueNeeded(text, name);
    return {};
}

Message checkBinding(const driver::Checked& checked, const QString& expression, std::string_view wanted,
                     bool isTarget) {
    const auto compiled = driver::compileExpression(checked, expression.toStdString());
    if (!compiled) {
        const Message& message = compiled.error().message;
        const QString near = nearMatch(checked, expression);
        return near.isEmpty() || message.english().find(toUtf8(near)) != std::string::npos
                   ? message
                   : errors::BindingDidYouMean(message, toUtf8(near));
    }
    return complaintOn({tableOf(*compiled), compiled->type(), compiled->place().has_value()}, expression, wanted,
                       isTarget);
}

namespace {

constexpr int kDeepest = 6;

void addTypeNames(const types::TypeTable& types, types::TypeId type, QStringList& out) {
    if (!type.isValid()) return;
    const types::Type& one = types[type];
    const QString name = QString::fromStdString(one.name);
    if (out.contains(name)) return;
    out += name;
    addTypeNames(types, one.base, out);
    for (const types::TypeId other : one.interfaces) addTypeNames(types, other, out);
}

/// Depth first; the path of the first variable whose type is called so.
QString findOfType(const types::TypeTable& types, types::TypeId type, const QString& path, const std::string& name,
                   int depth) {
    if (equalsIgnoringCase(types[type].name, name)) return path;
    if (depth >= kDeepest) return {};
    const types::Type& one = types[type];
    if (one.kind == types::TypeKind::Array) {
        QStringList indices;
        for (const types::Dimension& dimension : one.dimensions) indices += QString::number(dimension.low);
        return findOfType(types, one.element, path + u'[' + indices.join(u',') + u']', name, depth + 1);
    }
    for (const types::Field& field : one.fields) {
        if (field.isPrivate) continue;
        const QString found =
            findOfType(types, field.type, path + u'.' + QString::fromStdString(field.name), name, depth + 1);
        if (!found.isEmpty()) return found;
    }
    return {};
}

bool isDeclared(const driver::Checked& checked, const QString& type) {
    const std::string name = type.toStdString();
    const auto& symbols = checked.analysis->symbols;
    return std::any_of(symbols.begin(), symbols.end(), [&](const sema::Symbol& one) {
        return (one.kind == sema::SymbolKind::Type || one.kind == sema::SymbolKind::FunctionBlock) &&
               equalsIgnoringCase(one.name, name);
    });
}

} // namespace

QStringList typeNamesOf(const driver::Checked& checked, const QString& expression) {
    const auto compiled = driver::compileExpression(checked, expression.toStdString());
    QStringList out;
    if (compiled) addTypeNames(compiled->types(), compiled->type(), out);
    return out;
}

QStringList typeNamesOf(const TypedExpression& given) {
    QStringList out;
    addTypeNames(*given.types, given.type, out);
    return out;
}

QString instanceOf(const driver::Checked& checked, const QString& type) {
    if (!checked.analysis || !checked.analysis->program || type.isEmpty()) return {};
    const image::Layout& layout = checked.analysis->program->layout;
    if (!layout.types) return {};
    for (const image::Root& root : layout.roots) {
        if (root.constant) continue;
        const QString found = findOfType(*layout.types, root.type, QString::fromStdString(image::Layout::pathOf(root)),
                                         type.toStdString(), 0);
        if (!found.isEmpty()) return found;
    }
    return {};
}

void askProgram(CheckInput& input, const driver::Checked& checked) {
    if (!checked.analysis) return;
    input.checkBinding = [&checked](const QString& expression, std::string_view wanted, bool isTarget) {
        return checkBinding(checked, expression, wanted, isTarget);
    };
    input.typeNames = [&checked](const QString& expression) { return typeNamesOf(checked, expression); };
    input.isType = [&checked](const QString& type) {
        return isDeclared(checked, type) || !instanceOf(checked, type).isEmpty();
    };
    input.anInstance = [&checked](const QString& type) { return instanceOf(checked, type); };
}

namespace {

void collectArrays(const types::TypeTable& types, types::TypeId type, const QString& path, const std::string& name,
                   int depth, QStringList& out) {
    const types::Type& one = types[type];
    if (one.kind == types::TypeKind::Array) {
        QStringList names;
        addTypeNames(types, one.element, names);
        if (one.dimensions.size() == 1 && names.contains(QString::fromStdString(name), Qt::CaseInsensitive))
            out += path;
        return;
    }
    if (depth >= kDeepest) return;
    for (const types::Field& field : one.fields)
        if (!field.isPrivate)
            collectArrays(types, field.type, path + u'.' + QString::fromStdString(field.name), name, depth + 1, out);
}

} // namespace

QStringList arraysOf(const driver::Checked& checked, const QString& type) {
    QStringList out;
    if (!checked.analysis || !checked.analysis->program || type.isEmpty()) return out;
    const image::Layout& layout = checked.analysis->program->layout;
    if (!layout.types) return out;
    for (const image::Root& root : layout.roots)
        if (!root.isHidden)
            collectArrays(*layout.types, root.type, QString::fromStdString(image::Layout::pathOf(root)),
                          type.toStdString(), 0, out);
    return out;
}

std::optional<std::pair<int, int>> boundsOf(const driver::Checked& checked, const QString& array) {
    if (!checked.analysis || array.trimmed().isEmpty()) return {};
    const auto compiled = driver::compileExpression(checked, array.toStdString());
    if (!compiled) return {};
    const types::Type& type = compiled->types()[compiled->type()];
    if (type.kind != types::TypeKind::Array || type.dimensions.size() != 1) return {};
    return std::pair(static_cast<int>(type.dimensions.front().low), static_cast<int>(type.dimensions.front().high));
}

driver::Checked checkedForPanels(const driver::BuildInput& input, const driver::Checked& checked,
                                 const std::vector<NamedPanel>& panels) {
    if (!checked.analysis) return checked;
    QStringList types;
    for (const NamedPanel& panel : panels)
        for (const Parameter& parameter : parametersOf(panel.panel))
            if (!parameter.isText() && !types.contains(parameter.type, Qt::CaseInsensitive) &&
                instanceOf(checked, parameter.type).isEmpty() &&
                (!parameter.wanted().empty() || isDeclared(checked, parameter.type)))
                types += parameter.type;
    if (types.isEmpty()) return checked;
    std::string text = "VAR_GLOBAL\n";
    int number = 0;
    for (const QString& type : types)
        text += "    ParameterOfPanel" + std::to_string(++number) + " : " + type.toStdString() + ";\n";
    driver::BuildInput more = input;
    more.files.push_back({"parameters_of_panels.st", text + "END_VAR\n"});
    const driver::Checked with = driver::check(more);
    return with.analysis && with.analysis->hasErrors && !checked.analysis->hasErrors ? checked : with;
}

} // namespace plc::hmi
