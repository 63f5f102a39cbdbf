#include "hmi/view/scene/value_source.h"

namespace plc::hmi {

BindingId HeldValues::bind(const QString& expression) {
    const QString text = expression.trimmed();
    if (text.isEmpty()) return {};
    const auto found = m_ids.constFind(text);
    if (found != m_ids.constEnd()) return {*found};
    const int index = static_cast<int>(m_entries.size());
    m_ids.insert(text, index);
    Entry entry;
    bool isNumber = false;
    const double number = text.toDouble(&isNumber);
    if (isNumber)
        entry.value = text.contains(u'.') ? Value::ofReal(number) : Value::ofInteger(text.toLongLong());
    else if (text.compare(QStringLiteral("TRUE"), Qt::CaseInsensitive) == 0)
        entry.value = Value::ofBool(true);
    else if (text.compare(QStringLiteral("FALSE"), Qt::CaseInsensitive) == 0)
        entry.value = Value::ofBool(false);
    m_entries.push_back(std::move(entry));
    return {index};
}

void HeldValues::set(const QString& expression, Value value) {
    const BindingId id = bind(expression);
    if (!id.isValid()) return;
    Entry& entry = m_entries[static_cast<size_t>(id.index)];
    entry.value = std::move(value);
    if (entry.facts.kind == ValueKind::None) entry.facts.kind = entry.value.kind();
    ++m_revision;
}

void HeldValues::setFacts(const QString& expression, ValueFacts facts) {
    const BindingId id = bind(expression);
    if (id.isValid()) m_entries[static_cast<size_t>(id.index)].facts = std::move(facts);
}

void HeldValues::setCurve(const QString& expression, std::vector<CurvePiece> pieces) {
    const BindingId id = bind(expression);
    if (id.isValid()) m_entries[static_cast<size_t>(id.index)].curve = std::move(pieces);
    ++m_revision;
}

const Value& HeldValues::value(BindingId binding) const {
    static const Value none;
    return binding.isValid() ? m_entries[static_cast<size_t>(binding.index)].value : none;
}

ValueFacts HeldValues::facts(BindingId binding) const {
    return binding.isValid() ? m_entries[static_cast<size_t>(binding.index)].facts : ValueFacts();
}

std::vector<CurvePiece> HeldValues::curve(BindingId binding, double, int) const {
    return binding.isValid() ? m_entries[static_cast<size_t>(binding.index)].curve : std::vector<CurvePiece>();
}

} // namespace plc::hmi
