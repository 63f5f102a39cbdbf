#include "runtime/history/probe.h"

namespace plc::history {

using types::TypeKind;

namespace {

template <class T> double numberAt(const std::byte* at) {
    T value;
    std::memcpy(&value, at, sizeof value);
    return static_cast<double>(value);
}

std::optional<double> scalar(TypeKind kind, const std::byte* at, int bit) {
    if (bit >= 0) return static_cast<double>(static_cast<unsigned>(*at) >> bit & 1);
    switch (kind) {
    case TypeKind::Bool:
        return static_cast<unsigned>(*at) != 0 ? 1.0 : 0.0;
    case TypeKind::Byte:
    case TypeKind::Usint:
    case TypeKind::Char:
        return numberAt<uint8_t>(at);
    case TypeKind::Sint:
        return numberAt<int8_t>(at);
    case TypeKind::Word:
    case TypeKind::Uint:
    case TypeKind::Wchar:
        return numberAt<uint16_t>(at);
    case TypeKind::Int:
        return numberAt<int16_t>(at);
    case TypeKind::Dword:
    case TypeKind::Udint:
        return numberAt<uint32_t>(at);
    case TypeKind::Dint:
        return numberAt<int32_t>(at);
    case TypeKind::Lword:
    case TypeKind::Ulint:
        return numberAt<uint64_t>(at);
    case TypeKind::Real:
        return numberAt<float>(at);
    case TypeKind::Lreal:
        return numberAt<double>(at);
    default:
        return numberAt<int64_t>(at); // LINT, durations, dates
    }
}

bool isScalar(TypeKind kind) {
    return types::isElementary(kind) && static_cast<size_t>(kind) <= static_cast<size_t>(TypeKind::Wchar);
}

void appendPrint(std::string& out, const types::Value& value) {
    out += static_cast<char>('0' + value.data.index());
    const auto raw = [&](const void* bytes, size_t size) { out.append(static_cast<const char*>(bytes), size); };
    if (const auto* integer = std::get_if<int64_t>(&value.data)) raw(integer, 8);
    if (const auto* real = std::get_if<double>(&value.data)) raw(real, 8);
    if (const auto* text = std::get_if<std::string>(&value.data)) out += *text + '\0';
    if (const auto* wide = std::get_if<std::u16string>(&value.data)) raw(wide->data(), wide->size() * 2), out += '\0';
    if (const auto* parts = std::get_if<std::vector<types::Value>>(&value.data))
        for (const types::Value& part : *parts) appendPrint(out, part);
}

bool isWide(const types::TypeTable& table, types::TypeId id) {
    const TypeKind kind = table.storageKind(id);
    return types::isElementary(kind) && table[id].size == 8 && kind != TypeKind::Lreal;
}

} // namespace

Probe::Probe(expression::Expression expression, const Segment& segment) : m_expression(std::move(expression)) {
    m_isWide = isWide(m_expression.types(), m_expression.type());
    const std::optional<image::Place> place = m_expression.place();
    if (place && segment.program) {
        const types::TypeTable& types = *segment.program->layout.types;
        m_kind = types.storageKind(place->type);
        const uint32_t size = place->bit >= 0 ? 1 : types[place->type].size;
        if (isScalar(m_kind) && place->offset + size <= segment.dataEnd) m_place = place;
        m_watched = watchedBytes({{place->offset, size}}, place->offset + size <= segment.dataEnd, segment.dataEnd);
        return;
    }
    const expression::ReadSet reads = m_expression.reads();
    m_watched = watchedBytes(reads.ranges, reads.isComplete, segment.dataEnd);
}

std::optional<double> Probe::number(std::span<const std::byte> image) const {
    return m_place ? scalar(m_kind, image.data() + m_place->offset, m_place->bit) : m_expression.number(image);
}

std::optional<int64_t> Probe::wide(std::span<const std::byte> image) const {
    if (!m_isWide) return std::nullopt;
    if (!m_place || m_place->bit >= 0) return m_expression.integer(image);
    int64_t bits;
    std::memcpy(&bits, image.data() + m_place->offset, sizeof bits);
    return bits;
}

bool Probe::isTrue(std::span<const std::byte> image) const {
    return m_place && m_kind == TypeKind::Bool ? number(image) != 0.0 : m_expression.isTrue(image);
}

std::string Probe::fingerprint(std::span<const std::byte> image) const {
    std::string print;
    appendPrint(print, m_expression.evaluate(image).value);
    return print;
}

const Probe* Probes::of(const Segment& segment) {
    const image::CompiledProgram* program = segment.program.get();
    const auto [entry, isNew] = m_probes.try_emplace(program);
    if (!isNew) return entry->second.get();
    const bool isOwn = m_expression.isValid() && program && &m_expression.types() == program->layout.types.get();
    expression::Expression own = isOwn || !program ? m_expression
                                 : m_recompile     ? m_recompile(*program)
                                                   : expression::Expression();
    if (own.isValid()) entry->second = std::make_unique<Probe>(std::move(own), segment);
    return entry->second.get();
}

std::span<std::byte> Probes::image(const Segment& segment) {
    const size_t size =
        std::max<size_t>(size_t(segment.blocks) * kBlock, segment.program ? segment.program->layout.imageSize : 0);
    if (m_image.size() < size) m_image.assign(size, std::byte{});
    return std::span(m_image).first(size);
}

} // namespace plc::history
