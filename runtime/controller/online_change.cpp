#include "runtime/controller/online_change.h"

#include "runtime/base/text.h"

#include <algorithm>
#include <cstring>
#include <map>
#include <unordered_map>

namespace plc::controller {

using image::Area;
using image::Layout;
using image::Place;
using image::Root;
using types::Dimension;
using types::Field;
using types::FieldSection;
using types::Type;
using types::TypeId;
using types::TypeKind;

namespace {

bool isReferenceKind(TypeKind kind) {
    return kind == TypeKind::Pointer || kind == TypeKind::Reference || kind == TypeKind::Interface;
}

// Takes values from an image of one layout into that of another. By name from the roots down, never by offset: what has
// the same name and a type that still holds it keeps its value, and everything else is reported (kept, initialised,
// lost, nulled).
class Carrier {
public:
    Carrier(const Layout& from, std::span<const std::byte> old, const Layout& to, std::span<std::byte> fresh)
        : m_from(from), m_to(to), m_fromTypes(*from.types), m_toTypes(*to.types), m_old(old), m_fresh(fresh) {}

    OnlineChangeReport run() {
        copyArea(Area::Input, m_from.inputs.begin, m_to.inputs.begin);
        copyArea(Area::Output, m_from.outputs.begin, m_to.outputs.begin);
        copyArea(Area::Memory, m_from.memory.begin, m_to.memory.begin);
        copyHierarchical();
        // What is left in it at the end is gone in the new program.
        std::unordered_map<std::string, const Root*> oldRoots;
        for (const Root& root : m_from.roots) oldRoots.emplace(key(root), &root);
        for (const Root& root : m_to.roots) {
            const auto found = oldRoots.find(key(root));
            std::string path = Layout::pathOf(root);
            if (found == oldRoots.end()) {
                if (!root.isHidden) m_report.initialised.push_back(std::move(path));
                continue;
            }
            const Root* before = found->second;
            oldRoots.erase(found);
            // A constant has the value that the new text says.
            if (root.constant) continue;
            // Hidden roots (second names, the compiler's own) are carried, but nobody reads about them.
            m_isQuiet = root.isHidden;
            carryBitOr({before->type, before->offset, before->bit}, {root.type, root.offset, root.bit}, path);
        }
        m_isQuiet = false;
        for (const Root& root : m_from.roots)
            if (!root.isHidden && !root.constant && oldRoots.count(key(root)))
                m_report.lost.push_back(Layout::pathOf(root));
        return std::move(m_report);
    }

private:
    // Located variables without a name go by their address.
    static std::string key(const Root& root) {
        return foldCase(root.space + "/" + root.list + "/" + (root.name.empty() ? root.address : root.name));
    }

    void copyArea(Area area, uint32_t from, uint32_t to) {
        std::memcpy(m_fresh.data() + to, m_old.data() + from, std::min(m_from.flatSize(area), m_to.flatSize(area)));
    }
    /// A place of its own may be elsewhere in the new image.
    void copyHierarchical() {
        for (const image::HierarchicalAddress& to : m_to.hierarchical)
            for (const image::HierarchicalAddress& from : m_from.hierarchical)
                if (from.name == to.name)
                    std::memcpy(m_fresh.data() + to.place.offset, m_old.data() + from.place.offset,
                                std::min(from.size, to.size));
    }

    // ------------------------------------------------------------ reports

    void kept(const std::string& path) {
        if (!m_isQuiet) m_report.kept.push_back(path);
    }
    void initialised(const std::string& path) {
        m_isWhole = false;
        if (!m_isQuiet) m_report.initialised.push_back(path);
    }
    void lost(const std::string& path) {
        m_isWhole = false;
        if (!m_isQuiet) m_report.lost.push_back(path);
    }
    void retyped(const std::string& path) {
        lost(path);
        initialised(path);
    }
    void nulled(const std::string& path) {
        m_isWhole = false;
        m_report.nulled.push_back(path);
    }

    // ------------------------------------------------------------ types

