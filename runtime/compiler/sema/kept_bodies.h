// What one check leaves to the next, so that a keystroke checks the body it is in and not all bodies again
// (docs/decisions/027-kept-bodies.md). Owned by who checks again and again (driver::KeptFiles); one thread.
#pragma once
#include "runtime/compiler/sema/sema.h"

#include <memory>

namespace plc::sema {

struct LastCheck;

class KeptBodies {
public:
    /// How many bodies the last check had to check.
    [[nodiscard]] size_t checkedLast() const { return m_checkedLast; }

private:
    friend std::shared_ptr<const Analysis> analyze(const SourceSet&,
                                                   std::vector<std::shared_ptr<const syntax::SyntaxFile>>,
                                                   std::vector<diagnostics::Diagnostic>, const Options&, KeptBodies*);
    std::shared_ptr<const LastCheck> m_last;
    size_t m_checkedLast = 0;
};

/// As sema::analyze, and finds exactly what it finds; where only bodies changed since `kept` was used last, only those
/// are checked.
[[nodiscard]] std::shared_ptr<const Analysis> analyze(const SourceSet& sources,
                                                      std::vector<std::shared_ptr<const syntax::SyntaxFile>> files,
                                                      std::vector<diagnostics::Diagnostic> syntaxDiagnostics,
                                                      const Options& options, KeptBodies* kept);

/// For who makes code of it: the trees of kept bodies still have the places of the text they were checked in; here they
/// have those of the analysis. The same analysis when nothing moved.
[[nodiscard]] std::shared_ptr<const Analysis> withTreesInPlace(const std::shared_ptr<const Analysis>& analysis);

} // namespace plc::sema
