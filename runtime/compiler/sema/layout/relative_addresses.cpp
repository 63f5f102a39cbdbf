// Members of a structure that have an address in it (IEC 61131-3 edition 3, table 11): `a AT %B0 : INT; b AT %X2.1 :
// BOOL`.
#include "runtime/compiler/sema/layout/relative_addresses.h"

#include "runtime/compiler/sema/context.h"
#include "runtime/compiler/sema/program/analyze.h"

#include <algorithm>

namespace plc::sema {
static bool locateMember(WorldBuilder& world, types::Field& field, const syntax::VarDecl& declaration);
static void checkMemberOverlaps(WorldBuilder& world, const StructType& type, const std::vector<types::Field>& fields,
                                size_t inherited, const std::vector<const syntax::VarDecl*>& declarations);

namespace {

// Parsed with an area in front, since an address without one means nothing elsewhere.
/// As of %MB4: the area does not count. An address with an area is none here.
std::optional<DirectAddress> parseRelative(std::string_view text) {
    if (text.size() < 2 || std::string_view("IQMiqm").find(text[1]) != std::string_view::npos) return std::nullopt;
    const auto address = image::parseAddress("%M" + std::string(text.substr(1)), image::Addressing::Bytes);
    return address && !address->isHierarchical ? address : std::nullopt;
}

/// AT %I* of a member: each variable of the structure gets its channel from the devices, it has no place in the image.
bool isOpenChannel(std::string_view text) {
    return text.size() == 3 && text[2] == '*' && std::string_view("IQMiqm").find(text[1]) != std::string_view::npos;
}

// Far above every real structure, and small enough for offsets in bits.
constexpr uint32_t kMaximumByte = 1u << 24;

} // namespace

/// Gives the members with an address their place; those of the base keep theirs when one has.
void locateMembers(WorldBuilder& world, const StructType& made, std::vector<types::Field>& fields, size_t inherited,
                   const std::vector<const syntax::VarDecl*>& declarations) {
    // As soon as one member says where it is, the compiler may move none of the others that do, those of the base
    // included.
    bool any = false;
    for (size_t i = inherited; i < fields.size(); ++i) {
        const syntax::VarDecl& declaration = *declarations[i - inherited];
        if (declaration.address.empty() || declaration.names.empty() ||
            // `a, b AT %B0` would put two members at one place: the address is that of the first.
            fields[i].declaration != declaration.names.front().range)
            continue;
        any = locateMember(world, fields[i], declaration) || any;
    }
    if (!any) return;
    for (size_t i = 0; i < inherited; ++i) fields[i].isLocated = true;
    if (!made.isUnion) checkMemberOverlaps(world, made, fields, inherited, declarations);
}

/// The size letter agrees with the type; B is the byte a member of any type begins at.
///   ok:    a AT %B0 : INT; b AT %W2 : INT; c AT %X4.1 : BOOL;      wrong: a AT %IB0 : INT; (P2043) b AT %D0 : INT;
///   (P3037)
bool locateMember(WorldBuilder& world, types::Field& field, const syntax::VarDecl& declaration) {
    const std::string_view text = declaration.address;
    // %I* of a member is completed by devices.json for each variable of the structure.
    if (isOpenChannel(text)) return false;
    const auto address = parseRelative(text);
    if (!address || (!address->isOpen && address->byte > kMaximumByte)) {
        if (!hasSyntaxErrorAt(world, declaration.addressRange))
            world.emit(declaration.addressRange, findings::RelativeAddress(text));
        return false;
    }
    if (address->isOpen) return false; // AT %B*: wherever there is room
    field.offset = address->byte;
    field.isLocated = true;
    const TypeKind kind = world.types.storageKind(field.type);
    if (address->bit >= 0) {
        if (kind == TypeKind::Bool)
            field.bit = address->bit;
        else if (kind != TypeKind::Unknown && address->bit != 0)
            return world.emit(declaration.addressRange, findings::TypeMismatch(text, world.nameOf(field.type))), true;
    } else {
        // A BOOL at %B4 takes the whole byte; at %X4.1 one bit of it.
        field.bit = -1;
    }
    const types::Family family = world.types.family(field.type);
    // Only for numbers does the letter say a size; a structure or a text begins at the byte, whatever the letter.
    const bool isNumber = types::isInteger(family) || family == types::Family::Real || family == types::Family::Bool;
    const unsigned has = types::bitsOf(kind), holds = types::bitsOf(address->kind);
    if (isNumber && holds != 8 && has != holds) {
        const char letter = has == 1 ? 'X' : has == 8 ? 'B' : has == 16 ? 'W' : has == 32 ? 'D' : 'L';
        const std::string own = std::string("%") + letter + std::to_string(address->byte) + (has == 1 ? ".0" : "");
        world.emit(declaration.addressRange, findings::AddressSize(text, holds, world.nameOf(field.type), has, own))
            .fixes.push_back({fixes::Write(own), {{declaration.addressRange, own}}});
    }
    return true;
}

///   wrong: a AT %B0 : INT; b AT %B1 : INT; (P2042)      ok: the same in STRUCT OVERLAP
void checkMemberOverlaps(WorldBuilder& world, const StructType& made, const std::vector<types::Field>& fields,
                         size_t inherited, const std::vector<const syntax::VarDecl*>& declarations) {
    struct Used {
        size_t field;
        uint64_t begin, end; // in bits
    };
    // In bits, so that eight BOOLs in one byte are neighbours.
    std::vector<Used> used;
    for (size_t i = 0; i < fields.size(); ++i) {
        if (!fields[i].isLocated) continue;
        const uint64_t begin = uint64_t(fields[i].offset) * 8 + static_cast<uint64_t>(std::max<int>(0, fields[i].bit));
        used.push_back(
            {i, begin, begin + (fields[i].bit >= 0 ? 1 : std::max(1u, world.types[fields[i].type].size) * 8ull)});
    }
    // Sorted by place, each has only to be compared with the one that reaches farthest before it: n log n instead of
    // all pairs, since generated structures have thousands of members.
    std::stable_sort(used.begin(), used.end(), [](const Used& a, const Used& b) { return a.begin < b.begin; });
    const uint64_t free =
        (std::max_element(used.begin(), used.end(), [](const Used& a, const Used& b) { return a.end < b.end; })->end +
         7) /
        8;
    size_t last = 0; // of those before, the one that reaches farthest
    for (size_t i = 1; i < used.size(); ++i) {
        const Used &a = used[last], &b = used[i];
        if (b.end > a.end) last = i;
        if (b.begin >= a.end) continue;
        const size_t later = std::max(a.field, b.field), earlier = std::min(a.field, b.field);
        // Two members of the base: reported there.
        if (later < inherited) continue;
        const syntax::VarDecl& moved = *declarations[later - inherited];
        auto& diagnostic = world.emit(
            moved.addressRange, findings::MembersOverlap(fields[earlier].name, fields[later].name, moved.address));
        diagnostic.related.push_back({fields[earlier].declaration, notes::DeclaredHere()});
        const std::string place = std::string(fields[later].bit >= 0 ? "%X" : "%B") + std::to_string(free) +
                                  (fields[later].bit >= 0 ? ".0" : "");
        diagnostic.fixes.push_back({fixes::MoveTo(fields[later].name, place), {{moved.addressRange, place}}});
        const SourceRange spec = made.spec->range;
        // Behind the word STRUCT, which has six letters.
        if (world.textOf(spec).size() > 6 && !made.spec->extends) {
            const SourceRange behind{spec.file, spec.begin + 6, spec.begin + 6};
            diagnostic.fixes.push_back({fixes::Write(Verbatim("STRUCT OVERLAP")), {{behind, " OVERLAP"}}});
        }
    }
}

} // namespace plc::sema
