// What checks add, whoever checks: findings, references, uses of variables and the code made. Nothing of it says what a
// name means. Belongs to one thread: that of the builder, or of the watch expression being checked.
#pragma once
#include "runtime/compiler/sema/scopes.h"

#include <map>

namespace plc::sema {

struct Call {
    uint32_t from = 0, to = 0;
    bool isDispatched = false;
    SourceRange range;
};

/// That a body reads or writes a variable.
struct VariableUse {
    uint32_t variable = 0; // World::numbered
    bool isRead = false, isWrite = false;
    bool operator==(const VariableUse&) const = default;
};

struct Gathered {
    Gathered(types::TypeTable& theTypes, Arena& theArena) : types(theTypes), arena(theArena) {}

    diagnostics::Diagnostic& emit(SourceRange range, diagnostics::Finding finding) {
        return sink.emit(range, std::move(finding));
    }

    types::TypeTable& types; // grows: bodies may have texts and pointers of types that no declaration has
    Arena& arena;
    diagnostics::Sink sink;
    std::vector<Symbol> symbols; // declared ones, then labels
    std::vector<Reference> references;
    std::vector<Call> calls;
    std::vector<VariableUse> uses;        // by the body being checked
    std::deque<tree::Function> functions; // moved into the program at the end
    std::map<TypeId, tree::FunctionId> initialisers;
    size_t suggestions = 0; // so many near names were looked for; at some point a reader has enough
    size_t completions = 0; // of functions that others share, whoever needed them first
};

} // namespace plc::sema