    /// Bytes of the one are bytes of the other: same structure, no references, same block numbers.
    bool areIdentical(TypeId oldId, TypeId newId) {
        // False while it is compared: types that refer to themselves do so by references, which are not identical
        // anyway.
        const auto [entry, isNew] = m_identical.try_emplace({oldId.value, newId.value}, false);
        if (!isNew) return entry->second;
        const bool result = compare(oldId, newId);
        return m_identical[{oldId.value, newId.value}] = result;
    }
    bool compare(TypeId oldId, TypeId newId) {
        const Type& a = m_fromTypes[oldId];
        const Type& b = m_toTypes[newId];
        // References are offsets into the old image and have to be looked at one by one.
        if (a.kind != b.kind || a.size != b.size || isReferenceKind(a.kind) || a.kind == TypeKind::OpenArray)
            return false;
        switch (a.kind) {
        case TypeKind::String:
        case TypeKind::Wstring:
            return a.capacity == b.capacity;
        case TypeKind::Enum:
            return a.name == b.name && m_fromTypes.storageKind(oldId) == m_toTypes.storageKind(newId) &&
                   std::equal(a.enumerators.begin(), a.enumerators.end(), b.enumerators.begin(), b.enumerators.end(),
                              [](const types::Enumerator& x, const types::Enumerator& y) {
                                  return x.value == y.value && equalsIgnoringCase(x.name, y.name);
                              });
        case TypeKind::Subrange:
            return a.low == b.low && a.high == b.high && areIdentical(a.element, b.element);
        case TypeKind::Array:
            return std::equal(
                       a.dimensions.begin(), a.dimensions.end(), b.dimensions.begin(), b.dimensions.end(),
                       [](const Dimension& x, const Dimension& y) { return x.low == y.low && x.high == y.high; }) &&
                   areIdentical(a.element, b.element);
        case TypeKind::Struct:
        case TypeKind::Union:
        case TypeKind::Block:
            // Block numbers are in the instances: other numbers, other bytes.
            if (a.kind == TypeKind::Block && (a.blockNumber != b.blockNumber || !isSameBlock(a, b))) return false;
            return std::equal(a.fields.begin(), a.fields.end(), b.fields.begin(), b.fields.end(),
                              [&](const Field& x, const Field& y) {
                                  return x.offset == y.offset && x.bit == y.bit && x.section == y.section &&
                                         // In-outs are references as well.
                                         !y.constant && y.section != FieldSection::InOut &&
                                         equalsIgnoringCase(x.name, y.name) &&
                                         (y.section == FieldSection::External || areIdentical(x.type, y.type));
                              });
        default:
            return true; // elementary
        }
    }
    static bool isSameBlock(const Type& a, const Type& b) {
        return equalsIgnoringCase(a.name, b.name) && equalsIgnoringCase(a.space, b.space);
    }

    // ------------------------------------------------------------ values

    template <class T> T oldWord(uint32_t offset) const {
        T value{};
        std::memcpy(&value, m_old.data() + offset, sizeof value);
        return value;
    }
    void copy(uint32_t from, uint32_t to, uint32_t size) {
        std::memcpy(m_fresh.data() + to, m_old.data() + from, size);
    }

    void carryBitOr(const Place& from, const Place& to, std::string& path) {
        if (from.bit < 0 && to.bit < 0) return carry(from.type, from.offset, to.type, to.offset, path);
        if (m_fromTypes.storageKind(from.type) != TypeKind::Bool || m_toTypes.storageKind(to.type) != TypeKind::Bool)
            return retyped(path);
        // BOOL as a bit and BOOL as a byte are the same variable to the user.
        const auto byte = static_cast<uint8_t>(m_old[from.offset]);
        const bool value = from.bit < 0 ? byte != 0 : (byte >> from.bit & 1) != 0;
        std::byte& target = m_fresh[to.offset];
        if (to.bit < 0)
            target = std::byte(value);
        else
            target = (target & ~std::byte(1u << to.bit)) | std::byte(unsigned(value) << to.bit);
        kept(path);
    }

