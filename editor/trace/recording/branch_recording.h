// What another recording held before it was gone back from: the scans that led to one end, as a recording of their own,
// to be drawn beneath the branch that followed. The other one must outlive it. May be called as the other one.
#pragma once
#include "editor/trace/recording/recording.h"

namespace plc::trace {

class BranchRecording final : public Recording {
public:
    /// The scans before `end`.
    BranchRecording(const Recording& of, Position end);

    std::pair<Position, Position> extent() const override { return {m_of.extent().first, m_end}; }
    std::vector<history::Branch> branches() const override { return m_branches; }
    std::vector<history::Mark> marks() const override;
    std::optional<history::ScanStamp> stamp(Position position) const override;
    std::optional<Position> positionAt(int64_t time) const override;
    history::Statistics statistics() const override { return m_of.statistics(); }
    Result<ChannelType> typeOf(const std::string& expression) const override { return m_of.typeOf(expression); }
    std::vector<history::Sample> samples(const std::string& expression, Position from, Position to) const override {
        return m_of.samples(expression, from, std::min(to, m_end));
    }
    std::optional<Position> find(const std::string& expression, Position from,
                                 history::History::Direction direction) const override {
        return before(m_of.find(expression, std::min(from, m_end), direction));
    }
    std::optional<Position> findChange(const std::string& expression, Position from,
                                       history::History::Direction direction) const override {
        return before(m_of.findChange(expression, std::min(from, m_end), direction));
    }
    std::shared_ptr<const image::CompiledProgram> program() const override { return m_of.program(); }
    Result<void> save(const std::string& path, Progress* progress = nullptr) const override {
        return m_of.save(path, progress);
    }

private:
    [[nodiscard]] std::optional<Position> before(std::optional<Position> position) const {
        return position && *position < m_end ? position : std::nullopt;
    }

    const Recording& m_of;
    Position m_end;
    std::vector<history::Branch> m_branches;
    std::vector<PositionRange> m_chain;
};

} // namespace plc::trace
