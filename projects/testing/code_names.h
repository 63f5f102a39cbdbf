// Names of a project that only compiled code can use in a TEST: its properties, and functions that have the name of a
// standard one. A value; one thread.
#pragma once
#include "runtime/compiler/parse/syntax.h"

#include <string>
#include <string_view>
#include <unordered_set>

namespace plc::testing {

class CodeNames {
public:
    /// Adds the FUNCTIONs and PROPERTYs that a text declares.
    void gather(std::string_view text);
    [[nodiscard]] bool isFunction(std::string_view name) const;
    [[nodiscard]] bool isProperty(std::string_view name) const;
    /// A call of something that is no standard function, or a property: such an expression needs the compiler's code.
    [[nodiscard]] bool needsCode(const syntax::Expr* expression) const;

private:
    std::unordered_set<std::string> m_functions, m_properties; // folded
};

} // namespace plc::testing
