// "Who set this?"
#include "runtime/inside/reasoner_state.h"
#include "runtime/inside/texts.h"

#include <algorithm>

namespace plc::inside {

using image::OutsideKind;
using image::WatchKind;

history::Recompile Reasoner::recompile(const Question& question) const {
    return [this, question](const image::CompiledProgram& program) {
        auto expression = compile(question, program);
        return expression ? *expression : expression::Expression();
    };
}

Result<expression::Expression> Reasoner::compile(const Question& question,
                                                 const image::CompiledProgram& program) const {
    const auto key = std::tuple(&program, question.text, question.scope);
    if (const auto known = m_expressions.find(key); known != m_expressions.end()) return known->second;
    auto checked = m_checked.find(&program);
    if (checked == m_checked.end()) {
        driver::Checked found;
        // Only the shared pointer leads to what a program was built from.
        for (const auto& shared : m_insight.history().programs())
            if (shared.get() == &program) found = driver::checkedOf(shared);
        checked = m_checked.emplace(&program, std::move(found)).first;
    }
    if (!checked->second.analysis) return Error{texts::NotBuiltFromSources(), {}};
    auto expression = driver::compileExpression(checked->second, question.text, question.scope);
    return m_expressions.emplace(key, std::move(expression)).first->second;
}

const StatementMap& Reasoner::mapOf(const Look& look) {
    std::unique_ptr<StatementMap>& map = m_maps[&look.tree()];
    if (!map) map = std::make_unique<StatementMap>(look.tree());
    return *map;
}

Result<Reasoner::Asked> Reasoner::ask(const Question& question, Position at) {
    Asked asked;
    asked.question = question;
    asked.at = at;
    asked.image = m_insight.history().seek(at, &asked.program);
    const auto stamp = m_insight.history().stamp(at);
    if (asked.image.empty() || !stamp || !asked.program) return Error{texts::ScanNotThere(), {}};
    asked.stamp = *stamp;
    auto expression = compile(question, *asked.program);
    if (!expression) return expression.error();
    asked.expression = *expression;
    asked.value = asked.text(asked.image);
    return asked;
}

std::optional<Position> Reasoner::lastChange(const expression::Expression& expression, const Question& question,
                                             Position at) {
    return m_insight.history().findChange(expression, recompile(question), at + 1,
                                          history::History::Direction::Backward);
}

std::vector<image::Place> Reasoner::placesOf(const Asked& asked) const {
    if (const auto place = asked.expression.place()) return {*place};
    std::vector<image::Place> places;
    const image::Layout& layout = asked.program->layout;
    for (const image::AreaRange& range : asked.expression.reads().ranges)
        for (const image::Root& root : layout.roots) {
            const uint32_t size = root.bit >= 0 ? 1 : (*layout.types)[root.type].size;
            if (root.offset >= range.begin + range.size || range.begin >= root.offset + size) continue;
            layout.forEachLeaf(image::Layout::pathOf(root), {root.type, root.offset, root.bit},
                               [&](const std::string&, const image::Place& leaf) {
                                   const uint32_t width = leaf.bit >= 0 ? 1 : (*layout.types)[leaf.type].size;
                                   if (leaf.offset < range.begin + range.size && range.begin < leaf.offset + width)
                                       places.push_back(leaf);
                                   // Of "a + b" both are asked; of a whole array nobody reads more writers than these.
                                   return places.size() < 64;
                               });
        }
    return places;
}

namespace {

WriterKind kindOf(OutsideKind kind) {
    switch (kind) {
    case OutsideKind::Write:
        return WriterKind::Written;
    case OutsideKind::Force:
        return WriterKind::Forced;
    case OutsideKind::Reset:
        return WriterKind::Reset;
    case OutsideKind::OnlineChange:
        return WriterKind::OnlineChange;
    case OutsideKind::Retain:
        return WriterKind::Retain;
    case OutsideKind::Stopped:
    case OutsideKind::Fault:
        return WriterKind::SafeState;
    case OutsideKind::Resumed:
        return WriterKind::Resumed;
    case OutsideKind::Function:
        return WriterKind::Test;
    case OutsideKind::Started:
    case OutsideKind::Paused:
    case OutsideKind::Release:
    case OutsideKind::ReleaseAll:
        return WriterKind::Unknown;
    }
    return WriterKind::Unknown;
}

/// Of an online change: what the program before did not have has not been carried over.
bool hadBefore(const history::History& history, history::Position at, const std::string& path) {
    std::shared_ptr<const image::CompiledProgram> before;
    if (at > 0) (void)history.seek(at - 1, &before);
    return !before || before->layout.find(path);
}

bool covers(uint32_t offset, uint32_t size, int bit, const image::Place& place, uint32_t placeSize) {
    if (offset >= place.offset + placeSize || place.offset >= offset + size) return false;
    return bit < 0 || place.bit < 0 || bit == place.bit;
}

bool isGivenFromOutside(WriterKind kind) {
    return kind == WriterKind::Written || kind == WriterKind::Forced || kind == WriterKind::Retain;
}

} // namespace

/// What acted from outside on the bytes when the scan began.
std::optional<Writer> Reasoner::outsideWriter(const image::Place& place, Position at,
                                              const std::shared_ptr<const image::CompiledProgram>& program) {
    const Result<history::ScanInput> input = m_insight.history().inputOf(at);
    const auto stamp = m_insight.history().stamp(at);
    if (!input || !stamp) return std::nullopt;
    Writer writer;
    writer.program = program;
    writer.at = *stamp;
    writer.path = nameOf(program->layout, place);
    const uint32_t size = place.bit >= 0 ? 1 : (*program->layout.types)[place.type].size;
    std::optional<Writer> found;
    for (const image::OutsideNote& note : input->notes) {
        writer.kind = kindOf(note.kind);
        writer.origin = note.origin;
        if (writer.kind == WriterKind::Unknown) continue;
        if (note.size == 0 || covers(note.offset, note.size, note.bit, place, size)) {
            // A note without a size (a reset, an online change) is about everything: one about these bytes says more.
            const bool isPrecise = note.size > 0;
            if (isPrecise || !found || found->kind != WriterKind::Written) found = writer;
        }
    }
    if (found && found->kind == WriterKind::OnlineChange && !hadBefore(m_insight.history(), at, found->path))
        found->kind = WriterKind::Initial;
    // A test calls functions from outside, which may or may not have written this: anything else explains it better.
    if (found && found->kind != WriterKind::Test) return found;
    for (const image::ForcedBytes& forced : input->start.forces)
        if (covers(forced.offset, forced.size, forced.bit, place, size)) {
            writer.kind = WriterKind::Forced;
            writer.origin.clear();
            return writer;
        }
    if (!found && input->start.timeBefore < 0) {
        writer.kind = WriterKind::Initial;
        writer.origin.clear();
        return writer;
    }
    return found;
}

Result<Writer> Reasoner::writerOf(const Question&, const image::Place& place, Position at) {
    auto look = m_insight.look(at);
    if (!look) return look.error();
    const image::CompiledProgram& program = (*look)->program();
    const uint32_t size = place.bit >= 0 ? 1 : (*program.layout.types)[place.type].size;
    const std::shared_ptr<const image::CompiledProgram> shared = (*look)->input().program;
    // First of all: a forced variable has that value whatever a statement wrote in between.
    for (const image::ForcedBytes& forced : (*look)->input().start.forces)
        if (covers(forced.offset, forced.size, forced.bit, place, size))
            if (auto writer = outsideWriter(place, at, shared)) return *writer;
    if ((*look)->isCut()) { // what wrote it last may be among what was not kept
        Writer unknown;
        unknown.kind = WriterKind::Unknown;
        unknown.program = shared;
        unknown.at = (*look)->input().stamp;
        unknown.path = nameOf(program.layout, place);
        return unknown;
    }
    const auto end = static_cast<EventIndex>((*look)->events().size());
    const EventIndex last = (*look)->lastWriteBefore(end, place.offset, size, place.bit);
    if (last == kNone) {
        if (auto writer = outsideWriter(place, at, shared)) return *writer;
        return Error{texts::NothingWroteIt(), {}};
    }
    const Event& event = (*look)->events()[last];
    Writer writer;
    writer.kind = WriterKind::Statement;
    writer.program = shared;
    writer.at = (*look)->input().stamp;
    writer.path = nameOf(program.layout, place);
    uint32_t index = event.activation;
    if (event.node) writer.range = event.stmt()->range;
    for (EventIndex i = last; writer.range.length() == 0 && i-- > 0;) // made by the compiler: what it belongs to
        if ((*look)->events()[i].kind == WatchKind::Statement && (*look)->events()[i].activation == index)
            writer.range = (*look)->events()[i].stmt()->range;
    writer.function = program.functions[(*look)->activations()[index].function].name;
    writer.instance = (*look)->instanceOf(index);
    for (; index != kNone; index = (*look)->activations()[index].parent) {
        const Activation& activation = (*look)->activations()[index];
        CallStep step{program.functions[activation.function].name, (*look)->instanceOf(index), {}};
        if (activation.call != kNone)
            for (EventIndex i = activation.call; i-- > 0;)
                if ((*look)->events()[i].kind == WatchKind::Statement &&
                    (*look)->events()[i].activation == activation.parent) {
                    step.range = (*look)->events()[i].stmt()->range;
                    break;
                }
        writer.calls.insert(writer.calls.begin(), std::move(step));
        if (activation.task != kNone) writer.task = program.tasks[activation.task].name;
    }
    return writer;
}

Result<Writer> Reasoner::lastWriter(const Question& question, Position at) {
    Result<Asked> asked = ask(question, at);
    if (!asked) return asked.error();
    const std::optional<Position> change = lastChange(asked->expression, question, at);
    const Position when = change ? *change : m_insight.history().statistics().first;
    Result<Asked> then = ask(question, when);
    if (!then) return then.error();
    Result<Writer> writer = Error{texts::NothingWroteIt(), {}};
    std::vector<std::byte> before = when > 0 ? m_insight.history().seek(when - 1) : std::vector<std::byte>();
    for (const image::Place& place : placesOf(*then)) {
        const size_t size = place.bit >= 0 ? 1 : (*then->program->layout.types)[place.type].size;
        const bool isSame = before.size() >= place.offset + size && then->image.size() >= place.offset + size &&
                            std::equal(before.begin() + place.offset, before.begin() + place.offset + size,
                                       then->image.begin() + place.offset);
        if (writer && isSame) continue;
        Result<Writer> found = writerOf(question, place, when);
        if (found && (!isSame || !writer)) writer = std::move(found);
        if (writer && !isSame) break;
    }
    if (!writer) return writer;
    writer->value = then->value;
    if (change) writer->before = then->text(before);
    return writer;
}

/// The first scan that is recorded has none before it: what it changed differs from what it began with, and what it
/// began with counts where somebody gave it.
std::optional<Writer> Reasoner::firstWriter(const Question& question, Position first) {
    Result<Writer> writer = lastWriter(question, first);
    if (!writer) return std::nullopt;
    if (isGivenFromOutside(writer->kind)) return std::move(*writer);
    const Result<Asked> asked = ask(question, first);
    const Result<history::ScanInput> input = m_insight.history().inputOf(first);
    if (writer->kind != WriterKind::Statement || !asked || !input) return std::nullopt;
    writer->before = asked->text(input->image);
    return writer->before == writer->value ? std::nullopt : std::optional(std::move(*writer));
}

Result<std::vector<Writer>> Reasoner::writers(const Question& question, Position from, Position to, size_t limit) {
    std::vector<Writer> all;
    if (to == 0) return all;
    Result<Asked> asked = ask(question, to - 1);
    if (!asked) return asked.error();
    if (const Position first = m_insight.history().statistics().first; from <= first && first < to && limit > 0)
        if (auto writer = firstWriter(question, first)) all.push_back(std::move(*writer));
    for (Position at = from; all.size() < limit && !m_insight.isCancelled();) {
        const std::optional<Position> change = m_insight.history().findChange(asked->expression, recompile(question),
                                                                              at, history::History::Direction::Forward);
        if (!change || *change >= to) break;
        at = *change;
        if (auto writer = lastWriter(question, at)) all.push_back(std::move(*writer));
    }
    return all;
}

Result<std::vector<Writer>> Reasoner::writersBackFrom(const Question& question, Position at, size_t limit) {
    std::vector<Writer> all;
    Result<Asked> asked = ask(question, at);
    if (!asked) return asked.error();
    for (Position before = at + 1; all.size() < limit && !m_insight.isCancelled();) {
        const std::optional<Position> change = lastChange(asked->expression, question, before - 1);
        const Position when = change ? *change : m_insight.history().statistics().first;
        auto writer = lastWriter(question, when);
        // The beginning of the recording is no writer by itself; it counts where something is known of it.
        if (writer && (change || writer->kind != WriterKind::Unknown)) all.push_back(std::move(*writer));
        if (!change) break;
        before = *change;
    }
    return all;
}

} // namespace plc::inside
