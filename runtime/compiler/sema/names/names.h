// What names mean: NameRef, Member, Index, Deref, Bit, Address → a place, a value, a unit, a type…
#pragma once
#include "runtime/compiler/sema/context.h"

namespace plc::sema {

/// A unit by its name; `instance`: of a method or action.
[[nodiscard]] inline Denoted unitOf(Unit& unit, tree::Place* instance) {
    Denoted out;
    out.kind = Denoted::Kind::Unit;
    out.unit = &unit;
    out.instance = instance;
    return out;
}
bool checkAccess(Context& context, syntax::Access access, const Unit* owner, const std::string& name,
                 SourceRange range);
Denoted denote(Context& context, const syntax::Expr& e, Access access, TypeId hint = {});
/// null: reported
tree::Place* place(Context& context, const syntax::Expr& e, Access access);
Denoted found(Context& context, const Found& found, const syntax::Name& name, Access access, TypeId hint);
Denoted ofVariable(Context& context, Variable& variable, tree::Place* instance, SourceRange range, Access access);

} // namespace plc::sema
