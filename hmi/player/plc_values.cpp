#include "hmi/player/plc_values.h"
#include "editor/kit/errors.h"
#include "editor/kit/message_text.h"

#include <cstring>

namespace plc::hmi {

history::Recompile PanelRecording::recompile(const std::string& text) const {
    return [compile = compile, text](const image::CompiledProgram& program) {
        auto compiled = compile(text, program);
        return compiled ? std::move(*compiled) : expression::Expression();
    };
}

PlcValues::PlcValues(session::Session* session)
    : m_session(session), m_program(session ? session->program() : nullptr) {
    refresh();
}

history::Recompile PlcValues::recompile(const QString& text) const {
    return m_recording ? m_recording->recompile(text.toStdString()) : m_session->recompile(text.toStdString());
}

/// For images of `m_program`: the running one, or the version that the past ran under.
void PlcValues::compile(Binding& binding) {
    const std::string text = binding.text.toStdString();
    binding.lastBytes.clear();
    const auto failed = [&](const QString& problem) {
        binding.compiled = {};
        binding.problem = problem;
        binding.value = Value::none(problem);
    };
    if (m_recording) {
        if (!m_program) return failed(kit::messageText(errors::NoLongerRecorded()));
        auto compiled = m_recording->compile(text, *m_program);
        if (!compiled) return failed(kit::messageText(compiled.error().message));
        binding.compiled = std::move(*compiled);
    } else {
        if (!m_session) return failed({});
        auto compiled = m_session->expression(text);
        if (!compiled) {
            binding.facts = {};
            return failed(kit::messageText(compiled.error().message));
        }
        binding.facts = factsOf(compiled->types(), compiled->type(), compiled->place().has_value());
        binding.compiled = m_program && m_program != m_session->program() ? m_session->recompile(text)(*m_program)
                                                                          : std::move(*compiled);
        binding.problem.clear();
        return;
    }
    binding.problem.clear();
    binding.facts = factsOf(binding.compiled.types(), binding.compiled.type(), binding.compiled.place().has_value());
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

void PlcValues::setRecording(std::optional<PanelRecording> recording) {
    m_recording = std::move(recording);
    m_position.reset();
    m_image.clear();
    m_program.reset(); // everything is compiled again
    m_scan = ~uint64_t(0);
    refresh();
}

std::optional<history::Position> PlcValues::shownPosition() const {
    if (m_position || !m_recording) return m_position;
    const history::Statistics there = m_recording->history->statistics();
    return there.end > there.first ? std::optional(there.end - 1) : std::nullopt;
}

bool PlcValues::refresh() {
    const controller::State before = m_status.state;
    m_status = m_session ? m_session->status() : session::Status();
    bool changed = before != m_status.state;
    const auto runUnder = [this](const std::shared_ptr<const image::CompiledProgram>& program) {
        if (!program || program == m_program) return;
        m_program = program;
        for (Binding& binding : m_bindings) compile(binding);
        m_scan = ~uint64_t(0);
    };
    if (isPast()) {
        const std::optional<history::Position> position = shownPosition();
        if (!position || (m_scan == *position && !m_image.empty())) return changed;
        // The past may have run under another version of the program: expressions are compiled for its layout.
        std::shared_ptr<const image::CompiledProgram> program;
        m_image = history()->seek(*position, &program);
        m_pastStamp = history()->stamp(*position);
        runUnder(program);
        m_scan = *position;
        evaluate();
        return true;
    }
    if (!m_session) {
        if (m_image.empty() && m_scan != ~uint64_t(0)) return changed;
        m_image.clear();
        m_scan = 0;
        evaluate();
        return true;
    }
    runUnder(m_session->program());
    // A scan that has not ended since the last frame has nothing new, but at a breakpoint values change within a scan.
    if (m_status.scans == m_scan && m_status.state != controller::State::Halted && !m_image.empty() && !changed)
        return false;
    m_scan = m_status.scans;
    m_image = m_session->snapshot();
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
    if (!this->history()) return out;
    const history::History& history = *this->history();
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
        const auto part = history.series(binding.compiled, recompile(binding.text), range.begin, range.end,
                                         std::max<size_t>(1, share));
        series.insert(series.end(), part.begin(), part.end());
    }
    const auto secondsOf = [&](history::Position position) {
        const auto stamp = history.stamp(position);
        return stamp ? static_cast<double>((stamp->time - now->time).count()) * 1e-9 : 0.0;
    };
    for (const history::Bucket& bucket : series) {
        CurvePiece piece{secondsOf(bucket.begin), 0,           bucket.first,    bucket.minimum,
                         bucket.maximum,          bucket.last, bucket.count > 0};
        piece.to = piece.from;
        if (!out.empty()) out.back().to = piece.from;
        out.push_back(piece);
    }
    if (!out.empty()) out.back().to = 0;
    return out;
}

Freshness PlcValues::freshness() const {
    if (isPast()) return Freshness::Past;
    if (!m_session) return Freshness::Disconnected;
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
