// A trace's recording of a run: of one that goes on, whose scan thread records meanwhile, or of one from a file. May be
// called from the window's thread and from one that saves.
#pragma once
#include "editor/trace/recording/recording.h"
#include "projects/session/recorded_run.h"

namespace plc::trace {

class RunRecording final : public Recording {
public:
    /// The run must outlive it.
    explicit RunRecording(const session::Run& run) : m_run(run) {}
    explicit RunRecording(std::shared_ptr<const session::RecordedRun> run, std::vector<Message> notes = {})
        : m_run(*run), m_owned(std::move(run)), m_notes(std::move(notes)) {}
    /// Of a recording the program is built again, which takes longest. A table of measured values (.csv, .tsv, .txt)
    /// opens as well: a program is written for its columns.
    [[nodiscard]] static Result<std::shared_ptr<RunRecording>> open(const std::string& path,
                                                                    Progress* progress = nullptr);
    /// What was not as it should be in a table, and what was done about it.
    [[nodiscard]] const std::vector<Message>& notes() const { return m_notes; }
    /// From a file; null: of a run that goes on.
    [[nodiscard]] const std::shared_ptr<const session::RecordedRun>& recordedRun() const { return m_owned; }

    std::pair<Position, Position> extent() const override;
    std::vector<history::Branch> branches() const override { return m_run.history().branches(); }
    std::vector<history::Mark> marks() const override { return m_run.history().marks(); }
    std::optional<history::ScanStamp> stamp(Position position) const override {
        return m_run.history().stamp(position);
    }
    std::optional<Position> positionAt(int64_t time) const override {
        return m_run.history().positionAt(history::Nanoseconds(time));
    }
    history::Statistics statistics() const override { return m_run.history().statistics(); }
    Result<ChannelType> typeOf(const std::string& expression) const override;
    std::vector<history::Sample> samples(const std::string& expression, Position from, Position to) const override;
    std::optional<Position> find(const std::string& expression, Position from,
                                 history::History::Direction direction) const override;
    std::optional<Position> findChange(const std::string& expression, Position from,
                                       history::History::Direction direction) const override;
    std::shared_ptr<const image::CompiledProgram> program() const override { return m_run.program(); }
    Result<void> save(const std::string& path, Progress* progress = nullptr) const override {
        return m_run.history().save(path, progress);
    }

private:
    const session::Run& m_run;
    std::shared_ptr<const session::RecordedRun> m_owned;
    std::vector<Message> m_notes;
};

} // namespace plc::trace
