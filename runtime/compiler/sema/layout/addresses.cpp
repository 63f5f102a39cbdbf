// Direct addresses: how large the areas %I, %Q and %M have to be, and where hierarchical addresses are in them.
#include "runtime/compiler/sema/layout/addresses.h"

#include "runtime/compiler/sema/layout/layout.h"

namespace plc::sema {
namespace {

using image::Area;

// Programs that grow by an address or two should not move everything behind the areas with each of them: retained
// values and recordings are found by offset.
constexpr uint32_t kMinimumArea = 256;

// %ML is 8 bytes and each area begins at a multiple of 8: the widest access is aligned wherever it is.
uint64_t aligned(uint64_t offset) { return (offset + 7) / 8 * 8; }

uint32_t bytesOf(TypeKind kind) { return std::max(1u, types::bitsOf(kind) / 8); }

/// What flat addresses use of each area, and the hierarchical ones with their sizes.
class Measure {
public:
    explicit Measure(WorldBuilder& world) : m_world(world) {}

    void use(std::string_view text, uint32_t bytes) {
        const auto address = image::parseAddress(text, m_world.options.addressing);
        // Wrong addresses are reported where the variable is placed; here they only must not make the area huge.
        if (!address || address->isOpen || address->byte > kMaximumAddress) return;
        if (address->isHierarchical) {
            HierarchicalPlace& place = m_world.hierarchical[image::hierarchicalName(text)];
            place.address = *address;
            place.size = std::max({place.size, bytes, bytesOf(address->kind)});
            return;
        }
        uint64_t& size = of(address->area);
        size = std::max<uint64_t>(size, uint64_t(address->byte) + std::max(bytes, bytesOf(address->kind)));
    }

    void finish() {
        for (uint64_t& size : m_sizes) size = aligned(size);
        // %IW3.1 says where it is in a rack, not in an area: such addresses follow what flat ones use, in order of
        // their names.
        for (auto& [name, place] : m_world.hierarchical) {
            uint64_t& size = of(place.address.area);
            place.address.byte = static_cast<uint32_t>(std::min<uint64_t>(size, kMaximumAddress));
            size = aligned(size + place.size);
        }
        m_world.rangeOfInputs = static_cast<uint32_t>(m_sizes[0]);
        m_world.rangeOfOutputs = static_cast<uint32_t>(m_sizes[1]);
        m_world.rangeOfMemory = static_cast<uint32_t>(m_sizes[2]);
    }

private:
    uint64_t& of(Area area) { return m_sizes[area == Area::Input ? 0 : area == Area::Output ? 1 : 2]; }

    WorldBuilder& m_world;
    uint64_t m_sizes[3] = {kMinimumArea, kMinimumArea, kMinimumArea};
};

} // namespace

std::optional<DirectAddress> addressIn(const World& world, std::string_view text) {
    const auto address = image::parseAddress(text, world.options.addressing);
    if (!address || !address->isHierarchical) return address;
    const auto known = world.hierarchical.find(image::hierarchicalName(text));
    return known == world.hierarchical.end() ? std::nullopt : std::optional(known->second.address);
}

// Tokens and not trees: an address counts wherever it is written, also in a body that is not checked again.
void measureAddresses(WorldBuilder& world) {
    Measure measure(world);
    for (const syntax::SyntaxFile* file : world.fileOf) {
        if (!file) continue;
        const std::string_view text = world.sources[file->file].text();
        for (const lex::Token& token : file->tokens.tokens)
            if (token.kind == lex::TokenKind::DirectAddress)
                measure.use(text.substr(token.begin, token.end - token.begin), 1);
    }
    // AT %MB0 : ARRAY[0..99] OF BYTE reaches farther than its letter says.
    const auto located = [&](const Variable& variable) {
        if (variable.isLocated && variable.declaration)
            measure.use(variable.declaration->address, std::max(1u, world.types[variable.type].size));
    };
    for (const Variable& variable : world.globals) located(variable);
    for (const Unit& unit : world.units)
        for (const Variable& variable : unit.variables) located(variable);
    measure.finish();
}

std::vector<image::HierarchicalAddress> hierarchicalAddresses(const World& world) {
    std::vector<image::HierarchicalAddress> out;
    for (const auto& [name, place] : world.hierarchical) {
        const DirectAddress& address = place.address;
        const image::Place at{types::TypeTable::of(address.kind), areaOf(world, address.area).begin + address.byte,
                              address.bit};
        out.push_back({name, at, address.area, place.size});
    }
    return out;
}

// The same byte with the letter of another size, for fixes.
std::string withLetter(const World& world, std::string_view text, TypeKind kind) {
    const auto address = image::parseAddress(text, world.options.addressing);
    const std::string letter(types::bitsOf(kind) == 1    ? "X"
                             : types::bitsOf(kind) == 8  ? "B"
                             : types::bitsOf(kind) == 16 ? "W"
                             : types::bitsOf(kind) == 32 ? "D"
                                                         : "L");
    if (!address || address->isHierarchical) return image::hierarchicalName(text).replace(2, 1, letter);
    DirectAddress own = *address;
    own.kind = kind;
    own.bit = kind == TypeKind::Bool ? int16_t(0) : int16_t(-1);
    if (const auto written = image::addressText(own, world.options.addressing)) return *written;
    return std::string(text).replace(2, 1, letter); // in words, of an odd byte: the same number
}

// Counts the last number up: a neighbour in the same module of the rack is the likeliest free place.
std::string freeHierarchical(const World& world, std::string_view text) {
    const std::string name = image::hierarchicalName(text);
    const size_t last = name.rfind('.') + 1;
    for (uint64_t number = std::stoull(name.substr(last)) + 1;; ++number) {
        std::string free = name.substr(0, last) + std::to_string(number);
        if (!world.hierarchical.contains(free)) return free;
    }
}

} // namespace plc::sema
