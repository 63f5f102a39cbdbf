#include "runtime/compiler/ladder/declared_types.h"

#include "runtime/base/text.h"

#include <algorithm>

namespace plc::ladder {

using lex::TokenKind;
using syntax::Expr;
using syntax::ExprKind;
using syntax::Pou;
using syntax::TypeSpec;
using syntax::TypeSpecKind;

namespace {

constexpr int kMostAliases = 20; // a type that names itself is wrong, not endless

template <class Map> auto found(const Map& map, const std::string& name) {
    const auto it = map.find(name);
    return it == map.end() ? typename Map::mapped_type{} : it->second;
}

std::string lastName(const syntax::Path& path) { return path.empty() ? std::string() : foldCase(path.back().text); }

bool isComparison(TokenKind op) {
    switch (op) {
    case TokenKind::Equal:
    case TokenKind::NotEqual:
    case TokenKind::Less:
    case TokenKind::LessEqual:
    case TokenKind::Greater:
    case TokenKind::GreaterEqual:
    case TokenKind::AndThen:
    case TokenKind::OrElse:
        return true;
    default:
        return false;
    }
}

/// %IX1.0, %I1.0, %Q0.3: one bit; %IW4: not.
bool isBitAddress(std::string_view text) {
    if (text.size() < 3) return false;
    const char size = text[2];
    return size == 'X' || size == 'x' || size == '*' || (size >= '0' && size <= '9');
}

/// Functions of the standard whose result is a BOOL whatever they compare (IEC 61131-3, table 28), and conversions.
bool isBoolFunction(const std::string& name) {
    static constexpr std::string_view comparisons[] = {"gt", "ge", "eq", "le", "lt", "ne", "is_valid"};
    return std::any_of(std::begin(comparisons), std::end(comparisons), [&](std::string_view c) { return c == name; }) ||
           name == "to_bool" || name.ends_with("_to_bool");
}

} // namespace

DeclaredTypes::DeclaredTypes(const std::vector<const syntax::SyntaxFile*>& files) {
    m_bool.kind = TypeSpecKind::Named;
    m_bool.path.push_back({"BOOL", {}});
    for (const syntax::SyntaxFile* file : files)
        if (file) collect(file->declarations);
}

void DeclaredTypes::collect(const std::vector<syntax::Decl*>& declarations) {
    for (const syntax::Decl* decl : declarations) {
        if (decl->space) collect(decl->space->declarations);
        if (decl->type) m_types.emplace(foldCase(decl->type->name.text), decl->type);
        if (decl->globals) {
            addGlobals({decl->globals->section});
            Names& list = m_lists[foldCase(decl->globals->name)];
            for (const syntax::VarDecl* variable : decl->globals->section->declarations)
                for (const syntax::Name& name : variable->names) list.emplace(foldCase(name.text), variable);
        }
        if (decl->configuration) {
            addGlobals(decl->configuration->sections);
            for (const syntax::ResourceDecl* resource : decl->configuration->resources) addGlobals(resource->sections);
        }
        if (!decl->pou || !m_pous.emplace(foldCase(decl->pou->name.text), decl->pou).second) continue;
        const auto gather = [&](const Pou& pou) {
            Members& members = m_members[&pou];
            for (const syntax::VarSection* section : pou.sections)
                for (const syntax::VarDecl* variable : section->declarations)
                    for (const syntax::Name& name : variable->names)
                        members.variables.emplace(foldCase(name.text), variable);
            for (const syntax::Property* p : pou.properties)
                members.properties.emplace(foldCase(p->name.text), p->type);
            for (const Pou* method : pou.methods) members.methods.emplace(foldCase(method->name.text), method);
        };
        gather(*decl->pou);
        for (const Pou* method : decl->pou->methods) gather(*method);
        for (const syntax::Property* property : decl->pou->properties)
            for (const Pou* accessor : {property->get, property->set})
                if (accessor) gather(*accessor);
    }
}

void DeclaredTypes::addGlobals(const std::vector<syntax::VarSection*>& sections) {
    for (const syntax::VarSection* section : sections) {
        if (!section || section->kind != syntax::SectionKind::Global) continue;
        for (const syntax::VarDecl* variable : section->declarations)
            for (const syntax::Name& name : variable->names) m_globals.emplace(foldCase(name.text), variable);
    }
}

const DeclaredTypes::Members& DeclaredTypes::membersOf(const Pou& pou) const {
    static const Members none;
    const auto it = m_members.find(&pou);
    return it == m_members.end() ? none : it->second;
}

const Pou* DeclaredTypes::pou(std::string_view name) const { return found(m_pous, foldCase(name)); }

std::vector<std::string> DeclaredTypes::blocks() const {
    std::vector<std::string> out;
    for (const auto& [name, pou] : m_pous)
        if (pou->kind == syntax::PouKind::FunctionBlock && !pou->name.text.empty()) out.emplace_back(pou->name.text);
    std::sort(out.begin(), out.end());
    return out;
}

const syntax::VarDecl* DeclaredTypes::memberVariable(const Pou& pou, const std::string& name) const {
    const Pou* at = &pou;
    for (int depth = 0; at && depth < kMostAliases; ++depth) {
        if (const auto* variable = found(membersOf(*at).variables, name)) return variable;
        at = at->extends.empty() ? nullptr : found(m_pous, lastName(at->extends.front()));
    }
    return nullptr;
}

const syntax::VarDecl* DeclaredTypes::declarationOf(const Expr& expr, const Scope& scope) const {
    const std::string name = foldCase(expr.name.text);
    if (expr.kind == ExprKind::NameRef) {
        for (const Pou* pou : {scope.pou, scope.owner})
            if (const syntax::VarDecl* variable = pou ? memberVariable(*pou, name) : nullptr) return variable;
        return found(m_globals, name);
    }
    if (expr.kind != ExprKind::Member) return nullptr;
    if (expr.base->kind == ExprKind::NameRef && !nameType(expr.base->name.text, scope)) {
        const auto list = m_lists.find(foldCase(expr.base->name.text));
        if (list != m_lists.end()) return found(list->second, name);
        if (const Pou* program = pou(expr.base->name.text)) return memberVariable(*program, name);
        return found(m_globals, name);
    }
    const TypeSpec* type = resolved(typeOf(*expr.base, scope));
    if (const Pou* block = blockOf(type)) return memberVariable(*block, name);
    for (const syntax::VarDecl* field : type ? type->fields : std::vector<syntax::VarDecl*>())
        for (const syntax::Name& each : field->names)
            if (foldCase(each.text) == name) return field;
    return nullptr;
}

const TypeSpec* DeclaredTypes::memberType(const Pou& pou, const std::string& name) const {
    const Pou* at = &pou;
    for (int depth = 0; at && depth < kMostAliases; ++depth) {
        const Members& members = membersOf(*at);
        if (const auto* variable = found(members.variables, name)) return variable->type;
        if (const auto* property = found(members.properties, name)) return property;
        at = at->extends.empty() ? nullptr : found(m_pous, lastName(at->extends.front()));
    }
    return nullptr;
}

const TypeSpec* DeclaredTypes::resolved(const TypeSpec* type) const {
    for (int depth = 0; type && depth < kMostAliases; ++depth) {
        if (type->kind != TypeSpecKind::Named) return type;
        const syntax::TypeDecl* decl = found(m_types, lastName(type->path));
        if (!decl) return type;
        type = decl->spec;
    }
    return type;
}

bool DeclaredTypes::isBoolType(const TypeSpec* type) const {
    const TypeSpec* at = resolved(type);
    if (!at || at->kind != TypeSpecKind::Named || at->path.size() != 1) return false;
    return equalsIgnoringCase(at->path[0].text, "BOOL") || equalsIgnoringCase(at->path[0].text, "SAFEBOOL");
}

const Pou* DeclaredTypes::blockOf(const TypeSpec* type) const {
    const TypeSpec* at = resolved(type);
    if (at && (at->kind == TypeSpecKind::Reference || at->kind == TypeSpecKind::RefTo)) at = resolved(at->element);
    return at && at->kind == TypeSpecKind::Named ? found(m_pous, lastName(at->path)) : nullptr;
}

const TypeSpec* DeclaredTypes::fieldType(const TypeSpec* type, const std::string& name) const {
    for (int depth = 0; type && depth < kMostAliases; ++depth) {
        const TypeSpec* at = resolved(type);
        if (at && (at->kind == TypeSpecKind::Reference || at->kind == TypeSpecKind::RefTo)) at = resolved(at->element);
        if (!at) return nullptr;
        for (const syntax::VarDecl* field : at->fields)
            for (const syntax::Name& each : field->names)
                if (foldCase(each.text) == name) return field->type;
        if (const Pou* block = blockOf(at)) return memberType(*block, name);
        type = at->extends;
    }
    return nullptr;
}

const TypeSpec* DeclaredTypes::nameType(std::string_view text, const Scope& scope) const {
    const std::string name = foldCase(text);
    for (const Pou* pou : {scope.pou, scope.owner}) {
        if (!pou) continue;
        if (const TypeSpec* type = memberType(*pou, name)) return type;
        if (pou->result && foldCase(pou->name.text) == name) return pou->result;
    }
    const syntax::VarDecl* global = found(m_globals, name);
    return global ? global->type : nullptr;
}

bool DeclaredTypes::isDeclared(std::string_view name, const Scope& scope) const {
    return nameType(name, scope) || pou(name);
}

bool DeclaredTypes::isTemporary(std::string_view name, const Scope& scope) const {
    if (!scope.pou) return false;
    for (const syntax::VarSection* section : scope.pou->sections)
        if (section->kind == syntax::SectionKind::Temp)
            for (const syntax::VarDecl* variable : section->declarations)
                for (const syntax::Name& each : variable->names)
                    if (equalsIgnoringCase(each.text, name)) return true;
    return false;
}

const Pou* DeclaredTypes::calleeOf(const Expr& base, const Scope& scope) const {
    if (base.kind == ExprKind::Member) {
        const std::string name = foldCase(base.name.text);
        const Pou* block = base.base->kind == ExprKind::This || base.base->kind == ExprKind::Deref
                               ? (scope.owner ? scope.owner : scope.pou)
                               : blockOf(typeOf(*base.base, scope));
        for (int depth = 0; block && depth < kMostAliases; ++depth) {
            if (const Pou* method = found(membersOf(*block).methods, name)) return method;
            block = block->extends.empty() ? nullptr : found(m_pous, lastName(block->extends.front()));
        }
    }
    if (const Pou* block = blockOf(typeOf(base, scope))) return block;
    if (base.kind != ExprKind::NameRef && base.kind != ExprKind::Member) return nullptr;
    const std::string name = foldCase(base.name.text);
    if (base.kind == ExprKind::NameRef)
        for (const Pou* pou : {scope.pou, scope.owner})
            if (pou)
                if (const Pou* method = found(membersOf(*pou).methods, name)) return method;
    return found(m_pous, name);
}

const TypeSpec* DeclaredTypes::callType(const Expr& call, const Scope& scope) const {
    if (const Pou* callee = calleeOf(*call.base, scope)) return callee->result;
    return isBoolFunction(foldCase(call.base->name.text)) ? &m_bool : nullptr;
}

const TypeSpec* DeclaredTypes::binaryType(const Expr& expr, const Scope& scope) const {
    if (isComparison(expr.op)) return &m_bool;
    if (const TypeSpec* left = typeOf(*expr.base, scope)) return left;
    return typeOf(*expr.right, scope);
}

const TypeSpec* DeclaredTypes::typeOf(const Expr& expr, const Scope& scope) const {
    switch (expr.kind) {
    case ExprKind::NameRef:
        return nameType(expr.name.text, scope);
    case ExprKind::Address:
        return isBitAddress(expr.text) ? &m_bool : nullptr;
    case ExprKind::Bit:
        return expr.text.size() > 1 && expr.text[0] == '%' && (expr.text[1] | 0x20) != 'x' ? nullptr : &m_bool;
    case ExprKind::Literal:
        return expr.op == TokenKind::True || expr.op == TokenKind::False || equalsIgnoringCase(expr.prefix.text, "BOOL")
                   ? &m_bool
                   : nullptr;
    case ExprKind::Member: {
        if (expr.base->kind == ExprKind::NameRef && !nameType(expr.base->name.text, scope)) {
            const auto list = m_lists.find(foldCase(expr.base->name.text));
            if (list != m_lists.end()) {
                const syntax::VarDecl* global = found(list->second, foldCase(expr.name.text));
                return global ? global->type : nullptr;
            }
            // a program's variable, or a list that is named after its file
            if (const Pou* program = pou(expr.base->name.text)) return memberType(*program, foldCase(expr.name.text));
            const syntax::VarDecl* global = found(m_globals, foldCase(expr.name.text));
            return global ? global->type : nullptr;
        }
        if (expr.base->kind == ExprKind::This ||
            (expr.base->kind == ExprKind::Deref && expr.base->base && expr.base->base->kind == ExprKind::This)) {
            const Pou* own = scope.owner ? scope.owner : scope.pou;
            return own ? memberType(*own, foldCase(expr.name.text)) : nullptr;
        }
        return fieldType(typeOf(*expr.base, scope), foldCase(expr.name.text));
    }
    case ExprKind::Index:
    case ExprKind::Deref: {
        const TypeSpec* type = resolved(typeOf(*expr.base, scope));
        return type ? type->element : nullptr;
    }
    case ExprKind::Call:
        return callType(expr, scope);
    case ExprKind::Unary:
        return typeOf(*expr.base, scope);
    case ExprKind::Binary:
        return binaryType(expr, scope);
    case ExprKind::AssignChain:
        return typeOf(*expr.base, scope);
    case ExprKind::Error:
    case ExprKind::TypedName:
    case ExprKind::ArrayInit:
    case ExprKind::StructInit:
    case ExprKind::Repeat:
    case ExprKind::This:
    case ExprKind::Super:
        return nullptr;
    }
    return nullptr;
}

DeclaredTypes::Truth DeclaredTypes::isBool(const Expr& expr, const Scope& scope) const {
    if (const TypeSpec* type = typeOf(expr, scope)) return isBoolType(type) ? Truth::Yes : Truth::No;
    return expr.kind == ExprKind::Literal ? Truth::No : Truth::Unknown;
}

} // namespace plc::ladder
