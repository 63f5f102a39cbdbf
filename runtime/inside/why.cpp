#include "runtime/base/messages.h"
#include "runtime/inside/reasoner_state.h"
#include "runtime/inside/texts.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace plc::inside {

using types::TypeKind;

namespace {

constexpr size_t kMostReruns = 4000, kMostLooks = 60, kMostWays = 6;
constexpr size_t kMostTogether = 3; // changes in one way
constexpr Position kLooksBack = 100'000;

uint32_t sizeOf(const image::Layout& layout, const image::Place& place) {
    return place.bit >= 0 ? 1 : std::max(1u, (*layout.types)[place.type].size);
}

bool isSame(const image::Layout& layout, const image::Place& place, std::span<const std::byte> a,
            std::span<const std::byte> b) {
    const uint32_t size = sizeOf(layout, place);
    if (a.size() < place.offset + size || b.size() < place.offset + size) return true;
    if (place.bit >= 0) return ((a[place.offset] ^ b[place.offset]) & std::byte(1 << place.bit)) == std::byte{};
    return std::memcmp(a.data() + place.offset, b.data() + place.offset, size) == 0;
}

void copyPlace(const image::Layout& layout, const image::Place& place, std::span<const std::byte> from,
               std::span<std::byte> to) {
    const uint32_t size = sizeOf(layout, place);
    if (from.size() < place.offset + size || to.size() < place.offset + size) return;
    if (place.bit >= 0) {
        const auto mask = std::byte(1 << place.bit);
        to[place.offset] = (to[place.offset] & ~mask) | (from[place.offset] & mask);
        return;
    }
    std::memcpy(to.data() + place.offset, from.data() + place.offset, size);
}

bool isInput(const image::Layout& layout, const image::Place& place) {
    return place.offset >= layout.inputs.begin && place.offset < layout.inputs.begin + layout.inputs.size;
}

/// Puts the value there; an input is held, or the plant would write it at once.
void put(history::ScanInput& input, const image::Place& place, const types::Value& value) {
    const image::Layout& layout = input.program->layout;
    types::writeValue(*layout.types, place.type, value, std::span(input.image).subspan(place.offset), place.bit);
    if (!isInput(layout, place)) return;
    image::ForcedBytes held{place.offset, sizeOf(layout, place), place.bit, {}, {}};
    held.bytes.assign(input.image.begin() + place.offset, input.image.begin() + place.offset + held.size);
    input.start.forces.push_back(std::move(held));
}

/// The value in the type of a variable; none where it does not fit.
std::optional<types::Value> asType(const types::TypeTable& types, types::TypeId type, const types::Value& value,
                                   double more) {
    types::Value made;
    made.type = type;
    double number = 0;
    if (const auto* integer = std::get_if<int64_t>(&value.data))
        number = static_cast<double>(*integer);
    else if (const auto* real = std::get_if<double>(&value.data))
        number = *real;
    else
        return std::nullopt;
    number += more;
    if (types.family(type) == types::Family::Real) {
        made.data = number;
        return made;
    }
    if (!std::isfinite(number) || std::fabs(number) > 9e15) return std::nullopt;
    if (types::isInteger(types.family(type)) && types[types.storage(type)].size < 8) {
        const auto [low, high] = types::TypeTable::integerRange(types.storageKind(type));
        if (number < static_cast<double>(low) || number > static_cast<double>(high)) return std::nullopt;
    }
    made.data = static_cast<int64_t>(std::llround(number));
    return made;
}

/// Other values that a variable could have so that what it decides comes out otherwise.
std::vector<types::Value> alternatives(const image::Layout& layout, const Leaf& leaf) {
    std::vector<types::Value> all;
    const types::TypeTable& types = *layout.types;
    if (leaf.isClock || !leaf.value.hasValue() || types.isText(leaf.place.type)) return all;
    if (types.storageKind(leaf.place.type) == TypeKind::Bool) {
        types::Value flipped = leaf.value;
        flipped.data = static_cast<int64_t>(leaf.value.isTrue() ? 0 : 1);
        all.push_back(flipped);
        return all;
    }
    const double step = types.family(leaf.place.type) == types::Family::Duration ? 1e6 : 1;
    for (const types::Value& other : leaf.others)
        for (const double more : {0.0, step, -step})
            if (const auto value = asType(types, leaf.place.type, other, more);
                value && !(value->data == leaf.value.data) && std::find(all.begin(), all.end(), *value) == all.end())
                all.push_back(*value);
    return all;
}

std::string textOf(const image::Layout& layout, const types::Value& value) {
    return value.hasValue() ? types::toText(*layout.types, value) : std::string();
}

std::string sourceText(const image::CompiledProgram& program, SourceRange range) {
    if (range.file.index() >= program.sources.files.size() || range.end <= range.begin) return {};
    return std::string(program.sources[range.file].slice(range));
}

} // namespace

