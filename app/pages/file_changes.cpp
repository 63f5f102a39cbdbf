#include "app/pages/file_changes.h"

#include "app/pages/editor_tabs.h"
#include "editor/kit/message_text.h"

namespace plc::app {

void FileChanges::apply(const std::map<QString, std::vector<diagnostics::TextEdit>>& edits,
                        std::function<void(bool)> alongside) {
    Group group;
    group.alongside = std::move(alongside);
    for (const auto& [file, list] : edits) {
        std::string text = m_workspace.text(file);
        Group::Texts& kept = group.texts[file];
        kept.before = text;
        if (StPage* page = m_tabs.pageOf(file)) {
            page->first().applyEdits(list);
        } else {
            for (size_t i = list.size(); i-- > 0;)
                text.replace(list[i].range.begin, list[i].range.length(), list[i].text);
            m_workspace.setText(file, std::move(text));
        }
        kept.after = m_workspace.text(file);
    }
    remember(std::move(group));
    m_workspace.checkNow();
}

void FileChanges::apply(const std::map<QString, std::string>& texts) {
    Group group;
    for (const auto& [file, text] : texts) {
        group.texts[file] = {m_workspace.text(file), text};
        if (StPage* page = m_tabs.pageOf(file)) page->first().takeText(text);
        m_workspace.setText(file, text);
    }
    remember(std::move(group));
    m_workspace.checkNow();
}

void FileChanges::remember(Group group) {
    const bool isAnEditorsOwn =
        group.texts.size() == 1 && !group.alongside && m_tabs.pageOf(group.texts.begin()->first);
    if (group.texts.empty() || isAnEditorsOwn) return;
    std::erase_if(m_groups, [](const Group& each) { return each.isUndone; });
    m_groups.push_back(std::move(group));
    if (m_groups.size() > 20) m_groups.pop_front();
}

/// The newest change of several files whose state the text in front shows.
FileChanges::Group* FileChanges::groupAt(bool undone) {
    const editor::StEditor* editor = m_tabs.currentEditor();
    if (!editor) return nullptr;
    const std::string text = editor->utf8();
    for (size_t i = m_groups.size(); i-- > 0;) {
        Group& group = m_groups[i];
        const auto here = group.texts.find(editor->file());
        if (group.isUndone == undone && here != group.texts.end() &&
            text == (undone ? here->second.before : here->second.after))
            return &group;
    }
    return nullptr;
}

void FileChanges::swapGroup(Group& group) {
    group.isUndone = !group.isUndone;
    const bool back = group.isUndone;
    int kept = 0;
    for (const auto& [file, texts] : group.texts) {
        const std::string &from = back ? texts.after : texts.before, &to = back ? texts.before : texts.after;
        if (!m_workspace.files().contains(file)) { // it left with the last unit in it
            if (back && !to.empty())
                if (auto added = m_workspace.addFile(file, to); !added)
                    emit m_tabs.message(kit::messageText(added.error()), true);
            continue;
        }
        if (m_workspace.text(file) != from) { // edited since
            ++kept;
            continue;
        }
        if (StPage* page = m_tabs.pageOf(file)) {
            back ? page->first().undo() : page->first().redo();
            page->first().takeText(to); // a page that was opened since has no undo of its own
        }
        m_workspace.setText(file, to);
    }
    if (group.alongside) group.alongside(back);
    m_workspace.checkNow();
    const int changed = static_cast<int>(group.texts.size()) - kept;
    emit m_tabs.message(
        kept ? EditorTabs::tr("Changed in %n file(s); those edited since stay as they are", nullptr, changed)
             : EditorTabs::tr("Changed in %n file(s)", nullptr, changed),
        false);
}

bool FileChanges::undo() {
    Group* group = groupAt(false);
    if (group) swapGroup(*group);
    return group != nullptr;
}

bool FileChanges::redo() {
    Group* group = groupAt(true);
    if (group) swapGroup(*group);
    return group != nullptr;
}

} // namespace plc::app
