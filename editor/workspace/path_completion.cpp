#include "editor/workspace/path_completion.h"

#include "editor/workspace/workspace.h"

#include <algorithm>

namespace plc::editor {

kit::CompletionSource pathCompletions(const Workspace& workspace) {
    return [&workspace](const QString& text, int cursor) {
        std::vector<kit::Completion> out;
        if (!workspace.model()) return out;
        const std::string utf8 = text.toStdString();
        const auto offset = static_cast<uint32_t>(text.left(cursor).toUtf8().size());
        analysis::Completion found = workspace.model()->completePath(utf8, offset);
        // What the project has comes before what every project has.
        std::stable_partition(found.items.begin(), found.items.end(), [](const analysis::CompletionItem& item) {
            return item.kind != analysis::ItemKind::Function && item.kind != analysis::ItemKind::Type;
        });
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
