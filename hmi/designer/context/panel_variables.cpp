#include "hmi/designer/context/panel_variables.h"

#include "editor/kit/fuzzy.h"
#include "editor/kit/message_text.h"
#include "editor/kit/texts.h"
#include "editor/kit/variables/layout_variables.h"
#include "runtime/base/text.h"

#include <algorithm>

namespace plc::hmi {

namespace {

const QString kPrefix = QStringLiteral("$");

/// What the program says about the type in a comment at its declaration.
QString commentOfType(const driver::Checked& checked, const QString& type) {
    if (!checked.analysis || type.isEmpty()) return {};
    for (const sema::Symbol& symbol : checked.analysis->symbols)
        if ((symbol.kind == sema::SymbolKind::Type || symbol.kind == sema::SymbolKind::FunctionBlock) &&
            equalsIgnoringCase(symbol.name, toUtf8(type)))
            return kit::fromView(symbol.comment);
    return {};
}

bool isPathPart(QChar c) { return c.isLetterOrNumber() || c == u'_' || c == u'.' || c == u'[' || c == u']'; }

/// Where the word with a `$` begins that ends at the cursor; -1: none does.
int parameterWord(const QString& text, int cursor) {
    int start = cursor;
    while (start > 0 && isPathPart(text[start - 1])) --start;
    return start > 0 && text[start - 1] == u'$' ? start - 1 : -1;
}

} // namespace

std::vector<Parameter> PanelVariables::parameters() const {
    std::vector<Parameter> out = parametersOf(m_document.panel());
    std::erase_if(out, [](const Parameter& one) { return one.isText(); });
    return out;
}

const kit::VariableProvider* PanelVariables::ofProject() const {
    return m_context.variables() ? &m_context.variables()() : nullptr;
}

/// A place for each parameter, by its name without the `$`: what lies below it is that of its type.
image::Layout PanelVariables::layout() const {
    image::Layout out;
    const driver::Checked& checked = m_context.checked();
    if (checked.analysis && checked.analysis->program) out.types = checked.analysis->program->layout.types;
    for (const Parameter& parameter : parameters()) {
        const std::optional<TypedExpression> type = typedVariable(checked, parameter.type);
        if (!type || type->types != out.types) continue;
        image::Root root;
        root.name = toUtf8(parameter.name);
        root.type = type->type;
        out.roots.push_back(std::move(root));
    }
    return out;
}

std::vector<kit::VariableNode> PanelVariables::children(const QString& path) const {
    std::vector<kit::VariableNode> out;
    const kit::VariableProvider* project = ofProject();
    if (!path.isEmpty() && !path.startsWith(u'$'))
        return project ? project->children(path) : std::vector<kit::VariableNode>();
    const image::Layout places = layout();
    const image::VariableTree tree(places);
    if (!path.isEmpty()) {
        for (const image::VariableNode& node : tree.children(toUtf8(path.mid(1))))
            out.push_back(kit::shownVariable(node, places, kPrefix));
        return out;
    }
    const std::vector<image::VariableNode> known = tree.declared();
    for (const Parameter& parameter : parameters()) {
        const QString name = u'$' + parameter.name;
        kit::VariableNode node{name, name, parameter.type, commentOfType(m_context.checked(), parameter.type)};
        for (const image::VariableNode& one : known)
            if (equalsIgnoringCase(one.path, toUtf8(parameter.name))) {
                const kit::VariableNode shown = kit::shownVariable(one, places);
                node.icon = shown.icon;
                node.hasChildren = shown.hasChildren;
            }
        out.push_back(std::move(node));
    }
    if (!project) return out;
    for (kit::VariableNode& node : project->children({})) out.push_back(std::move(node));
    return out;
}

std::vector<kit::VariableNode> PanelVariables::search(const QString& wanted, int limit) const {
    const image::Layout places = layout();
    const image::VariableTree tree(places);
    std::vector<image::VariableNode> members;
    for (const image::VariableNode& parameter : tree.declared())
        for (image::VariableNode& member : tree.children(parameter.path)) members.push_back(std::move(member));
    std::vector<kit::ScoredVariable> hits;
    for (kit::VariableNode& node : children({})) // those without a known type, too
        if (node.path.startsWith(u'$'))
            if (const auto match = kit::fuzzyMatch(wanted, node.path)) hits.push_back({match->score + 1, node});
    for (kit::ScoredVariable& hit : kit::matchingVariables(places, members, false, wanted, kPrefix))
        hits.push_back(std::move(hit));
    std::vector<kit::VariableNode> out = kit::bestOf(std::move(hits), limit);
    const kit::VariableProvider* project = ofProject();
    const int left = limit - static_cast<int>(out.size());
    if (!project || left <= 0) return out;
    for (kit::VariableNode& node : project->search(wanted, left)) out.push_back(std::move(node));
    return out;
}

std::optional<TypedExpression> PanelVariables::typed(const QString& path) const {
    const driver::Checked& checked = m_context.checked();
    if (!path.startsWith(u'$')) return typedExpression(checked, path);
    for (const Parameter& parameter : parameters())
        if (path.mid(1).compare(parameter.name, Qt::CaseInsensitive) == 0)
            return typedVariable(checked, parameter.type);
    const image::Layout places = layout();
    if (!places.types) return {};
    const Result<image::Place> place = places.find(toUtf8(path.mid(1)));
    if (!place) return {};
    return TypedExpression{places.types, place->type, true};
}

QString PanelVariables::complaint(const QString& expression, std::string_view wanted, bool isTarget) const {
    if (parameterNames(expression).isEmpty()) return m_context.checkBinding(expression, wanted, isTarget);
    const QString path = expression.trimmed();
    if (!path.startsWith(u'$')) return {};
    const std::optional<TypedExpression> known = typed(path);
    return known ? kit::messageText(complaintOn(*known, path, wanted, isTarget)) : QString();
}

std::vector<kit::Completion> PanelVariables::complete(const QString& text, int cursor) const {
    std::vector<kit::Completion> out;
    const int start = parameterWord(text, cursor);
    const QString word = start < 0 ? QString() : text.mid(start, cursor - start);
    const auto dot = word.lastIndexOf(u'.');
    const QString begun = dot < 0 ? word : word.mid(dot + 1);
    const bool isInWord = cursor > 0 && isPathPart(text[cursor - 1]); // of the project
    std::vector<std::pair<int, kit::Completion>> hits;
    if (start >= 0 || !isInWord)
        for (const kit::VariableNode& node : children(dot < 0 ? QString() : word.left(dot))) {
            if (!node.path.startsWith(u'$') || node.name.startsWith(u'[')) continue;
            const int from = start < 0 ? cursor : dot < 0 ? start : start + static_cast<int>(dot) + 1;
            if (const auto match = kit::fuzzyMatch(begun, node.name))
                hits.emplace_back(match->score, kit::Completion{node.name, node.type, node.icon, from});
        }
    std::stable_sort(hits.begin(), hits.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    for (auto& [score, completion] : hits) out.push_back(std::move(completion));
    if (start >= 0 || !m_context.completions()) return out;
    for (kit::Completion& completion : m_context.completions()(text, cursor)) out.push_back(std::move(completion));
    return out;
}

std::optional<QString> PanelVariables::pick(const QString& present, QWidget* parent) const {
    if (!parameters().empty() && m_context.variables()) return kit::pickVariable(*this, present, parent);
    return m_context.picker() ? m_context.picker()(present) : std::nullopt;
}

} // namespace plc::hmi
