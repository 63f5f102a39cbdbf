#include "editor/trace/recording/run_recording.h"

#include "editor/trace/recording/table_recording.h"

namespace plc::trace {

namespace {

Result<std::shared_ptr<RunRecording>> openTable(const std::string& path, Progress* progress) {
    auto table = waveform::readTable(path);
    if (!table) return table.error();
    auto recorded = recordTable(*table, progress);
    if (!recorded) return Error{recorded.error().message, path};
    return std::make_shared<RunRecording>(
        session::RecordedRun::of(std::move(recorded->built), std::move(recorded->history)), std::move(table->notes));
}

} // namespace

Result<std::shared_ptr<RunRecording>> RunRecording::open(const std::string& path, Progress* progress) {
    if (isTableFile(path)) return openTable(path, progress);
    auto run = session::RecordedRun::open(path, progress);
    if (!run) return run.error();
    return std::make_shared<RunRecording>(std::move(*run));
}

std::pair<Position, Position> RunRecording::extent() const {
    const history::Statistics s = m_run.history().statistics();
    return {s.first, s.end};
}

Result<ChannelType> RunRecording::typeOf(const std::string& text) const {
    const auto expression = m_run.expression(text);
    if (!expression) return expression.error();
    return channelTypeOf(*expression);
}

std::vector<history::Sample> RunRecording::samples(const std::string& text, Position from, Position to) const {
    const auto expression = m_run.expression(text);
    if (!expression) return {};
    return m_run.history().samples(*expression, m_run.recompile(text), from, to);
}

std::optional<Position> RunRecording::find(const std::string& text, Position from,
                                           history::History::Direction direction) const {
    const auto expression = m_run.expression(text);
    if (!expression) return std::nullopt;
    return m_run.history().find(*expression, m_run.recompile(text), from, direction);
}

std::optional<Position> RunRecording::findChange(const std::string& text, Position from,
                                                 history::History::Direction direction) const {
    const auto expression = m_run.expression(text);
    if (!expression) return std::nullopt;
    return m_run.history().findChange(*expression, m_run.recompile(text), from, direction);
}

} // namespace plc::trace