std::string Reasoner::outcomeOf(history::ScanInput input, const expression::Expression& expression) {
    const uint32_t end = input.program->layout.dataEnd;
    const Rerun made = m_insight.rerunner().runFrom(std::move(input));
    if (made.image.size() < end || m_insight.isCancelled()) return {};
    const expression::Outcome outcome = expression.evaluate(made.image);
    return outcome.hasValue() ? types::toText(expression.types(), outcome.value) : std::string();
}

/// The scan before `at` in which the task ran: with what it then began, it would have decided as then.
Position Reasoner::previousRun(Position at, uint32_t task, const image::CompiledProgram& program) const {
    const history::History& history = m_insight.history();
    const Position first = history.statistics().first;
    if (at <= first) return at;
    if (task == kNone || program.tasks[task].kind != image::TaskKind::Cyclic ||
        program.tasks[task].interval.count() <= 0)
        return at - 1;
    const int64_t interval = program.tasks[task].interval.count();
    for (Position p = at - 1; p > first && at - p < kLooksBack; --p) {
        const auto now = history.stamp(p), before = history.stamp(p - 1);
        if (!now || !before) return p;
        if (now->time.count() / interval > before->time.count() / interval || now->time < before->time) return p;
    }
    return first;
}

Part Reasoner::partOf(const Leaf& leaf, Position at, const image::CompiledProgram& program) {
    Part part;
    part.path = leaf.path;
    part.place = leaf.place;
    part.isClock = leaf.isClock;
    part.condition = sourceText(program, leaf.condition);
    part.value = textOf(program.layout, leaf.value);
    if (leaf.isClock || leaf.path.empty()) return part;
    // What it had when the scan began it got in this scan from outside, or in one before.
    if (const auto shared = m_insight.history().inputOf(at); shared && leaf.place.type.isValid()) {
        const bool actedNow =
            std::any_of(shared->notes.begin(), shared->notes.end(), [&](const image::OutsideNote& note) {
                return note.size > 0 && note.offset < leaf.place.offset + sizeOf(program.layout, leaf.place) &&
                       leaf.place.offset < note.offset + note.size &&
                       (note.bit < 0 || leaf.place.bit < 0 || note.bit == leaf.place.bit);
            });
        if (actedNow || at == 0 || shared->start.timeBefore < 0) {
            part.writer = outsideWriter(leaf.place, at, shared->program);
            return part;
        }
    }
    if (auto writer = lastWriter({leaf.path, {}}, at - 1)) part.writer = std::move(*writer);
    return part;
}

