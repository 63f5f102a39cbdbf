// The projects of other tools in a folder: which there are, which of their files belong to which, and which of them use
// which. Nothing of the units is read here. A value; functions, any thread.
#pragma once
#include "runtime/base/progress.h"

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace plc::exchange {

/// A project by itself: a .plcproj with the files it lists, or a file that holds a whole project.
struct TreePart {
    std::string name;
    std::filesystem::path folder;                      // of a .plcproj
    std::filesystem::path projectFile;                 // the .plcproj; empty: a file that holds a whole project
    std::set<std::string> names;                       // folded: what others refer to it by
    std::set<std::string> uses;                        // folded: libraries it refers to
    std::vector<std::filesystem::path> files, leftOut; // leftOut: in its folder, but not part of the project
};

struct Tree {
    std::filesystem::path root;
    std::vector<TreePart> parts;
    std::vector<std::filesystem::path> rest; // files that belong to no project
};

/// Parts of a tree that become one project, the one they are there for first; -1 is the rest.
using TreeGroup = std::vector<int>;

[[nodiscard]] Tree surveyTree(const std::filesystem::path& root, Progress* progress);
/// Each project that no other uses, with those it uses; the rest by itself.
[[nodiscard]] std::vector<TreeGroup> groupsOf(const Tree& tree);
[[nodiscard]] TreeGroup withUsed(const Tree& tree, int part);
[[nodiscard]] std::string nameOf(const Tree& tree, const TreeGroup& group);

/// Folded names of the units, types and configurations that a text declares.
[[nodiscard]] std::set<std::string> declaredNames(std::string_view text);
/// The ending of a file's name in small letters: ".tcpou".
[[nodiscard]] std::string endingOf(const std::filesystem::path& path);
/// By its ending a file that an import may read.
[[nodiscard]] bool isSourceName(const std::filesystem::path& path);
/// Of TwinCAT and CODESYS: the files around a project, none of which has a program itself.
[[nodiscard]] bool isSolutionName(const std::filesystem::path& path);

} // namespace plc::exchange
