// Evaluates alarm conditions for every recorded scan, behind the scan thread, so that an alarm of one scan is not lost.
// AlarmEvaluator works in the calling thread; AlarmWatch gives it a thread of its own and hands what it finds to the
// book.
#pragma once
#include "hmi/alarms/alarm_book.h"
#include "projects/session/run.h"

#include <QObject>
#include <condition_variable>
#include <map>
#include <mutex>
#include <thread>

namespace plc::hmi {

/// What a piece of the recording gave. After going back, `rewindTo` says from which scan the new branch went on.
struct AlarmFindings {
    std::optional<history::Position> rewindTo;
    std::vector<AlarmRecord> records;
};

class AlarmEvaluator {
public:
    /// The run must outlive it.
    AlarmEvaluator(const session::Run& run, std::vector<AlarmDefinition> definitions);

    /// Evaluates recorded scans up to the newest one, at most `limit` of them; true while some are left.
    bool process(std::vector<AlarmFindings>& findings, size_t limit = 1 << 14);
    /// What was acknowledged when these scans were evaluated before.
    void setAcknowledged(const std::vector<AlarmRecord>& records);
    void acknowledge(size_t alarm, const QString& user, std::vector<AlarmFindings>& findings);
    void acknowledgeAll(const QStringList& classes, const QString& user, std::vector<AlarmFindings>& findings);
    const AlarmLifeCycle& lifeCycle() const { return m_lifeCycle; }
    history::Position position() const { return m_next; }

private:
    void compile();
    bool followBranch(std::vector<AlarmFindings>& findings, history::Position& end);
    void processRange(history::Position from, history::Position to, AlarmFindings& out);
    AlarmRecord recordOf(const AlarmEvent& event) const;
    AlarmInstant now() const;
    void acknowledgeAgain(const AlarmInstant& at, AlarmFindings& out);
    void append(std::span<const AlarmEvent> events, const QString& user, AlarmFindings& out);

    const session::Run& m_run;
    std::vector<AlarmDefinition> m_definitions;
    std::shared_ptr<const image::CompiledProgram> m_program;
    std::vector<expression::Expression> m_conditions, m_inhibits;
    AlarmLifeCycle m_lifeCycle;
    std::vector<AlarmEvent> m_events;
    std::multimap<history::Position, AlarmRecord> m_acknowledged;
    history::Position m_next = 0;
    size_t m_branch = 0;
};

class AlarmWatch final : public QObject {
    Q_OBJECT
public:
    /// Both must outlive the watch. What the book knows is found again, but for what was acknowledged.
    AlarmWatch(const session::Run& of, AlarmBook& book, QObject* parent = nullptr);
    ~AlarmWatch() override;

    void acknowledge(size_t alarm, const QString& user = {});
    void acknowledgeAll(const QStringList& classes = {}, const QString& user = {});
    /// Waits until all scans recorded so far are evaluated and the book knows of it; for tests and pictures.
    void catchUp();

private:
    struct Command {
        bool all = false;
        size_t alarm = 0;
        QStringList classes;
        QString user;
    };
    void run(std::vector<AlarmDefinition> definitions, const std::vector<AlarmRecord>& acknowledged);
    void deliver();

    const session::Run& m_run;
    AlarmBook& m_book;
    std::mutex m_mutex;
    std::condition_variable m_wake, m_caughtUp;
    std::vector<Command> m_commands;
    std::vector<AlarmFindings> m_findings;
    bool m_stop = false, m_posted = false;
    uint64_t m_asked = 0, m_answered = 0;
    std::thread m_thread;
};

} // namespace plc::hmi