Result<Explanation> Reasoner::why(const Question& question, Position at, uint32_t depth) {
    Result<Asked> asked = ask(question, at);
    if (!asked) return asked.error();
    if (asked->value.empty())
        return Error{texts::NoValueInScan(asked->expression.evaluate(asked->image).reason), question.text};
    Explanation answer;
    answer.question = question;
    answer.value = asked->value;
    answer.asked = asked->stamp;
    answer.program = asked->program;
    const std::optional<Position> change = lastChange(asked->expression, question, at);
    const Position since = change ? *change : m_insight.history().statistics().first;
    Result<Asked> then = ask(question, since);
    if (!then) return then.error();
    answer.since = then->stamp;
    answer.isSinceBegin = !change;
    answer.program = then->program;
    if (change) answer.before = then->text(m_insight.history().seek(since - 1));
    if (auto writer = lastWriter(question, at)) answer.writer = std::move(*writer);
    auto look = m_insight.look(since);
    if (m_insight.isCancelled()) return Error{errors::Cancelled(), question.text};
    if (look) answer.doubt = (*look)->doubt();
    if (look && !(*look)->isCut()) { // else the way to the value would be that of an earlier one
        const Slice slice = Slicer(**look, mapOf(**look)).sliceOf(placesOf(*then));
        answer.steps = slice.steps;
        if (change) findTriggers(answer, *then, since, slice, depth);
        findEnablers(answer, *then, since, slice);
    }
    if (at != since || !look) {
        auto now = m_insight.look(at);
        if (!now) return answer;
        if (answer.doubt.isEmpty()) answer.doubt = (*now)->doubt();
        if ((*now)->isCut()) return answer;
        const Slice slice = Slicer(**now, mapOf(**now)).sliceOf(placesOf(*asked));
        if (!look) answer.steps = slice.steps;
        Explanation holding;
        findEnablers(holding, *asked, at, slice);
        answer.holding = std::move(holding.enablers);
    }
    return answer;
}

// ---------------------------------------------------------------- triggers

namespace {

/// Something that the scan began with otherwise than the run before; it can be taken back.
struct Toggle {
    enum class Kind : uint8_t { Leaf, Clock, First, Forces } kind = Kind::Leaf;
    size_t leaf = 0;
};

} // namespace

namespace {

/// Variables that differ between the two beginnings and are not in `known`.
std::vector<Leaf> otherDifferences(const history::ScanInput& before, const history::ScanInput& now,
                                   const std::vector<Leaf>& known) {
    constexpr size_t kMost = 200;
    const image::Layout& layout = now.program->layout;
    std::vector<Leaf> found;
    const auto isKnown = [](const std::vector<Leaf>& leaves, const std::string& path) {
        return std::any_of(leaves.begin(), leaves.end(), [&](const Leaf& leaf) { return leaf.path == path; });
    };
    for (const history::Patch& patch :
         history::difference(before.image, now.image, sizeof(image::ImageHeader), layout.dataEnd, {})) {
        for (uint32_t at = 0; at < patch.bytes.size() && found.size() < kMost;) {
            Leaf leaf;
            leaf.path = layout.pathAt(patch.offset + at);
            const Result<image::Place> place = layout.find(leaf.path);
            if (leaf.path.empty() || !place || layout.types->isAggregate(place->type)) {
                ++at;
                continue;
            }
            at = std::max(at + 1, place->offset + sizeOf(layout, *place) - patch.offset);
            if (isKnown(known, leaf.path) || isKnown(found, leaf.path)) continue;
            leaf.place = *place;
            leaf.value =
                types::readValue(*layout.types, place->type, std::span(now.image).subspan(place->offset), place->bit);
            found.push_back(std::move(leaf));
        }
    }
    return found;
}

} // namespace

