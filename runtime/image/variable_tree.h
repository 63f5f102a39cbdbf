// The variables of a compiled program as a tree of paths: what pickers, the watch, the command line, the debug adapter
// and servers list. Made by the compiler's layout alone, so all of them list the same. The layout must outlive it; any
// thread.
#pragma once
#include "runtime/image/layout.h"

#include <functional>
#include <string>
#include <vector>

namespace plc::image {

enum class VariableKind { Program, List, Block, Structure, Enumeration, Input, Output, Constant, Variable };

struct VariableNode {
    std::string name; // shown in a tree: "Kp", "[3]"
    std::string path; // the whole path
    VariableKind kind = VariableKind::Variable;
    types::TypeId type;         // of a list: none
    std::string comment;        // of its declaration
    const Root* root = nullptr; // that it is part of; of a list: its first variable
    bool hasMembers = false;
    bool isConstant = false;
    bool isInOut = false; // a way to elsewhere: no value of its own

    bool isGroup() const { return kind == VariableKind::List; }
};

class VariableTree {
public:
    explicit VariableTree(const Layout& layout) : m_layout(layout) {}

    /// Programs, lists of globals and globals without a list, each in order of declaration.
    [[nodiscard]] std::vector<VariableNode> roots() const;
    /// The same without lists: their variables themselves, all in order of declaration.
    [[nodiscard]] std::vector<VariableNode> declared() const;
    /// What is below a path, which may be that of a list; of the empty path: the roots. Of a long array, the start.
    [[nodiscard]] std::vector<VariableNode> children(std::string_view path) const;
    [[nodiscard]] std::vector<VariableNode> members(const VariableNode& node) const;

    enum class Next { Into, Over, Stop };
    /// Visits nodes and what is below them, a node before its members; members of arrays only `intoArrays`. False: it
    /// was stopped.
    using Visitor = std::function<Next(const VariableNode& node, int depth)>;
    bool visit(const std::vector<VariableNode>& from, const Visitor& visitor, bool intoArrays) const;

    /// Elements of an array that are listed.
    static constexpr uint64_t kMostElements = 1000;

private:
    VariableNode nodeOf(const Root& root) const;
    bool visit(const VariableNode& node, int depth, const Visitor& visitor, bool intoArrays) const;
    std::vector<VariableNode> elements(const VariableNode& array) const;
    std::vector<VariableNode> listed(std::string_view list) const;

    const Layout& m_layout;
};

} // namespace plc::image
