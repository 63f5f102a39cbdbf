#include "editor/trace/program_variables.h"

#include "editor/kit/fuzzy.h"

#include <QRegularExpression>
#include <algorithm>
#include <set>

namespace plc::trace {

namespace {

using kit::Icon;
using types::TypeKind;

constexpr uint64_t MostElements = 1000; // of an array in a tree

bool hasMembers(const types::Type& type) {
    switch (type.kind) {
    case TypeKind::Struct:
    case TypeKind::Union:
    case TypeKind::Block:
        return !type.fields.empty();
    case TypeKind::Array:
        return true;
    default:
        return false;
    }
}

Icon iconOf(const types::Type& type, types::FieldSection section) {
    switch (type.kind) {
    case TypeKind::Block:
        return Icon::Block;
    case TypeKind::Struct:
    case TypeKind::Union:
        return Icon::Structure;
    case TypeKind::Enum:
        return Icon::Enumeration;
    default:
        break;
    }
    if (section == types::FieldSection::Input) return Icon::Input;
    if (section == types::FieldSection::Output) return Icon::Output;
    return Icon::Variable;
}

Icon iconOf(const image::Root& root, const types::Type& type) {
    switch (root.area) {
    case image::Area::Program:
        return Icon::Program;
    case image::Area::Input:
        return Icon::Input;
    case image::Area::Output:
        return Icon::Output;
    default:
        return root.constant ? Icon::Constant : iconOf(type, types::FieldSection::Member);
    }
}

QString text(const std::string& s) { return QString::fromStdString(s); }

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

std::vector<kit::VariableNode> ProgramVariables::rootNodes() const {
    std::vector<kit::VariableNode> out;
    std::set<QString> lists;
    for (const image::Root& root : m_program->layout.roots) {
        if (root.isHidden) continue;
        if (!root.list.empty()) {
            const QString list = text(root.space.empty() ? root.list : root.space + "." + root.list);
            if (lists.insert(list.toLower()).second)
                out.push_back({list, list, QString(), QString(), Icon::Globals, true, false});
            continue;
        }
        const types::Type& type = (*m_program->layout.types)[root.type];
        const QString path = text(image::Layout::pathOf(root));
        out.push_back({path, path, text(type.name), text(root.comment), iconOf(root, type), hasMembers(type)});
    }
    std::stable_sort(out.begin(), out.end(), [](const kit::VariableNode& a, const kit::VariableNode& b) {
        auto rank = [](const kit::VariableNode& n) {
            return n.icon == Icon::Program ? 0 : n.icon == Icon::Globals ? 1 : 2;
        };
        return rank(a) < rank(b);
    });
    return out;
}

std::vector<kit::VariableNode> ProgramVariables::memberNodes(const QString& path, const image::Place& place) const {
    std::vector<kit::VariableNode> out;
    const types::TypeTable& types = *m_program->layout.types;
    const types::Type& type = types[place.type];
    if (type.kind == TypeKind::Array) {
        uint64_t count = 1;
        for (const types::Dimension& d : type.dimensions) count *= d.count();
        std::vector<int64_t> at;
        for (const types::Dimension& d : type.dimensions) at.push_back(d.low);
        const types::Type& element = types[type.element];
        for (uint64_t i = 0; i < std::min(count, MostElements); ++i) {
            QStringList indices;
            for (int64_t index : at) indices += QString::number(index);
            const QString name = QLatin1Char('[') + indices.join(QLatin1Char(',')) + QLatin1Char(']');
            out.push_back({name, path + name, text(element.name), QString(),
                           iconOf(element, types::FieldSection::Member), hasMembers(element)});
            for (size_t d = at.size(); d-- > 0;) {
                if (++at[d] <= type.dimensions[d].high) break;
                at[d] = type.dimensions[d].low;
            }
        }
        return out;
    }
    for (const types::Field& field : type.fields) {
        if (field.isPrivate || field.section == types::FieldSection::External) continue;
        const types::Type& fieldType = types[field.type];
        const QString name = text(field.name);
        const bool follows = field.section != types::FieldSection::InOut; // an IN_OUT is only a way to elsewhere
        out.push_back({name, path + QLatin1Char('.') + name, text(fieldType.name), text(field.comment),
                       iconOf(fieldType, field.section), follows && hasMembers(fieldType)});
    }
    return out;
}

std::vector<kit::VariableNode> ProgramVariables::children(const QString& path) const {
    if (!m_program) return {};
    if (path.isEmpty()) return rootNodes();
    std::vector<kit::VariableNode> out;
    for (const image::Root& root : m_program->layout.roots) {
        if (root.isHidden || root.list.empty()) continue;
        const QString list = text(root.space.empty() ? root.list : root.space + "." + root.list);
        if (list.compare(path, Qt::CaseInsensitive) != 0) continue;
        const types::Type& type = (*m_program->layout.types)[root.type];
        out.push_back({text(root.name), text(image::Layout::pathOf(root)), text(type.name), text(root.comment),
                       iconOf(root, type), hasMembers(type)});
    }
    if (!out.empty()) return out;
    const auto place = m_program->layout.find(path.toStdString());
    return place ? memberNodes(path, *place) : out;
}

std::vector<kit::VariableNode> ProgramVariables::search(const QString& wanted, int limit) const {
    std::vector<std::pair<int, kit::VariableNode>> hits;
    size_t visited = 0;
    std::function<void(const kit::VariableNode&, int)> visit = [&](const kit::VariableNode& node, int depth) {
        if (++visited > 20'000) return;
        if (node.isSelectable)
            if (const auto match = kit::fuzzyMatch(wanted, node.path)) hits.emplace_back(match->score - depth, node);
        if (!node.hasChildren || depth > 6) return;
        for (const kit::VariableNode& child : children(node.path)) visit(child, depth + 1);
    };
    for (const kit::VariableNode& root : children(QString())) visit(root, 0);
    std::stable_sort(hits.begin(), hits.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<kit::VariableNode> out;
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
