#include "editor/trace/setup/program_variables.h"

#include "editor/kit/fuzzy.h"
#include "editor/kit/texts.h"
#include "runtime/image/variable_tree.h"

#include <QRegularExpression>
#include <algorithm>

namespace plc::trace {

namespace {

using image::VariableKind;
using kit::Icon;

Icon iconOf(VariableKind kind) {
    switch (kind) {
    case VariableKind::Program:
        return Icon::Program;
    case VariableKind::List:
        return Icon::Globals;
    case VariableKind::Block:
        return Icon::Block;
    case VariableKind::Structure:
        return Icon::Structure;
    case VariableKind::Enumeration:
        return Icon::Enumeration;
    case VariableKind::Input:
        return Icon::Input;
    case VariableKind::Output:
        return Icon::Output;
    case VariableKind::Constant:
        return Icon::Constant;
    case VariableKind::Variable:
        return Icon::Variable;
    }
    return Icon::Variable;
}

kit::VariableNode shown(const image::VariableNode& node, const types::TypeTable& types) {
    return {kit::fromView(node.name),
            kit::fromView(node.path),
            node.isGroup() ? QString() : kit::fromView(types[node.type].name),
            kit::fromView(node.comment),
            iconOf(node.kind),
            node.hasMembers,
            !node.isGroup()};
}

bool isPathCharacter(QChar c) {
    return c.isLetterOrNumber() || c == QLatin1Char('_') || c == QLatin1Char('.') || c == QLatin1Char('[') ||
           c == QLatin1Char(']') || c == QLatin1Char('%');
}

/// "0..100 %" is a range and its unit; "1..8" a range alone.
QString withoutRange(QString text) {
    static const QRegularExpression range(QStringLiteral("^\\s*(±|[-+]?\\d[\\d.eE]*?\\.\\.)\\s*[-+±]?\\d[\\w.]*"));
    return text.remove(range).trimmed();
}

} // namespace

std::vector<kit::VariableNode> ProgramVariables::children(const QString& path) const {
    std::vector<kit::VariableNode> out;
    if (!m_program) return out;
    const image::Layout& layout = m_program->layout;
    for (const image::VariableNode& node : image::VariableTree(layout).children(path.toStdString()))
        out.push_back(shown(node, *layout.types));
    return out;
}

std::vector<kit::VariableNode> ProgramVariables::search(const QString& wanted, int limit) const {
    using Next = image::VariableTree::Next;
    std::vector<kit::VariableNode> out;
    if (!m_program) return out;
    constexpr size_t MostVisited = 20'000;
    constexpr int Deepest = 6;
    std::vector<std::pair<int, kit::VariableNode>> hits;
    size_t visited = 0;
    const image::VariableTree tree(m_program->layout);
    tree.visit(
        tree.roots(),
        [&](const image::VariableNode& node, int depth) {
            if (++visited > MostVisited) return Next::Stop;
            if (!node.isGroup())
                if (const auto match = kit::fuzzyMatch(wanted, kit::fromView(node.path)))
                    hits.emplace_back(match->score - depth, shown(node, *m_program->layout.types));
            return depth > Deepest ? Next::Over : Next::Into;
        },
        true);
    std::stable_sort(hits.begin(), hits.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    for (auto& [score, node] : hits) {
        if (static_cast<int>(out.size()) >= limit) break;
        out.push_back(std::move(node));
    }
    return out;
}

std::vector<kit::Completion> ProgramVariables::complete(const QString& line, int cursor) const {
    int start = cursor;
    while (start > 0 && isPathCharacter(line[start - 1])) --start;
    const QString path = line.mid(start, cursor - start);
    const auto dot = path.lastIndexOf(QLatin1Char('.'));
    const QString parent = dot < 0 ? QString() : path.left(dot), begun = path.mid(dot + 1);
    std::vector<std::pair<int, kit::Completion>> hits;
    auto offer = [&](const kit::VariableNode& node, int bonus, const QString& inserted, int from) {
        const auto match = kit::fuzzyMatch(begun, node.name);
        if (match) hits.emplace_back(match->score + bonus, kit::Completion{inserted, node.type, node.icon, from});
    };
    for (const kit::VariableNode& node : children(parent))
        offer(node, 20, node.name, start + static_cast<int>(dot) + 1);
    // Members of programs and lists can be found by their own name.
    if (dot < 0 && begun.size() >= 2)
        for (const kit::VariableNode& root : children(QString()))
            if (root.hasChildren)
                for (const kit::VariableNode& node : children(root.path)) offer(node, 0, node.path, start);
    std::stable_sort(hits.begin(), hits.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<kit::Completion> out;
    for (auto& [score, completion] : hits) {
        if (out.size() >= 60) break;
        out.push_back(std::move(completion));
    }
    return out;
}

QString ProgramVariables::unitOf(const QString& path) const {
    if (!m_program) return {};
    const auto dot = path.lastIndexOf(QLatin1Char('.'));
    for (const kit::VariableNode& node : children(dot < 0 ? QString() : path.left(dot))) {
        if (node.path.compare(path, Qt::CaseInsensitive) != 0) continue;
        const auto open = node.comment.indexOf(QLatin1Char('[')), close = node.comment.indexOf(QLatin1Char(']'), open);
        if (open < 0 || close - open < 2 || close - open > 24) return {};
        return withoutRange(node.comment.mid(open + 1, close - open - 1));
    }
    return {};
}

} // namespace plc::trace