    void carry(TypeId oldId, uint32_t from, TypeId newId, uint32_t to, std::string& path) {
        const Type& a = m_fromTypes[oldId];
        const Type& b = m_toTypes[newId];
        if (areIdentical(oldId, newId)) {
            // Most of every image goes this way, in one piece.
            copy(from, to, b.size);
            return kept(path);
        }
        if (a.kind != b.kind) return retyped(path);
        switch (b.kind) {
        case TypeKind::Enum:
            return carryEnum(a, b, oldId, newId, from, to, path);
        case TypeKind::Subrange:
            return carrySubrange(b, oldId, newId, from, to, path);
        case TypeKind::String:
            return carryText<char>(b, from, to, path, a.capacity);
        case TypeKind::Wstring:
            return carryText<char16_t>(b, from, to, path, a.capacity);
        case TypeKind::Array:
            return summedUp(path, [&] { carryArray(a, b, from, to, path); });
        case TypeKind::Struct:
            return summedUp(path, [&] { carryFields(a, b, from, to, path); });
        case TypeKind::Block:
            if (!isSameBlock(a, b)) return retyped(path); // another block's state means nothing
            return summedUp(path, [&] { carryFields(a, b, from, to, path); });
        case TypeKind::Pointer:
        case TypeKind::Reference:
        case TypeKind::Interface:
            return carryReference(b.kind == TypeKind::Interface ? oldId : a.element,
                                  b.kind == TypeKind::Interface ? newId : b.element, from, to, path);
        default:
            return retyped(path); // a union of another shape
        }
    }

    /// When all of a variable was kept, it is reported as one.
    template <class Work> void summedUp(const std::string& path, Work work) {
        const size_t before = m_report.kept.size();
        // Nested: an inner part that lost something makes all around it less than whole.
        const bool wasWhole = m_isWhole;
        m_isWhole = true;
        work();
        if (m_isWhole) {
            m_report.kept.resize(before);
            kept(path);
        }
        m_isWhole = m_isWhole && wasWhole;
    }

    void carryFields(const Type& a, const Type& b, uint32_t from, uint32_t to, std::string& path) {
        const size_t length = path.size();
        const bool wasQuiet = m_isQuiet;
        for (const Field& field : b.fields) {
            // VAR_EXTERNAL is stored elsewhere.
            if (field.section == FieldSection::External || field.constant) continue;
            // One string grows and shrinks: paths of large arrays would otherwise be most of the work.
            path += "." + field.name;
            m_isQuiet = wasQuiet || field.isPrivate;
            const auto old = std::find_if(a.fields.begin(), a.fields.end(),
                                          [&](const Field& f) { return equalsIgnoringCase(f.name, field.name); });
            if (old == a.fields.end() || old->section == FieldSection::External ||
                (old->section == FieldSection::InOut) != (field.section == FieldSection::InOut)) {
                if (field.section != FieldSection::InOut) initialised(path);
            } else if (field.section == FieldSection::InOut) {
                carrySlot(*old, field, from + old->offset, to + field.offset, path);
            } else {
                carryBitOr({old->type, from + old->offset, old->bit}, {field.type, to + field.offset, field.bit}, path);
            }
            path.resize(length);
        }
        for (const Field& field : a.fields) {
            if (field.section == FieldSection::External || field.section == FieldSection::InOut || field.constant)
                continue;
            m_isQuiet = wasQuiet || field.isPrivate;
            const bool stays = std::any_of(b.fields.begin(), b.fields.end(),
                                           [&](const Field& f) { return equalsIgnoringCase(f.name, field.name); });
            if (!stays) lost(path + "." + field.name);
        }
        m_isQuiet = wasQuiet;
    }

    static std::string rangeText(int64_t low, int64_t high) {
        return "[" + std::to_string(low) + (low == high ? "" : ".." + std::to_string(high)) + "]";
    }

