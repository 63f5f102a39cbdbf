// What a trace reads from: a running session's history, or a recording from a file. Positions, times and samples;
// expressions by their text. Functions may be called from the window's thread while the scan thread records.
#pragma once

#include "runtime/expression/expression.h"
#include "runtime/history/column_store.h"
#include "runtime/history/history.h"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace plc::trace {

using history::Position;

/// How the values of an expression are kept and named.
struct ChannelType {
    history::ColumnKind kind = history::ColumnKind::Double;
    bool isBool = false, isSingle = false, isInteger = false;
    bool isTime = false;                        // nanoseconds, shown as milliseconds
    std::string name;                           // "REAL"
    std::function<std::string(int64_t)> toText; // of dates and times of day
    std::map<int64_t, std::string> valueNames;
};

class Recording {
public:
    virtual ~Recording() = default;

    /// Oldest position still there, and one past the newest.
    [[nodiscard]] virtual std::pair<Position, Position> extent() const = 0;
    [[nodiscard]] virtual std::vector<history::Branch> branches() const = 0;
    [[nodiscard]] virtual std::vector<history::Mark> marks() const = 0;
    [[nodiscard]] virtual std::optional<history::ScanStamp> stamp(Position position) const = 0;
    /// The last position at or before that time on the newest branch.
    [[nodiscard]] virtual std::optional<Position> positionAt(int64_t time) const = 0;
    [[nodiscard]] virtual history::Statistics statistics() const = 0;

    [[nodiscard]] virtual Result<ChannelType> typeOf(const std::string& expression) const = 0;
    [[nodiscard]] virtual std::vector<history::Sample> samples(const std::string& expression, Position from,
                                                               Position to) const = 0;
    [[nodiscard]] virtual std::optional<Position> find(const std::string& expression, Position from,
                                                       history::History::Direction direction) const = 0;
    [[nodiscard]] virtual std::optional<Position> findChange(const std::string& expression, Position from,
                                                             history::History::Direction direction) const = 0;
    /// The program of the newest scan, for names and completion; null before anything ran.
    [[nodiscard]] virtual std::shared_ptr<const image::CompiledProgram> program() const = 0;
    /// Writes what is recorded now to a file that `stepwise replay` and the studio open.
    virtual Result<void> save(const std::string& path, Progress* progress = nullptr) const = 0;
};

using history::PositionRange;
/// Neighbours on a chain of positions (history::chainTo).
[[nodiscard]] std::optional<Position> nextOnChain(const std::vector<PositionRange>& chain, Position position);
[[nodiscard]] std::optional<Position> previousOnChain(const std::vector<PositionRange>& chain, Position position);

[[nodiscard]] ChannelType channelTypeOf(const expression::Expression& expression);

} // namespace plc::trace
