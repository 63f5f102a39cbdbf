#include "runtime/expression/expression.h"

#include "runtime/base/messages.h"
#include "runtime/expression/machine.h"

namespace plc::expression {

Expression::Expression(std::string text, std::shared_ptr<const types::TypeTable> types,
                       std::shared_ptr<const Code> code, types::TypeId type)
    : m_text(std::move(text)), m_types(std::move(types)), m_code(std::move(code)), m_type(type),
      m_kind(m_types->storageKind(type)) {}

std::optional<image::Place> Expression::place() const { return m_code ? m_code->place : std::nullopt; }

ReadSet Expression::reads() const { return m_code ? m_code->reads : ReadSet{}; }

Outcome Expression::evaluate(std::span<const std::byte> image) const {
    if (!m_code) return {{}, errors::NoExpression()};
    Machine machine(*m_types, *m_code, image);
    Slot result;
    if (!machine.run(result)) return {{}, machine.failure().message()};
    return {machine.valueOf(result, m_type), {}};
}

std::optional<double> Expression::number(std::span<const std::byte> image) const {
    if (!m_code) return std::nullopt;
    if (!types::isElementary(m_kind)) return std::nullopt;
    Machine machine(*m_types, *m_code, image);
    Slot result;
    if (!machine.run(result)) return std::nullopt;
    if (types::familyOf(m_kind) == types::Family::Real) return result.real;
    if (m_kind == types::TypeKind::Ulint || m_kind == types::TypeKind::Lword)
        return static_cast<double>(static_cast<uint64_t>(result.integer));
    return static_cast<double>(result.integer);
}

std::optional<int64_t> Expression::integer(std::span<const std::byte> image) const {
    if (!m_code || !types::isElementary(m_kind) || types::familyOf(m_kind) == types::Family::Real) return std::nullopt;
    Machine machine(*m_types, *m_code, image);
    Slot result;
    if (!machine.run(result)) return std::nullopt;
    return result.integer;
}

bool Expression::isTrue(std::span<const std::byte> image) const {
    if (!m_code || m_kind != types::TypeKind::Bool) return false;
    Machine machine(*m_types, *m_code, image);
    Slot result;
    return machine.run(result) && result.integer != 0;
}

} // namespace plc::expression