    void carryArray(const Type& a, const Type& b, uint32_t from, uint32_t to, std::string& path) {
        if (a.dimensions.size() != b.dimensions.size()) return retyped(path);
        const uint32_t oldSize = m_fromTypes[a.element].size;
        const uint32_t newSize = m_toTypes[b.element].size;
        std::vector<Dimension> common;
        bool isEmpty = false;
        for (size_t d = 0; d < b.dimensions.size(); ++d) {
            common.push_back({std::max(a.dimensions[d].low, b.dimensions[d].low),
                              std::min(a.dimensions[d].high, b.dimensions[d].high)});
            isEmpty = isEmpty || common.back().count() == 0;
        }
        if (isEmpty) return retyped(path);
        const auto number = [](const Type& array, const std::vector<int64_t>& index) {
            uint64_t n = 0;
            for (size_t d = 0; d < index.size(); ++d)
                n = n * array.dimensions[d].count() + static_cast<uint64_t>(index[d] - array.dimensions[d].low);
            return static_cast<uint32_t>(n);
        };
        const bool areSame = areIdentical(a.element, b.element);
        const size_t length = path.size();
        const size_t last = common.size() - 1;
        std::vector<int64_t> index;
        for (const Dimension& d : common) index.push_back(d.low);
        // Only what both have; what is new in the larger one keeps its initial value.
        for (;;) { // one row of the last dimension at a time
            const uint32_t oldAt = from + number(a, index) * oldSize;
            const uint32_t newAt = to + number(b, index) * newSize;
            const auto count = static_cast<uint32_t>(common[last].count());
            if (areSame) {
                copy(oldAt, newAt, count * newSize);
            } else {
                for (uint32_t i = 0; i < count; ++i) {
                    index[last] = common[last].low + i;
                    path += "[";
                    for (size_t d = 0; d <= last; ++d) path += (d ? "," : "") + std::to_string(index[d]);
                    path += "]";
                    carry(a.element, oldAt + i * oldSize, b.element, newAt + i * newSize, path);
                    path.resize(length);
                }
                index[last] = common[last].low;
            }
            size_t d = last;
            while (d-- > 0) {
                if (++index[d] <= common[d].high) break;
                index[d] = common[d].low;
            }
            if (d == size_t(-1)) break;
        }
        reportRanges(a, b, common, areSame, path);
    }

    void reportRanges(const Type& a, const Type& b, const std::vector<Dimension>& common, bool areSame,
                      const std::string& path) {
        if (common.size() > 1) {
            for (size_t d = 0; d < common.size(); ++d) {
                if (b.dimensions[d].count() > common[d].count()) return initialised(path);
                if (a.dimensions[d].count() > common[d].count()) return lost(path);
            }
            return;
        }
        const Dimension& before = a.dimensions[0];
        const Dimension& after = b.dimensions[0];
        const Dimension& stays = common[0];
        const bool isResized = before.low != after.low || before.high != after.high;
        if (areSame && isResized) kept(path + rangeText(stays.low, stays.high));
        if (after.low < stays.low) initialised(path + rangeText(after.low, stays.low - 1));
        if (after.high > stays.high) initialised(path + rangeText(stays.high + 1, after.high));
        if (before.low < stays.low) lost(path + rangeText(before.low, stays.low - 1));
        if (before.high > stays.high) lost(path + rangeText(stays.high + 1, before.high));
    }

    void carryEnum(const Type& a, const Type& b, TypeId oldId, TypeId newId, uint32_t from, uint32_t to,
                   const std::string& path) {
        if (!equalsIgnoringCase(a.name, b.name)) return retyped(path);
        const int64_t value = types::readValue(m_fromTypes, m_fromTypes.storage(oldId), m_old.subspan(from)).integer();
        const auto old = std::find_if(a.enumerators.begin(), a.enumerators.end(),
                                      [&](const types::Enumerator& e) { return e.value == value; });
        if (old == a.enumerators.end()) return retyped(path);
        const auto now = std::find_if(b.enumerators.begin(), b.enumerators.end(), [&](const types::Enumerator& e) {
            return equalsIgnoringCase(e.name, old->name);
        });
        if (now == b.enumerators.end()) return retyped(path);
        const TypeId storage = m_toTypes.storage(newId);
        types::writeValue(m_toTypes, storage, types::Value{storage, now->value}, m_fresh.subspan(to));
        kept(path);
    }

    void carrySubrange(const Type& b, TypeId oldId, TypeId newId, uint32_t from, uint32_t to, const std::string& path) {
        const TypeId storage = m_toTypes.storage(newId);
        if (m_fromTypes.storageKind(oldId) != m_toTypes.kind(storage)) return retyped(path);
        const int64_t value = types::readValue(m_fromTypes, m_fromTypes.storage(oldId), m_old.subspan(from)).integer();
        if (value < b.low || value > b.high) return retyped(path);
        copy(from, to, b.size);
        kept(path);
    }