void Reasoner::findTriggers(Explanation& answer, const Asked& asked, Position changed, const Slice& slice,
                            uint32_t depth) {
    const Position base = previousRun(changed, slice.task, *asked.program);
    Result<history::ScanInput> now = m_insight.history().inputOf(changed);
    Result<history::ScanInput> before = m_insight.history().inputOf(base);
    if (!now || !before || base == changed || before->program != now->program) return;
    const image::Layout& layout = asked.program->layout;
    std::vector<Leaf> leaves = slice.leaves;
    std::vector<Toggle> toggles;
    for (size_t i = 0; i < leaves.size(); ++i) {
        const Leaf& leaf = leaves[i];
        if (leaf.isClock)
            toggles.push_back({Toggle::Kind::Clock, i});
        else if (!isSame(layout, leaf.place, before->image, now->image))
            toggles.push_back({Toggle::Kind::Leaf, i});
    }
    if (now->start.isFirst != before->start.isFirst && !now->startIsPartial)
        toggles.push_back({Toggle::Kind::First, 0});
    if (!(now->start.forces == before->start.forces)) toggles.push_back({Toggle::Kind::Forces, 0});
    const auto comesOut = [&](const std::vector<Toggle>& taken) {
        history::ScanInput input = *now;
        Rerunner::How how;
        for (const Toggle& toggle : taken) {
            if (toggle.kind == Toggle::Kind::Leaf)
                copyPlace(layout, leaves[toggle.leaf].place, before->image, input.image);
            if (toggle.kind == Toggle::Kind::Clock) how.clockBack = now->stamp.time - before->stamp.time;
            if (toggle.kind == Toggle::Kind::First) input.start.isFirst = before->start.isFirst;
            if (toggle.kind == Toggle::Kind::Forces) input.start.forces = before->start.forces;
        }
        const Rerun made = m_insight.rerunner().runFrom(std::move(input), how);
        return m_insight.isCancelled() ? std::string() : asked.text(made.image);
    };
    std::vector<Toggle> found;
    for (const Toggle& toggle : toggles)
        if (m_insight.isCancelled())
            return;
        else if (comesOut({toggle}) == answer.before)
            found.push_back(toggle);
    const auto togetherOf = [&] {
        if (toggles.empty() || comesOut(toggles) == answer.value) return;
        found = toggles; // only together: leave out what does not matter
        for (size_t i = 0; i < found.size() && found.size() > 1 && !m_insight.isCancelled();) {
            std::vector<Toggle> fewer = found;
            fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
            if (comesOut(fewer) != answer.value)
                found = std::move(fewer);
            else
                ++i;
        }
    };
    if (found.empty()) togetherOf();
    if (found.empty()) { // it was not on the way that was followed: whatever else differs
        for (Leaf& other : otherDifferences(*before, *now, leaves)) {
            toggles.push_back({Toggle::Kind::Leaf, leaves.size()});
            leaves.push_back(std::move(other));
        }
        togetherOf();
    }
    const auto isInside = [&](const Toggle& toggle) {
        return toggle.kind == Toggle::Kind::Leaf && leaves[toggle.leaf].isInternal;
    };
    if (!std::all_of(found.begin(), found.end(), isInside)) std::erase_if(found, isInside);
    for (const Toggle& toggle : found) {
        Part part;
        if (toggle.kind == Toggle::Kind::Leaf || toggle.kind == Toggle::Kind::Clock) {
            const Leaf& leaf = leaves[toggle.leaf];
            part = partOf(leaf, changed, *asked.program);
            if (!leaf.isClock)
                part.before = textOf(layout, types::readValue(*layout.types, leaf.place.type,
                                                              std::span(before->image).subspan(leaf.place.offset),
                                                              leaf.place.bit));
            const bool goesOn = depth > 0 && part.writer && part.writer->kind == WriterKind::Statement && changed > 0;
            if (goesOn)
                if (auto deeper = why({leaf.path, {}}, changed - 1, depth - 1))
                    part.because = std::move(deeper->triggers);
            // What counts on from itself is no news.
            std::erase_if(part.because, [&](const Part& deeper) { return deeper.path == part.path; });
        } else {
            part.isFirstScan = toggle.kind == Toggle::Kind::First;
            part.isForces = !part.isFirstScan;
        }
        part.isVerified = true;
        answer.triggers.push_back(std::move(part));
    }
}

void Reasoner::findEnablers(Explanation& answer, const Asked& asked, Position at, const Slice& slice) {
    Result<history::ScanInput> input = m_insight.history().inputOf(at);
    if (!input) return;
    const image::Layout& layout = asked.program->layout;
    size_t reruns = 0;
    for (const Leaf& leaf : slice.leaves) {
        const bool isTrigger = std::any_of(answer.triggers.begin(), answer.triggers.end(), [&](const Part& part) {
            return part.isClock == leaf.isClock && part.path == leaf.path;
        });
        if (isTrigger || leaf.isClock || leaf.isInternal) continue;
        for (const types::Value& other : alternatives(layout, leaf)) {
            if (++reruns > kMostReruns / 10 || m_insight.isCancelled()) return;
            history::ScanInput changed = *input;
            put(changed, leaf.place, other);
            if (outcomeOf(std::move(changed), asked.expression) == asked.value) continue;
            Part part = partOf(leaf, at, *asked.program);
            part.isVerified = true;
            answer.enablers.push_back(std::move(part));
            break;
        }
    }
}

