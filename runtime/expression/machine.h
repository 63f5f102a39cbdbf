// Runs the code of one expression on one image. Lives for one evaluation; nothing is allocated for scalars.
#pragma once
#include "runtime/expression/code.h"

namespace plc::expression {

union Slot {
    int64_t integer; // also image offsets, and indices of objects
    double real;
};

/// Why there is no value; words are made of it only when somebody asks.
struct Failure {
    enum class Kind : uint8_t {
        None,
        Index,
        Null,
        Foreign,
        MissingInOut,
        Character,
        DivisionByZero,
        OtherImage,
        NotEvaluable
    } kind = Kind::None;
    int64_t detail[3] = {};
    [[nodiscard]] Message message() const;
};

class Machine {
public:
    Machine(const types::TypeTable& types, const Code& code, std::span<const std::byte> image)
        : m_types(types), m_code(code), m_image(image) {}

    /// False: see failure().
    [[nodiscard]] bool run(Slot& result);
    [[nodiscard]] const Failure& failure() const { return m_failure; }
    [[nodiscard]] types::Value valueOf(Slot slot, types::TypeId type) const;

private:
    bool fail(Failure::Kind kind, int64_t a = 0, int64_t b = 0, int64_t c = 0);
    bool fail(library::EvaluationError error);
    [[nodiscard]] bool isInside(int64_t offset, uint32_t size) const;
    [[nodiscard]] int64_t wordAt(int64_t offset) const;
    [[nodiscard]] Slot load(const Instruction& instruction, int64_t offset);
    [[nodiscard]] Slot slotOf(types::Value&& value);
    [[nodiscard]] Slot object(types::Value&& value);
    bool index(const Bounds& bounds);
    bool openIndex(uint32_t rank, uint32_t elementSize);
    bool character(types::TypeId text);
    bool unary(const Instruction& instruction);
    bool binary(const Instruction& instruction);
    bool slowBinary(const Instruction& instruction, Slot a, Slot b);
    bool convert(const Instruction& instruction);
    bool intrinsic(const IntrinsicCall& call);
    Slot& top() { return m_stack[m_used - 1]; }
    Slot pop() { return m_stack[--m_used]; }
    void push(Slot slot) { m_stack[m_used++] = slot; }

    const types::TypeTable& m_types;
    const Code& m_code;
    std::span<const std::byte> m_image;
    Failure m_failure;
    uint32_t m_used = 0;
    std::vector<types::Value> m_objects;
    Slot m_stack[kMaximumSlots];
};

} // namespace plc::expression
