#include "runtime/compiler/driver/expression_compiler.h"
#include "runtime/base/messages.h"

#include "runtime/expression/code.h"

namespace plc::driver {
namespace {

using expression::Bounds;
using expression::CodeBuilder;
using expression::Op;
using tree::Expr;
using tree::ExprKind;
using tree::Place;
using tree::PlaceKind;
using types::TypeId;
using types::TypeKind;

/// Where a place lies: known now, or an offset on the stack to which `offset` is still to be added.
struct Address {
    bool isStatic = true;
    uint32_t offset = 0;
    int bit = -1;
};

class Compiler {
public:
    explicit Compiler(const types::TypeTable& types) : m_types(types) {}

    bool compile(const Expr& root) {
        if (root.kind == ExprKind::Load && !expression(root)) return false;
        if (root.kind == ExprKind::Load) {
            if (const auto place = staticPlace(*root.place)) m_code.setPlace(*place);
            return true;
        }
        return expression(root);
    }
    CodeBuilder& code() { return m_code; }
    [[nodiscard]] const Message& error() const { return m_error; }

private:
    bool fail(Message message) {
        if (m_error.isEmpty()) m_error = std::move(message);
        return false;
    }

    /// The place when nothing has to be computed for it.
    std::optional<image::Place> staticPlace(const Place& place) {
        const auto address = constantAddress(place);
        if (!address) return std::nullopt;
        return image::Place{place.type, address->offset, static_cast<int16_t>(address->bit)};
    }

    std::optional<Address> constantAddress(const Place& place) {
        switch (place.kind) {
        case PlaceKind::Absolute:
            return Address{true, place.offset, place.bit};
        case PlaceKind::Field: {
            auto base = constantAddress(*place.base);
            if (base) *base = {true, base->offset + place.offset, place.bit};
            return base;
        }
        case PlaceKind::Bit: {
            auto base = constantAddress(*place.base);
            if (base) *base = {true, base->offset + static_cast<uint32_t>(place.bit) / 8, place.bit % 8};
            return base;
        }
        case PlaceKind::Index:
            return constantElement(place);
        default:
            return std::nullopt;
        }
    }

    std::optional<Address> constantElement(const Place& place) {
        const types::Type& array = m_types[place.base->type];
        if (array.kind != TypeKind::Array || array.dimensions.size() != place.indices.size()) return std::nullopt;
        auto base = constantAddress(*place.base);
        if (!base) return std::nullopt;
        uint64_t element = 0;
        for (size_t i = 0; i < place.indices.size(); ++i) {
            const Expr& index = *place.indices[i];
            if (index.kind != ExprKind::Constant || !std::holds_alternative<int64_t>(index.value.data))
                return std::nullopt;
            const types::Dimension& dimension = array.dimensions[i];
            const int64_t value = index.value.integer();
            if (value < dimension.low || value > dimension.high) return std::nullopt;
            element = element * dimension.count() + static_cast<uint64_t>(value - dimension.low);
        }
        return Address{true, base->offset + static_cast<uint32_t>(element * m_types[array.element].size), -1};
    }

    /// After this the offset of the place is on the stack (less `offset`, which the caller adds), unless it is static.
    bool address(const Place& place, Address& out) {
        if (const auto constant = constantAddress(place)) {
            out = *constant;
            return true;
        }
        switch (place.kind) {
        case PlaceKind::Absolute:
            break; // is constant
        case PlaceKind::Instance:
        case PlaceKind::Local:
            return fail(errors::LocalOfACall());
        case PlaceKind::Temporary:
            return fail(errors::PartOfComputedValue());
        case PlaceKind::TextIndex:
            return fail(errors::CharacterHasNoAddress());
        case PlaceKind::Field:
            if (!address(*place.base, out)) return false;
            out.offset += place.offset;
            out.bit = place.bit;
            return true;
        case PlaceKind::Bit:
            if (!address(*place.base, out)) return false;
            out.offset += static_cast<uint32_t>(place.bit) / 8;
            out.bit = place.bit % 8;
            return true;
        case PlaceKind::InOutSlot:
            if (!slotOffset(place)) return false;
            m_code.followInOut(place.type);
            m_code.readsAnything();
            out = {false, 0, -1};
            return true;
        case PlaceKind::Deref:
            if (!expression(*place.pointer)) return false;
            m_code.dereference(place.type);
            m_code.readsAnything();
            out = {false, 0, -1};
            return true;
        case PlaceKind::Index:
            return element(place, out);
        }
        return fail(errors::PlaceNotShown());
    }

