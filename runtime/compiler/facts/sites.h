// Which statement is which site of the debugger. Made once per program from the checked tree; immutable afterwards.
#pragma once
#include "runtime/compiler/tree/tree.h"

#include <unordered_map>

namespace plc::facts {

/// Statement → site, in the order of DebugMap::sites. Statements of one text share a site; it is asked for a stop once,
/// where the outermost (or first) of them begins. A Block that stands for a written statement (a block call) is such a
/// statement.
class SiteTable {
public:
    explicit SiteTable(const tree::Program& program);
    struct Place {
        uint32_t site = 0;  // 0 = none
        bool stops = false; // asks whether to stop
    };
    [[nodiscard]] Place at(const tree::Stmt& stmt) const;
    [[nodiscard]] uint32_t siteOf(const tree::Stmt& stmt) const { return at(stmt).site; }
    std::vector<image::Site> sites; // 0 unused

private:
    std::unordered_map<const tree::Stmt*, Place> m_places;
};

} // namespace plc::facts
