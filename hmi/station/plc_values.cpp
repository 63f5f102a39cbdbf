#include "hmi/station/plc_values.h"
#include "editor/kit/errors.h"
#include "editor/kit/message_text.h"

#include <cstring>

namespace plc::hmi {

PlcValues::PlcValues(const session::Run* run) : m_run(run), m_program(run ? run->program() : nullptr) { refresh(); }

/// For images of `m_program`: the running one, or the version that the past ran under.
void PlcValues::compile(Binding& binding) {
    const std::string text = binding.text.toStdString();
    binding.lastBytes.clear();
    binding.compiled = {};
    binding.problem.clear();
    const auto failed = [&](const QString& problem) {
        binding.problem = problem;
        binding.value = Value::none(problem);
    };
    if (!m_run) return failed({});
    if (!m_program && !m_run->isLive()) return failed(kit::messageText(errors::NoLongerRecorded()));
    const auto newest = m_run->program();
    auto compiled = m_run->expression(text, {}, m_program ? *m_program : *newest);
    const auto isNow = m_program && m_program != newest ? m_run->expression(text) : compiled;
    const auto& shape = isNow ? isNow : compiled; // what is entered goes to the newest version
    if (!shape) {
        binding.facts = {};
        return failed(kit::messageText(compiled.error().message));
    }
    binding.facts = factsOf(shape->types(), shape->type(), shape->place().has_value());
    if (compiled) binding.compiled = std::move(*compiled); // else that version did not have it
}

BindingId PlcValues::bind(const QString& expression) {
    const QString text = expression.trimmed();
    if (text.isEmpty()) return {};
    const auto known = m_ids.constFind(text);
    if (known != m_ids.constEnd()) return {*known};
    Binding binding;
    binding.text = text;
    compile(binding);
    const int index = static_cast<int>(m_bindings.size());
    m_bindings.push_back(std::move(binding));
    m_ids.insert(text, index);
    Binding& added = m_bindings.back();
    if (added.compiled.isValid() && !m_image.empty()) {
        const expression::Outcome outcome = added.compiled.evaluate(m_image);
        added.value = outcome.hasValue() ? toPanel(added.compiled.types(), outcome.value)
                                         : Value::none(kit::messageText(outcome.reason));
    }
    ++m_revision;
    return {index};
}

void PlcValues::setPosition(std::optional<history::Position> position) {
    if (position == m_position) return;
    m_position = position;
    m_scan = ~uint64_t(0);
    refresh();
}

void PlcValues::setRun(const session::Run* run) {
    m_run = run;
    m_position.reset();
    m_image.clear();
    m_program.reset(); // everything is compiled again
    m_scan = ~uint64_t(0);
    refresh();
}

std::optional<history::Position> PlcValues::shownPosition() const {
    if (m_position || !m_run || m_run->isLive()) return m_position;
    const history::Statistics there = m_run->history().statistics();
    return there.end > there.first ? std::optional(there.end - 1) : std::nullopt;
}

void PlcValues::runUnder(const std::shared_ptr<const image::CompiledProgram>& program) {
    if (!program || program == m_program) return;
    m_program = program;
    for (Binding& binding : m_bindings) compile(binding);
    m_scan = ~uint64_t(0);
}

bool PlcValues::refreshPast(bool changed) {
    const std::optional<history::Position> position = shownPosition();
    if (!position || (m_scan == *position && !m_image.empty())) return changed;
    // The past may have run under another version of the program: expressions are compiled for its layout.
    std::shared_ptr<const image::CompiledProgram> program;
    m_image = m_run->history().seek(*position, &program);
    m_pastStamp = m_run->history().stamp(*position);
    runUnder(program);
    m_scan = *position;
    evaluate();
    return true;
}

bool PlcValues::refresh() {
    const controller::State before = m_status.state;
    m_status = m_run ? m_run->status() : session::Status();
    const bool changed = before != m_status.state;
    if (!m_run) {
        if (m_image.empty() && m_scan != ~uint64_t(0)) return changed;
        m_image.clear();
        m_scan = 0;
        evaluate();
        return true;
    }
    if (isPast()) return refreshPast(changed);
    runUnder(m_run->program());
    // A scan that has not ended since the last frame has nothing new, but at a breakpoint values change within a scan.
    if (m_status.scans == m_scan && m_status.state != controller::State::Halted && !m_image.empty() && !changed)
        return false;
    m_scan = m_status.scans;
    m_image = m_run->snapshot();
    evaluate();
    return true;
}

void PlcValues::evaluate() {
    bool changed = false;
    for (Binding& binding : m_bindings) {
        if (!binding.compiled.isValid()) {
            if (binding.problem.isEmpty() && !binding.value.isNone())
                binding.value = Value::none(QStringLiteral("not in this program")), changed = true;
            continue;
        }
        if (m_image.empty()) {
            if (!binding.value.isNone()) changed = true;
            binding.value = Value::none(kit::messageText(errors::NoLongerRecorded()));
            binding.lastBytes.clear();
            continue;
        }
        if (const std::optional<image::Place> place = binding.compiled.place(); place && place->bit < 0) {
            const uint32_t size = binding.compiled.types()[place->type].size;
            if (size > 0 && place->offset + size <= m_image.size()) {
                const std::byte* bytes = m_image.data() + place->offset;
                if (binding.lastBytes.size() == size && std::memcmp(binding.lastBytes.data(), bytes, size) == 0)
                    continue;
                binding.lastBytes.assign(bytes, bytes + size);
            }
        }
        const expression::Outcome outcome = binding.compiled.evaluate(m_image);
        Value now = outcome.hasValue() ? toPanel(binding.compiled.types(), outcome.value)
                                       : Value::none(kit::messageText(outcome.reason));
        if (now == binding.value) continue;
        binding.value = std::move(now);
        changed = true;
    }
    if (changed) ++m_revision;
}

const Value& PlcValues::value(BindingId binding) const {
    static const Value none;
    return binding.isValid() ? m_bindings[static_cast<size_t>(binding.index)].value : none;
}

ValueFacts PlcValues::facts(BindingId binding) const {
    return binding.isValid() ? m_bindings[static_cast<size_t>(binding.index)].facts : ValueFacts();
}

namespace {

/// The first position of the range that was recorded at or after that PLC time (times rise within a range); its end
/// when none was.
history::Position firstSince(const history::History& history, history::PositionRange range, history::Nanoseconds time) {
    while (range.begin < range.end) {
        const history::Position middle = range.begin + (range.end - range.begin) / 2;
        const auto stamp = history.stamp(middle);
        if (stamp && stamp->time >= time)
            range.end = middle;
        else
            range.begin = middle + 1;
    }
    return range.begin;
}

} // namespace

std::vector<CurvePiece> PlcValues::curve(BindingId id, double seconds, int buckets) const {
    std::vector<CurvePiece> out;
    if (!id.isValid()) return out;
    const Binding& binding = m_bindings[static_cast<size_t>(id.index)];
    if (!binding.compiled.isValid()) return out;
    if (!m_run) return out;
    const history::History& history = m_run->history();
    const history::Statistics there = history.statistics();
    if (there.scans == 0) return out;
    const history::Position last = shownPosition().value_or(there.end - 1);
    const std::optional<history::ScanStamp> now = history.stamp(last);
    if (!now) return out;
    const auto begin = now->time - history::Nanoseconds(static_cast<int64_t>(seconds * 1e9));
    // Only what led to this scan: of a branch that was gone back from, the part before the return.
    std::vector<history::PositionRange> ranges;
    history::Position count = 0;
    for (history::PositionRange range : history::chainTo(history.branches(), last + 1)) {
        range.begin = firstSince(history, {std::max(range.begin, there.first), range.end}, begin);
        if (range.begin >= range.end) continue;
        count += range.end - range.begin;
        ranges.push_back(range);
    }
    std::vector<history::Bucket> series;
    for (const history::PositionRange& range : ranges) {
        const auto share = static_cast<size_t>(
            static_cast<double>(buckets) * static_cast<double>(range.end - range.begin) / static_cast<double>(count));
        const auto part = history.series(binding.compiled, m_run->recompile(binding.text.toStdString()), range.begin,
                                         range.end, std::max<size_t>(1, share));
        series.insert(series.end(), part.begin(), part.end());
    }
    for (const history::Bucket& bucket : series) {
        const auto stamp = history.stamp(bucket.begin);
        if (!stamp) continue; // forgotten since it was read
        const int64_t from = (stamp->time - now->time).count();
        if (!out.empty()) out.back().to = from;
        out.push_back({bucket, from, from});
    }
    if (!out.empty()) out.back().to = 0;
    return out;
}

Freshness PlcValues::freshness() const {
    if (isPast()) {
        // The scan in which the controller has faulted: the operator reads why it stands still.
        const bool isFault = m_run && m_run->isLive() && m_status.state == controller::State::Fault && m_status.fault &&
                             m_pastStamp && m_pastStamp->scan == m_status.fault->scan;
        return isFault ? Freshness::Fault : Freshness::Past;
    }
    if (!m_run) return Freshness::Disconnected;
    switch (m_status.state) {
    case controller::State::Stopped:
        return Freshness::Stopped;
    case controller::State::Running:
        return Freshness::Live;
    case controller::State::Paused:
    case controller::State::Halted:
        return Freshness::Paused;
    case controller::State::Fault:
        return Freshness::Fault;
    }
    return Freshness::Disconnected;
}

qint64 PlcValues::clock() const {
    if (m_image.size() < sizeof(image::ImageHeader)) return 0;
    image::ImageHeader header;
    std::memcpy(&header, m_image.data(), sizeof header);
    return header.calendarNs;
}

std::optional<qint64> PlcValues::clockAtZero() const {
    if (m_image.size() < sizeof(image::ImageHeader)) return {};
    image::ImageHeader header;
    std::memcpy(&header, m_image.data(), sizeof header);
    if (header.calendarNs == 0) return {};
    return header.calendarNs - header.timeNs;
}

} // namespace plc::hmi
