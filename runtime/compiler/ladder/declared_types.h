// What the declarations alone say about types: enough to draw a BOOL as a contact and a number as a pin, before and
// without a check. Views of syntax trees, which must outlive it; built by one thread, then immutable.
#pragma once
#include "runtime/compiler/parse/syntax.h"

#include <string>
#include <unordered_map>
#include <vector>

namespace plc::ladder {

class DeclaredTypes {
public:
    /// Of several declarations of a name the one in the earlier file counts: the file that is shown comes first.
    explicit DeclaredTypes(const std::vector<const syntax::SyntaxFile*>& files);

    enum class Truth : uint8_t { No, Yes, Unknown };
    /// Where an expression stands: its names resolve in `pou`, then in `owner`, then in the globals.
    struct Scope {
        const syntax::Pou* pou = nullptr;
        const syntax::Pou* owner = nullptr;
    };
    [[nodiscard]] const syntax::TypeSpec* typeOf(const syntax::Expr& expr, const Scope& scope) const;
    [[nodiscard]] Truth isBool(const syntax::Expr& expr, const Scope& scope) const;
    /// Where a variable is declared: a name, a member of a list or a structure; null for anything else.
    [[nodiscard]] const syntax::VarDecl* declarationOf(const syntax::Expr& expr, const Scope& scope) const;
    /// The block, function, method or program that a call's base means; null when it is not declared here.
    [[nodiscard]] const syntax::Pou* calleeOf(const syntax::Expr& base, const Scope& scope) const;
    [[nodiscard]] const syntax::Pou* pou(std::string_view name) const;
    /// Every function block, by name.
    [[nodiscard]] std::vector<std::string> blocks() const;
    /// Declared in VAR_TEMP of the scope's unit.
    [[nodiscard]] bool isTemporary(std::string_view name, const Scope& scope) const;
    [[nodiscard]] bool isDeclared(std::string_view name, const Scope& scope) const;
    [[nodiscard]] bool isBoolType(const syntax::TypeSpec* type) const;

private:
    using Names = std::unordered_map<std::string, const syntax::VarDecl*>;
    struct Members {
        Names variables;
        std::unordered_map<std::string, const syntax::TypeSpec*> properties;
        std::unordered_map<std::string, const syntax::Pou*> methods;
    };
    void collect(const std::vector<syntax::Decl*>& declarations);
    void addGlobals(const std::vector<syntax::VarSection*>& sections);
    [[nodiscard]] const Members& membersOf(const syntax::Pou& pou) const;
    [[nodiscard]] const syntax::VarDecl* memberVariable(const syntax::Pou& pou, const std::string& name) const;
    [[nodiscard]] const syntax::TypeSpec* memberType(const syntax::Pou& pou, const std::string& name) const;
    [[nodiscard]] const syntax::TypeSpec* fieldType(const syntax::TypeSpec* type, const std::string& name) const;
    [[nodiscard]] const syntax::TypeSpec* nameType(std::string_view name, const Scope& scope) const;
    [[nodiscard]] const syntax::TypeSpec* callType(const syntax::Expr& call, const Scope& scope) const;
    [[nodiscard]] const syntax::TypeSpec* binaryType(const syntax::Expr& expr, const Scope& scope) const;
    /// Through the names of types, to what one of them stands for.
    [[nodiscard]] const syntax::TypeSpec* resolved(const syntax::TypeSpec* type) const;
    [[nodiscard]] const syntax::Pou* blockOf(const syntax::TypeSpec* type) const;

    std::unordered_map<std::string, const syntax::TypeDecl*> m_types;
    std::unordered_map<std::string, const syntax::Pou*> m_pous;
    Names m_globals;
    std::unordered_map<std::string, Names> m_lists;
    std::unordered_map<const syntax::Pou*, Members> m_members;
    syntax::TypeSpec m_bool;
};

} // namespace plc::ladder
