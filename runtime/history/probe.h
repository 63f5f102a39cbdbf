// An expression as a query over several program versions reads it: the words it watches, its value as a number or as it
// is. A plain variable is read straight from the bytes. Reader.
#pragma once
#include "runtime/history/replay.h"

#include <map>

namespace plc::history {

class Probe {
public:
    Probe(expression::Expression expression, const Segment& segment);
    [[nodiscard]] const Watched& watched() const { return m_watched; }
    [[nodiscard]] std::optional<double> number(std::span<const std::byte> image) const;
    /// The same without rounding, of what a double cannot hold (64-bit integers, times, dates); else none.
    [[nodiscard]] std::optional<int64_t> wide(std::span<const std::byte> image) const;
    [[nodiscard]] bool isTrue(std::span<const std::byte> image) const;
    /// Equal exactly when the values are equal (NaN equals itself).
    [[nodiscard]] std::string fingerprint(std::span<const std::byte> image) const;

private:
    expression::Expression m_expression;
    std::optional<image::Place> m_place; // a scalar variable
    types::TypeKind m_kind = types::TypeKind::Unknown;
    bool m_isWide = false;
    Watched m_watched;
};

/// Probes by program version; a version the expression has no meaning in has none.
class Probes {
public:
    Probes(const expression::Expression& expression, const Recompile& recompile)
        : m_expression(expression), m_recompile(recompile) {}
    [[nodiscard]] const Probe* of(const Segment& segment);
    /// Scratch image, large enough for the segment's program.
    [[nodiscard]] std::span<std::byte> image(const Segment& segment);

private:
    const expression::Expression& m_expression;
    const Recompile& m_recompile;
    std::map<const image::CompiledProgram*, std::unique_ptr<Probe>> m_probes;
    std::vector<std::byte> m_image;
};

} // namespace plc::history
