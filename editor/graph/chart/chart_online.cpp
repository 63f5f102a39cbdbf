// What a chart shows of a running or recorded controller: lit steps with their time, conditions, the last taken path,
// the qualifiers.
#include "editor/graph/chart/chart_items.h"
#include "editor/graph/chart/chart_view.h"
#include "editor/kit/texts.h"
#include "runtime/base/text.h"

#include <algorithm>

namespace plc::editor {

namespace {
constexpr double kFadeMs = 1500;
constexpr double kFadeNs = kFadeMs * 1e6;

/// Does an association ask for its action, given its step (2.6.4.4)?
bool asks(std::string_view qualifier, const ChartOnline::StepState& step, bool on, bool off, int64_t since,
          int64_t time) {
    const std::string q = foldCase(qualifier);
    if (q == "p" || q == "p1") return on;
    if (q == "p0") return off;
    if (q == "l" || q == "sl") return step.isActive && since < time;
    if (q == "d" || q == "ds" || q == "sd") return step.isActive && since >= time;
    return step.isActive;
}
} // namespace

void ChartView::setPast(bool isPast) {
    if (m_isPast == isPast) return;
    m_isPast = isPast;
    std::fill(m_takenAt.begin(), m_takenAt.end(), -100000);
    std::fill(m_enteredBy.begin(), m_enteredBy.end(), -1);
    std::fill(m_wasActive.begin(), m_wasActive.end(), false);
}

void ChartView::refreshOnline() {
    if (!m_values || !m_chart || !isVisible() || m_isStale) return;
    ChartOnline online;
    const qint64 now = m_clock.elapsed();
    const QRectF seen = m_canvas->mapToScene(m_canvas->viewport()->rect()).boundingRect().adjusted(-40, -80, 40, 80);
    const size_t count = m_chart->steps.size();
    std::vector<bool> active(count);
    std::vector<int64_t> since(count, 0);
    online.steps.resize(count);
    online.associations.resize(count);
    for (size_t i = 0; i < count; ++i) {
        const syntax::StepDecl& step = *m_chart->steps[i].decl;
        const QString name = kit::fromView(step.name.text);
        const ChartValue x = m_values(name + ".X");
        if (!x.text.isEmpty())
            online.isOn = true;
        else if (i == 0)
            break; // not running: nothing has a value
        ChartOnline::StepState& state = online.steps[i];
        active[i] = state.isActive = x.isTrue;
        state.isForced = x.isForced;
        if (state.isActive) {
            const ChartValue t = m_values(name + ".T");
            since[i] = t.nanoseconds;
            state.time = t.text.section('#', 1);
            for (const syntax::Pragma& pragma : step.pragmas)
                if (equalsIgnoringCase(pragma.key, "maxTime"))
                    state.isLate = since[i] > m_values(kit::fromView(pragma.value)).nanoseconds;
        }
        online.associations[i].resize(step.actions.size());
        const bool isSeen = m_scene->stepRect(static_cast<int>(i)).adjusted(0, 0, 400, 0).intersects(seen);
        for (size_t k = 0; k < step.actions.size(); ++k) {
            const syntax::ActionAssociation& action = step.actions[k];
            const QString key = kit::fromView(action.action.text).toLower();
            if (!online.actions.contains(key)) {
                const QString control = QString::fromStdString(controlVariable(m_place.number, action.action.text));
                online.actions[key] =
                    (isSeen || state.isActive) && (m_values(control + ".Q").isTrue || m_values(control + ".B").isTrue);
            }
            ChartOnline::ActionState& shown = online.associations[i][k];
            shown.isActive = online.actions[key];
            if (!isSeen) continue;
            const int64_t time = action.time ? m_values(kit::fromView(std::string_view(m_text).substr(
                                                            action.time->range.begin, action.time->range.length())))
                                                   .nanoseconds
                                             : 0;
            const bool edges =
                !action.qualifier.text.empty() && (action.qualifier.text[0] == 'P' || action.qualifier.text[0] == 'p');
            shown.asks = asks(action.qualifier.text, state, edges && m_values(name + ".on").isTrue,
                              edges && m_values(name + ".off").isTrue, since[i], time);
            if (action.time && state.isActive && time > 0)
                shown.progress = std::min(1.0, static_cast<double>(since[i]) / static_cast<double>(time));
        }
    }
    if (online.isOn) {
        for (size_t i = 0; i < m_chart->transitions.size(); ++i) {
            const chart::Transition& transition = m_chart->transitions[i];
            const bool isSeen = m_scene->barRect(static_cast<int>(i)).adjusted(0, 0, 400, 0).intersects(seen);
            ChartValue value;
            if (isSeen && !transition.decl->condition && i < m_listConditions.size() && !m_listConditions[i].isEmpty())
                value = m_values(m_listConditions[i]);
            if (isSeen && transition.decl->condition)
                value = m_values(kit::fromView(std::string_view(m_text).substr(
                    transition.decl->condition->range.begin, transition.decl->condition->range.length())));
            online.transitions.push_back(value.text.isEmpty() ? std::nullopt : std::optional(value.isTrue));
            // The last path: by the flag of this scan, by what changed since the last look, and by the age of the step
            // it led to.
            const bool left = std::any_of(transition.from.begin(), transition.from.end(), [&](chart::StepId step) {
                return m_wasActive[step.index()] && !active[step.index()];
            });
            const bool entered = std::any_of(transition.to.begin(), transition.to.end(), [&](chart::StepId step) {
                return !m_wasActive[step.index()] && active[step.index()];
            });
            const bool fired = (isSeen || left || entered) &&
                               m_values(QString::fromStdString(firedVariable(m_place.number, i))).isTrue;
            if (fired || (left && entered && !m_isPast)) {
                m_takenAt[i] = now;
                for (const chart::StepId step : transition.to) m_enteredBy[step.index()] = static_cast<int>(i);
            }
            double taken = fired ? 1.0 : 0.0;
            for (const chart::StepId step : transition.to) {
                const bool isOnlyWay = m_chart->steps[step.index()].in.size() == 1;
                if (active[step.index()] && (isOnlyWay || m_enteredBy[step.index()] == static_cast<int>(i)))
                    taken = std::max(taken, 1.0 - static_cast<double>(since[step.index()]) / kFadeNs);
            }
            if (!m_isPast) taken = std::max(taken, 1.0 - static_cast<double>(now - m_takenAt[i]) / kFadeMs);
            online.taken.push_back(std::clamp(taken, 0.0, 1.0));
        }
        m_wasActive = active;
    }
    if (online.isOn || m_scene->online().isOn) {
        if (!online.isOn) online = {};
        m_scene->setOnline(std::move(online));
    }
}

} // namespace plc::editor
