// A recording made of functions of the scan: what a trace reads, without compiler and controller. For tests, one
// thread.
#pragma once

#include "editor/trace/recording/recording.h"
#include "runtime/base/messages.h"

#include <cmath>
#include <functional>

namespace plc::trace {

class FakeRecording : public Recording {
public:
    struct Channel {
        ChannelType type;
        std::function<std::optional<double>(const history::ScanStamp&)> value;
    };
    std::map<std::string, Channel> channels;
    std::vector<history::ScanStamp> scans; // by position
    std::vector<history::Branch> branchList;
    std::vector<history::Mark> markList;
    Position oldest = 0;
    int64_t period = 1'000'000;
    std::function<void()> whileRead; // samples are asked for; what they are comes after

    /// Records scans on from the newest one.
    void run(int count) {
        for (int i = 0; i < count; ++i) {
            const uint64_t scan = scans.empty() ? 0 : m_nextScan;
            scans.push_back({scans.size(), scan, history::Nanoseconds(static_cast<int64_t>(scan) * period)});
            m_nextScan = scan + 1;
        }
    }
    void goBackTo(Position position) {
        if (branchList.empty()) branchList.push_back({0, 0});
        branchList.push_back({scans.size(), position});
        m_nextScan = scans[position].scan + 1;
    }
    void addReal(const std::string& name, std::function<double(double)> f) {
        channels[name] = {ChannelType{.kind = history::ColumnKind::Float, .isSingle = true, .name = "REAL"},
                          [f](const history::ScanStamp& s) { return f(static_cast<double>(s.time.count()) / 1e9); }};
    }
    void addBool(const std::string& name, std::function<bool(double)> f) {
        channels[name] = {
            ChannelType{.kind = history::ColumnKind::Bit, .isBool = true, .name = "BOOL"},
            [f](const history::ScanStamp& s) { return f(static_cast<double>(s.time.count()) / 1e9) ? 1.0 : 0.0; }};
    }

    std::pair<Position, Position> extent() const override { return {oldest, scans.size()}; }
    std::vector<history::Branch> branches() const override { return branchList; }
    std::vector<history::Mark> marks() const override { return markList; }
    std::optional<history::ScanStamp> stamp(Position p) const override {
        if (p < oldest || p >= scans.size()) return std::nullopt;
        return scans[p];
    }
    std::optional<Position> positionAt(int64_t time) const override {
        std::optional<Position> found;
        for (const PositionRange& range : history::chainTo(branchList, scans.size()))
            for (Position p = std::max(range.begin, oldest); p < range.end; ++p)
                if (scans[p].time.count() <= time) found = p;
        return found;
    }
    history::Statistics statistics() const override { return {scans.size() - oldest, oldest, scans.size(), 0, 0, 1}; }
    Result<ChannelType> typeOf(const std::string& text) const override {
        const auto it = channels.find(text);
        if (it == channels.end()) return Error{errors::NoVariable(text), ""};
        return it->second.type;
    }
    std::vector<history::Sample> samples(const std::string& text, Position from, Position to) const override {
        std::vector<history::Sample> out;
        if (whileRead) whileRead();
        for (Position p = std::max(from, oldest); p < std::min<Position>(to, scans.size()); ++p) {
            const auto value = channels.at(text).value(scans[p]);
            out.push_back({scans[p], value.value_or(0), value.has_value()});
        }
        return out;
    }
    std::optional<Position> find(const std::string& text, Position from,
                                 history::History::Direction direction) const override {
        return seek(from, direction, [&](Position p) { return truth(text, p) && !(p > oldest && truth(text, p - 1)); });
    }
    std::optional<Position> findChange(const std::string& text, Position from,
                                       history::History::Direction direction) const override {
        const auto& value = channels.at(text).value;
        return seek(from, direction, [&](Position p) { return p > oldest && value(scans[p]) != value(scans[p - 1]); });
    }
    std::shared_ptr<const image::CompiledProgram> program() const override { return nullptr; }
    plc::Result<void> save(const std::string& path, Progress*) const override {
        return Error{errors::NothingRecorded(), path};
    }

private:
    bool truth(const std::string& text, Position p) const { return channels.at(text).value(scans[p]).value_or(0) != 0; }
    template <class Match>
    std::optional<Position> seek(Position from, history::History::Direction direction, Match&& match) const {
        if (direction == history::History::Direction::Forward) {
            for (Position p = from + 1; p < scans.size(); ++p)
                if (match(p)) return p;
        } else {
            for (Position p = from; p-- > oldest;)
                if (match(p)) return p;
        }
        return std::nullopt;
    }
    uint64_t m_nextScan = 0;
};

} // namespace plc::trace
