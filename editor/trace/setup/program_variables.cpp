#include "editor/trace/setup/program_variables.h"

#include "editor/kit/fuzzy.h"
#include "editor/kit/texts.h"
#include "editor/kit/variables/layout_variables.h"
#include "runtime/image/variable_tree.h"

#include <QRegularExpression>
#include <algorithm>

namespace plc::trace {

namespace {

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
        out.push_back(kit::shownVariable(node, layout));
    return out;
}

std::vector<kit::VariableNode> ProgramVariables::search(const QString& wanted, int limit) const {
    if (!m_program) return {};
    const image::Layout& layout = m_program->layout;
    return kit::bestOf(kit::matchingVariables(layout, image::VariableTree(layout).roots(), true, wanted), limit);
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
