// Places. An Address is base + dynamic + constant, kept apart until it is used, so that a.b[i].c is one addition; what
// is known about it (alignment, alias node, bounds of an open array) goes along.
#include "runtime/compiler/codegen/emitter.h"

#include <numeric>

namespace plc::codegen {

using image::FaultCode;
using tree::Place;
using tree::PlaceKind;
using types::TypeKind;

llvm::Value* FunctionEmitter::pointer(const Address& a) {
    Value* p = a.base;
    if (a.dynamic) p = b.CreateInBoundsGEP(m.i8, p, a.dynamic);
    if (a.constant != 0) p = b.CreateConstInBoundsGEP1_64(m.i8, p, static_cast<uint64_t>(a.constant));
    return p;
}

llvm::Value* FunctionEmitter::offset(const Address& a) {
    // In the image every address is also an offset. Places outside (slots) have none, and isImage says so.
    Value* at = a.baseOffset ? a.baseOffset : int64(0);
    if (a.dynamic) at = b.CreateAdd(at, a.dynamic);
    return a.constant == 0 ? at : b.CreateAdd(at, int64(a.constant));
}

llvm::MaybeAlign FunctionEmitter::alignOf(const Address& a) {
    // The lowest bit set in either is what both are multiples of.
    // Wrong alignment is undefined for LLVM, one that is too small is only slower: 8 is the most that is claimed.
    const uint64_t at = static_cast<uint64_t>(a.constant) | a.align;
    return llvm::Align(at & 7 ? at & (~at + 1) & 7 : 8);
}

template <class Access> void FunctionEmitter::tag(Access* access, const Address& a) {
    // Quick code is not optimised; what is not in the image is an alloca, which LLVM follows by itself.
    if (m.isQuick() || !a.isImage) return;
    access->setMetadata(llvm::LLVMContext::MD_tbaa, m.aliasTag(a.alias ? a.alias : m.imageNode()));
}

llvm::Value* FunctionEmitter::load(const Address& a) {
    if (a.bit >= 0) {
        // A bit of the byte (located BOOL, BIT member) or of the integer below (bit access).
        llvm::Type* type = a.container.isValid() && a.type == types::TypeTable::of(TypeKind::Bool) && !a.isImage
                               ? m.memoryType(a.container)
                               : m.i8;
        Address byte = a;
        int bit = a.bit;
        if (type == m.i8 && a.isImage) {
            byte.constant += bit / 8;
            bit %= 8;
        }
        llvm::LoadInst* value =
            b.CreateAlignedLoad(type, pointer(byte), type == m.i8 ? llvm::Align(1) : alignOf(byte).valueOrOne());
        tag(value, a);
        return b.CreateICmpNE(b.CreateAnd(value, llvm::ConstantInt::get(type, uint64_t(1) << bit)),
                              llvm::ConstantInt::get(type, 0));
    }
    llvm::LoadInst* value = b.CreateAlignedLoad(m.memoryType(a.type), pointer(a), alignOf(a).valueOrOne());
    tag(value, a);
    if (m.types().storageKind(a.type) == TypeKind::Bool) return b.CreateICmpNE(value, b.getInt8(0));
    return value;
}

void FunctionEmitter::store(const Address& a, Value* value) {
    plainStore(a, value);
    watchPlace(image::WatchKind::Write, m_cause, a);
}

void FunctionEmitter::plainStore(const Address& a, Value* value) {
    if (a.bit >= 0) {
        llvm::Type* type = a.container.isValid() && !a.isImage ? m.memoryType(a.container) : m.i8;
        Address byte = a;
        int bit = a.bit;
        if (type == m.i8 && a.isImage) {
            byte.constant += bit / 8;
            bit %= 8;
        }
        const llvm::Align align = type == m.i8 ? llvm::Align(1) : alignOf(byte).valueOrOne();
        Value* at = pointer(byte);
        llvm::LoadInst* old = b.CreateAlignedLoad(type, at, align);
        tag(old, a);
        // Read, change, write: the scan thread is the only one that writes the image.
        Value* mask = llvm::ConstantInt::get(type, uint64_t(1) << bit);
        Value* with =
            b.CreateShl(b.CreateZExtOrTrunc(value, type), llvm::ConstantInt::get(type, static_cast<uint64_t>(bit)));
        if (type == m.i1) with = value;
        llvm::StoreInst* stored =
            b.CreateAlignedStore(b.CreateOr(b.CreateAnd(old, b.CreateNot(mask)), with), at, align);
        tag(stored, a);
        return;
    }
    // Exactly 0 or 1 in memory, which memcmp, recordings and other programs rely on.
    if (value->getType() == m.i1) value = b.CreateZExt(value, m.i8);
    llvm::Type* wanted = m.memoryType(a.type);
    if (value->getType() != wanted && value->getType()->isIntegerTy() && wanted->isIntegerTy())
        value = b.CreateZExtOrTrunc(value, wanted);
    tag(b.CreateAlignedStore(value, pointer(a), alignOf(a).valueOrOne()), a);
}

// Paid for by its size: copying a megabyte in a loop must reach the watchdog as soon as the same work in statements.
void FunctionEmitter::copy(const Address& to, const Address& from, uint32_t size) {
    if (size == 0) return;
    chargeUnits(facts::copyUnits(size));
    // Not memcpy: through references and in-outs, source and target may be the same or overlap.
    b.CreateMemMove(pointer(to), alignOf(to), pointer(from), alignOf(from), size);
    // Reported after it was written, like every write.
    watchPlace(image::WatchKind::Write, m_cause, to, size);
}

Text FunctionEmitter::textAt(const Address& a) {
    const types::Type& type = m.types()[a.type];
    return {pointer(a), int32(type.capacity), type.kind == TypeKind::Wstring};
}

// ---------------------------------------------------------------- kinds of places

Address FunctionEmitter::readAddress(const Place& place) {
    const Address a = place.kind == PlaceKind::TextIndex ? textIndexAddress(place, Purpose::Read) : address(place);
    watchPlace(image::WatchKind::Read, &place, a);
    return a;
}

Address FunctionEmitter::address(const Place& place) {
    switch (place.kind) {
    case PlaceKind::Absolute: {
        Address a;
        a.base = m_image;
        a.constant = place.offset;
        a.type = place.type;
        a.bit = place.bit;
        // The image itself is aligned to a cache line, so the constant alone decides.
        a.align = 16;
        if (const int root = m.isQuick() ? -1 : m.rootAt(place.offset); root >= 0) {
            const image::Root& r = m.program.layout.roots[static_cast<size_t>(root)];
            a.isPrecise = true;
            a.alias = m.rootNode(static_cast<size_t>(root));
            if (r.type != place.type || r.offset != place.offset)
                // A field of a global: its node is that of the type's field, which is the same behind THIS.
                describeField(a, r.type, place.offset - r.offset, place.type);
            a.isPrecise = a.isPrecise && !m.isTainted(place.type);
        }
        return a;
    }
    case PlaceKind::Instance: {
        Address a;
        a.base = m_thisPointer;
        a.baseOffset = m_this64;
        a.constant = place.offset;
        a.type = place.type;
        a.bit = place.bit;
        // An instance may be an element of an array: only the alignment of its type is sure.
        a.align = std::max(1u, std::min(16u, m.types()[m_tree.instanceType].align));
        if (!m.isQuick()) {
            a.isPrecise = true;
            describeField(a, m_tree.instanceType, place.offset, place.type);
        }
        return a;
    }
    case PlaceKind::Local: {
        Address a = localAddress(place.local);
        return a;
    }
    case PlaceKind::InOutSlot:
        return followSlot(place);
    case PlaceKind::Field: {
        Address a = address(*place.base);
        a.constant += place.offset;
        a.bounds.clear();
        if (a.isPrecise) describeField(a, place.base->type, place.offset, place.type);
        a.type = place.type;
        a.bit = place.bit;
        return a;
    }
    case PlaceKind::Index:
        return indexAddress(place);
    case PlaceKind::Bit: {
        Address a = address(*place.base);
        // In the image a bit is one of a byte; in a slot it is one of the whole integer.
        a.container = place.base->type;
        a.isPrecise = false;
        a.type = place.type;
        a.bit = place.bit;
        return a;
    }
    // A character is where it is; that it exists is checked at each use, because texts grow and shrink.
    case PlaceKind::TextIndex:
        return textIndexAddress(place, Purpose::Write);
    case PlaceKind::Deref:
        return derefAddress(place);
    case PlaceKind::Temporary: {
        if (m.types().isText(place.type)) {
            // In the frame: it may be pointed to for as long as the statement lasts.
            Address a = temporary(place.type);
            textInto(*place.value, textAt(a));
            return a;
        }
        if (m.isScalar(place.type)) {
            Value* value = scalar(*place.value);
            Address a = temporary(place.type);
            store(a, value);
            return a;
        }
        return aggregate(*place.value);
    }
    }
    return {};
}

Address FunctionEmitter::localAddress(uint32_t index) {
    const tree::Local& local = m_tree.locals[index];
    Address a;
    a.type = local.type;
    if (local.isInOut) {
        Value* at = b.CreateLoad(m.i64, m_locals[index]);
        // Only what the checker or a caller may leave out; most in-outs are always bound.
        if (m_facts.mayBeNull[index]) guard(b.CreateICmpEQ(at, int64(0)), FaultCode::MissingInOut);
        a = imageAddress(at, local.type);
        for (auto& [low, high] : m_localBounds[index])
            a.bounds.push_back({b.CreateLoad(m.i64, low), b.CreateLoad(m.i64, high)});
        return a;
    }
    if (m_locals[index]) {
        a.base = m_locals[index];
        a.isImage = false;
        // A slot is an alloca of exactly this type.
        a.align = std::max(1u, m.types()[local.type].size);
        return a;
    }
    a.base = m_framePointer;
    a.baseOffset = m_frame64;
    a.constant = m_facts.frame.offsets[index];
    a.align = 16;
    return a;
}

Address FunctionEmitter::imageAddress(Value* at, types::TypeId type) {
    Address a;
    a.base = b.CreateInBoundsGEP(m.i8, m_image, at);
    a.baseOffset = at;
    a.type = type;
    return a;
}

Address FunctionEmitter::slotAddress(const Place& place) {
    Address a;
    if (place.kind == PlaceKind::InOutSlot && place.base) {
        a = address(*place.base);
    } else {
        a.base = m_thisPointer;
        a.baseOffset = m_this64;
    }
    a.constant += place.offset;
    a.type = place.type;
    // Slots of in-outs may be written by any call of the block: nothing is claimed about them.
    a.alias = nullptr;
    a.isPrecise = false;
    a.bit = -1;
    a.align = 1;
    return a;
}

// An in-out of a block: the slot holds where its argument is, as the last call bound it.
Address FunctionEmitter::followSlot(const Place& place) {
    const bool isOpen = m.types().kind(place.type) == TypeKind::OpenArray;
    // The offset from THIS as fixedFromThis counts it in the prologue.
    uint32_t fixed = place.offset;
    bool isFixed = true;
    for (const Place* p = place.base; p; p = p->base) {
        isFixed = isFixed && (p->kind == PlaceKind::Instance || p->kind == PlaceKind::Field);
        fixed += p->offset;
    }
    // followed and checked at the entry; what it was there is read again only to say what is wrong with it
    if (const auto it = m_slots.find(fixed); isFixed && it != m_slots.end()) {
        Value* at = b.CreateLoad(m.i64, it->second.offset);
        Block* bad = newBlock("no_inout");
        Block* ok = newBlock("ok");
        branchUnlikely(b.CreateICmpEQ(at, int64(0)), bad, ok);
        enter(bad);
        Value* raw = b.CreateAlignedLoad(m.i64, pointer(slotAddress(place)), llvm::Align(1));
        Value* code =
            b.CreateSelect(b.CreateICmpEQ(raw, int64(0)), int32(static_cast<uint32_t>(FaultCode::MissingInOut)),
                           int32(static_cast<uint32_t>(FaultCode::ForeignReference)));
        b.CreateCall(m.raise(), {m_context, code, int32(m_site), raw, int64(0), int64(0)});
        b.CreateUnreachable();
        enter(ok);
        Address a = imageAddress(at, place.type);
        for (auto& [low, high] : it->second.bounds)
            a.bounds.push_back({b.CreateLoad(m.i64, low), b.CreateLoad(m.i64, high)});
        return a;
    }
    const Address slot = slotAddress(place);
    Value* at = b.CreateAlignedLoad(m.i64, pointer(slot), llvm::Align(1));
    guard(b.CreateICmpEQ(at, int64(0)), FaultCode::MissingInOut);
    // What is bound lies within live memory as a whole, so no access inside of it is checked again.
    Value* size = int64(m.types()[place.type].size);
    std::vector<std::pair<Value*, Value*>> bounds;
    if (isOpen) {
        Address boundAt = slot;
        size = int64(m.types()[m.types()[place.type].element].size);
        Value* bad = b.getFalse();
        for (size_t d = 0; d < m.types()[place.type].dimensions.size(); ++d) {
            boundAt.constant += 8;
            Value* low = b.CreateAlignedLoad(m.i64, pointer(boundAt), llvm::Align(1));
            boundAt.constant += 8;
            Value* high = b.CreateAlignedLoad(m.i64, pointer(boundAt), llvm::Align(1));
            Value* count = b.CreateAdd(b.CreateSub(high, low), int64(1));
            // See emitPrologue: no product of bounds may wrap.
            bad = b.CreateOr(bad, b.CreateICmpUGT(count, int64(1 << 30)));
            size = b.CreateMul(size, b.CreateAnd(count, int64((int64_t(1) << 31) - 1)));
            bad = b.CreateOr(bad, b.CreateICmpUGT(size, int64(1 << 30)));
            bounds.push_back({low, high});
        }
        guard(bad, FaultCode::ForeignReference, at);
    }
    guardReference(at, size);
    Address a = imageAddress(at, place.type);
    a.bounds = std::move(bounds);
    return a;
}

std::vector<std::pair<llvm::Value*, llvm::Value*>> FunctionEmitter::boundsOf(const Address& a) {
    // Of an open array they came with it; of others they are in the type.
    if (!a.bounds.empty()) return a.bounds;
    std::vector<std::pair<Value*, Value*>> bounds;
    for (const types::Dimension& d : m.types()[a.type].dimensions) bounds.push_back({int64(d.low), int64(d.high)});
    return bounds;
}

Address FunctionEmitter::indexAddress(const Place& place) {
    Address a = address(*place.base);
    const types::Type& array = m.types()[place.base->type];
    const types::TypeId element = array.element;
    const int64_t size = m.types()[element].size;
    const auto bounds = boundsOf(a);
    Value* flat = nullptr;
    for (size_t d = 0; d < place.indices.size() && d < bounds.size(); ++d) {
        const tree::Expr& indexExpr = *place.indices[d];
        // By the sign of its own type: an index of type USINT is never negative.
        Value* index = castInteger(scalar(indexExpr), indexExpr.type, m.i64);
        auto [low, high] = bounds[d];
        Value* from = b.CreateSub(index, low);
        const auto* constantLow = llvm::dyn_cast<llvm::ConstantInt>(low);
        const auto* constantHigh = llvm::dyn_cast<llvm::ConstantInt>(high);
        bool isSafe = false;
        if (constantLow && constantHigh) {
            const Range range = rangeOf(indexExpr);
            isSafe = range.low >= constantLow->getSExtValue() && range.high <= constantHigh->getSExtValue();
        }
        if (!isSafe) {
            Value* span = b.CreateSub(high, low);
            // unsigned: an index below the lower bound wraps to a large one, so that one compare asks for both ends
            Value* bad = b.CreateICmpUGT(from, span);
            // An empty open array (high = low - 1) has no element at all.
            if (!llvm::isa<llvm::ConstantInt>(span)) bad = b.CreateOr(bad, b.CreateICmpSLT(span, int64(0)));
            guard(bad, FaultCode::IndexOutOfRange, index, low, high);
        }
        if (!flat) {
            flat = from;
        } else {
            Value* count = b.CreateAdd(b.CreateSub(high, low), int64(1));
            // nuw and nsw are true here: the guards above bound every factor.
            flat = b.CreateAdd(b.CreateMul(flat, count, "", true, true), from, "", true, true);
        }
    }
    if (!flat) flat = int64(0);
    Value* bytes = size == 1 ? flat : b.CreateMul(flat, int64(size), "", true, true);
    a.bounds.clear();
    if (const auto* known = llvm::dyn_cast<llvm::ConstantInt>(bytes)) {
        a.constant += known->getSExtValue();
    } else {
        a.dynamic = a.dynamic ? b.CreateAdd(a.dynamic, bytes) : bytes;
        // the largest power of two in the size is what every element is aligned to
        const uint64_t low = static_cast<uint64_t>(size) & (~static_cast<uint64_t>(size) + 1);
        a.align = static_cast<uint32_t>(std::min<uint64_t>(a.align, low ? low : 1));
    }
    a.type = place.type;
    a.bit = place.bit;
    a.isPrecise = a.isPrecise && !m.isTainted(element);
    return a;
}

/// The end mark behind the last character may be read (it is 0), as loops over a text do; it cannot be written.
Address FunctionEmitter::textIndexAddress(const Place& place, Purpose purpose) {
    Address a = address(*place.base);
    const Text text = textAt(a);
    const tree::Expr& indexExpr = *place.indices.front();
    Value* index = castInteger(scalar(indexExpr), indexExpr.type, m.i64);
    Value* length = b.CreateZExt(textCall("length", text.isWide, m.i32, {text.pointer, text.capacity}, false), m.i64);
    if (purpose == Purpose::Read)
        guard(b.CreateICmpUGT(index, length), FaultCode::StringIndex, index, int64(0), length);
    else
        guard(b.CreateICmpUGE(index, length), FaultCode::StringIndex, index, int64(0), b.CreateSub(length, int64(1)));
    Value* bytes = text.isWide ? b.CreateShl(index, int64(1)) : index;
    a.dynamic = a.dynamic ? b.CreateAdd(a.dynamic, bytes) : bytes;
    a.align = 1;
    a.type = place.type;
    return a;
}

// A pointer may hold anything that a program can compute; what is used is checked here, each time.
Address FunctionEmitter::derefAddress(const Place& place) {
    Value* at = scalar(*place.pointer);
    at = b.CreateZExtOrTrunc(at, m.i64);
    // At least a byte: an empty structure still has to lie somewhere.
    guardReference(at, int64(std::max(1u, m.types()[place.type].size)));
    // A pointer to a block must find one, since calls read its number.
    if (m.types().kind(place.type) == TypeKind::Block) guardBlock(at, place.type);
    Address a = imageAddress(at, place.type);
    a.bit = place.bit;
    return a;
}

/// Narrows the alias node to the field of `container` that lies at `at`; gives up where types may overlap.
void FunctionEmitter::describeField(Address& a, types::TypeId container, uint32_t at, types::TypeId wanted) {
    for (;;) {
        const types::Type& type = m.types()[container];
        if (type.kind == TypeKind::Array) {
            const uint32_t size = m.types()[type.element].size;
            if (size == 0) break;
            // Elements of an array share the node of their type: which one it is does not matter for apartness of
            // fields.
            at %= size;
            container = type.element;
            if (container == wanted || m.isScalar(container)) return;
            continue;
        }
        if ((type.kind != TypeKind::Struct && type.kind != TypeKind::Block) || m.isTainted(container)) break;
        size_t found = type.fields.size();
        for (size_t i = 0; i < type.fields.size(); ++i) {
            const types::Field& field = type.fields[i];
            const uint32_t size =
                field.section == types::FieldSection::InOut ? 8 : std::max(1u, m.types()[field.type].size);
            if (at >= field.offset && at < field.offset + size) {
                found = i;
                break;
            }
        }
        if (found == type.fields.size()) break;
        const types::Field& field = type.fields[found];
        a.alias = m.fieldNode(container, found);
        at -= field.offset;
        if (m.isTainted(field.type)) break;
        if (field.type == wanted || m.isScalar(field.type) || m.types().isText(field.type)) return;
        container = field.type;
    }
    a.alias = nullptr;
    a.isPrecise = false;
}

} // namespace plc::codegen
