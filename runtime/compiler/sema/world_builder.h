// Makes a World: declares, resolves and completes, each thing when something asks for it, because names may be used
// before they are declared. Lives for one check, on one thread; the World stays.
#pragma once
#include "runtime/compiler/sema/gathered.h"
#include "runtime/compiler/sema/world.h"

namespace plc::sema {

struct Located { // an open address that VAR_CONFIG completes, copied at the scan's borders when it lies in a block
    Variable* variable = nullptr;
    bool isCompleted = false;
};

struct Copy {
    image::Place data, address;
    bool isInput = false;
    uint32_t root = 0;
};

struct WorldBuilder : World, Gathered {
    WorldBuilder(const SourceSet& sources, const Options& options, const std::shared_ptr<tree::Program>& theProgram);

    [[nodiscard]] NameId key(std::string_view spelling) { return names.intern(spelling); }

    using Gathered::types; // it may change them
    std::shared_ptr<tree::Program> program;

    std::vector<Located> openAddresses;
    std::vector<Copy> copies;
    std::vector<DynamicInit> programInits; // absolute offsets, in order
    uint32_t waiting = 0, completing = 0;  // see limits.h
    uint64_t initialBytes = 0;             // of all types
    std::vector<std::byte> image;
    std::vector<NameId> slotNames;
};

} // namespace plc::sema
