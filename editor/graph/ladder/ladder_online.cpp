// What a ladder or function block diagram shows of a controller: the power behind each part as the scan computed it
// there, values at pins, progress of timers and counters, forced variables.
#include "editor/graph/ladder/ladder_view.h"
#include "editor/kit/texts.h"

#include <algorithm>

namespace plc::editor {

using ladder::NodeId;
using ladder::NodeKind;
using ladder::Power;
using ladder::RungId;

namespace {

constexpr int kLongestValue = 24;

/// Numbers, times and texts are no power.
Power powerOf(const GraphValue& value) {
    if (value.isTrue) return Power::On;
    return value.text == "FALSE" ? Power::Off : Power::Unknown;
}

} // namespace

double LadderView::progressOf(const ladder::Node& box) const {
    if (box.instance.empty()) return -1;
    const QString instance = kit::fromView(box.instance);
    for (const auto& [done, all] : {std::pair{".ET", ".PT"}, std::pair{".CV", ".PV"}}) {
        const GraphValue part = m_values(instance + done), whole = m_values(instance + all);
        if (part.text.isEmpty() || whole.text.isEmpty()) continue;
        const double limit = whole.nanoseconds ? static_cast<double>(whole.nanoseconds) : whole.text.toDouble();
        const double value = whole.nanoseconds ? static_cast<double>(part.nanoseconds) : part.text.toDouble();
        return limit > 0 ? std::clamp(value / limit, 0.0, 1.0) : -1;
    }
    return -1;
}

/// As it was computed there; a constant, and what nobody looked into, as it is at the scan's end.
GraphValue LadderView::valueOf(const ladder::Question& question, const ComputedValues* computed) const {
    if (computed && computed->covers(question.range))
        if (auto exact = computed->at(question.range)) return *exact;
    return m_values(QString::fromStdString(question.text));
}

/// At pins; contacts and coils show theirs as power.
void LadderView::showValues(const ladder::Node& node, NodeId id, const ComputedValues* computed,
                            LadderOnline& out) const {
    if (node.operand) {
        out.forced[id.index()] = m_values(kit::fromView(node.label)).isForced;
        const bool isLiteral = node.operand->kind == syntax::ExprKind::Literal;
        if (node.kind == NodeKind::Operand && !isLiteral)
            out.values[id.index()] =
                valueOf(ladder::questionOf(m_text, m_diagram, id), computed).text.left(kLongestValue);
    }
    if (node.kind != NodeKind::Box) return;
    out.progress[id.index()] = progressOf(node);
    QStringList texts;
    for (const ladder::OutputPin& pin : node.outputs) {
        std::string text = pin.target;
        if (text.empty() || pin.source.length() == 0) {
            texts << (text.empty() ? QString() : m_values(kit::fromView(text)).text.left(kLongestValue));
            continue;
        }
        texts << valueOf({std::move(text), pin.source, nullptr}, computed).text.left(kLongestValue);
    }
    out.outputs.insert(id.value, texts);
}

/// Of the rungs that are seen; the others follow when they come into view.
LadderOnline LadderView::online() const {
    LadderOnline out;
    const size_t count = m_diagram.nodes.size();
    out.power.assign(count, Power::Unknown);
    out.values.resize(count);
    out.progress.assign(count, -1);
    out.forced.assign(count, false);
    out.leftOut.assign(m_diagram.rungs.size(), false);
    const std::shared_ptr<const ComputedValues> computed = m_computed ? m_computed() : nullptr;
    out.isExact = computed != nullptr;
    const ladder::Answers answers = [&](const ladder::Question& question) {
        const GraphValue value = valueOf(question, computed.get());
        out.isOn |= !value.text.isEmpty();
        return powerOf(value);
    };
    ladder::Executed isExecuted;
    if (computed)
        isExecuted = [&](SourceRange range) { return !computed->covers(range) || computed->isExecuted(range); };
    const QRectF seen = m_canvas->mapToScene(m_canvas->viewport()->rect()).boundingRect();
    const auto [first, last] = m_scene->rungsIn(seen);
    for (size_t i = first; i < last; ++i) {
        const ladder::Rung& rung = m_diagram.rungs[i];
        ladder::computeFlow(m_text, m_diagram, rung, answers, out.power, isExecuted);
        out.leftOut[i] = !ladder::isRungExecuted(m_diagram, rung, isExecuted);
        out.isOn |= out.leftOut[i];
        if (out.leftOut[i]) continue;
        for (const NodeId id : m_diagram.nodesOf(rung)) showValues(m_diagram[id], id, computed.get(), out);
    }
    return out;
}

void LadderView::refreshOnline() {
    if (!m_syntax || m_isStale || !isVisible() || !m_values) return;
    LadderOnline state = online();
    if (!state.isOn) state = {};
    m_scene->setOnline(std::move(state));
}

} // namespace plc::editor