    template <class Character>
    void carryText(const Type& b, uint32_t from, uint32_t to, const std::string& path, uint32_t oldCapacity) {
        uint32_t length = 0;
        while (length < oldCapacity && oldWord<Character>(from + length * uint32_t(sizeof(Character))) != 0) ++length;
        if (length > b.capacity) return retyped(path);
        std::memset(m_fresh.data() + to, 0, b.size);
        copy(from, to, length * uint32_t(sizeof(Character)));
        kept(path);
    }

    // ------------------------------------------------------------ references

    /// Where what lay at `target` lies now; 0 when it is gone or no longer of the type.
    uint64_t translated(uint64_t target, TypeId oldWanted, TypeId newWanted) const {
        if (target == 0 || target < sizeof(image::ImageHeader) || target >= m_from.dataEnd) return 0;
        const auto offset = static_cast<uint32_t>(target);
        const std::string path = m_from.pathAt(offset, oldWanted);
        const Result<Place> before = m_from.find(path);
        const Result<Place> after = m_to.find(path);
        if (path.empty() || !before || !after || before->bit >= 0 || after->bit >= 0 || offset < before->offset)
            return 0;
        const uint32_t within = offset - before->offset;
        const Type& a = m_fromTypes[before->type];
        const Type& b = m_toTypes[after->type];
        const bool isSameType = a.kind == b.kind && equalsIgnoringCase(a.name, b.name);
        const bool isWanted =
            within == 0 && (after->type == newWanted || m_toTypes.isDerivedFrom(after->type, newWanted));
        if (!(isSameType || isWanted) || within >= b.size) return 0;
        return after->offset + within;
    }

    void carryReference(TypeId oldTarget, TypeId newTarget, uint32_t from, uint32_t to, const std::string& path) {
        if (!equalsIgnoringCase(m_fromTypes[oldTarget].name, m_toTypes[newTarget].name)) return retyped(path);
        const auto target = oldWord<uint64_t>(from);
        const uint64_t now = translated(target, oldTarget, newTarget);
        std::memcpy(m_fresh.data() + to, &now, sizeof now);
        if (target != 0 && now == 0)
            nulled(path);
        else
            kept(path);
    }

    /// The slot of a VAR_IN_OUT: an offset, for ARRAY[*] followed by the bounds.
    void carrySlot(const Field& a, const Field& b, uint32_t from, uint32_t to, const std::string& path) {
        const bool isOpen = m_toTypes.kind(b.type) == TypeKind::OpenArray;
        const auto target = oldWord<uint64_t>(from);
        uint64_t now = 0;
        if (!isOpen && m_fromTypes.kind(a.type) != TypeKind::OpenArray &&
            equalsIgnoringCase(m_fromTypes[a.type].name, m_toTypes[b.type].name))
            now = translated(target, a.type, b.type);
        // ARRAY[*] is bound again by the next call; until then it is not connected, since its bounds may have changed.
        std::memset(m_fresh.data() + to, 0, isOpen ? m_toTypes[b.type].size : 8);
        std::memcpy(m_fresh.data() + to, &now, sizeof now);
        if (target != 0 && now == 0 && !isOpen) nulled(path);
    }

    const Layout& m_from;
    const Layout& m_to;
    const types::TypeTable& m_fromTypes;
    const types::TypeTable& m_toTypes;
    std::span<const std::byte> m_old;
    std::span<std::byte> m_fresh;
    OnlineChangeReport m_report;
    std::map<std::pair<uint32_t, uint32_t>, bool> m_identical;
    bool m_isQuiet = false; // hidden variables are carried over without a word
    bool m_isWhole = true;  // all of the variable at work was kept
};

} // namespace

OnlineChangeReport carryOver(const Layout& from, std::span<const std::byte> old, const Layout& to,
                             std::span<std::byte> fresh) {
    return Carrier(from, old, to, fresh).run();
}

} // namespace plc::controller
