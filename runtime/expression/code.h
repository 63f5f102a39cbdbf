// The small code of an expression: a stack machine over 64-bit slots (integers, doubles, image offsets); texts and
// aggregates lie in a side list that scalar code never touches. Made by compiler/driver through CodeBuilder; immutable
// afterwards, any thread.
#pragma once
#include "runtime/expression/expression.h"

namespace plc::expression {

enum class Op : uint8_t {
    Constant,      // a, b: low and high half of the slot (scalar)
    Object,        // a: constants index (text, aggregate)
    Offset,        // a: image offset → slot
    Load,          // a: image offset, bit; b: type
    LoadAt,        // pops an offset; bit; b: type
    AddOffset,     // a: bytes
    Index,         // offset, index → offset; a: bounds index
    OpenIndex,     // slot's offset, index… → offset; a: rank, b: bytes of an element
    FollowInOut,   // slot's offset → offset of the variable; b: type of the variable
    Dereference,   // pointer → offset, checked; b: type of the variable
    Character,     // text's offset, index → character; b: type of the text
    Unary,         // extra: UnaryOp; kind; b: type
    Binary,        // extra: BinaryOp; kind; b: operand type
    Convert,       // a: from type, b: to type
    Intrinsic,     // a: calls index
    IsZero,        // pointer or interface → BOOL
    Jump,          // a: instruction
    JumpIfFalse,   // pops; a: instruction
    JumpKeepFalse, // top FALSE: jumps and keeps it, else pops it (AND_THEN)
    JumpKeepTrue,  // OR_ELSE
};

struct Instruction {
    Op op;
    types::TypeKind kind = types::TypeKind::Unknown;
    int8_t bit = -1;
    uint8_t extra = 0;
    uint32_t a = 0;
    uint32_t b = 0;
};

struct Bounds {
    int64_t low, high;
    uint32_t stride; // bytes from one index to the next
};

struct IntrinsicCall {
    library::Intrinsic intrinsic;
    types::TypeId result;
    std::vector<types::TypeId> operands;
    int64_t selector;
};

struct Code {
    std::vector<Instruction> instructions;
    std::vector<types::Value> constants;
    std::vector<Bounds> bounds;
    std::vector<IntrinsicCall> calls;
    std::optional<image::Place> place;
    ReadSet reads;
    uint32_t directEnd = 0; // end of the last byte that a Load reads
};

/// Slots that an evaluation may need; deeper expressions are refused when they are compiled.
inline constexpr uint32_t kMaximumSlots = 128;

/// Writes code from left to right and keeps count of the slots in use.
class CodeBuilder {
public:
    void constant(const types::TypeTable& types, const types::Value& value);
    void offset(uint32_t offset);
    void load(const types::TypeTable& types, image::Place place);
    void loadAt(const types::TypeTable& types, types::TypeId type, int bit);
    void addOffset(uint32_t bytes);
    void index(const Bounds& bounds);
    void openIndex(uint32_t rank, uint32_t elementSize);
    void followInOut(types::TypeId type);
    void dereference(types::TypeId type);
    void character(types::TypeId text);
    void unary(const types::TypeTable& types, library::UnaryOp op, types::TypeId type);
    void binary(const types::TypeTable& types, library::BinaryOp op, types::TypeId operands);
    void convert(types::TypeId from, types::TypeId to);
    void intrinsic(IntrinsicCall call);
    void isZero();
    /// A jump forward; `land` it where it leads.
    [[nodiscard]] size_t jump(Op op);
    void land(size_t jump);
    /// Two ways that leave one value each: call before the second.
    void otherWay() { --m_slots; }

    void setPlace(image::Place place) { m_code.place = place; }
    void reads(uint32_t offset, uint32_t size);
    void readsAnything() { m_code.reads.isComplete = false; }
    [[nodiscard]] bool isTooDeep() const { return m_most > kMaximumSlots; }
    [[nodiscard]] std::shared_ptr<const Code> finish();

private:
    Instruction& add(Instruction instruction, int slots);
    Code m_code;
    uint32_t m_slots = 0, m_most = 0;
};

} // namespace plc::expression
