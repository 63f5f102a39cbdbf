#include "hmi/station/alarm_evaluator.h"

#include "editor/kit/post.h"
#include "hmi/station/plc_convert.h"

#include <QDateTime>

namespace plc::hmi {

AlarmEvaluator::AlarmEvaluator(const session::Run& run, std::vector<AlarmDefinition> definitions)
    : m_run(run), m_definitions(std::move(definitions)), m_lifeCycle(m_definitions) {
    m_next = m_run.history().statistics().first;
    compile();
}

void AlarmEvaluator::compile() {
    m_program = m_run.program();
    m_conditions.clear();
    m_inhibits.clear();
    const auto compiled = [&](const QString& text) {
        if (text.trimmed().isEmpty()) return expression::Expression();
        auto result = m_run.expression(text.toStdString());
        return result ? *result : expression::Expression();
    };
    for (const AlarmDefinition& one : m_definitions) {
        m_conditions.push_back(compiled(one.condition));
        m_inhibits.push_back(compiled(one.inhibit));
    }
}

AlarmInstant AlarmEvaluator::now() const {
    const auto stamp = m_next > 0 ? m_run.history().stamp(m_next - 1) : std::nullopt;
    return stamp ? AlarmInstant{stamp->position, stamp->scan, stamp->time} : AlarmInstant{};
}

AlarmRecord AlarmEvaluator::recordOf(const AlarmEvent& event) const {
    const AlarmDefinition& alarm = m_definitions[event.alarm];
    AlarmRecord record{0, alarm.id, event.kind, event.at, QDateTime::currentMSecsSinceEpoch(), {}, {}};
    if (event.kind != AlarmEventKind::Raised || alarm.values.empty()) return record;
    std::shared_ptr<const image::CompiledProgram> program;
    const std::vector<std::byte> image = m_run.history().seek(event.at.position, &program);
    for (const auto& [name, text] : alarm.values) {
        Value value;
        if (!image.empty() && program) {
            const expression::Expression compiled = m_run.recompile(text.toStdString())(*program);
            if (compiled.isValid())
                if (const expression::Outcome outcome = compiled.evaluate(image); outcome.hasValue())
                    value = toPanel(compiled.types(), outcome.value);
        }
        record.values.emplace_back(name, std::move(value));
    }
    return record;
}

void AlarmEvaluator::append(std::span<const AlarmEvent> events, const QString& user, AlarmFindings& out) {
    for (const AlarmEvent& event : events) {
        m_events.push_back(event);
        out.records.push_back(recordOf(event));
        out.records.back().user = user;
    }
}

bool AlarmEvaluator::followBranch(std::vector<AlarmFindings>& findings, history::Position& end) {
    const std::vector<history::Branch> branches = m_run.history().branches();
    // The next branch that begins at or behind what was evaluated: first the end of the old one, then its parent's
    // state.
    for (size_t i = std::max<size_t>(m_branch, 1); i < branches.size(); ++i) {
        const history::Branch& branch = branches[i];
        if (branch.first > m_next) {
            end = std::min(end, branch.first);
            return false;
        }
        m_branch = i + 1;
        std::erase_if(m_events, [&](const AlarmEvent& event) { return event.at.position > branch.parent; });
        m_lifeCycle.restore(m_events, branch.parent);
        AlarmFindings back;
        back.rewindTo = branch.parent;
        findings.push_back(std::move(back));
    }
    return true;
}

bool AlarmEvaluator::process(std::vector<AlarmFindings>& findings, size_t limit) {
    if (m_run.program() != m_program) compile();
    const history::Statistics there = m_run.history().statistics();
    if (m_next < there.first) m_next = there.first; // evicted before we came to it
    history::Position end = there.end;
    followBranch(findings, end);
    if (m_next >= end) return m_next < there.end;
    const history::Position to = std::min<history::Position>(end, m_next + limit);
    AlarmFindings out;
    processRange(m_next, to, out);
    m_next = to;
    if (!out.records.empty()) findings.push_back(std::move(out));
    return m_next < there.end;
}

void AlarmEvaluator::processRange(history::Position from, history::Position to, AlarmFindings& out) {
    const history::History& history = m_run.history();
    const size_t count = m_definitions.size(), scans = static_cast<size_t>(to - from);
    if (count == 0 || scans == 0) return;
    std::vector<std::vector<Condition>> conditions(count, std::vector<Condition>(scans, Condition::Unknown));
    std::vector<std::optional<AlarmInstant>> instants(scans); // none: forgotten before it was read
    const auto read = [&](const expression::Expression& expression, const QString& text, std::vector<Condition>& into) {
        if (!expression.isValid()) return;
        for (const history::Sample& sample :
             history.samples(expression, m_run.recompile(text.toStdString()), from, to)) {
            if (sample.at.position < from || sample.at.position >= to) continue;
            const size_t i = static_cast<size_t>(sample.at.position - from);
            instants[i] = AlarmInstant{sample.at.position, sample.at.scan, sample.at.time};
            if (sample.hasValue) into[i] = sample.value != 0 ? Condition::True : Condition::False;
        }
    };
    for (size_t alarm = 0; alarm < count; ++alarm) {
        read(m_conditions[alarm], m_definitions[alarm].condition, conditions[alarm]);
        if (!m_inhibits[alarm].isValid()) continue;
        std::vector<Condition> inhibited(scans, Condition::Unknown);
        read(m_inhibits[alarm], m_definitions[alarm].inhibit, inhibited);
        for (size_t i = 0; i < scans; ++i)
            if (inhibited[i] == Condition::True) conditions[alarm][i] = Condition::False;
    }
    std::vector<Condition> present(count);
    std::vector<AlarmEvent> events;
    bool isFirst = true;
    for (size_t i = 0; i < scans; ++i) {
        if (!instants[i]) continue;
        bool any = std::exchange(isFirst, false) || m_lifeCycle.hasPendingDelay();
        for (size_t alarm = 0; alarm < count; ++alarm) {
            present[alarm] = conditions[alarm][i];
            any |= i > 0 && conditions[alarm][i] != conditions[alarm][i - 1];
        }
        if (any) m_lifeCycle.step(*instants[i], present, events);
        if (m_acknowledged.contains(instants[i]->position)) {
            append(std::exchange(events, {}), {}, out);
            acknowledgeAgain(*instants[i], out);
        }
    }
    append(events, {}, out);
}

void AlarmEvaluator::setAcknowledged(const std::vector<AlarmRecord>& records) {
    for (const AlarmRecord& record : records) m_acknowledged.emplace(record.at.position, record);
}

void AlarmEvaluator::acknowledgeAgain(const AlarmInstant& at, AlarmFindings& out) {
    const auto [first, last] = m_acknowledged.equal_range(at.position);
    for (auto it = first; it != last; ++it)
        for (size_t alarm = 0; alarm < m_definitions.size(); ++alarm) {
            if (m_definitions[alarm].id != it->second.alarm) continue;
            std::vector<AlarmEvent> events;
            m_lifeCycle.acknowledge(alarm, at, events);
            append(events, it->second.user, out);
        }
}

void AlarmEvaluator::acknowledge(size_t alarm, const QString& user, std::vector<AlarmFindings>& findings) {
    if (alarm >= m_definitions.size()) return;
    std::vector<AlarmEvent> events;
    m_lifeCycle.acknowledge(alarm, now(), events);
    AlarmFindings out;
    append(events, user, out);
    if (!out.records.empty()) findings.push_back(std::move(out));
}

void AlarmEvaluator::acknowledgeAll(const QStringList& classes, const QString& user,
                                    std::vector<AlarmFindings>& findings) {
    for (size_t i = 0; i < m_definitions.size(); ++i)
        if (classes.isEmpty() || classes.contains(m_definitions[i].className)) acknowledge(i, user, findings);
}

// ---- the thread

AlarmWatch::AlarmWatch(const session::Run& of, AlarmBook& book, QObject* parent)
    : QObject(parent), m_run(of), m_book(book) {
    m_thread = std::thread([this, definitions = book.definitions(), acknowledged = book.takeAcknowledged()]() mutable {
        run(std::move(definitions), acknowledged);
    });
}

AlarmWatch::~AlarmWatch() {
    {
        std::lock_guard lock(m_mutex);
        m_stop = true;
    }
    m_wake.notify_all();
    m_thread.join();
}

void AlarmWatch::run(std::vector<AlarmDefinition> definitions, const std::vector<AlarmRecord>& acknowledged) {
    AlarmEvaluator evaluator(m_run, std::move(definitions));
    evaluator.setAcknowledged(acknowledged);
    std::unique_lock lock(m_mutex);
    while (!m_stop) {
        const std::vector<Command> commands = std::exchange(m_commands, {});
        const uint64_t asked = m_asked;
        lock.unlock();
        std::vector<AlarmFindings> findings;
        bool more = evaluator.process(findings);
        for (const Command& command : commands) {
            if (command.all)
                evaluator.acknowledgeAll(command.classes, command.user, findings);
            else
                evaluator.acknowledge(command.alarm, command.user, findings);
        }
        lock.lock();
        if (!findings.empty()) {
            std::move(findings.begin(), findings.end(), std::back_inserter(m_findings));
            if (!std::exchange(m_posted, true)) kit::post(this, [this] { deliver(); });
        }
        if (!more && commands.empty()) {
            m_answered = asked;
            m_caughtUp.notify_all();
        }
        if (!more && m_commands.empty() && m_answered == m_asked && !m_stop)
            m_wake.wait_for(lock, std::chrono::milliseconds(30));
    }
    m_answered = m_asked;
    m_caughtUp.notify_all();
}

void AlarmWatch::deliver() {
    std::vector<AlarmFindings> findings;
    {
        std::lock_guard lock(m_mutex);
        m_posted = false;
        findings = std::exchange(m_findings, {});
    }
    for (const AlarmFindings& one : findings) {
        if (one.rewindTo) m_book.rewind(*one.rewindTo);
        m_book.take(one.records);
    }
}

void AlarmWatch::acknowledge(size_t alarm, const QString& user) {
    {
        std::lock_guard lock(m_mutex);
        m_commands.push_back({false, alarm, {}, user});
    }
    m_wake.notify_all();
}

void AlarmWatch::acknowledgeAll(const QStringList& classes, const QString& user) {
    {
        std::lock_guard lock(m_mutex);
        m_commands.push_back({true, 0, classes, user});
    }
    m_wake.notify_all();
}

void AlarmWatch::catchUp() {
    {
        std::unique_lock lock(m_mutex);
        const uint64_t mine = ++m_asked;
        m_wake.notify_all();
        m_caughtUp.wait(lock, [&] { return m_answered >= mine || m_stop; });
    }
    deliver();
}

} // namespace plc::hmi
