#include "editor/trace/session_recording.h"
#include "runtime/base/messages.h"

#include "editor/trace/table_recording.h"
#include "projects/session/versions.h"

namespace plc::trace {

std::pair<Position, Position> SessionRecording::extent() const {
    const history::Statistics s = m_session.history().statistics();
    return {s.first, s.end};
}

Result<ChannelType> SessionRecording::typeOf(const std::string& text) const {
    const auto expression = m_session.expression(text);
    if (!expression) return expression.error();
    return channelTypeOf(*expression);
}

std::vector<history::Sample> SessionRecording::samples(const std::string& text, Position from, Position to) const {
    const auto expression = m_session.expression(text);
    if (!expression) return {};
    return m_session.history().samples(*expression, m_session.recompile(text), from, to);
}

std::optional<Position> SessionRecording::find(const std::string& text, Position from,
                                               history::History::Direction direction) const {
    const auto expression = m_session.expression(text);
    if (!expression) return std::nullopt;
    return m_session.history().find(*expression, m_session.recompile(text), from, direction);
}

std::optional<Position> SessionRecording::findChange(const std::string& text, Position from,
                                                     history::History::Direction direction) const {
    const auto expression = m_session.expression(text);
    if (!expression) return std::nullopt;
    return m_session.history().findChange(*expression, m_session.recompile(text), from, direction);
}

Result<std::shared_ptr<FileRecording>> FileRecording::open(const std::string& path, Progress* progress) {
    if (isTableFile(path)) return openTable(path, progress);
    std::shared_ptr<FileRecording> recording(new FileRecording);
    Message failure;
    auto history = history::History::load(
        path,
        [&](const history::History::Sources& sources) -> std::shared_ptr<const image::CompiledProgram> {
            driver::Built built = driver::build(session::recordedInput(sources), progress);
            if (!built.program) {
                failure = built.failure.isEmpty() ? errors::RecordedProgramHasErrors() : built.failure;
                return nullptr;
            }
            recording->m_versions.push_back({built.program, built.checked});
            return built.program;
        },
        progress);
    if (!history && isCancelled(progress)) return history.error();
    if (!history) return failure.isEmpty() ? history.error() : Error{errors::RecordingNotOpened(failure), path};
    recording->m_history = std::move(*history);
    return recording;
}

Result<std::shared_ptr<FileRecording>> FileRecording::openTable(const std::string& path, Progress* progress) {
    const auto table = waveform::readTable(path);
    if (!table) return table.error();
    auto recorded = recordTable(*table, progress);
    if (!recorded) return Error{recorded.error().message, path};
    std::shared_ptr<FileRecording> recording(new FileRecording);
    recording->m_versions.push_back({recorded->built.program, recorded->built.checked});
    recording->m_history = std::move(recorded->history);
    return recording;
}

std::pair<Position, Position> FileRecording::extent() const {
    const history::Statistics s = m_history->statistics();
    return {s.first, s.end};
}

Result<expression::Expression> FileRecording::compile(const std::string& text) const {
    if (const auto it = m_expressions.find(text); it != m_expressions.end()) return it->second;
    if (m_versions.empty()) return Error{errors::RecordingHasNoProgram(), ""};
    auto expression = driver::compileExpression(m_versions.back().checked, text);
    if (expression) m_expressions.emplace(text, *expression);
    return expression;
}

Result<expression::Expression> FileRecording::expression(const std::string& text, const std::string& scope,
                                                         const image::CompiledProgram& program) const {
    for (const Version& version : m_versions)
        if (version.program->version == program.version) return driver::compileExpression(version.checked, text, scope);
    return Error{errors::RecordingHasNoProgram(), ""};
}

history::Recompile FileRecording::recompile(const std::string& text) const {
    return [this, text](const image::CompiledProgram& program) -> expression::Expression {
        for (const Version& version : m_versions)
            if (version.program->version == program.version) {
                auto expression = driver::compileExpression(version.checked, text);
                return expression ? *expression : expression::Expression();
            }
        return {};
    };
}

Result<ChannelType> FileRecording::typeOf(const std::string& text) const {
    const auto expression = compile(text);
    if (!expression) return expression.error();
    return channelTypeOf(*expression);
}

std::vector<history::Sample> FileRecording::samples(const std::string& text, Position from, Position to) const {
    const auto expression = compile(text);
    return expression ? m_history->samples(*expression, recompile(text), from, to) : std::vector<history::Sample>();
}

std::optional<Position> FileRecording::find(const std::string& text, Position from,
                                            history::History::Direction direction) const {
    const auto expression = compile(text);
    return expression ? m_history->find(*expression, recompile(text), from, direction) : std::nullopt;
}

std::optional<Position> FileRecording::findChange(const std::string& text, Position from,
                                                  history::History::Direction direction) const {
    const auto expression = compile(text);
    return expression ? m_history->findChange(*expression, recompile(text), from, direction) : std::nullopt;
}

std::shared_ptr<const image::CompiledProgram> FileRecording::program() const {
    return m_versions.empty() ? nullptr : m_versions.back().program;
}

} // namespace plc::trace
