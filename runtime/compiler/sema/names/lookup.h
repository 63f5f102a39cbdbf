// Name lookup: own unit, its bases, the namespace and those around it, USING, the project, then the libraries.
#pragma once
#include "runtime/compiler/sema/context.h"

namespace plc::sema {

/// Near names that are looked for in one program.
inline constexpr size_t kMaximumSuggestions = 100;

[[nodiscard]] Member findMember(Unit& unit, NameId id);
[[nodiscard]] Found lookupIn(Space& space, NameId id);
[[nodiscard]] Found lookup(const World& world, const Scope& scope, NameId id, bool wantsType = false);
[[nodiscard]] Found lookupPath(const World& world, const Scope& scope, const syntax::Path& path);
void addNames(const World& world, const Space& space, std::vector<std::string>& out);
[[nodiscard]] std::vector<std::string> visibleNames(const World& world, const Scope& scope);
[[nodiscard]] std::vector<std::string> memberNames(const World& world, TypeId type);
void suggest(Gathered& gathered, diagnostics::Diagnostic& diagnostic, SourceRange range, std::string_view name,
             const std::vector<std::string>& candidates);
void suggest(Context& context, diagnostics::Diagnostic& diagnostic, SourceRange range, std::string_view name,
             const std::vector<std::string>& candidates);
/// Not too many near names were looked for.
[[nodiscard]] bool maySuggest(const Context& context);

} // namespace plc::sema
