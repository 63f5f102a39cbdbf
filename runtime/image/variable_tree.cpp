#include "runtime/image/variable_tree.h"

#include "runtime/base/text.h"

#include <algorithm>
#include <set>

namespace plc::image {

namespace {

using types::TypeKind;

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

VariableKind kindOf(const types::Type& type, types::FieldSection section) {
    switch (type.kind) {
    case TypeKind::Block:
        return VariableKind::Block;
    case TypeKind::Struct:
    case TypeKind::Union:
        return VariableKind::Structure;
    case TypeKind::Enum:
        return VariableKind::Enumeration;
    default:
        break;
    }
    if (section == types::FieldSection::Input) return VariableKind::Input;
    if (section == types::FieldSection::Output) return VariableKind::Output;
    return VariableKind::Variable;
}

VariableKind kindOf(const Root& root, const types::Type& type) {
    switch (root.area) {
    case Area::Program:
        return VariableKind::Program;
    case Area::Input:
        return VariableKind::Input;
    case Area::Output:
        return VariableKind::Output;
    default:
        return root.constant ? VariableKind::Constant : kindOf(type, types::FieldSection::Member);
    }
}

/// "Ns.GVL"; the path of a variable of the list is this, a point and its name.
std::string listOf(const Root& root) { return root.space.empty() ? root.list : root.space + "." + root.list; }

int rankOf(const VariableNode& node) {
    return node.kind == VariableKind::Program ? 0 : node.kind == VariableKind::List ? 1 : 2;
}

} // namespace

VariableNode VariableTree::nodeOf(const Root& root) const {
    const types::Type& type = (*m_layout.types)[root.type];
    const std::string path = Layout::pathOf(root);
    return {path, path, kindOf(root, type), root.type, root.comment, &root, hasMembers(type), root.constant, false};
}

std::vector<VariableNode> VariableTree::declared() const {
    std::vector<VariableNode> out;
    for (const Root& root : m_layout.roots)
        if (!root.isHidden && root.area != Area::Frame) out.push_back(nodeOf(root));
    return out;
}

std::vector<VariableNode> VariableTree::roots() const {
    std::vector<VariableNode> out;
    std::set<std::string> lists;
    for (VariableNode& node : declared()) {
        if (node.root->list.empty()) {
            out.push_back(std::move(node));
            continue;
        }
        const std::string list = listOf(*node.root);
        if (lists.insert(foldCase(list)).second)
            out.push_back({list, list, VariableKind::List, {}, {}, node.root, true, false, false});
    }
    std::stable_sort(out.begin(), out.end(),
                     [](const VariableNode& a, const VariableNode& b) { return rankOf(a) < rankOf(b); });
    return out;
}

std::vector<VariableNode> VariableTree::listed(std::string_view list) const {
    std::vector<VariableNode> out;
    for (VariableNode& node : declared()) {
        if (node.root->list.empty() || !equalsIgnoringCase(listOf(*node.root), list)) continue;
        node.name = node.root->name;
        out.push_back(std::move(node));
    }
    return out;
}

std::vector<VariableNode> VariableTree::elements(const VariableNode& array) const {
    const types::TypeTable& types = *m_layout.types;
    const types::Type& type = types[array.type];
    const types::Type& element = types[type.element];
    uint64_t count = 1;
    std::vector<int64_t> at;
    for (const types::Dimension& dimension : type.dimensions) {
        count = std::min(count * dimension.count(), kMostElements);
        at.push_back(dimension.low);
    }
    std::vector<VariableNode> out;
    for (uint64_t i = 0; i < count; ++i) {
        std::string name = "[";
        for (const int64_t index : at) name += (name.size() > 1 ? "," : "") + std::to_string(index);
        name += "]";
        const std::string path = array.path + name;
        out.push_back({std::move(name),
                       path,
                       kindOf(element, types::FieldSection::Member),
                       type.element,
                       {},
                       array.root,
                       hasMembers(element),
                       array.isConstant,
                       false});
        for (size_t d = at.size(); d-- > 0;) {
            if (++at[d] <= type.dimensions[d].high) break;
            at[d] = type.dimensions[d].low;
        }
    }
    return out;
}

std::vector<VariableNode> VariableTree::members(const VariableNode& node) const {
    if (node.isGroup()) return listed(node.path);
    if (!node.hasMembers) return {};
    const types::TypeTable& types = *m_layout.types;
    const types::Type& type = types[node.type];
    if (type.kind == TypeKind::Array) return elements(node);
    std::vector<VariableNode> out;
    for (const types::Field& field : type.fields) {
        if (field.isPrivate || field.section == types::FieldSection::External) continue;
        const types::Type& fieldType = types[field.type];
        const bool isInOut = field.section == types::FieldSection::InOut;
        out.push_back({field.name, node.path + "." + field.name, kindOf(fieldType, field.section), field.type,
                       field.comment, node.root, !isInOut && hasMembers(fieldType), node.isConstant || field.constant,
                       isInOut});
    }
    return out;
}

std::vector<VariableNode> VariableTree::children(std::string_view path) const {
    if (path.empty()) return roots();
    if (std::vector<VariableNode> list = listed(path); !list.empty()) return list;
    const Result<Place> place = m_layout.find(path);
    if (!place || place->bit >= 0) return {};
    VariableNode node;
    node.path = path;
    node.type = place->type;
    node.hasMembers = hasMembers((*m_layout.types)[place->type]);
    return members(node);
}

bool VariableTree::visit(const VariableNode& node, int depth, const Visitor& visitor, bool intoArrays) const {
    switch (visitor(node, depth)) {
    case Next::Stop:
        return false;
    case Next::Over:
        return true;
    case Next::Into:
        break;
    }
    if (!intoArrays && !node.isGroup() && (*m_layout.types)[node.type].kind == TypeKind::Array) return true;
    for (const VariableNode& each : members(node))
        if (!visit(each, depth + 1, visitor, intoArrays)) return false;
    return true;
}

bool VariableTree::visit(const std::vector<VariableNode>& from, const Visitor& visitor, bool intoArrays) const {
    for (const VariableNode& node : from)
        if (!visit(node, 0, visitor, intoArrays)) return false;
    return true;
}

} // namespace plc::image
