// An ST expression anywhere (D7): watch, trigger, breakpoint condition, panel binding, alarm, assertion. Compiled once
// (by compiler/driver, from the checked tree) into a small code, evaluated on any image, live or recorded. No side
// effects; an error gives no value and a reason. Immutable after compiling; evaluate from any thread, each on its own
// image.
#pragma once
#include "runtime/image/layout.h"
#include "runtime/library/evaluate.h"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace plc::expression {

/// One step of the small code: a stack machine over Values, with quick paths for scalars.
struct Code; // expression/code.h

struct Outcome {
    types::Value value; // no value when `reason` is set
    Message reason;     // "index 7 is outside 1..5", "the reference is NULL"
    [[nodiscard]] bool hasValue() const { return value.hasValue(); }
};

/// Bytes of the image an expression reads directly; empty `isComplete` = through references, so any byte may matter.
struct ReadSet {
    std::vector<image::AreaRange> ranges;
    bool isComplete = true;
};

class Expression {
public:
    Expression() = default;
    Expression(std::string text, std::shared_ptr<const types::TypeTable> types, std::shared_ptr<const Code> code,
               types::TypeId type);

    [[nodiscard]] bool isValid() const { return m_code != nullptr; }
    [[nodiscard]] const std::string& text() const { return m_text; }
    [[nodiscard]] types::TypeId type() const { return m_type; }
    [[nodiscard]] const types::TypeTable& types() const { return *m_types; }
    /// Set when the expression is nothing but a variable: the place it names (write, force, fast series).
    [[nodiscard]] std::optional<image::Place> place() const;
    [[nodiscard]] ReadSet reads() const;

    [[nodiscard]] Outcome evaluate(std::span<const std::byte> image) const;
    /// Quick forms for triggers and charts; none when there is no value. BOOL gives 0/1, enums and times their number.
    [[nodiscard]] std::optional<double> number(std::span<const std::byte> image) const;
    /// Of integers, enums, times and dates without rounding; LWORD and ULINT as their bits.
    [[nodiscard]] std::optional<int64_t> integer(std::span<const std::byte> image) const;
    [[nodiscard]] bool isTrue(std::span<const std::byte> image) const;

private:
    std::string m_text;
    std::shared_ptr<const types::TypeTable> m_types;
    std::shared_ptr<const Code> m_code;
    types::TypeId m_type;
    types::TypeKind m_kind = types::TypeKind::Unknown; // that stores m_type
};

} // namespace plc::expression
