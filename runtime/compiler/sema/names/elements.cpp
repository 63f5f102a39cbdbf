// Parts of variables: elements of arrays and texts, what pointers point to, bits and bytes, direct addresses.
#include "runtime/compiler/sema/names/elements.h"

#include "runtime/compiler/sema/calls/calls.h"
#include "runtime/compiler/sema/context.h"
#include "runtime/compiler/sema/layout/addresses.h"
#include "runtime/compiler/sema/layout/layout.h"
#include "runtime/compiler/sema/names/lookup.h"
#include "runtime/compiler/sema/names/names.h"
#include "runtime/compiler/sema/names/places.h"
#include "runtime/compiler/sema/operators/operators.h"
#include "runtime/compiler/sema/types/conversions.h"
#include "runtime/compiler/sema/values/expressions.h"

#include <cstdlib>

namespace plc::sema {

using syntax::ExprKind;

using DK = Denoted::Kind;

// One type for all, so that code has one way to check bounds and no bound of a type is in the way: a[b] with b : USINT
// and ARRAY[0..1000].
/// The indices as LINT, one for each argument; unknown where they are no integers or missing, which the parser
/// reported.
static std::vector<Operand> indicesOf(Context& context, const syntax::Expr& e) {
    std::vector<Operand> indices;
    for (const syntax::Argument& argument : e.arguments) {
        Operand index = argument.value ? expression(context, *argument.value) : unknown(context, argument.range);
        if (!index.isUnknown()) {
            const types::Family family = context.types.family(index.type());
            if (!types::isInteger(family)) {
                context.emit(argument.value->range, findings::IndexNotInteger(context.nameOf(index.type())));
                index = unknown(context, argument.value->range);
            } else if (context.types.storageKind(index.type()) != TypeKind::Lint) {
                index = convertNode(context, index, context.elementary(TypeKind::Lint));
            }
        }
        indices.push_back(index);
    }
    return indices;
}

/// Makes a place of what is indexed: a value is kept in a temporary. False: it has no elements, or was reported.
// Elements of what a function or a property gives can be read, not written: the value is gone afterwards.
static bool becomePlace(Context& context, Denoted& from, const syntax::Expr& e) {
    if (from.kind == DK::Property) {
        const Operand value = propertyValue(context, from, e.base->range);
        if (value.isUnknown()) return false;
        from = valueOf(value);
    }
    if (from.kind == DK::Value) {
        from.kind = DK::Place;
        from.place = temporary(context, from.value);
        from.isReadOnly = true;
        from.whyReadOnly = context.textOf(e.range);
    }
    if (from.kind == DK::Nothing) return false;
    if (from.kind == DK::Place) return true;
    context.emit(e.base->range, findings::NotAnArray(context.textOf(e.base->range)));
    return false;
}

static bool areKnown(const std::vector<Operand>& indices) {
    return std::none_of(indices.begin(), indices.end(), [](const Operand& o) { return o.isUnknown(); });
}

/// Where the element lies when all indices are constant. `isGood` false: one is out of range, and reported.
// A constant index that is out of range is an error here; the same index in a variable is a fault when it runs.
static std::optional<uint64_t> constantElement(Context& context, const types::Type& type, const syntax::Expr& e,
                                               const std::vector<Operand>& indices, bool& isGood) {
    bool allConstant = type.kind == TypeKind::Array;
    uint64_t number = 0;
    for (size_t i = 0; i < indices.size(); ++i) {
        if (!indices[i].isConstant()) {
            allConstant = false;
            continue;
        }
        if (type.kind != TypeKind::Array) continue;
        const int64_t index = indices[i].expr->value.integer();
        const types::Dimension& dimension = type.dimensions[i];
        if (index < dimension.low || index > dimension.high) {
            context.emit(e.arguments[i].value->range,
                         findings::ConstantIndexOutOfRange(index, dimension.low, dimension.high));
            isGood = false;
            return std::nullopt;
        }
        // Row-major, as arrays are laid out: the last index is the neighbour.
        number = number * dimension.count() + static_cast<uint64_t>(index - dimension.low);
    }
    return allConstant ? std::optional(number) : std::nullopt;
}

static Denoted elementOfArray(Context& context, Denoted out, const syntax::Expr& e,
                              const std::vector<Operand>& indices) {
    tree::Place* base = out.place;
    const types::Type& type = context.types[base->type];
    if (indices.size() != type.dimensions.size()) {
        context.emit(e.range, findings::WrongIndexCount(type.dimensions.size(), indices.size()));
        return {};
    }
    if (!areKnown(indices)) return {};
    bool isGood = true;
    const std::optional<uint64_t> number = constantElement(context, type, e, indices, isGood);
    if (!isGood) return {};
    const bool isStatic = base->kind == tree::PlaceKind::Absolute || base->kind == tree::PlaceKind::Instance ||
                          base->kind == tree::PlaceKind::Field;
    tree::Place* place = nullptr;
    // a[3] with a known place is a field like any other: no bounds to check, an offset that a watch can show.
    if (number && isStatic) {
        place = fieldPlace(context, base, static_cast<uint32_t>(*number * context.types[type.element].size),
                           type.element, -1, e.range);
    } else {
        place = context.arena.make<tree::Place>();
        place->kind = tree::PlaceKind::Index;
        place->type = type.element;
        place->range = e.range;
        place->base = base;
        for (const Operand& index : indices) place->indices.push_back(index.expr);
    }
    // ARRAY OF REFERENCE TO T: naming the element means what it refers to.
    out.place = context.isKind(place->type, TypeKind::Reference) ? dereferenced(context, place, e.range) : place;
    return out;
}

static Denoted characterOfText(Context& context, Denoted out, const syntax::Expr& e,
                               const std::vector<Operand>& indices) {
    tree::Place* base = out.place;
    const types::Type& type = context.types[base->type];
    if (indices.size() != 1) {
        context.emit(e.range, findings::WrongIndexCount(1, indices.size()));
        return {};
    }
    if (!areKnown(indices)) return {};
    // Characters count from 0 (edition 3, 6.4.4.10 leaves it open; CODESYS and this compiler count so), positions of
    // LEFT and MID from 1.
    if (indices[0].isConstant()) {
        const int64_t index = indices[0].expr->value.integer();
        if (index < 0 || index >= static_cast<int64_t>(type.capacity)) {
            context.emit(e.arguments[0].value->range,
                         findings::ConstantIndexOutOfRange(index, 0, int64_t(type.capacity) - 1));
            return {};
        }
    }
    tree::Place* place = context.arena.make<tree::Place>();
    place->kind = tree::PlaceKind::TextIndex;
    place->type = context.elementary(type.kind == TypeKind::String ? TypeKind::Char : TypeKind::Wchar);
    place->range = e.range;
    place->base = base;
    place->indices.push_back(indices[0].expr);
    out.place = place;
    return out;
}

/// p[i], as in CODESYS: the i-th variable from where it points to.
static Denoted elementBehind(Context& context, Denoted out, const syntax::Expr& e,
                             const std::vector<Operand>& indices) {
    tree::Place* base = out.place;
    const types::Type& type = context.types[base->type];
    if (indices.size() != 1 || !areKnown(indices)) {
        if (areKnown(indices)) context.emit(e.range, findings::WrongIndexCount(1, indices.size()));
        return {};
    }
    // By arithmetic on addresses: there is no array to take bounds from. The controller checks the address that
    // results.
    const Operand address = sameBits(context, load(context, base, e.base->range), context.elementary(TypeKind::Lword));
    const Operand size =
        constant(context, {context.elementary(TypeKind::Lword), int64_t(context.types[type.element].size)}, e.range);
    const Operand step =
        makeBinary(context, library::BinaryOp::Multiply, context.elementary(TypeKind::Lword),
                   convertNode(context, indices[0], context.elementary(TypeKind::Lword)), size, e.range);
    const Operand sum =
        makeBinary(context, library::BinaryOp::Add, context.elementary(TypeKind::Lword), address, step, e.range);
    tree::Place* place = context.arena.make<tree::Place>();
    place->kind = tree::PlaceKind::Deref;
    place->type = type.element;
    place->range = e.range;
    place->pointer = sameBits(context, sum, base->type).expr;
    out.place = place;
    out.isReadOnly = false;
    return out;
}

/// An element of an array, a character of a text, what lies behind a pointer.
///   ok:    a[i, 2]; s[1]; p[3]      wrong: x[1]  with x : INT (P2014)   a[1]  of two dimensions (P2015)
///          a[3]  of ARRAY[1..2] (P2016)
Denoted denoteIndex(Context& context, const syntax::Expr& e, Access access) {
    Denoted from = denote(context, *e.base,
                          access == Access::Address ? Access::ReadWrite
                          : access == Access::Call  ? Access::ReadWrite
                                                    : access);
    const std::vector<Operand> indices = indicesOf(context, e);
    if (!becomePlace(context, from, e)) return {};
    const bool isComplete =
        !indices.empty() && std::ranges::all_of(e.arguments, [](const auto& argument) { return argument.value; });
    if (!isComplete) return {}; // reported by the parser
    Denoted out = from;
    // An element has exactly the declared type, unlike what a pointer to it might be.
    out.isExact = true;
    out.isSuper = false;
    switch (context.types.kind(from.place->type)) {
    case TypeKind::Unknown:
        return {};
    case TypeKind::Array:
    case TypeKind::OpenArray:
        return elementOfArray(context, out, e, indices);
    case TypeKind::String:
    case TypeKind::Wstring:
        return characterOfText(context, out, e, indices);
    case TypeKind::Pointer:
        return elementBehind(context, out, e, indices);
    default:
        context.emit(e.base->range, findings::NotAnArray(context.textOf(e.base->range)));
        return {};
    }
}

///   ok:    p^ := 5;  with p : REF_TO INT      wrong: x^ := 5;  with x : INT (P2020)
Denoted denoteDeref(Context& context, const syntax::Expr& e, Access access) {
    // THIS^ and SUPER^: the mark is required by CODESYS, and THIS is already the instance.
    if (e.base->kind == ExprKind::This || e.base->kind == ExprKind::Super) {
        Denoted out = denote(context, *e.base, access);
        if (out.place) out.place->range = e.range;
        return out;
    }
    Denoted from = denote(context, *e.base, Access::Read);
    Operand pointer;
    if (from.kind == DK::Nothing) return {};
    pointer = value(context, from, *e.base, {});
    if (pointer.isUnknown()) return {};
    const TypeKind kind = context.types.kind(pointer.type());
    if (kind != TypeKind::Pointer && kind != TypeKind::Reference) {
        // ref^ where ref is REFERENCE TO: the mark is accepted and means the same
        if (from.kind == DK::Place && from.place->kind == tree::PlaceKind::Deref && from.place->pointer &&
            context.isKind(from.place->pointer->type, TypeKind::Reference))
            return from;
        context.emit(e.base->range, findings::NotAPointer(context.textOf(e.base->range)));
        return {};
    }
    tree::Place* place = context.arena.make<tree::Place>();
    place->kind = tree::PlaceKind::Deref;
    place->type = context.types[pointer.type()].element;
    place->range = e.range;
    place->pointer = pointer.expr;
    Denoted out =
        placeOf(context.isKind(place->type, TypeKind::Reference) ? dereferenced(context, place, e.range) : place);
    return out;
}

///   ok:    b.7  with b : BYTE      wrong: b.8  (P2021)
Denoted denoteBit(Context& context, const syntax::Expr& e, Access access) {
    // Writing a bit keeps the others, so the variable is read as well.
    const Access baseAccess = access == Access::Write || access == Access::Address ? Access::ReadWrite : access;
    Denoted from = denote(context, *e.base, baseAccess);
    if (from.kind == DK::Property) {
        const Operand value = propertyValue(context, from, e.base->range);
        if (value.isUnknown()) return {};
        from = valueOf(value);
    }
    if (from.kind == DK::Nothing) return {};
    if (from.kind == DK::Value) {
        from.place = temporary(context, settled(context, from.value));
        from.kind = DK::Place;
        from.isReadOnly = true;
        from.whyReadOnly = context.textOf(e.range);
    }
    if (from.kind != DK::Place) {
        context.emit(e.base->range, findings::NoValue(context.textOf(e.base->range)));
        return {};
    }
    tree::Place* base = from.place;
    const types::Family family = context.types.family(base->type);
    if (context.isKind(base->type, TypeKind::Unknown)) return {};
    // A bit of a bit: %X0.1 of an address is a BOOL already.
    if (!types::isInteger(family) || base->bit >= 0) {
        context.emit(e.range, findings::UnknownMember(context.nameOf(base->type), e.text));
        return {};
    }
    // b.7, b.%X7, w.%B1 (edition 3, 6.5.1.3): a bit, or a part of that size counted from the lowest.
    std::string_view text = e.text;
    unsigned width = 1;
    if (!text.empty() && text.front() == '%') text.remove_prefix(1);
    if (!text.empty() && (text.front() < '0' || text.front() > '9')) {
        switch (text.front() | 0x20) {
        case 'x':
            width = 1;
            break;
        case 'b':
            width = 8;
            break;
        case 'w':
            width = 16;
            break;
        case 'd':
            width = 32;
            break;
        case 'l':
            width = 64;
            break;
        default:
            context.emit(e.range, findings::UnknownMember(context.nameOf(base->type), e.text));
            return {};
        }
        text.remove_prefix(1);
    }
    const int64_t number = std::atoll(std::string(text).c_str());
    const unsigned count = types::bitsOf(context.types.storageKind(base->type)) / width;
    if (text.empty() || number < 0 || number >= static_cast<int64_t>(count)) {
        const SourceRange at{e.range.file, e.range.end - static_cast<uint32_t>(e.text.size()), e.range.end};
        context.emit(at, findings::NoSuchBit(context.nameOf(base->type), int64_t(count) - 1));
        return {};
    }
    Denoted out = from;
    if (width == 1) {
        tree::Place* place = context.arena.make<tree::Place>();
        place->kind = tree::PlaceKind::Bit;
        place->type = context.elementary(TypeKind::Bool);
        place->range = e.range;
        place->base = base;
        place->bit = static_cast<int16_t>(number);
        out.place = place;
        return out;
    }
    const TypeKind piece = width == 8    ? TypeKind::Byte
                           : width == 16 ? TypeKind::Word
                           : width == 32 ? TypeKind::Dword
                                         : TypeKind::Lword;
    // A part is a field at an offset, so the variable must be in memory. Bytes are in the order of the machine, little
    // endian: %B0 is the lowest.
    takeAddress(context, base);
    out.place =
        fieldPlace(context, base, static_cast<uint32_t>(number) * (width / 8), context.elementary(piece), -1, e.range);
    return out;
}

namespace {

/// 3 of X3, as PC WORX and MULTIPROG write %X3.
std::optional<int64_t> bitOfLetter(std::string_view name) {
    if (name.size() < 2 || name.size() > 3 || (name[0] != 'X' && name[0] != 'x')) return std::nullopt;
    int64_t bit = 0;
    for (const char c : name.substr(1)) {
        if (c < '0' || c > '9') return std::nullopt;
        bit = bit * 10 + (c - '0');
    }
    return bit;
}

} // namespace

// status.cReady with a constant cReady : INT := 3, as CODESYS allows, and status.X3.
std::optional<Denoted> namedBit(Context& context, const Denoted& from, tree::Place* base, const syntax::Name& name,
                                SourceRange range) {
    if (!types::isInteger(context.types.family(base->type)) || base->bit >= 0) return std::nullopt;
    const Found constant = lookup(context.world, context.scope, context.key(name.text));
    const bool isConstant = (constant.member.variable && constant.member.variable->isConstant) ||
                            (constant.entity.variable && constant.entity.variable->isConstant);
    std::optional<int64_t> written = bitOfLetter(name.text);
    if (isConstant) {
        const Denoted number = found(context, constant, name, Access::Read, {});
        if (number.kind == DK::Value && number.value.isConstant() &&
            std::holds_alternative<int64_t>(number.value.expr->value.data))
            written = number.value.expr->value.integer();
    }
    if (!written) return std::nullopt;
    const int64_t bit = *written;
    const int64_t last = int64_t(types::bitsOf(context.types.storageKind(base->type))) - 1;
    if (bit < 0 || bit > last) {
        context.emit(name.range, findings::NoSuchBit(context.nameOf(base->type), last));
        return Denoted{};
    }
    tree::Place* place = context.arena.make<tree::Place>();
    place->kind = tree::PlaceKind::Bit;
    place->type = context.elementary(TypeKind::Bool);
    place->range = range;
    place->base = base;
    place->bit = static_cast<int16_t>(bit);
    Denoted out = from;
    out.kind = DK::Place;
    out.place = place;
    return out;
}

///   ok:    %IX0.7      wrong: %IX99999999.0  (P2034)
// A direct address in a body (%IX0.0) is a place like any other; its letter is its type.
Denoted denoteAddress(Context& context, const syntax::Expr& e) {
    const auto address = addressIn(context.world, e.text);
    if (!address || address->isOpen) {
        context.emit(e.range, findings::AddressOutOfRange(e.text, addressAreas()));
        return {};
    }
    const image::AreaRange area = areaOf(context.world, address->area);
    // Areas are measured from all addresses of the program; only an expression of a watch can name one outside.
    if (address->byte + std::max(1u, types::bitsOf(address->kind) / 8) > area.size) {
        context.emit(e.range, findings::AddressOutOfRange(e.text, {{address->area == image::Area::Input    ? "%I"
                                                                    : address->area == image::Area::Output ? "%Q"
                                                                                                           : "%M"}}));
        return {};
    }
    return placeOf(
        absolutePlace(context, area.begin + address->byte, context.elementary(address->kind), address->bit, e.range));
}

} // namespace plc::sema
