#include "projects/testing/code_names.h"

#include "runtime/base/text.h"
#include "runtime/library/signatures.h"

#include <cctype>

namespace plc::testing {

using syntax::Expr;
using syntax::ExprKind;

namespace {

bool isNameByte(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || static_cast<unsigned char>(c) >= 0x80;
}

std::string nextWord(std::string_view text, size_t& at) {
    while (at < text.size() && !isNameByte(text[at])) ++at;
    const size_t begin = at;
    while (at < text.size() && isNameByte(text[at])) ++at;
    return foldCase(text.substr(begin, at - begin));
}

bool isModifier(std::string_view word) {
    for (const std::string_view each : {"public", "private", "protected", "internal", "abstract", "final", "override"})
        if (word == each) return true;
    return false;
}

} // namespace

/// A word in a comment may add a name too many: its uses are compiled then, which gives the same.
void CodeNames::gather(std::string_view text) {
    for (size_t at = 0; at < text.size();) {
        const std::string word = nextWord(text, at);
        if (word != "function" && word != "property") continue;
        std::string name = nextWord(text, at);
        while (isModifier(name)) name = nextWord(text, at);
        (word == "function" ? m_functions : m_properties).insert(std::move(name));
    }
}

bool CodeNames::isFunction(std::string_view name) const { return m_functions.contains(foldCase(name)); }
bool CodeNames::isProperty(std::string_view name) const { return m_properties.contains(foldCase(name)); }

bool CodeNames::needsCode(const Expr* expression) const {
    if (!expression) return false;
    if (expression->kind == ExprKind::Call) {
        const Expr* callee = expression->base;
        const bool isStandard =
            callee && callee->kind == ExprKind::NameRef && !isFunction(callee->name.text) &&
            (library::findSignature(callee->name.text) || library::findConversion(callee->name.text));
        if (!isStandard) return true;
    }
    if (expression->kind == ExprKind::AssignChain) return true;
    if (expression->kind == ExprKind::Member && isProperty(expression->name.text)) return true;
    for (const syntax::Argument& argument : expression->arguments)
        if (argument.kind == syntax::ArgumentKind::Output || needsCode(argument.value)) return true;
    return needsCode(expression->base) || needsCode(expression->right);
}

} // namespace plc::testing