    bool pushAddress(const Place& place) {
        Address at;
        if (!address(place, at)) return false;
        pushed(at);
        return true;
    }
    void pushed(const Address& at) {
        if (at.isStatic)
            m_code.offset(at.offset);
        else
            m_code.addOffset(at.offset);
    }

    /// The place of an IN_OUT's slot itself, not of what it refers to.
    bool slotOffset(const Place& place) {
        Address at;
        if (place.base) {
            if (!address(*place.base, at)) return false;
        } else {
            at = {};
        }
        at.offset += place.offset;
        if (at.isStatic) m_code.reads(at.offset, 8);
        pushed(at);
        return true;
    }

    bool element(const Place& place, Address& out) {
        const types::Type& array = m_types[place.base->type];
        out = {false, 0, -1};
        if (array.kind == TypeKind::OpenArray) {
            if (place.base->kind != PlaceKind::InOutSlot) return fail(errors::OpenArrayNotHere());
            if (!slotOffset(*place.base)) return false;
            for (const Expr* index : place.indices)
                if (!expression(*index)) return false;
            m_code.openIndex(static_cast<uint32_t>(place.indices.size()), m_types[array.element].size);
            m_code.readsAnything();
            return true;
        }
        if (array.kind != TypeKind::Array || array.dimensions.size() != place.indices.size())
            return fail(errors::NotAnArray());
        if (const auto base = constantAddress(*place.base)) {
            m_code.reads(base->offset, array.size);
            m_code.offset(base->offset);
        } else if (!pushAddress(*place.base)) {
            return false;
        }
        uint64_t stride = array.size;
        for (size_t i = 0; i < place.indices.size(); ++i) {
            if (!expression(*place.indices[i])) return false;
            const types::Dimension& dimension = array.dimensions[i];
            stride = dimension.count() ? stride / dimension.count() : 0;
            m_code.index(Bounds{dimension.low, dimension.high, static_cast<uint32_t>(stride)});
        }
        return true;
    }

    bool load(const Place& place) {
        if (place.kind == PlaceKind::TextIndex) return character(place);
        if (place.kind == PlaceKind::Temporary && place.value) return expression(*place.value);
        if (const auto constant = staticPlace(place)) {
            m_code.load(m_types, *constant);
            return true;
        }
        Address at;
        if (!address(place, at)) return false;
        pushed(at);
        m_code.loadAt(m_types, place.type, at.bit);
        return true;
    }

    bool character(const Place& place) {
        const Place& base = *place.base;
        if (base.kind == PlaceKind::Temporary && base.value) {
            if (!expression(*base.value) || !expression(*place.indices.at(0))) return false;
            m_code.intrinsic({library::Intrinsic::CharAt, place.type, {base.value->type, place.indices[0]->type}, -1});
            return true;
        }
        if (const auto constant = constantAddress(base)) m_code.reads(constant->offset, m_types[base.type].size);
        if (!pushAddress(base) || !expression(*place.indices.at(0))) return false;
        m_code.character(base.type);
        return true;
    }

    bool shortCircuit(const Expr& expr) {
        if (!expression(*expr.a)) return false;
        const size_t end = m_code.jump(expr.kind == ExprKind::AndThen ? Op::JumpKeepFalse : Op::JumpKeepTrue);
        if (!expression(*expr.b)) return false;
        m_code.land(end);
        return true;
    }

