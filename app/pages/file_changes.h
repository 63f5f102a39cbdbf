// Changes of several files at once (rename, replace in all files): open ones through their editor, the others in the
// workspace, and one undo takes all of them back. Owned by the tabs; GUI thread.
#pragma once
#include "editor/workspace/workspace.h"
#include "runtime/diagnostics/diagnostic.h"

#include <deque>
#include <functional>
#include <map>

namespace plc::app {

class EditorTabs;

class FileChanges {
public:
    FileChanges(editor::Workspace& workspace, EditorTabs& tabs) : m_workspace(workspace), m_tabs(tabs) {}

    /// `alongside` changes the panels with the texts, forward (false) and back (true).
    void apply(const std::map<QString, std::vector<diagnostics::TextEdit>>& edits, std::function<void(bool)> alongside);
    /// New texts.
    void apply(const std::map<QString, std::string>& texts);
    /// False: the newest change of the text in front is its own.
    bool undo();
    bool redo();
    void clear() { m_groups.clear(); }

private:
    struct Group {
        struct Texts {
            std::string before, after;
        };
        std::map<QString, Texts> texts;
        std::function<void(bool)> alongside;
        bool isUndone = false;
    };
    void remember(Group group);
    [[nodiscard]] Group* groupAt(bool undone);
    void swapGroup(Group& group);

    editor::Workspace& m_workspace;
    EditorTabs& m_tabs;
    std::deque<Group> m_groups;
};

} // namespace plc::app
