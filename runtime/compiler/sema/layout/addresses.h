// Direct addresses of a program: how they count (the project's `addressing`), how large the areas %I, %Q and %M become,
// and the places of hierarchical addresses (%IW3.1). One thread builds it.
#pragma once
#include "runtime/compiler/sema/context.h"

namespace plc::sema {

inline constexpr uint32_t kMaximumAddress = 16 << 20;

/// A hierarchical address has its place once the areas are measured.
[[nodiscard]] std::optional<DirectAddress> addressIn(const World& world, std::string_view text);
/// Sizes the areas by the addresses in use; hierarchical addresses follow the flat ones.
void measureAddresses(WorldBuilder& world);
[[nodiscard]] std::vector<image::HierarchicalAddress> hierarchicalAddresses(const World& world);
/// The same address with the letter of another size.
[[nodiscard]] std::string withLetter(const World& world, std::string_view text, TypeKind kind);
/// The next one that nothing uses: %IW3.2 for %IW3.1.
[[nodiscard]] std::string freeHierarchical(const World& world, std::string_view text);

} // namespace plc::sema
