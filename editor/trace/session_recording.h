// Recordings of a running session and of a file. A session outlives its recording; a file's recording owns its history.
// The functions may be called while the scan thread records.
#pragma once

#include "editor/trace/recording.h"
#include "projects/session/session.h"

#include <mutex>

namespace plc::trace {

class SessionRecording final : public Recording {
public:
    explicit SessionRecording(const session::Session& session) : m_session(session) {}

    std::pair<Position, Position> extent() const override;
    std::vector<history::Branch> branches() const override { return m_session.history().branches(); }
    std::vector<history::Mark> marks() const override { return m_session.history().marks(); }
    std::optional<history::ScanStamp> stamp(Position position) const override {
        return m_session.history().stamp(position);
    }
    std::optional<Position> positionAt(int64_t time) const override {
        return m_session.history().positionAt(history::Nanoseconds(time));
    }
    history::Statistics statistics() const override { return m_session.history().statistics(); }
    Result<ChannelType> typeOf(const std::string& expression) const override;
    std::vector<history::Sample> samples(const std::string& expression, Position from, Position to) const override;
    std::optional<Position> find(const std::string& expression, Position from,
                                 history::History::Direction direction) const override;
    std::optional<Position> findChange(const std::string& expression, Position from,
                                       history::History::Direction direction) const override;
    std::shared_ptr<const image::CompiledProgram> program() const override { return m_session.program(); }
    Result<void> save(const std::string& path, Progress* progress = nullptr) const override {
        return m_session.history().save(path, progress);
    }

private:
    const session::Session& m_session;
};

/// A recording that `stepwise run --record` or the studio saved; its program is built again from the sources in it. Or
/// a table of measured values (.csv, .tsv, .txt), for whose columns a program is written.
class FileRecording final : public Recording {
public:
    [[nodiscard]] static Result<std::shared_ptr<FileRecording>> open(const std::string& path,
                                                                     Progress* progress = nullptr);

    std::pair<Position, Position> extent() const override;
    std::vector<history::Branch> branches() const override { return m_history->branches(); }
    std::vector<history::Mark> marks() const override { return m_history->marks(); }
    std::optional<history::ScanStamp> stamp(Position position) const override { return m_history->stamp(position); }
    std::optional<Position> positionAt(int64_t time) const override {
        return m_history->positionAt(history::Nanoseconds(time));
    }
    history::Statistics statistics() const override { return m_history->statistics(); }
    Result<ChannelType> typeOf(const std::string& expression) const override;
    std::vector<history::Sample> samples(const std::string& expression, Position from, Position to) const override;
    std::optional<Position> find(const std::string& expression, Position from,
                                 history::History::Direction direction) const override;
    std::optional<Position> findChange(const std::string& expression, Position from,
                                       history::History::Direction direction) const override;
    std::shared_ptr<const image::CompiledProgram> program() const override;
    Result<void> save(const std::string& path, Progress* progress = nullptr) const override {
        return m_history->save(path, progress);
    }
    [[nodiscard]] const history::History& history() const { return *m_history; }
    /// For images of that version, as seen from `scope`.
    Result<expression::Expression> expression(const std::string& text, const std::string& scope,
                                              const image::CompiledProgram& program) const;

private:
    struct Version {
        std::shared_ptr<const image::CompiledProgram> program;
        driver::Checked checked;
    };
    FileRecording() = default;
    [[nodiscard]] static Result<std::shared_ptr<FileRecording>> openTable(const std::string& path, Progress* progress);
    Result<expression::Expression> compile(const std::string& text) const;
    history::Recompile recompile(const std::string& text) const;

    std::unique_ptr<history::History> m_history;
    std::vector<Version> m_versions;
    mutable std::map<std::string, expression::Expression> m_expressions; // of the newest version
};

} // namespace plc::trace
