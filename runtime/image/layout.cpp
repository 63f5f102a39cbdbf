#include "runtime/image/layout.h"
#include "runtime/base/chars.h"
#include "runtime/base/messages.h"

#include "runtime/base/text.h"
#include "runtime/image/path_reader.h"

#include <algorithm>

namespace plc::image {

using types::Field;
using types::Type;
using types::TypeId;
using types::TypeKind;

namespace {

bool isAscii(std::string_view text) {
    return std::all_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

/// equalsIgnoringCase without allocation for the usual case.
bool same(std::string_view a, std::string_view b) {
    if (a.size() == b.size() &&
        std::equal(a.begin(), a.end(), b.begin(), [](char x, char y) { return asciiLower(x) == asciiLower(y); }))
        return true;
    return !(isAscii(a) && isAscii(b)) && equalsIgnoringCase(a, b);
}

Message noVariableIn(std::string_view owner, std::string_view name, const std::vector<std::string>& candidates) {
    const std::optional<std::string> near = nearestName(name, candidates);
    return near ? errors::NoVariableInSuggest(owner, name, *near) : errors::NoVariableIn(owner, name);
}

/// Whether the names before the root's own name are its list, its namespace or both.
bool isQualifiedBy(const Root& root, std::string_view qualifier) {
    if (qualifier.empty()) return true;
    if (!root.list.empty() && same(root.list, qualifier)) return true;
    if (root.space.empty()) return false;
    return same(root.space, qualifier) || (!root.list.empty() && same(root.space + "." + root.list, qualifier));
}

struct FoundRoot {
    const Root* root = nullptr;
    size_t used = 0; // parts of the path that name it
};

/// The first names of the path as one text: "Ns.GVL" of the first two.
std::string joinedNames(const std::vector<PathPart>& parts, size_t count) {
    std::string text;
    for (size_t i = 0; i < count; ++i) text += (i ? "." : "") + std::string(parts[i].name);
    return text;
}

Result<FoundRoot> ambiguous(std::string_view name, const std::vector<const Root*>& roots) {
    std::vector<std::string> paths;
    for (const Root* root : roots) paths.push_back(Layout::pathOf(*root));
    return Error{errors::AmbiguousPath(name, std::move(paths)), {}};
}

Result<FoundRoot> findRoot(const Layout& layout, const std::vector<PathPart>& parts) {
    std::vector<const Root*> plain; // matched by the first name alone
    FoundRoot qualified;
    const Root* program = nullptr;
    const size_t names = static_cast<size_t>(
        std::find_if(parts.begin(), parts.end(), [](const PathPart& p) { return p.kind != PathPart::Kind::Name; }) -
        parts.begin());
    std::vector<std::string> qualifiers(1);
    for (size_t k = 1; k < std::min<size_t>(names, 6); ++k) qualifiers.push_back(joinedNames(parts, k));
    for (const Root& root : layout.roots) {
        for (size_t k = 0; k < qualifiers.size(); ++k) {
            if (!same(root.name, parts[k].name) || !isQualifiedBy(root, qualifiers[k])) continue;
            if (k == 0 && root.area == Area::Program && root.list.empty()) {
                program = &root;
                continue;
            }
            if (k == 0) plain.push_back(&root);
            if (k > 0 && k + 1 > qualified.used) qualified = {&root, k + 1};
        }
    }
    // a located variable or a constant of a program is a root of its own, in the list of the program's name
    if (qualified.root) return qualified;
    if (program) return FoundRoot{program, 1};
    if (plain.size() == 1) return FoundRoot{plain[0], 1};
    if (plain.size() > 1) { // a name of its own hides those of lists and libraries
        const auto own =
            std::find_if(plain.begin(), plain.end(), [](const Root* r) { return r->list.empty() && r->space.empty(); });
        if (own != plain.end()) return FoundRoot{*own, 1};
        return ambiguous(parts[0].name, plain);
    }
    std::vector<const Root*> instances;
    for (const Root& root : layout.roots)
        if (root.area == Area::Program && same(root.programType, parts[0].name)) instances.push_back(&root);
    if (instances.size() == 1) return FoundRoot{instances[0], 1};
    if (instances.size() > 1) return ambiguous(parts[0].name, instances);

    std::vector<std::string> candidates;
    bool isList = false;
    for (const Root& root : layout.roots) {
        if (root.isHidden) continue;
        isList = isList || same(root.list, parts[0].name);
        candidates.push_back(root.name);
        if (!root.list.empty()) candidates.push_back(root.list);
    }
    if (isList && parts.size() > 1) {
        candidates.clear();
        for (const Root& root : layout.roots)
            if (same(root.list, parts[0].name)) candidates.push_back(root.name);
        return Error{noVariableIn(parts[0].name, parts[1].name, candidates), {}};
    }
    const std::optional<std::string> near = nearestName(parts[0].name, candidates);
    return Error{near ? errors::NoVariableSuggest(parts[0].name, *near) : errors::NoVariable(parts[0].name), {}};
}

Result<Place> member(const Layout& layout, const Place& place, const PathPart& part) {
    const Type& type = (*layout.types)[place.type];
    if (type.kind != TypeKind::Struct && type.kind != TypeKind::Union && type.kind != TypeKind::Block) {
        if (type.kind == TypeKind::Pointer || type.kind == TypeKind::Reference || type.kind == TypeKind::Interface)
            return Error{errors::BehindReference(part.name), {}};
        return Error{errors::NoPartOfType(part.name, type.name), {}};
    }
    const Field* field = type.findField(part.name);
    if (!field) {
        std::vector<std::string> candidates;
        for (const Field& f : type.fields)
            if (!f.isPrivate) candidates.push_back(f.name);
        return Error{noVariableIn(type.name, part.name, candidates), {}};
    }
    if (field->section == types::FieldSection::External) return layout.find(field->name);
    if (field->section == types::FieldSection::InOut) return Error{errors::PathThroughInOut(part.name), {}};
    if (field->bit >= 0) return Place{types::TypeTable::of(TypeKind::Bool), place.offset + field->offset, field->bit};
    return Place{field->type, place.offset + field->offset, -1};
}

Result<Place> element(const Layout& layout, const Place& place, const PathPart& part) {
    const Type& type = (*layout.types)[place.type];
    if (type.kind == TypeKind::String || type.kind == TypeKind::Wstring) {
        if (part.indices.size() != 1) return Error{errors::TextHasOneIndex(), {}};
        if (part.indices[0] < 0 || part.indices[0] >= static_cast<int64_t>(type.capacity))
            return Error{errors::IndexOutOfRange(part.indices[0], 0, int64_t(type.capacity) - 1), {}};
        const bool wide = type.kind == TypeKind::Wstring;
        return Place{types::TypeTable::of(wide ? TypeKind::Wchar : TypeKind::Char),
                     place.offset + static_cast<uint32_t>(part.indices[0]) * (wide ? 2 : 1), -1};
    }
    if (type.kind != TypeKind::Array) return Error{errors::NoElements(type.name), {}};
    if (part.indices.size() != type.dimensions.size())
        return Error{errors::IndexCount(type.name, type.dimensions.size(), part.indices.size()), {}};
    uint64_t number = 0;
    for (size_t d = 0; d < part.indices.size(); ++d) {
        const types::Dimension& dimension = type.dimensions[d];
        if (part.indices[d] < dimension.low || part.indices[d] > dimension.high)
            return Error{errors::IndexOutOfRange(part.indices[d], dimension.low, dimension.high), {}};
        number = number * dimension.count() + static_cast<uint64_t>(part.indices[d] - dimension.low);
    }
    return Place{type.element, place.offset + static_cast<uint32_t>(number * (*layout.types)[type.element].size), -1};
}

/// Bit or part of an integer: x.5, x.%X5, x.%B1, x.%W0, x.%D1. Images are little endian.
Result<Place> slice(const Layout& layout, const Place& place, const PathPart& part) {
    const TypeKind kind = layout.types->storageKind(place.type);
    const types::Family family = layout.types->family(place.type);
    if (!types::isInteger(family) || place.bit >= 0) return Error{errors::NoBits((*layout.types)[place.type].name), {}};
    const unsigned width = part.sliceBits;
    const unsigned count = types::bitsOf(kind) / width;
    if (part.sliceIndex >= count)
        return Error{width == 1 ? errors::BitOutOfRange(part.sliceIndex, int64_t(count) - 1)
                                : errors::PartOutOfRange(part.sliceIndex, int64_t(count) - 1),
                     {}};
    if (width == 1)
        return Place{types::TypeTable::of(TypeKind::Bool), place.offset + part.sliceIndex / 8,
                     static_cast<int16_t>(part.sliceIndex % 8)};
    const TypeKind piece = width == 8    ? TypeKind::Byte
                           : width == 16 ? TypeKind::Word
                           : width == 32 ? TypeKind::Dword
                                         : TypeKind::Lword;
    return Place{types::TypeTable::of(piece), place.offset + part.sliceIndex * (width / 8), -1};
}

} // namespace

namespace {
const AreaRange& rangeOf(const Layout& layout, Area area) {
    return area == Area::Input ? layout.inputs : area == Area::Output ? layout.outputs : layout.memory;
}
} // namespace

std::string Layout::pathOf(const Root& root) {
    if (root.name.empty()) return root.address;
    std::string path = root.space.empty() ? std::string() : root.space + ".";
    if (!root.list.empty()) path += root.list + ".";
    return path + root.name;
}

Result<Place> Layout::find(std::string_view path) const {
    path = withoutBlanks(path);
    if (!path.empty() && path.front() == '%') return address(path);
    Result<std::vector<PathPart>> parts = readPath(path);
    if (!parts) return parts.error();
    const Result<FoundRoot> found = findRoot(*this, *parts);
    if (!found) return found.error();
    Place place{found->root->type, found->root->offset, found->root->bit};
    for (size_t i = found->used; i < parts->size(); ++i) {
        const PathPart& part = (*parts)[i];
        Result<Place> next = part.kind == PathPart::Kind::Name    ? member(*this, place, part)
                             : part.kind == PathPart::Kind::Index ? element(*this, place, part)
                                                                  : slice(*this, place, part);
        if (!next) return Error{next.error().message, std::string(path)};
        place = *next;
    }
    return place;
}

Result<Place> Layout::address(std::string_view text) const {
    const std::optional<DirectAddress> address = parseAddress(text, addressing);
    if (!address || address->isOpen) return Error{errors::NotAnAddress(text), {}};
    if (address->isHierarchical) {
        const std::string name = hierarchicalName(text);
        for (const HierarchicalAddress& each : hierarchical)
            if (each.name == name) return each.place;
        return Error{errors::AddressUnused(text), {}};
    }
    const AreaRange& range = rangeOf(*this, address->area);
    const uint64_t bytes = std::max(1u, types::bitsOf(address->kind) / 8);
    if (address->byte + bytes > flatSize(address->area)) return Error{errors::AddressUnused(text), {}};
    return Place{types::TypeTable::of(address->kind), range.begin + address->byte, address->bit};
}

uint32_t Layout::flatSize(Area area) const {
    const AreaRange& range = rangeOf(*this, area);
    uint32_t end = range.begin + range.size;
    for (const HierarchicalAddress& each : hierarchical)
        if (each.area == area) end = std::min(end, each.place.offset);
    return end - range.begin;
}

namespace {

std::string indexText(const Type& array, uint64_t number) {
    std::vector<int64_t> indices(array.dimensions.size());
    for (size_t d = array.dimensions.size(); d-- > 0;) {
        const uint64_t count = std::max<uint64_t>(1, array.dimensions[d].count());
        indices[d] = array.dimensions[d].low + static_cast<int64_t>(number % count);
        number /= count;
    }
    std::string text = "[";
    for (size_t d = 0; d < indices.size(); ++d) text += (d ? "," : "") + std::to_string(indices[d]);
    return text + "]";
}

struct Covered {
    std::string path;
    bool isWanted = false; // ends at a variable of the wanted type
};

bool fits(const types::TypeTable& types, TypeId type, TypeId wanted) {
    return type == wanted || types.isDerivedFrom(type, wanted) ||
           (types::isElementary(types.kind(wanted)) && types.storage(type) == types.storage(wanted));
}

/// Descends from a variable at `begin` to the one that covers `offset`.
Covered descend(const types::TypeTable& types, std::string path, TypeId id, uint32_t begin, uint32_t offset,
                TypeId wanted) {
    for (;;) {
        const Type& type = types[id];
        if (wanted.isValid() && offset == begin && fits(types, id, wanted)) return {path, true};
        if (type.kind == TypeKind::Array) {
            const uint32_t size = types[type.element].size;
            if (!size) return {path, false};
            const uint64_t number = (offset - begin) / size;
            path += indexText(type, number);
            begin += static_cast<uint32_t>(number) * size;
            id = type.element;
            continue;
        }
        const Field* inner = nullptr;
        for (const Field& field : type.fields) {
            if (field.section == types::FieldSection::External || field.bit >= 0) continue;
            const uint32_t size = field.section == types::FieldSection::InOut ? 8 : types[field.type].size;
            if (offset < begin + field.offset || offset >= begin + field.offset + size) continue;
            if (type.kind == TypeKind::Union &&
                wanted.isValid()) { // several members cover it: take one of the wanted type
                Covered member =
                    descend(types, path + "." + field.name, field.type, begin + field.offset, offset, wanted);
                if (member.isWanted) return member;
                if (inner) continue;
            }
            inner = &field;
            if (type.kind != TypeKind::Union) break;
        }
        if (!inner) return {path, false};
        path += "." + inner->name;
        if (inner->section == types::FieldSection::InOut) return {path, false};
        begin += inner->offset;
        id = inner->type;
    }
}

} // namespace

std::string Layout::pathAt(uint32_t offset, TypeId wanted) const {
    std::string path;
    for (const Root& root : roots) {
        const uint32_t size = (*types)[root.type].size;
        if (root.bit >= 0 || offset < root.offset || offset >= root.offset + size) continue;
        Covered covered = descend(*types, pathOf(root), root.type, root.offset, offset, wanted);
        if (covered.isWanted) return covered.path;
        if (path.empty()) path = std::move(covered.path);
    }
    if (!path.empty()) return path;
    for (const HierarchicalAddress& each : hierarchical)
        if (offset >= each.place.offset && offset < each.place.offset + each.size) return each.name;
    const std::pair<const AreaRange*, char> areas[] = {{&inputs, 'I'}, {&outputs, 'Q'}, {&memory, 'M'}};
    for (const auto& [range, letter] : areas)
        if (offset >= range->begin && offset < range->begin + range->size)
            return std::string("%") + letter + "B" + std::to_string(offset - range->begin);
    return path;
}

namespace {

bool visitLeaves(const types::TypeTable& types, std::string& path, Place place,
                 const std::function<bool(const std::string&, const Place&)>& visit) {
    const Type& type = types[place.type];
    const size_t length = path.size();
    switch (type.kind) {
    case TypeKind::Array: {
        const uint32_t size = types[type.element].size;
        const uint64_t count = size ? type.size / size : 0;
        for (uint64_t i = 0; i < count; ++i) {
            path += indexText(type, i);
            const bool goOn = visitLeaves(
                types, path, Place{type.element, place.offset + static_cast<uint32_t>(i * size), -1}, visit);
            path.resize(length);
            if (!goOn) return false;
        }
        return true;
    }
    case TypeKind::Struct:
    case TypeKind::Union:
    case TypeKind::Block:
        for (const Field& field : type.fields) {
            if (field.section == types::FieldSection::InOut || field.section == types::FieldSection::External) continue;
            path += '.';
            path += field.name;
            const Place inner{field.bit >= 0 ? types::TypeTable::of(TypeKind::Bool) : field.type,
                              place.offset + field.offset, field.bit};
            const bool goOn = visitLeaves(types, path, inner, visit);
            path.resize(length);
            if (!goOn) return false;
        }
        return true;
    case TypeKind::OpenArray:
    case TypeKind::Null:
    case TypeKind::Void:
    case TypeKind::Unknown:
        return true;
    default:
        return visit(path, place);
    }
}

} // namespace

void Layout::forEachLeaf(const std::string& path, Place place,
                         const std::function<bool(const std::string&, const Place&)>& visit) const {
    std::string text = path;
    (void)visitLeaves(*types, text, place, visit);
}

} // namespace plc::image
