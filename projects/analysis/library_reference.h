// The reference of all libraries as Markdown, made from the doc comments and declarations of their ST texts and from
// the table of standard functions. `stepwise doc library` writes it, docs/library holds it, a test says when that is
// stale. Pure; any thread.
#pragma once
#include "runtime/base/result.h"

#include <string>
#include <vector>

namespace plc::analysis {

struct ReferencePage {
    std::string fileName; // "toolbox.md"
    std::string markdown;
};

/// README.md first, then a page per library, by name.
[[nodiscard]] std::vector<ReferencePage> libraryReference();

/// Writes the pages into `folder` (made when missing); a page that is as it should be is not touched. Returns how many
/// were written.
[[nodiscard]] Result<int> writeLibraryReference(const std::string& folder);

} // namespace plc::analysis
