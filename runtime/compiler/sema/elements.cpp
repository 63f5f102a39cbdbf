// Parts of variables: elements of arrays and texts, what pointers point to, bits and bytes, direct addresses.
#include "runtime/compiler/sema/checker.h"

#include <cstdlib>

namespace plc::sema {

using syntax::ExprKind;

using DK = Denoted::Kind;

/// An element of an array, a character of a text, what lies behind a pointer.
///   ok:    a[i, 2]; s[1]; p[3]      wrong: x[1]  with x : INT (P2014)   a[1]  of two dimensions (P2015)
///          a[3]  of ARRAY[1..2] (P2016)
Denoted Checker::denoteIndex(const syntax::Expr& e, Access access) {
    Denoted from = denote(*e.base, access == Access::Address ? Access::ReadWrite
                                   : access == Access::Call  ? Access::ReadWrite
                                                             : access);
    std::vector<Operand> indices;
    for (const syntax::Argument& argument : e.arguments) {
        if (!argument.value) continue;
        Operand index = expression(*argument.value);
        if (!index.isUnknown()) {
            const types::Family family = types.family(index.type());
            if (!types::isInteger(family)) {
                emit(argument.value->range, findings::IndexNotInteger(nameOf(index.type())));
                index = unknown(argument.value->range);
            } else if (types.storageKind(index.type()) != TypeKind::Lint) {
                index = convertNode(index, elementary(TypeKind::Lint));
            }
        }
        indices.push_back(index);
    }
    if (from.kind == DK::Property) {
        const Operand value = propertyValue(from, e.base->range);
        if (value.isUnknown()) return {};
        from = valueOf(value);
    }
    if (from.kind == DK::Value) {
        from.kind = DK::Place;
        from.place = temporary(from.value);
        from.isReadOnly = true;
        from.whyReadOnly = textOf(e.range);
    }
    if (from.kind == DK::Nothing) return {};
    if (from.kind != DK::Place) {
        emit(e.base->range, findings::NotAnArray(textOf(e.base->range)));
        return {};
    }
    tree::Place* base = from.place;
    const types::Type& type = types[base->type];
    const auto good = [&] {
        return std::none_of(indices.begin(), indices.end(), [](const Operand& o) { return o.isUnknown(); });
    };
    Denoted out = from;
    out.isExact = true;
    out.isSuper = false;
    switch (type.kind) {
    case TypeKind::Unknown:
        return {};
    case TypeKind::Array:
    case TypeKind::OpenArray: {
        if (indices.size() != type.dimensions.size()) {
            if (type.kind == TypeKind::Array && indices.size() == 1 && e.arguments.size() == 1) {
            }
            emit(e.range, findings::WrongIndexCount(type.dimensions.size(), indices.size()));
            return {};
        }
        if (!good()) return {};
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
                emit(e.arguments[i].value->range,
                     findings::ConstantIndexOutOfRange(index, dimension.low, dimension.high));
                return {};
            }
            number = number * dimension.count() + static_cast<uint64_t>(index - dimension.low);
        }
        const bool isStatic = base->kind == tree::PlaceKind::Absolute || base->kind == tree::PlaceKind::Instance ||
                              base->kind == tree::PlaceKind::Field;
        tree::Place* place = nullptr;
        if (allConstant && isStatic) {
            place =
                fieldPlace(base, static_cast<uint32_t>(number * types[type.element].size), type.element, -1, e.range);
        } else {
            place = arena.make<tree::Place>();
            place->kind = tree::PlaceKind::Index;
            place->type = type.element;
            place->range = e.range;
            place->base = base;
            for (const Operand& index : indices) place->indices.push_back(index.expr);
        }
        out.place = isKind(place->type, TypeKind::Reference) ? dereferenced(place, e.range) : place;
        return out;
    }
    case TypeKind::String:
    case TypeKind::Wstring: {
        if (indices.size() != 1) {
            emit(e.range, findings::WrongIndexCount(1, indices.size()));
            return {};
        }
        if (!good()) return {};
        if (indices[0].isConstant()) {
            const int64_t index = indices[0].expr->value.integer();
            if (index < 0 || index >= static_cast<int64_t>(type.capacity)) {
                emit(e.arguments[0].value->range,
                     findings::ConstantIndexOutOfRange(index, 0, int64_t(type.capacity) - 1));
                return {};
            }
        }
        tree::Place* place = arena.make<tree::Place>();
        place->kind = tree::PlaceKind::TextIndex;
        place->type = elementary(type.kind == TypeKind::String ? TypeKind::Char : TypeKind::Wchar);
        place->range = e.range;
        place->base = base;
        place->indices.push_back(indices[0].expr);
        out.place = place;
        return out;
    }
    case TypeKind::Pointer: { // p[i], as in CODESYS: the i-th variable from where it points to
        if (indices.size() != 1 || !good()) {
            if (good()) emit(e.range, findings::WrongIndexCount(1, indices.size()));
            return {};
        }
        const Operand address = sameBits(load(base, e.base->range), elementary(TypeKind::Lword));
        const Operand size = constant({elementary(TypeKind::Lword), int64_t(types[type.element].size)}, e.range);
        const Operand step = makeBinary(library::BinaryOp::Multiply, elementary(TypeKind::Lword),
                                        convertNode(indices[0], elementary(TypeKind::Lword)), size, e.range);
        const Operand sum = makeBinary(library::BinaryOp::Add, elementary(TypeKind::Lword), address, step, e.range);
        tree::Place* place = arena.make<tree::Place>();
        place->kind = tree::PlaceKind::Deref;
        place->type = type.element;
        place->range = e.range;
        place->pointer = sameBits(sum, base->type).expr;
        out.place = place;
        out.isReadOnly = false;
        return out;
    }
    default:
        emit(e.base->range, findings::NotAnArray(textOf(e.base->range)));
        return {};
    }
}

