#include "runtime/expression/machine.h"

#include "runtime/base/messages.h"
#include "runtime/types/conversion.h"

#include <array>
#include <cstring>

namespace plc::expression {
namespace {

using library::BinaryOp;
using types::Family;
using types::TypeId;
using types::TypeKind;
using types::Value;

bool isObjectKind(TypeKind kind) {
    switch (kind) {
    case TypeKind::String:
    case TypeKind::Wstring:
    case TypeKind::Array:
    case TypeKind::Struct:
    case TypeKind::Union:
    case TypeKind::Block:
        return true;
    default:
        return false;
    }
}

template <class T> T read(std::span<const std::byte> image, int64_t offset) {
    T value;
    std::memcpy(&value, image.data() + offset, sizeof value);
    return value;
}

Slot ofInteger(int64_t value) { return {.integer = value}; }
Slot ofReal(double value) { return {.real = value}; }

/// The quick ones; false: the reference does it.
template <class Number> bool quickReal(BinaryOp op, Number a, Number b, Slot& out) {
    switch (op) {
    case BinaryOp::Add:
        out = ofReal(static_cast<double>(a + b));
        return true;
    case BinaryOp::Subtract:
        out = ofReal(static_cast<double>(a - b));
        return true;
    case BinaryOp::Multiply:
        out = ofReal(static_cast<double>(a * b));
        return true;
    case BinaryOp::Divide:
        out = ofReal(static_cast<double>(a / b));
        return true;
    case BinaryOp::Equal:
        out = ofInteger(a == b);
        return true;
    case BinaryOp::NotEqual:
        out = ofInteger(a != b);
        return true;
    case BinaryOp::Less:
        out = ofInteger(a < b);
        return true;
    case BinaryOp::LessEqual:
        out = ofInteger(a <= b);
        return true;
    case BinaryOp::Greater:
        out = ofInteger(a > b);
        return true;
    case BinaryOp::GreaterEqual:
        out = ofInteger(a >= b);
        return true;
    default:
        return false;
    }
}

bool quickInteger(BinaryOp op, TypeKind kind, int64_t a, int64_t b, Slot& out) {
    // Below 64 bits both signed and unsigned values compare as they are.
    const bool isWideUnsigned = kind == TypeKind::Ulint || kind == TypeKind::Lword || !types::isElementary(kind);
    if (isWideUnsigned && op >= BinaryOp::Less) return false;
    const auto left = static_cast<uint64_t>(a), right = static_cast<uint64_t>(b);
    switch (op) {
    case BinaryOp::Equal:
        out = ofInteger(a == b);
        return true;
    case BinaryOp::NotEqual:
        out = ofInteger(a != b);
        return true;
    case BinaryOp::Less:
        out = ofInteger(a < b);
        return true;
    case BinaryOp::LessEqual:
        out = ofInteger(a <= b);
        return true;
    case BinaryOp::Greater:
        out = ofInteger(a > b);
        return true;
    case BinaryOp::GreaterEqual:
        out = ofInteger(a >= b);
        return true;
    case BinaryOp::And:
        out = ofInteger(a & b);
        return true;
    case BinaryOp::Or:
        out = ofInteger(a | b);
        return true;
    case BinaryOp::Xor:
        out = ofInteger(a ^ b);
        return true;
    case BinaryOp::Add:
        out = ofInteger(types::wrapInteger(kind, static_cast<int64_t>(left + right)));
        return true;
    case BinaryOp::Subtract:
        out = ofInteger(types::wrapInteger(kind, static_cast<int64_t>(left - right)));
        return true;
    case BinaryOp::Multiply:
        out = ofInteger(types::wrapInteger(kind, static_cast<int64_t>(left * right)));
        return true;
    default:
        return false;
    }
}

} // namespace

Message Failure::message() const {
    switch (kind) {
    case Kind::None:
        return {};
    case Kind::Index:
        return errors::IndexOutOfRange(detail[0], detail[1], detail[2]);
    case Kind::Null:
        return errors::NullReference();
    case Kind::Foreign:
        return errors::ForeignReference();
    case Kind::MissingInOut:
        return errors::MissingInOut();
    case Kind::Character:
        return errors::TextIndexOutOfRange(detail[0], 0, detail[1]);
    case Kind::DivisionByZero:
        return errors::DivisionByZero();
    case Kind::OtherImage:
        return errors::NotInThisImage();
    case Kind::NotEvaluable:
        return errors::NoValueHere();
    }
    return {};
}

bool Machine::fail(Failure::Kind kind, int64_t a, int64_t b, int64_t c) {
    m_failure = {kind, {a, b, c}};
    return false;
}

bool Machine::fail(library::EvaluationError error) {
    using library::EvaluationError;
    switch (error) {
    case EvaluationError::None:
        return true;
    case EvaluationError::DivisionByZero:
        return fail(Failure::Kind::DivisionByZero);
    case EvaluationError::IndexOutOfRange:
        return fail(Failure::Kind::Index);
    case EvaluationError::NullReference:
        return fail(Failure::Kind::Null);
    case EvaluationError::StringIndex:
        return fail(Failure::Kind::Character);
    case EvaluationError::NotEvaluable:
        return fail(Failure::Kind::NotEvaluable);
    }
    return false;
}

bool Machine::isInside(int64_t offset, uint32_t size) const {
    return offset >= static_cast<int64_t>(sizeof(image::ImageHeader)) &&
           static_cast<uint64_t>(offset) + size <= m_image.size();
}

int64_t Machine::wordAt(int64_t offset) const { return read<int64_t>(m_image, offset); }

Slot Machine::object(Value&& value) {
    m_objects.push_back(std::move(value));
    return ofInteger(static_cast<int64_t>(m_objects.size()) - 1);
}

Slot Machine::slotOf(Value&& value) {
    if (const auto* integer = std::get_if<int64_t>(&value.data)) return ofInteger(*integer);
    if (const auto* real = std::get_if<double>(&value.data)) return ofReal(*real);
    return object(std::move(value));
}

Value Machine::valueOf(Slot slot, TypeId type) const {
    const TypeKind kind = m_types.storageKind(type);
    if (isObjectKind(kind)) {
        Value value = m_objects[static_cast<size_t>(slot.integer)];
        value.type = type;
        return value;
    }
    if (kind == TypeKind::Real || kind == TypeKind::Lreal) return {type, slot.real};
    return {type, slot.integer};
}

Slot Machine::load(const Instruction& instruction, int64_t offset) {
    if (instruction.bit >= 0) return ofInteger((read<uint8_t>(m_image, offset) >> instruction.bit) & 1);
    switch (instruction.kind) {
    case TypeKind::Bool:
        return ofInteger(read<uint8_t>(m_image, offset) != 0);
    case TypeKind::Byte:
    case TypeKind::Usint:
    case TypeKind::Char:
        return ofInteger(read<uint8_t>(m_image, offset));
    case TypeKind::Sint:
        return ofInteger(read<int8_t>(m_image, offset));
    case TypeKind::Word:
    case TypeKind::Uint:
    case TypeKind::Wchar:
        return ofInteger(read<uint16_t>(m_image, offset));
    case TypeKind::Int:
        return ofInteger(read<int16_t>(m_image, offset));
    case TypeKind::Dword:
    case TypeKind::Udint:
        return ofInteger(read<uint32_t>(m_image, offset));
    case TypeKind::Dint:
        return ofInteger(read<int32_t>(m_image, offset));
    case TypeKind::Real:
        return ofReal(static_cast<double>(read<float>(m_image, offset)));
    case TypeKind::Lreal:
        return ofReal(read<double>(m_image, offset));
    default:
        break;
    }
    if (isObjectKind(instruction.kind))
        return object(types::readValue(m_types, TypeId(instruction.b), m_image.subspan(static_cast<size_t>(offset))));
    return ofInteger(read<int64_t>(m_image, offset));
}

bool Machine::index(const Bounds& bounds) {
    const int64_t index = pop().integer;
    if (index < bounds.low || index > bounds.high) return fail(Failure::Kind::Index, index, bounds.low, bounds.high);
    top().integer += (index - bounds.low) * bounds.stride;
    return true;
}

/// The slot holds the array's offset, then low and high of each dimension.
bool Machine::openIndex(uint32_t rank, uint32_t elementSize) {
    m_used -= rank;
    const int64_t slot = top().integer;
    if (!isInside(slot, 8 + 16 * rank)) return fail(Failure::Kind::Foreign);
    const int64_t base = wordAt(slot);
    if (base == 0) return fail(Failure::Kind::MissingInOut);
    int64_t element = 0;
    for (uint32_t i = 0; i < rank; ++i) {
        const int64_t low = wordAt(slot + 8 + 16 * i), high = wordAt(slot + 16 + 16 * i);
        const int64_t index = m_stack[m_used + i].integer;
        if (index < low || index > high) return fail(Failure::Kind::Index, index, low, high);
        const auto count = static_cast<uint64_t>(high) - static_cast<uint64_t>(low) + 1;
        element = static_cast<int64_t>(static_cast<uint64_t>(element) * count + static_cast<uint64_t>(index) -
                                       static_cast<uint64_t>(low));
    }
    const auto offset =
        static_cast<int64_t>(static_cast<uint64_t>(base) + static_cast<uint64_t>(element) * elementSize);
    if (!isInside(offset, elementSize)) return fail(Failure::Kind::Foreign);
    top().integer = offset;
    return true;
}

bool Machine::character(TypeId text) {
    const types::Type& type = m_types[m_types.storage(text)];
    const bool isWide = type.kind == TypeKind::Wstring;
    const int64_t index = pop().integer;
    const int64_t offset = top().integer;
    if (!isInside(offset, type.size)) return fail(Failure::Kind::Foreign);
    const auto unit = [&](int64_t at) -> int64_t {
        return isWide ? read<uint16_t>(m_image, offset + 2 * at) : read<uint8_t>(m_image, offset + at);
    };
    int64_t length = 0;
    while (length < type.capacity && unit(length) != 0) ++length;
    if (index < 0 || index > length) return fail(Failure::Kind::Character, index, length);
    top().integer = index == length ? 0 : unit(index);
    return true;
}

bool Machine::unary(const Instruction& instruction) {
    const auto op = static_cast<library::UnaryOp>(instruction.extra);
    if (instruction.kind == TypeKind::Bool) {
        top().integer = top().integer == 0;
        return true;
    }
    const TypeId type(instruction.b);
    library::Evaluated result = library::evaluateUnary(m_types, op, type, valueOf(top(), type));
    if (result.error != library::EvaluationError::None) return fail(result.error);
    top() = slotOf(std::move(result.value));
    return true;
}

bool Machine::binary(const Instruction& instruction) {
    const auto op = static_cast<BinaryOp>(instruction.extra);
    const Slot b = pop(), a = top();
    bool isDone = false;
    if (instruction.kind == TypeKind::Real)
        isDone = quickReal(op, static_cast<float>(a.real), static_cast<float>(b.real), top());
    else if (instruction.kind == TypeKind::Lreal)
        isDone = quickReal(op, a.real, b.real, top());
    else if (!isObjectKind(instruction.kind))
        isDone = quickInteger(op, instruction.kind, a.integer, b.integer, top());
    return isDone || slowBinary(instruction, a, b);
}

bool Machine::slowBinary(const Instruction& instruction, Slot a, Slot b) {
    const TypeId type(instruction.b);
    library::Evaluated result = library::evaluateBinary(m_types, static_cast<BinaryOp>(instruction.extra), type,
                                                        valueOf(a, type), valueOf(b, type));
    if (result.error != library::EvaluationError::None) return fail(result.error);
    top() = slotOf(std::move(result.value));
    return true;
}

bool Machine::convert(const Instruction& instruction) {
    const TypeId from(instruction.a), to(instruction.b);
    const TypeKind source = m_types.storageKind(from), target = m_types.storageKind(to);
    if (types::isInteger(types::familyOf(source)) && types::isInteger(types::familyOf(target))) {
        top().integer = types::wrapInteger(target, top().integer);
        return true;
    }
    top() = slotOf(types::convert(m_types, valueOf(top(), from), to));
    return true;
}

bool Machine::intrinsic(const IntrinsicCall& call) {
    const size_t count = call.operands.size();
    constexpr size_t kFew = 8;
    std::array<Value, kFew> few;
    std::vector<Value> many;
    if (count > kFew) many.resize(count);
    const std::span<Value> operands = count > kFew ? std::span(many) : std::span(few).first(count);
    m_used -= static_cast<uint32_t>(count);
    for (size_t i = 0; i < count; ++i) operands[i] = valueOf(m_stack[m_used + i], call.operands[i]);
    image::ImageHeader header;
    if (m_image.size() >= sizeof header) std::memcpy(&header, m_image.data(), sizeof header);
    library::Evaluated result =
        library::evaluateIntrinsic(m_types, call.intrinsic, call.result, operands, &header, call.selector);
    if (result.error != library::EvaluationError::None) return fail(result.error);
    push(slotOf(std::move(result.value)));
    return true;
}

bool Machine::run(Slot& result) {
    if (m_code.directEnd > m_image.size()) return fail(Failure::Kind::OtherImage);
    const size_t end = m_code.instructions.size();
    for (size_t at = 0; at < end;) {
        const Instruction& instruction = m_code.instructions[at++];
        switch (instruction.op) {
        case Op::Constant:
            push(ofInteger(static_cast<int64_t>(uint64_t(instruction.b) << 32 | instruction.a)));
            break; // a slot has one pattern for both
        case Op::Object:
            push(object(Value(m_code.constants[instruction.a])));
            break;
        case Op::Offset:
            push(ofInteger(instruction.a));
            break;
        case Op::Load:
            push(load(instruction, instruction.a));
            break;
        case Op::LoadAt:
            if (!isInside(top().integer, instruction.bit >= 0 ? 1 : m_types[TypeId(instruction.b)].size))
                return fail(Failure::Kind::Foreign);
            top() = load(instruction, top().integer);
            break;
        case Op::AddOffset:
            top().integer += instruction.a;
            break;
        case Op::Index:
            if (!index(m_code.bounds[instruction.a])) return false;
            break;
        case Op::OpenIndex:
            if (!openIndex(instruction.a, instruction.b)) return false;
            break;
        case Op::FollowInOut: {
            if (!isInside(top().integer, 8)) return fail(Failure::Kind::Foreign);
            const int64_t target = wordAt(top().integer);
            if (target == 0) return fail(Failure::Kind::MissingInOut);
            if (!isInside(target, m_types[TypeId(instruction.b)].size)) return fail(Failure::Kind::Foreign);
            top().integer = target;
            break;
        }
        case Op::Dereference:
            if (top().integer == 0) return fail(Failure::Kind::Null);
            if (!isInside(top().integer, m_types[TypeId(instruction.b)].size)) return fail(Failure::Kind::Foreign);
            break;
        case Op::Character:
            if (!character(TypeId(instruction.b))) return false;
            break;
        case Op::Unary:
            if (!unary(instruction)) return false;
            break;
        case Op::Binary:
            if (!binary(instruction)) return false;
            break;
        case Op::Convert:
            if (!convert(instruction)) return false;
            break;
        case Op::Intrinsic:
            if (!intrinsic(m_code.calls[instruction.a])) return false;
            break;
        case Op::IsZero:
            top().integer = top().integer == 0;
            break;
        case Op::Jump:
            at = instruction.a;
            break;
        case Op::JumpIfFalse:
            if (pop().integer == 0) at = instruction.a;
            break;
        case Op::JumpKeepFalse:
            if (top().integer == 0)
                at = instruction.a;
            else
                pop();
            break;
        case Op::JumpKeepTrue:
            if (top().integer != 0)
                at = instruction.a;
            else
                pop();
            break;
        }
    }
    result = pop();
    return true;
}

} // namespace plc::expression
