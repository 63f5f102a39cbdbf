#include "runtime/inside/slow_scan.h"

#include "runtime/base/text.h"
#include "runtime/compiler/driver/driver.h"
#include "runtime/debug/frames.h"
#include "runtime/inside/texts.h"

#include <algorithm>
#include <cstring>

namespace plc::inside {

using debug::Step;
using image::WatchKind;

SlowScan::SlowScan(std::shared_ptr<const Look> look) : m_look(std::move(look)) {
    findStops();
    goTo(0);
}

/// The statements of the user's text, in the order in which they ran.
void SlowScan::findStops() {
    const std::span<const Event> events = m_look->events();
    std::vector<EventIndex> last(m_look->activations().size(), kNone); // stop of each activation
    for (EventIndex i = 0; i < events.size(); ++i) {
        const Event& event = events[i];
        if (event.kind == WatchKind::Write) m_writes.push_back(i);
        if (event.kind != WatchKind::Statement || event.stmt()->isHidden || !event.stmt()->range.file.isValid() ||
            event.stmt()->range.length() == 0)
            continue;
        // The call of a block is several statements of one text.
        const EventIndex before = last[event.activation];
        last[event.activation] = i;
        if (before != kNone && events[before].stmt()->range == event.stmt()->range &&
            m_look->passesAt(before) == m_look->passesAt(i))
            continue;
        m_stops.push_back(i);
    }
}

SourceRange SlowScan::range() const {
    return isAtEnd() ? SourceRange() : m_look->events()[m_stops[m_at]].stmt()->range;
}

EventIndex SlowScan::event() const {
    return isAtEnd() ? static_cast<EventIndex>(m_look->events().size()) : m_stops[m_at];
}

std::vector<uint64_t> SlowScan::passes() const {
    return isAtEnd() ? std::vector<uint64_t>() : m_look->passesAt(m_stops[m_at]);
}

// ---------------------------------------------------------------- what is seen

std::vector<SlowScan::Frame> SlowScan::stackTrace() const {
    std::vector<Frame> frames;
    if (isAtEnd()) return frames;
    EventIndex at = m_stops[m_at];
    for (uint32_t index = activationOf(m_at); index != kNone;) {
        const Activation& activation = m_look->activations()[index];
        Frame frame;
        frame.id = index;
        frame.function = m_look->program().functions[activation.function].name;
        frame.instance = m_look->instanceOf(index);
        if (activation.task != kNone) frame.task = m_look->program().tasks[activation.task].name;
        while (at > 0 &&
               (m_look->events()[at].kind != WatchKind::Statement || m_look->events()[at].activation != index))
            --at;
        if (m_look->events()[at].kind == WatchKind::Statement) frame.range = m_look->events()[at].stmt()->range;
        frames.push_back(std::move(frame));
        if (activation.call != kNone) at = activation.call;
        index = activation.parent;
    }
    return frames;
}

std::vector<SlowScan::Variable> SlowScan::variables(uint32_t frame, bool locals) const {
    const Activation& activation = m_look->activations()[frame];
    const bool hasInstance = m_look->tree().functions[activation.function].instanceType.isValid();
    controller::FaultFrame wanted;
    wanted.functionIndex = activation.function;
    if (locals) wanted.frameOffset = activation.frame;
    if (!locals && hasInstance) wanted.instanceOffset = activation.instance;
    const auto now = debug::frameVariables(m_look->program(), m_image, wanted);
    const auto before = debug::frameVariables(m_look->program(), m_before, wanted);
    std::vector<Variable> all;
    for (size_t i = 0; i < now.size(); ++i)
        all.push_back({now[i].name, now[i].value, i < before.size() && !(now[i].value == before[i].value)});
    return all;
}

std::vector<SlowScan::Scope> SlowScan::scopes(uint32_t frame) const {
    std::vector<Scope> all;
    if (frame >= m_look->activations().size()) return all;
    if (auto found = variables(frame, true); !found.empty()) all.push_back({Scope::Kind::Locals, {}, std::move(found)});
    if (auto found = variables(frame, false); !found.empty())
        all.push_back({Scope::Kind::Instance, m_look->instanceOf(frame), std::move(found)});
    return all;
}

Result<types::Value> SlowScan::evaluate(const std::string& text, uint32_t frame) {
    std::string instance;
    if (frame < m_look->activations().size()) {
        instance = m_look->instanceOf(frame);
        for (const Variable& local : variables(frame, true))
            if (foldCase(local.name) == foldCase(text)) return local.value;
    }
    const driver::Checked checked = driver::checkedOf(m_look->input().program);
    if (!checked.analysis) return Error{texts::NotBuiltFromSources(), {}};
    const auto expression = driver::compileExpression(checked, text, instance);
    if (!expression) return expression.error();
    const expression::Outcome outcome = expression->evaluate(m_image);
    if (!outcome.hasValue()) return Error{outcome.reason, text};
    return outcome.value;
}

std::vector<EventIndex> SlowScan::writes() const {
    if (m_at == 0) return {};
    const auto from = std::lower_bound(m_writes.begin(), m_writes.end(), m_stops[m_at - 1]);
    return {from, std::lower_bound(from, m_writes.end(), event())};
}

// ---------------------------------------------------------------- the image at a moment

void SlowScan::apply(const Event& event, std::vector<std::byte>& image) const {
    if (size_t(event.offset) + event.size > image.size()) return;
    const std::span<const std::byte> copied = m_look->bytesOf(event);
    if (!copied.empty()) {
        std::memcpy(image.data() + event.offset, copied.data(), std::min<size_t>(copied.size(), event.size));
    } else if (event.bit >= 0) {
        const auto mask = std::byte(1 << event.bit);
        image[event.offset] =
            (image[event.offset] & ~mask) | (static_cast<std::byte>(static_cast<uint8_t>(event.bits)) & mask);
    } else {
        std::memcpy(image.data() + event.offset, &event.bits, std::min<size_t>(sizeof event.bits, event.size));
    }
}

std::vector<std::byte> SlowScan::imageAt(size_t stop) const {
    std::vector<std::byte> image = m_look->input().image;
    for (const image::ForcedBytes& forced : m_look->input().start.forces) {
        if (size_t(forced.offset) + forced.size > image.size() || forced.bytes.size() < forced.size) continue;
        const auto mask = forced.bit >= 0 ? std::byte(1 << forced.bit) : std::byte(0xff);
        for (uint32_t i = 0; i < forced.size; ++i)
            image[forced.offset + i] = (image[forced.offset + i] & ~mask) | (forced.bytes[i] & mask);
    }
    const EventIndex end = stop < m_stops.size() ? m_stops[stop] : static_cast<EventIndex>(m_look->events().size());
    for (const EventIndex write : m_writes) {
        if (write >= end) break;
        apply(m_look->events()[write], image);
    }
    if (stop >= m_stops.size()) { // what the controller itself did at the end counts, too
        const std::span<const std::byte> after = m_look->image();
        std::copy(after.begin(), after.begin() + static_cast<std::ptrdiff_t>(std::min(after.size(), image.size())),
                  image.begin());
    }
    return image;
}

// ---------------------------------------------------------------- moving

void SlowScan::goTo(size_t stop) {
    m_at = std::min(stop, m_stops.size());
    m_image = imageAt(m_at);
    m_before = m_at > 0 ? imageAt(m_at - 1) : m_image;
}

uint32_t SlowScan::activationOf(size_t stop) const { return m_look->events()[m_stops[stop]].activation; }

bool SlowScan::isAround(uint32_t outer, uint32_t inner) const {
    for (; inner != kNone; inner = m_look->activations()[inner].parent)
        if (inner == outer) return true;
    return false;
}

/// Whether a step that begins at stop `from` ends at stop `to`.
bool SlowScan::ends(Step how, size_t from, size_t to) const {
    const uint32_t here = activationOf(from), there = activationOf(to);
    const bool isAnotherTask = m_look->activations()[there].parent == kNone && here != there && !isAround(there, here);
    switch (how) {
    case Step::In:
        return true;
    case Step::Over:
        return isAnotherTask || isAround(there, here);
    case Step::Out:
        return isAnotherTask || (here != there && isAround(there, here));
    }
    return true;
}

bool SlowScan::step(Step how) {
    if (isAtEnd()) return false;
    size_t to = m_at + 1;
    while (to < m_stops.size() && !ends(how, m_at, to)) ++to;
    goTo(to);
    return true;
}

bool SlowScan::stepBack(Step how) {
    if (m_at == 0) return false;
    if (isAtEnd()) {
        size_t to = m_stops.size() - 1; // from the end not into what the last statement called
        while (how != Step::In && to > 0 && m_look->activations()[activationOf(to)].parent != kNone) --to;
        goTo(to);
        return true;
    }
    size_t to = m_at - 1;
    while (to > 0 && !ends(how, m_at, to)) --to;
    goTo(to);
    return true;
}

SlowScan::LineOf SlowScan::lineOf(size_t stop) const {
    const SourceRange range = m_look->events()[m_stops[stop]].stmt()->range;
    if (range.file.index() >= m_look->program().sources.files.size()) return {range.file, 0};
    return {range.file, m_look->program().sources[range.file].lineColumn(range.begin).line};
}

/// As in a running program, a breakpoint is at the first statement of its line, not at those after it.
bool SlowScan::isBreakpoint(size_t stop) const {
    const LineOf line = lineOf(stop);
    if (std::find(m_breakpoints.begin(), m_breakpoints.end(), line) == m_breakpoints.end()) return false;
    const auto beginOf = [&](size_t one) { return m_look->events()[m_stops[one]].stmt()->range.begin; };
    for (size_t before = stop; before-- > 0;)
        if (activationOf(before) == activationOf(stop))                           // not what it called
            return !(lineOf(before) == line) || beginOf(before) >= beginOf(stop); // a loop that comes again
    return true;
}

bool SlowScan::goToLine(const LineOf& line) {
    for (size_t n = 1; n <= m_stops.size(); ++n) {
        const size_t stop = (m_at + n) % m_stops.size();
        if (!(lineOf(stop) == line)) continue;
        goTo(stop);
        return true;
    }
    return false;
}

bool SlowScan::goOn() {
    if (isAtEnd()) return false;
    size_t to = m_at + 1;
    while (to < m_stops.size() && !isBreakpoint(to)) ++to;
    goTo(to);
    return true;
}

bool SlowScan::reverseContinue() {
    if (m_at == 0) return false;
    size_t to = m_at - 1;
    while (to > 0 && !isBreakpoint(to)) --to;
    goTo(to);
    return true;
}

bool SlowScan::goToStatement(SourceRange statement) {
    for (size_t n = 1; n <= m_stops.size(); ++n) {
        const size_t stop = (m_at + n) % m_stops.size();
        if (!(m_look->events()[m_stops[stop]].stmt()->range == statement)) continue;
        goTo(stop);
        return true;
    }
    return false;
}

bool SlowScan::goToEvent(EventIndex event) {
    const auto next = std::upper_bound(m_stops.begin(), m_stops.end(), event);
    if (next == m_stops.begin()) return false;
    goTo(static_cast<size_t>(next - m_stops.begin()) - 1);
    return true;
}

} // namespace plc::inside
