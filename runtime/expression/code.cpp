#include "runtime/expression/code.h"

#include "runtime/base/assert.h"

#include <algorithm>
#include <bit>

namespace plc::expression {
namespace {

bool isObject(const types::Value& value) {
    return !std::holds_alternative<int64_t>(value.data) && !std::holds_alternative<double>(value.data);
}

uint32_t bytesOf(const types::TypeTable& types, const image::Place& place) {
    return place.bit >= 0 ? 1 : types[place.type].size;
}

} // namespace

Instruction& CodeBuilder::add(Instruction instruction, int slots) {
    m_slots = static_cast<uint32_t>(static_cast<int>(m_slots) + slots);
    m_most = std::max(m_most, m_slots);
    m_code.instructions.push_back(instruction);
    return m_code.instructions.back();
}

void CodeBuilder::constant(const types::TypeTable& types, const types::Value& value) {
    const types::TypeKind kind = types.storageKind(value.type);
    if (isObject(value)) {
        add({.op = Op::Object, .kind = kind, .a = static_cast<uint32_t>(m_code.constants.size())}, 1);
        m_code.constants.push_back(value);
        return;
    }
    const auto* real = std::get_if<double>(&value.data);
    const auto bits = real ? std::bit_cast<uint64_t>(*real) : static_cast<uint64_t>(value.integer());
    add({.op = Op::Constant, .kind = kind, .a = static_cast<uint32_t>(bits), .b = static_cast<uint32_t>(bits >> 32)},
        1);
}

void CodeBuilder::offset(uint32_t offset) { add({.op = Op::Offset, .a = offset}, 1); }

void CodeBuilder::load(const types::TypeTable& types, image::Place place) {
    add({.op = Op::Load,
         .kind = types.storageKind(place.type),
         .bit = static_cast<int8_t>(place.bit),
         .a = place.offset,
         .b = place.type.value},
        1);
    reads(place.offset, bytesOf(types, place));
    m_code.directEnd = std::max(m_code.directEnd, place.offset + bytesOf(types, place));
}

void CodeBuilder::loadAt(const types::TypeTable& types, types::TypeId type, int bit) {
    add({.op = Op::LoadAt, .kind = types.storageKind(type), .bit = static_cast<int8_t>(bit), .b = type.value}, 0);
}

void CodeBuilder::addOffset(uint32_t bytes) {
    if (bytes != 0) add({.op = Op::AddOffset, .a = bytes}, 0);
}

void CodeBuilder::index(const Bounds& bounds) {
    add({.op = Op::Index, .a = static_cast<uint32_t>(m_code.bounds.size())}, -1);
    m_code.bounds.push_back(bounds);
}

void CodeBuilder::openIndex(uint32_t rank, uint32_t elementSize) {
    add({.op = Op::OpenIndex, .a = rank, .b = elementSize}, -static_cast<int>(rank));
}
void CodeBuilder::followInOut(types::TypeId type) { add({.op = Op::FollowInOut, .b = type.value}, 0); }
void CodeBuilder::dereference(types::TypeId type) { add({.op = Op::Dereference, .b = type.value}, 0); }
void CodeBuilder::character(types::TypeId text) { add({.op = Op::Character, .b = text.value}, -1); }

void CodeBuilder::unary(const types::TypeTable& types, library::UnaryOp op, types::TypeId type) {
    add({.op = Op::Unary, .kind = types.storageKind(type), .extra = static_cast<uint8_t>(op), .b = type.value}, 0);
}

void CodeBuilder::binary(const types::TypeTable& types, library::BinaryOp op, types::TypeId operands) {
    add({.op = Op::Binary, .kind = types.storageKind(operands), .extra = static_cast<uint8_t>(op), .b = operands.value},
        -1);
}

void CodeBuilder::convert(types::TypeId from, types::TypeId to) {
    if (from != to) add({.op = Op::Convert, .a = from.value, .b = to.value}, 0);
}

void CodeBuilder::intrinsic(IntrinsicCall call) {
    using library::Intrinsic;
    switch (call.intrinsic) {
#define PLC_OF_SCAN(Name, field) case Intrinsic::Name:
#include "runtime/library/intrinsic_meanings.def"
        reads(0, sizeof(image::ImageHeader));
        m_code.directEnd = std::max<uint32_t>(m_code.directEnd, sizeof(image::ImageHeader));
        break;
    default:
        break;
    }
    add({.op = Op::Intrinsic, .a = static_cast<uint32_t>(m_code.calls.size())},
        1 - static_cast<int>(call.operands.size()));
    m_code.calls.push_back(std::move(call));
}

void CodeBuilder::isZero() { add({.op = Op::IsZero}, 0); }

size_t CodeBuilder::jump(Op op) {
    add({.op = op}, op == Op::Jump ? 0 : -1);
    return m_code.instructions.size() - 1;
}

void CodeBuilder::land(size_t jump) { m_code.instructions[jump].a = static_cast<uint32_t>(m_code.instructions.size()); }

void CodeBuilder::reads(uint32_t offset, uint32_t size) { m_code.reads.ranges.push_back({offset, size}); }

std::shared_ptr<const Code> CodeBuilder::finish() {
    PLC_ASSERT(m_slots == 1, return nullptr);
    auto& ranges = m_code.reads.ranges;
    std::ranges::sort(ranges, {}, &image::AreaRange::begin);
    std::vector<image::AreaRange> merged;
    for (const image::AreaRange& range : ranges) {
        if (range.size == 0) continue;
        if (!merged.empty() && range.begin <= merged.back().begin + merged.back().size) {
            const uint32_t end = std::max(merged.back().begin + merged.back().size, range.begin + range.size);
            merged.back().size = end - merged.back().begin;
        } else {
            merged.push_back(range);
        }
    }
    ranges = std::move(merged);
    return std::make_shared<const Code>(std::move(m_code));
}

} // namespace plc::expression