    bool conditional(const Expr& expr) {
        if (!expression(*expr.a)) return false;
        const size_t otherwise = m_code.jump(Op::JumpIfFalse);
        if (!expression(*expr.b)) return false;
        const size_t end = m_code.jump(Op::Jump);
        m_code.land(otherwise);
        m_code.otherWay();
        if (!expression(*expr.c)) return false;
        m_code.land(end);
        return true;
    }

    bool bound(const Expr& expr) {
        const Place& place = *expr.place;
        const types::Type& array = m_types[place.type];
        const auto dimension = static_cast<size_t>(expr.selector);
        if (dimension >= array.dimensions.size()) return fail(errors::NoSuchDimension());
        if (array.kind == TypeKind::Array) {
            m_code.constant(m_types, {expr.type, expr.isUpper ? array.dimensions[dimension].high
                                                              : array.dimensions[dimension].low});
            return true;
        }
        if (place.kind != PlaceKind::InOutSlot || !slotOffset(place)) return fail(errors::OpenArrayNotHere());
        m_code.addOffset(static_cast<uint32_t>(8 + 16 * dimension + (expr.isUpper ? 8 : 0)));
        m_code.loadAt(m_types, types::TypeTable::of(TypeKind::Lint), -1);
        m_code.readsAnything();
        m_code.convert(types::TypeTable::of(TypeKind::Lint), expr.type);
        return true;
    }

    bool expression(const Expr& expr) {
        switch (expr.kind) {
        case ExprKind::Constant:
            if (!expr.value.hasValue()) return fail(errors::NoValue());
            m_code.constant(m_types, expr.value);
            return true;
        case ExprKind::Load:
            return load(*expr.place);
        case ExprKind::Unary:
            if (!expression(*expr.a)) return false;
            m_code.unary(m_types, expr.unary, expr.type);
            return true;
        case ExprKind::Binary:
            if (!expression(*expr.a) || !expression(*expr.b)) return false;
            m_code.binary(m_types, expr.binary, expr.operandType.isValid() ? expr.operandType : expr.type);
            return true;
        case ExprKind::AndThen:
        case ExprKind::OrElse:
            return shortCircuit(expr);
        case ExprKind::Convert:
            if (!expression(*expr.a)) return false;
            m_code.convert(expr.a->type, expr.type);
            return true;
        case ExprKind::AddressOf:
        case ExprKind::InterfaceOf:
            return pushAddress(*expr.place);
        case ExprKind::Intrinsic: {
            expression::IntrinsicCall call{expr.intrinsic, expr.type, {}, expr.selector};
            for (const Expr* operand : expr.operands) {
                if (!expression(*operand)) return false;
                call.operands.push_back(operand->type);
            }
            m_code.intrinsic(std::move(call));
            return true;
        }
        case ExprKind::Conditional:
            return conditional(expr);
        case ExprKind::Bound:
            return bound(expr);
        case ExprKind::IsNull:
            if (!expression(*expr.a)) return false;
            m_code.isZero();
            return true;
        case ExprKind::Sequence:
            if (!expr.statements.empty()) return fail(errors::NoSideEffects());
            return expression(*expr.a);
        case ExprKind::Call:
            return fail(errors::OnlyStandardFunctions());
        case ExprKind::TryCast:
            return fail(errors::InterfaceCastNotWatched());
        }
        return fail(errors::NotEvaluated());
    }

    const types::TypeTable& m_types;
    CodeBuilder m_code;
    Message m_error;
};

} // namespace

Result<expression::Expression> compile(const tree::Expr& root, std::shared_ptr<const types::TypeTable> types,
                                       std::string text) {
    Compiler compiler(*types);
    if (!compiler.compile(root)) return Error{compiler.error(), text};
    if (compiler.code().isTooDeep()) return Error{errors::ExpressionTooDeep(), text};
    return expression::Expression(text, types, compiler.code().finish(), root.type);
}

} // namespace plc::driver