// ---------------------------------------------------------------- why not

namespace {

struct Attempt {
    std::vector<std::pair<Leaf, types::Value>> changes;
};

bool holds(const Attempt& attempt, const Leaf& leaf) {
    return std::any_of(attempt.changes.begin(), attempt.changes.end(), [&](const auto& change) {
        return change.first.place.offset == leaf.place.offset && change.first.place.bit == leaf.place.bit;
    });
}

/// Every change of `smaller` is one of `larger`.
bool isWithin(const Attempt& smaller, const Attempt& larger) {
    return std::all_of(smaller.changes.begin(), smaller.changes.end(),
                       [&](const auto& change) { return holds(larger, change.first); });
}

} // namespace

Result<WhyNot> Reasoner::whyNot(const Question& question, Position at) {
    Result<Asked> asked = ask(question, at);
    if (!asked) return asked.error();
    if (asked->value != "TRUE" && asked->value != "FALSE") return Error{texts::NotNeedsCondition(), question.text};
    WhyNot answer;
    answer.question = question;
    answer.value = asked->value;
    answer.wanted = asked->value == "TRUE" ? "FALSE" : "TRUE";
    answer.asked = asked->stamp;
    answer.program = asked->program;
    auto look = m_insight.look(at);
    if (!look) return look.error();
    answer.doubt = (*look)->doubt();
    const Result<history::ScanInput> input = m_insight.history().inputOf(at);
    if (!input) return input.error();
    const image::Layout& layout = asked->program->layout;
    const std::vector<image::Place> targets = placesOf(*asked);
    const auto isTarget = [&](const Leaf& leaf) {
        return std::any_of(targets.begin(), targets.end(), [&](const image::Place& target) {
            return target.offset == leaf.place.offset && target.bit == leaf.place.bit;
        });
    };
    const auto apply = [&](const Attempt& attempt) {
        history::ScanInput changed = *input;
        for (const auto& [leaf, value] : attempt.changes) put(changed, leaf.place, value);
        return changed;
    };
    std::vector<Attempt> successes, open{Attempt{}};
    size_t reruns = 0, looks = 0;
    for (size_t together = 1; together <= kMostTogether && successes.size() < kMostWays; ++together) {
        std::vector<Attempt> next;
        for (const Attempt& attempt : open) {
            if (++looks > kMostLooks || m_insight.isCancelled()) break;
            const auto seen = attempt.changes.empty() ? look : m_insight.lookFrom(apply(attempt));
            if (!seen) continue;
            const Slice slice = Slicer(**seen, mapOf(**seen)).sliceOf(targets);
            if (attempt.changes.empty()) {
                answer.steps = slice.steps;
                answer.leaves = slice.leaves;
            }
            for (const Leaf& leaf : slice.leaves) {
                const bool isMeant = targets.size() == 1 && isTarget(leaf) && !isInput(layout, leaf.place);
                if (leaf.isClock || leaf.isInternal || isMeant || holds(attempt, leaf)) continue;
                for (const types::Value& value : alternatives(layout, leaf)) {
                    Attempt more = attempt;
                    more.changes.emplace_back(leaf, value);
                    const auto contains = [&](const Attempt& known) { return isWithin(known, more); };
                    if (std::any_of(successes.begin(), successes.end(), contains)) break;
                    if (++reruns > kMostReruns || m_insight.isCancelled()) break;
                    if (outcomeOf(apply(more), asked->expression) == answer.wanted) {
                        successes.push_back(std::move(more));
                        break;
                    }
                    next.push_back(std::move(more));
                }
            }
        }
        open = std::move(next);
    }
    for (const Attempt& success : successes) {
        std::vector<Change> way;
        for (const auto& [leaf, value] : success.changes)
            way.push_back({leaf.path, textOf(layout, leaf.value), textOf(layout, value), leaf.place});
        answer.ways.push_back(std::move(way));
        if (answer.ways.size() >= kMostWays) break;
    }
    return answer;
}

} // namespace plc::inside
