// What the check of one body gave, and all of one check: kept for the next one (kept_bodies.h). Immutable once made;
// shared by the checks that follow and by whoever still has an Analysis of them.
#pragma once
#include "runtime/compiler/sema/kept/shape.h"
#include "runtime/compiler/sema/world_builder.h"

namespace plc::sema {

/// Everything that checking a body gathered, and the tree it made. Places are those of `shapes`.
struct BodyRecord {
    std::shared_ptr<const Shapes> shapes;
    std::shared_ptr<Arena> arena; // holds the tree
    std::vector<tree::Stmt*> body;
    std::vector<tree::Local> locals;
    uint32_t labelCount = 0;

    std::vector<diagnostics::Diagnostic> diagnostics;
    std::vector<Reference> references;
    std::vector<Symbol> symbols; // labels
    std::vector<Call> calls;
    std::vector<VariableUse> uses;
    std::vector<std::pair<TypeKind, uint32_t>> texts; // types of texts that nothing had before, with their capacities
    size_t suggestionsBefore = 0, suggestions = 0;
    bool isKeepable = false; // it completed nothing that others share
};

struct LastCheck {
    std::vector<std::shared_ptr<const syntax::SyntaxFile>> files;
    std::vector<SourceText> sources;
    std::shared_ptr<const Shapes> shapes;
    struct Rules { // what of the options a body depends on
        bool isStrict = false;
        image::Addressing addressing = image::Addressing::Bytes;
        uint32_t memoryForNew = 0;
        types::StringCode strings = types::StringCode::Latin1;
        bool operator==(const Rules&) const = default;
    } rules;
    std::vector<uint64_t> declared;                         // what the declarations came to
    std::vector<std::shared_ptr<const BodyRecord>> records; // by unit; null: has no code
};

/// What of the last check still holds.
struct StillValid {
    std::shared_ptr<const Shapes> shapes;   // of the files now
    std::vector<std::vector<bool>> changed; // by file and body of its shape
    bool isAny = false;                     // false: more than bodies changed
    [[nodiscard]] bool isChanged(const Unit& unit) const;
};
[[nodiscard]] StillValid stillValid(const LastCheck* last, const World& world,
                                    const std::vector<std::shared_ptr<const syntax::SyntaxFile>>& files);

/// Numbers that differ when declarations were understood differently, although their text is the same: a body decides
/// whether there is an ENO, and how much of %M is used.
[[nodiscard]] std::vector<uint64_t> summaryOf(const WorldBuilder& world);

/// The tree of a body with its places moved, in `arena`.
void moveTree(tree::Function& function, const Moves& moves, Arena& arena);

} // namespace plc::sema
