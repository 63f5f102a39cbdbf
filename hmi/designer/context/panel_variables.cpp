#include "hmi/designer/context/panel_variables.h"

#include "editor/kit/fuzzy.h"
#include "editor/kit/message_text.h"
#include "editor/kit/texts.h"
#include "runtime/base/text.h"

#include <algorithm>

namespace plc::hmi {

namespace {

kit::Icon iconOfVariable(image::VariableKind kind) {
    switch (kind) {
    case image::VariableKind::Program:
        return kit::Icon::Program;
    case image::VariableKind::List:
        return kit::Icon::Globals;
    case image::VariableKind::Block:
        return kit::Icon::Block;
    case image::VariableKind::Structure:
        return kit::Icon::Structure;
    case image::VariableKind::Enumeration:
        return kit::Icon::Enumeration;
    case image::VariableKind::Input:
        return kit::Icon::Input;
    case image::VariableKind::Output:
        return kit::Icon::Output;
    case image::VariableKind::Constant:
        return kit::Icon::Constant;
    case image::VariableKind::Variable:
        return kit::Icon::Variable;
    }
    return kit::Icon::Variable;
}

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

kit::VariableNode PanelVariables::shown(const image::VariableNode& node, const image::Layout& layout) const {
    return {kit::fromView(node.name),
            u'$' + kit::fromView(node.path),
            kit::fromView((*layout.types)[node.type].name),
            kit::fromView(node.comment),
            iconOfVariable(node.kind),
            node.hasMembers,
            true};
}

std::vector<kit::VariableNode> PanelVariables::children(const QString& path) const {
    std::vector<kit::VariableNode> out;
    const kit::VariableProvider* project = ofProject();
    if (!path.isEmpty() && !path.startsWith(u'$'))
        return project ? project->children(path) : std::vector<kit::VariableNode>();
    const image::Layout places = layout();
    const image::VariableTree tree(places);
    if (!path.isEmpty()) {
        for (const image::VariableNode& node : tree.children(toUtf8(path.mid(1)))) out.push_back(shown(node, places));
        return out;
    }
    const std::vector<image::VariableNode> known = tree.declared();
    for (const Parameter& parameter : parameters()) {
        const QString name = u'$' + parameter.name;
        kit::VariableNode node{name, name, parameter.type, commentOfType(m_context.checked(), parameter.type)};
        for (const image::VariableNode& one : known)
            if (equalsIgnoringCase(one.path, toUtf8(parameter.name))) {
                node.icon = iconOfVariable(one.kind);
                node.hasChildren = one.hasMembers;
            }
        out.push_back(std::move(node));
    }
    if (!project) return out;
    for (kit::VariableNode& node : project->children({})) out.push_back(std::move(node));
    return out;
}

std::vector<kit::VariableNode> PanelVariables::search(const QString& wanted, int limit) const {
    using Next = image::VariableTree::Next;
    constexpr size_t MostVisited = 5'000;
    constexpr int Deepest = 6;
    std::vector<std::pair<int, kit::VariableNode>> hits;
    const auto take = [&](kit::VariableNode node, int depth) {
        if (const auto match = kit::fuzzyMatch(wanted, node.path))
            hits.emplace_back(match->score - depth, std::move(node));
    };
    for (kit::VariableNode& node : children({}))
        if (node.path.startsWith(u'$')) take(std::move(node), 0);
    size_t visited = 0;
    const image::Layout places = layout();
    const image::VariableTree tree(places);
    tree.visit(
        tree.declared(),
        [&](const image::VariableNode& node, int depth) {
            if (++visited > MostVisited) return Next::Stop;
            if (depth > 0) take(shown(node, places), depth); // the parameters are there
            return depth > Deepest ? Next::Over : Next::Into;
        },
        false);
    std::stable_sort(hits.begin(), hits.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<kit::VariableNode> out;
    for (auto& [score, node] : hits)
        if (static_cast<int>(out.size()) < limit) out.push_back(std::move(node));
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