///   ok:    p^ := 5;  with p : REF_TO INT      wrong: x^ := 5;  with x : INT (P2020)
Denoted Checker::denoteDeref(const syntax::Expr& e, Access access) {
    if (e.base->kind == ExprKind::This || e.base->kind == ExprKind::Super) {
        Denoted out = denote(*e.base, access);
        if (out.place) out.place->range = e.range;
        return out;
    }
    Denoted from = denote(*e.base, Access::Read);
    Operand pointer;
    if (from.kind == DK::Nothing) return {};
    pointer = value(from, *e.base, {});
    if (pointer.isUnknown()) return {};
    const TypeKind kind = types.kind(pointer.type());
    if (kind != TypeKind::Pointer && kind != TypeKind::Reference) {
        // ref^ where ref is REFERENCE TO: the mark is accepted and means the same
        if (from.kind == DK::Place && from.place->kind == tree::PlaceKind::Deref && from.place->pointer &&
            isKind(from.place->pointer->type, TypeKind::Reference))
            return from;
        emit(e.base->range, findings::NotAPointer(textOf(e.base->range)));
        return {};
    }
    tree::Place* place = arena.make<tree::Place>();
    place->kind = tree::PlaceKind::Deref;
    place->type = types[pointer.type()].element;
    place->range = e.range;
    place->pointer = pointer.expr;
    Denoted out = placeOf(isKind(place->type, TypeKind::Reference) ? dereferenced(place, e.range) : place);
    return out;
}

///   ok:    b.7  with b : BYTE      wrong: b.8  (P2021)
Denoted Checker::denoteBit(const syntax::Expr& e, Access access) {
    const Access baseAccess = access == Access::Write || access == Access::Address ? Access::ReadWrite : access;
    Denoted from = denote(*e.base, baseAccess);
    if (from.kind == DK::Property) {
        const Operand value = propertyValue(from, e.base->range);
        if (value.isUnknown()) return {};
        from = valueOf(value);
    }
    if (from.kind == DK::Nothing) return {};
    if (from.kind == DK::Value) {
        from.place = temporary(settled(from.value));
        from.kind = DK::Place;
        from.isReadOnly = true;
        from.whyReadOnly = textOf(e.range);
    }
    if (from.kind != DK::Place) {
        emit(e.base->range, findings::NoValue(textOf(e.base->range)));
        return {};
    }
    tree::Place* base = from.place;
    const types::Family family = types.family(base->type);
    if (isKind(base->type, TypeKind::Unknown)) return {};
    if (!types::isInteger(family) || base->bit >= 0) {
        emit(e.range, findings::UnknownMember(nameOf(base->type), e.text));
        return {};
    }
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
            emit(e.range, findings::UnknownMember(nameOf(base->type), e.text));
            return {};
        }
        text.remove_prefix(1);
    }
    const int64_t number = std::atoll(std::string(text).c_str());
    const unsigned count = types::bitsOf(types.storageKind(base->type)) / width;
    if (text.empty() || number < 0 || number >= static_cast<int64_t>(count)) {
        const SourceRange at{e.range.file, e.range.end - static_cast<uint32_t>(e.text.size()), e.range.end};
        emit(at, findings::NoSuchBit(nameOf(base->type), int64_t(count) - 1));
        return {};
    }
    Denoted out = from;
    if (width == 1) {
        tree::Place* place = arena.make<tree::Place>();
        place->kind = tree::PlaceKind::Bit;
        place->type = elementary(TypeKind::Bool);
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
    takeAddress(base);
    out.place = fieldPlace(base, static_cast<uint32_t>(number) * (width / 8), elementary(piece), -1, e.range);
    return out;
}

///   ok:    %IX0.7      wrong: %IX99999999.0  (P2034)
Denoted Checker::denoteAddress(const syntax::Expr& e) {
    const auto address = parseAddress(e.text);
    if (!address || address->isOpen) {
        emit(e.range, findings::AddressOutOfRange(e.text, addressAreas()));
        return {};
    }
    const image::AreaRange area = world.areaOf(address->area);
    if (address->byte + std::max(1u, types::bitsOf(address->kind) / 8) > area.size) {
        emit(e.range, findings::AddressOutOfRange(e.text, {{address->area == image::Area::Input    ? "%I"
                                                            : address->area == image::Area::Output ? "%Q"
                                                                                                   : "%M"}}));
        return {};
    }
    return placeOf(absolutePlace(area.begin + address->byte, elementary(address->kind), address->bit, e.range));
}

} // namespace plc::sema
