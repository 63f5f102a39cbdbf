#include "editor/analysis/path_completion.h"

#include "editor/analysis/workspace.h"

namespace plc::editor {

kit::CompletionSource pathCompletions(const Workspace& workspace) {
    return [&workspace](const QString& text, int cursor) {
        std::vector<kit::Completion> out;
        if (!workspace.model()) return out;
        const std::string utf8 = text.toStdString();
        const auto offset = static_cast<uint32_t>(text.left(cursor).toUtf8().size());
        const analysis::Completion found = workspace.model()->completePath(utf8, offset);
        const int from = static_cast<int>(QString::fromStdString(utf8.substr(0, found.replaceBegin)).size());
        for (const analysis::CompletionItem& item : found.items) {
            out.push_back(
                {QString::fromStdString(item.text), QString::fromStdString(item.detail), kit::Icon::Variable, from});
            if (out.size() == 100) break;
        }
        return out;
    };
}

} // namespace plc::editor
