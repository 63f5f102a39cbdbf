// Conditional pragmas of CODESYS: {define}, {undefine}, {IF defined (…)}, {ELSIF}, {ELSE}, {END_IF}, and {error},
// {warning}, {info}, {text}, which speak where they are compiled. Decides which tokens count before anything is parsed.
// Pure functions, any thread.
#pragma once
#include "runtime/compiler/lex/token.h"

#include <string>
#include <unordered_map>
#include <unordered_set>

namespace plc::parse {

/// What a condition can ask for; names are folded.
struct Definitions {
    std::unordered_map<std::string, std::string> values;    // of {define NAME VALUE} in the project
    std::unordered_set<std::string> types, pous, tasks;     // of all files
    std::unordered_map<std::string, std::string> variables; // global ones, and this file's: name → type as written
    std::unordered_map<std::string, std::unordered_set<std::string>> attributes; // of units and variables
};

struct Conditions {
    std::vector<bool> isInactive; // by index of the token; empty: every token counts
    bool asksForNames = false;    // of other files: the result may change once they are known
    [[nodiscard]] bool isLeftOut(size_t token) const { return !isInactive.empty() && isInactive[token]; }
};

/// `known` null: no name is defined but by {define} in this text.
[[nodiscard]] Conditions readConditions(FileId file, std::string_view text, const lex::TokenList& tokens,
                                        const Definitions* known, diagnostics::Sink& sink);

} // namespace plc::parse
