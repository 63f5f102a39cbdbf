#include "projects/loops/loops.h"

#include "projects/loops/errors.h"
#include "runtime/base/assert.h"
#include "runtime/base/text.h"

#include <algorithm>
#include <future>
#include <set>

namespace plc::loops {

namespace {

using image::Place;

bool isNamed(const types::TypeTable& types, types::TypeId type, std::string_view name) {
    for (; type.isValid() && types[type].kind == types::TypeKind::Block; type = types[type].base)
        if (equalsIgnoringCase(types[type].name, name)) return true;
    return false;
}

bool hasPins(const image::CompiledProgram& program, const Loop& loop) {
    const tuning::BlockForm& form = *loop.form;
    for (const std::string_view pin : {form.input, form.output, form.setPoint})
        if (!program.layout.find(loop.pin(pin))) return false;
    return std::all_of(form.parameters.begin(), form.parameters.end(), [&](const tuning::ParameterForm& parameter) {
        return static_cast<bool>(program.layout.find(loop.pin(parameter.member)));
    });
}

double taskTimeOf(const image::CompiledProgram& program, const std::string& path) {
    for (const image::Task& task : program.tasks)
        for (const image::TaskProgram& one : task.programs) {
            const std::string root = image::Layout::pathOf(program.layout.roots[one.root]);
            if (path.size() > root.size() && path[root.size()] == '.' &&
                equalsIgnoringCase(path.substr(0, root.size()), root))
                return std::chrono::duration<double>(task.interval).count();
        }
    return 0;
}

/// Every instance whose type is one of the controllers'.
void addInstance(const image::CompiledProgram& program, const std::string& instance, types::TypeId type,
                 std::vector<Loop>& out) {
    for (const tuning::BlockForm& form : tuning::blockForms()) {
        if (!isNamed(*program.layout.types, type, form.type)) continue;
        Loop loop;
        loop.instance = instance;
        loop.name = form.part.empty() ? instance : instance + "." + std::string(form.part);
        loop.form = &form;
        if (!hasPins(program, loop)) continue;
        loop.taskTime = taskTimeOf(program, instance);
        out.push_back(std::move(loop));
    }
}

/// Instances inside instances, structures and (the first elements of) arrays.
void visit(const image::CompiledProgram& program, const std::string& path, types::TypeId type, int depth,
           std::vector<Loop>& out) {
    constexpr int kDeepest = 12;
    const types::TypeTable& types = *program.layout.types;
    const types::Type& is = types[type];
    if (depth > kDeepest) return;
    if (is.kind == types::TypeKind::Array) {
        constexpr int64_t kMost = 64;
        if (is.dimensions.size() != 1 || !types.isAggregate(is.element)) return;
        for (int64_t i = is.dimensions[0].low; i <= is.dimensions[0].high && i < is.dimensions[0].low + kMost; ++i)
            visit(program, path + "[" + std::to_string(i) + "]", is.element, depth + 1, out);
        return;
    }
    if (is.kind == types::TypeKind::Block) {
        const size_t before = out.size();
        addInstance(program, path, type, out);
        if (out.size() > before) return;
    }
    if (is.kind != types::TypeKind::Block && is.kind != types::TypeKind::Struct) return;
    for (const types::Field& field : is.fields)
        if (types.isAggregate(field.type)) visit(program, path + "." + field.name, field.type, depth + 1, out);
}

/// What the text means in a version of the program that the recording holds: the front end is asked again, each reader
/// of a history keeps the answer for as long as it reads.
history::Recompile recompileOf(const history::History& history, const std::string& text) {
    return [&history, text](const image::CompiledProgram& version) {
        for (const ProgramPointer& program : history.programs()) {
            if (program.get() != &version) continue;
            const driver::Checked checked = driver::checkedOf(program);
            if (!checked.analysis) break;
            auto compiled = driver::compileExpression(checked, text);
            return compiled ? std::move(*compiled) : expression::Expression();
        }
        return expression::Expression();
    };
}

Result<expression::Expression> newestMeaning(const history::History& history, const std::string& text) {
    const auto programs = history.programs();
    for (auto program = programs.rbegin(); program != programs.rend(); ++program)
        if (const driver::Checked checked = driver::checkedOf(*program); checked.analysis)
            return driver::compileExpression(checked, text);
    return Error{errors::NoProgramInRecording(), text};
}

} // namespace

std::optional<double> numberAt(const image::CompiledProgram& program, std::span<const std::byte> image,
                               const std::string& path) {
    const auto place = program.layout.find(path);
    if (!place) return std::nullopt;
    const types::TypeTable& types = *program.layout.types;
    const types::Value value = types::readValue(types, place->type, image.subspan(place->offset), place->bit);
    if (const auto* number = std::get_if<double>(&value.data)) return *number;
    if (const auto* number = std::get_if<int64_t>(&value.data)) {
        const bool isTime = types.family(place->type) == types::Family::Duration;
        return isTime ? static_cast<double>(*number) * 1e-9 : static_cast<double>(*number);
    }
    return std::nullopt;
}

std::string Loop::pin(std::string_view member) const { return instance + "." + std::string(member); }

std::vector<Loop> loopsOf(const image::CompiledProgram& program) {
    std::vector<Loop> out;
    for (const image::Root& root : program.layout.roots)
        if (!root.isHidden && !root.constant && program.layout.types->isAggregate(root.type))
            visit(program, image::Layout::pathOf(root), root.type, 0, out);
    return out;
}

Result<Loop> findLoop(const image::CompiledProgram& program, const std::string& name) {
    const std::vector<Loop> all = loopsOf(program);
    std::vector<std::string> names;
    std::vector<const Loop*> byInstance, byName; // a part of the name will do
    const auto endsWith = [&](const std::string& whole) {
        return whole.size() > name.size() && whole[whole.size() - name.size() - 1] == '.' &&
               equalsIgnoringCase(whole.substr(whole.size() - name.size()), name);
    };
    for (const Loop& loop : all) {
        if (equalsIgnoringCase(loop.name, name)) return loop;
        if (endsWith(loop.instance)) byInstance.push_back(&loop);
        if (endsWith(loop.name)) byName.push_back(&loop);
        names.push_back(loop.name);
    }
    if (byInstance.size() == 1) return *byInstance.front();
    if (byInstance.empty() && byName.size() == 1) return *byName.front();
    if (all.empty()) return Error{errors::NoLoops(), name};
    const std::vector<const Loop*>& several = byInstance.empty() ? byName : byInstance;
    if (several.empty()) return Error{errors::NoLoop(name, names), ""};
    names.clear();
    for (const Loop* loop : several) names.push_back(loop->name);
    return Error{errors::SeveralLoops(name, names), ""};
}

namespace {
/// In parts, so that an hour of scans needs no memory of its own.
template <class Visit>
void forEachSample(const history::History& history, const expression::Expression& expression,
                   const history::Recompile& recompile, history::PositionRange range, const Visit& visit) {
    constexpr history::Position kPart = history::Position(1) << 18;
    for (history::Position at = range.begin; at < range.end; at += kPart)
        for (const history::Sample& sample :
             history.samples(expression, recompile, at, std::min(at + kPart, range.end)))
            visit(sample);
}
} // namespace

Signals signalsOf(const Loop& loop) {
    return {loop.pin(loop.form->input), loop.pin(loop.form->output), loop.pin(loop.form->setPoint)};
}

namespace {

/// A signal, ready to be read. The expression is compiled by who makes it; it is read on a thread of its own.
class Channel {
public:
    static Result<std::unique_ptr<Channel>> of(const history::History& history, const std::string& text) {
        const auto expression = newestMeaning(history, text);
        if (!expression) return expression.error();
        const types::Family family = expression->types().family(expression->type());
        if (family == types::Family::Other || family == types::Family::Character ||
            expression->types().isAggregate(expression->type()))
            return Error{errors::NotASignal(), text};
        return std::unique_ptr<Channel>(new Channel(*expression, recompileOf(history, text)));
    }
    void read(const history::History& history, const std::vector<history::PositionRange>& ranges, bool wantsTime) {
        size_t rowsBefore = 0; // of the range
        for (const history::PositionRange& range : ranges) {
            forEachSample(history, m_expression, m_recompile, range, [&](const history::Sample& sample) {
                const size_t row = rowsBefore + static_cast<size_t>(sample.at.position - range.begin);
                if (row != first + values.size()) beginAt(row);
                if (wantsTime) time.push_back(std::chrono::duration<double>(sample.at.time).count());
                values.push_back(sample.hasValue ? sample.value : values.empty() ? 0.0 : values.back());
            });
            rowsBefore += static_cast<size_t>(range.end - range.begin);
        }
        if (rowsBefore != first + values.size()) beginAt(rowsBefore); // the last scans are gone, too
    }
    /// Drops the values of the rows before.
    void beginAt(size_t row) {
        const auto old = static_cast<std::ptrdiff_t>(std::min(row - first, values.size()));
        values.erase(values.begin(), values.begin() + old);
        if (!time.empty()) time.erase(time.begin(), time.begin() + old);
        first = row;
    }
    size_t first = 0; // row of the first value: what was recorded before was forgotten while it was read
    std::vector<double> time, values;

private:
    Channel(expression::Expression expression, history::Recompile recompile)
        : m_expression(std::move(expression)), m_recompile(std::move(recompile)) {}
    expression::Expression m_expression;
    history::Recompile m_recompile;
};

/// The first ones.
void dropRows(std::vector<history::PositionRange>& scans, size_t rows) {
    while (!scans.empty() && rows > 0) {
        const size_t dropped = std::min(rows, static_cast<size_t>(scans.front().end - scans.front().begin));
        scans.front().begin += dropped;
        rows -= dropped;
        if (scans.front().begin == scans.front().end) scans.erase(scans.begin());
    }
}

} // namespace

history::PositionRange RecordedSeries::scansOf(size_t begin, size_t end) const {
    PLC_ASSERT(begin < end && end <= series.size(), return {});
    size_t rowsBefore = 0; // of the range
    for (const history::PositionRange& range : scans) {
        const size_t rows = static_cast<size_t>(range.end - range.begin);
        if (end <= rowsBefore + rows)
            return {range.begin + (std::max(begin, rowsBefore) - rowsBefore), range.begin + (end - rowsBefore)};
        rowsBefore += rows;
    }
    return {};
}

Result<RecordedSeries> seriesOf(const history::History& history, const Signals& channels) {
    const history::Statistics all = history.statistics();
    RecordedSeries out;
    for (history::PositionRange range : history::chainTo(history.branches(), all.end)) {
        range.begin = std::max(range.begin, all.first);
        if (range.begin < range.end) out.scans.push_back(range);
    }
    struct Reading {
        std::unique_ptr<Channel> channel;
        std::vector<double> tuning::LoopSeries::*target;
        std::future<void> done;
    };
    std::vector<Reading> readings;
    for (const auto& [text, target] : {std::pair{channels.input, &tuning::LoopSeries::input},
                                       std::pair{channels.output, &tuning::LoopSeries::output},
                                       std::pair{channels.setPoint, &tuning::LoopSeries::setPoint}}) {
        if (text.empty()) continue;
        auto channel = Channel::of(history, text);
        if (!channel) return channel.error();
        readings.push_back({std::move(*channel), target, {}});
    }
    // an hour of 1 ms scans takes a while: all of them at once
    for (Reading& reading : readings)
        reading.done = std::async(std::launch::async, [&, wantsTime = &reading == readings.data()] {
            reading.channel->read(history, out.scans, wantsTime);
        });
    size_t first = 0; // the row that all of them have
    for (Reading& reading : readings) {
        reading.done.get();
        first = std::max(first, reading.channel->first);
    }
    for (Reading& reading : readings) {
        reading.channel->beginAt(first);
        out.series.*reading.target = std::move(reading.channel->values);
    }
    if (!readings.empty()) out.series.time = std::move(readings.front().channel->time);
    dropRows(out.scans, first);
    if (auto checked = tuning::checkSeries(out.series); !checked) return checked.error();
    return out;
}

Settings settingsOf(const Loop& loop, const image::CompiledProgram& program, std::span<const std::byte> image) {
    Settings out;
    const auto at = [&](std::string_view member) { return numberAt(program, image, loop.pin(member)); };
    for (const tuning::ParameterForm& parameter : loop.form->parameters)
        out.values.push_back(at(parameter.member).value_or(0));
    out.gains = tuning::gainsOf(*loop.form, out.values);
    if (!loop.form->low.empty()) {
        out.low = at(loop.form->low);
        out.high = at(loop.form->high);
        if (out.low && out.high && !(*out.high > *out.low)) out.low = out.high = std::nullopt;
    }
    out.cycle = loop.taskTime;
    if (!loop.form->cycle.empty())
        if (const auto cycle = at(loop.form->cycle); cycle && *cycle > 0)
            out.cycle = loop.form->cycleUnit == tuning::Unit::Milliseconds ? *cycle * 1e-3 : *cycle;
    return out;
}

} // namespace plc::loops
