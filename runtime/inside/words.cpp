#include "runtime/inside/words.h"

#include "runtime/inside/texts.h"

#include <algorithm>
#include <cmath>

namespace plc::inside {

namespace {

constexpr size_t kLongestStatement = 90;
constexpr uint32_t kDeepestStep = 12;

double toThreeDigits(double value) { return std::round(value * 1000) / 1000; }

Message scanWords(const history::ScanStamp& at) { return texts::AtScan(timeWords(at.time), at.scan); }

} // namespace

Message timeWords(controller::Nanoseconds time) {
    const auto ns = static_cast<double>(time.count());
    if (std::fabs(ns) < 1e6 && time.count() != 0) return texts::Microseconds(toThreeDigits(ns / 1e3));
    if (std::fabs(ns) < 60e9) return texts::Seconds(toThreeDigits(ns / 1e9));
    const int64_t minutes = time.count() / 60'000'000'000;
    return texts::MinutesAndSeconds(minutes, toThreeDigits((ns - static_cast<double>(minutes) * 60e9) / 1e9));
}

Message blockNote(const Look& look, uint32_t instance, const types::Type& block) {
    const types::TypeTable& types = *look.tree().types;
    const auto read = [&](const char* name) -> std::optional<int64_t> {
        const types::Field* field = block.findField(name);
        if (!field || types.isAggregate(field->type) || types.isText(field->type)) return std::nullopt;
        const size_t offset = instance + field->offset;
        if (offset + types[types.storage(field->type)].size > look.image().size()) return std::nullopt;
        const types::Value value = types::readValue(types, field->type, look.image().subspan(offset), field->bit);
        const auto* integer = std::get_if<int64_t>(&value.data);
        return integer ? std::optional(*integer) : std::nullopt;
    };
    const auto elapsed = read("ET"), preset = read("PT"), counted = read("CV"), target = read("PV"), q = read("Q");
    if (elapsed && preset) {
        const auto in = read("IN");
        if (*elapsed >= *preset && *preset > 0)
            return texts::ItsTimeIsOver(timeWords(controller::Nanoseconds(*preset)));
        if (*elapsed == 0 && in && *in == 0 && (!q || *q == 0)) return texts::ItDoesNotRun();
        return texts::ItHasRun(timeWords(controller::Nanoseconds(*elapsed)),
                               timeWords(controller::Nanoseconds(*preset)),
                               timeWords(controller::Nanoseconds(*preset - *elapsed)));
    }
    if (counted && target) return texts::ItHasCounted(*counted, *target);
    return {};
}

std::string placeWords(const image::CompiledProgram& program, SourceRange range) {
    if (range.file.index() >= program.sources.files.size() || range.end <= range.begin) return {};
    const SourceText& text = program.sources[range.file];
    return text.path() + ":" + std::to_string(text.lineColumn(range.begin).line);
}

std::string statementWords(const image::CompiledProgram& program, SourceRange range) {
    if (range.file.index() >= program.sources.files.size() || range.end <= range.begin) return {};
    std::string shown;
    bool isSpace = false;
    for (const char c : program.sources[range.file].slice(range)) {
        const bool space = c == ' ' || c == '\t' || c == '\n' || c == '\r';
        if (space && isSpace) continue;
        isSpace = space;
        shown += space ? ' ' : c;
        if (shown.size() >= kLongestStatement) return shown + " …";
    }
    return shown;
}

namespace {

/// Who wrote from outside: what the journal keeps, in words.
messages::Thing originWords(const std::string& origin) {
    if (origin == "the command line") return messages::Phrase(texts::TheCommandLine());
    if (origin == "studio") return messages::Phrase(texts::TheStudio());
    constexpr std::string_view kPanel = "panel ";
    const size_t comma = origin.find(", ");
    if (origin.starts_with(kPanel) && comma != std::string::npos)
        return messages::Phrase(
            texts::PanelElement(origin.substr(kPanel.size(), comma - kPanel.size()), origin.substr(comma + 2)));
    return origin;
}

Message statementWriter(const Writer& writer) {
    const std::string statement = statementWords(*writer.program, writer.range),
                      place = placeWords(*writer.program, writer.range),
                      who = writer.instance.empty() ? writer.function : writer.instance;
    if (statement.empty()) return texts::SetByCompiler(who);
    if (writer.task.empty()) return texts::SetBy(statement, place, who);
    return texts::SetByInTask(statement, place, who, writer.task);
}

} // namespace

Message writerWords(const Writer& writer) {
    switch (writer.kind) {
    case WriterKind::Statement:
        return statementWriter(writer);
    case WriterKind::Written:
        return writer.origin.empty() ? texts::WrittenFromOutside() : texts::WrittenFrom(originWords(writer.origin));
    case WriterKind::Forced:
        return writer.origin.empty() ? texts::Forced() : texts::ForcedFrom(originWords(writer.origin));
    case WriterKind::Reset:
        return texts::PutBackByReset();
    case WriterKind::OnlineChange:
        return texts::CarriedOver();
    case WriterKind::Retain:
        return texts::Retained();
    case WriterKind::Initial:
        return texts::ItsInitialValue();
    case WriterKind::SafeState:
        return texts::SafeState();
    case WriterKind::Resumed:
        return texts::AsResumed();
    case WriterKind::Test:
        return texts::SetByTest();
    case WriterKind::Unknown:
        break;
    }
    return texts::WriterUnknown();
}

namespace {

/// The calls that led to it, innermost first, without the outermost: nothing of the user's called that.
void addCalls(std::vector<Sentence>& out, const Writer& writer) {
    for (size_t i = 1; i < writer.calls.size(); ++i) {
        const SourceRange range = writer.calls[i].range;
        out.push_back({SentenceKind::Writer,
                       texts::CalledBy(statementWords(*writer.program, range), placeWords(*writer.program, range)),
                       range,
                       writer.at,
                       {},
                       {}});
    }
}

void addWriter(Sentence& sentence, const Writer& writer) {
    sentence.at = writer.at;
    if (writer.kind == WriterKind::Statement) sentence.range = writer.range;
}

Message triggerWords(const Part& part) {
    if (part.isClock) return texts::TimePassed();
    if (part.isFirstScan) return texts::FirstScan();
    if (part.isForces) return texts::ForcesChanged();
    if (part.value.empty())
        return part.writer ? texts::ChangedBy(part.path, writerWords(*part.writer)) : texts::Changed(part.path);
    return part.writer ? texts::BecameBy(part.path, part.value, writerWords(*part.writer))
                       : texts::Became(part.path, part.value);
}

Message enablerWords(const Part& part) {
    if (part.isClock) return texts::TimePassed();
    if (!part.writer) return texts::Was(part.path, part.value);
    return texts::WasSince(part.path, part.value, timeWords(part.writer->at.time), writerWords(*part.writer));
}

Sentence sentenceOf(const Part& part, SentenceKind kind) {
    Sentence sentence;
    sentence.kind = kind;
    sentence.path = part.path;
    sentence.text = kind == SentenceKind::Trigger ? triggerWords(part) : enablerWords(part);
    if (part.writer) addWriter(sentence, *part.writer);
    if (part.because.empty()) return sentence;
    Sentence because{kind, texts::Because(), {}, {}, {}, {}};
    for (const Part& deeper : part.because) because.parts.push_back(sentenceOf(deeper, SentenceKind::Trigger));
    sentence.parts.push_back(std::move(because));
    return sentence;
}

void addParts(std::vector<Sentence>& out, Message head, const std::vector<Part>& parts, SentenceKind kind) {
    if (parts.empty()) return;
    Sentence sentence{kind, std::move(head), {}, {}, {}, {}};
    for (const Part& part : parts) sentence.parts.push_back(sentenceOf(part, kind));
    out.push_back(std::move(sentence));
}

Message blockWords(const Reason& step) {
    Message words = step.path.empty() ? texts::OnlyName(step.function) : texts::BlockOfType(step.path, step.blockType);
    return step.note.isEmpty() ? words : texts::WithNote(std::move(words), step.note);
}

/// Empty: nothing to say of it.
Message stepWords(const Reason& step, const image::CompiledProgram& program) {
    const std::string text = statementWords(program, step.range),
                      value = step.value.hasValue() ? types::toText(*program.layout.types, step.value) : std::string();
    switch (step.kind) {
    case Reason::Kind::Statement:
        return value.empty() ? texts::OnlyName(text) : texts::StatementGave(text, value);
    case Reason::Kind::Guard:
        return texts::ItRan(text, value);
    case Reason::Kind::NotReset:
        return texts::NotWrittenLater(text, value);
    case Reason::Kind::Blocked:
        return texts::DidNotRun(text, value);
    case Reason::Kind::Block:
        return blockWords(step);
    case Reason::Kind::Leaf:
        return step.path.empty() || step.isInternal ? Message() : texts::WasWhenScanBegan(step.path, value);
    }
    return {};
}

void addSteps(std::vector<Sentence>& out, const image::CompiledProgram& program, const history::ScanStamp& at,
              const std::vector<Reason>& steps, uint32_t depth) {
    if (depth > kDeepestStep) return;
    for (const Reason& step : steps) {
        const bool isNamed = step.kind == Reason::Kind::Leaf || step.kind == Reason::Kind::Block ||
                             !statementWords(program, step.range).empty();
        if (!isNamed) { // made by the compiler
            addSteps(out, program, at, step.steps, depth);
            continue;
        }
        Message words = stepWords(step, program);
        if (words.isEmpty()) continue;
        if (std::string place = placeWords(program, step.range); !place.empty())
            words = texts::AtPlace(std::move(words), std::move(place));
        Sentence sentence{SentenceKind::Step, std::move(words), step.range, at, step.path, {}};
        addSteps(sentence.parts, program, at, step.steps, depth + 1);
        out.push_back(std::move(sentence));
    }
}

void addSteps(std::vector<Sentence>& out, Message head, const std::shared_ptr<const image::CompiledProgram>& program,
              const history::ScanStamp& at, const std::vector<Reason>& steps) {
    if (steps.empty() || !program) return;
    Sentence sentence{SentenceKind::Step, std::move(head), {}, {}, {}, {}};
    addSteps(sentence.parts, *program, at, steps, 0);
    out.push_back(std::move(sentence));
}

void addDoubt(std::vector<Sentence>& out, const Message& doubt) {
    if (!doubt.isEmpty()) out.push_back({SentenceKind::Note, texts::Note(doubt), {}, {}, {}, {}});
}

Message wayWords(const std::vector<Change>& way) {
    Message words;
    for (const Change& change : way) {
        Message one = texts::Were(change.path, change.to, change.from);
        words = words.isEmpty() ? std::move(one) : texts::And(std::move(words), std::move(one));
    }
    return words;
}

} // namespace

Sentence sentenceOf(const Writer& writer) {
    Message who = writerWords(writer), when = scanWords(writer.at);
    Sentence sentence;
    sentence.kind = SentenceKind::Writer;
    sentence.path = writer.path;
    sentence.text = writer.before.empty() ? texts::ChangedTo(std::move(when), writer.path, writer.value, std::move(who))
                                          : texts::ChangedFromTo(std::move(when), writer.path, writer.before,
                                                                 writer.value, std::move(who));
    addWriter(sentence, writer);
    addCalls(sentence.parts, writer);
    return sentence;
}

std::vector<Sentence> sentencesOf(const Explanation& answer) {
    std::vector<Sentence> out;
    const std::string& what = answer.question.text;
    Message head = answer.isSinceBegin
                       ? texts::IsSinceBegin(what, answer.value, scanWords(answer.asked))
                       : texts::IsSince(what, answer.value, scanWords(answer.asked), scanWords(answer.since));
    out.push_back({SentenceKind::Head, std::move(head), {}, answer.since, what, {}});
    if (answer.writer && answer.writer->kind != WriterKind::Unknown) {
        Sentence writer{SentenceKind::Writer,
                        answer.writer->kind == WriterKind::Initial ? texts::ItHasItsInitialValue()
                                                                   : texts::ItWas(writerWords(*answer.writer)),
                        {},
                        {},
                        answer.writer->path,
                        {}};
        addWriter(writer, *answer.writer);
        addCalls(writer.parts, *answer.writer);
        out.push_back(std::move(writer));
    }
    addParts(out, texts::ItBecame(answer.value), answer.triggers, SentenceKind::Trigger);
    addParts(out, answer.triggers.empty() ? texts::ItNeeds() : texts::ThisNeeded(), answer.enablers,
             SentenceKind::Enabler);
    addParts(out, texts::ItStays(), answer.holding, SentenceKind::Holding);
    addSteps(out, texts::StepByStep(), answer.program, answer.since, answer.steps);
    addDoubt(out, answer.doubt);
    return out;
}

std::vector<Sentence> sentencesOf(const WhyNot& answer) {
    std::vector<Sentence> out;
    out.push_back({SentenceKind::Head,
                   texts::IsAt(answer.question.text, answer.value, scanWords(answer.asked)),
                   {},
                   answer.asked,
                   answer.question.text,
                   {}});
    if (answer.ways.empty()) out.push_back({SentenceKind::Way, texts::NoChangeMakesIt(answer.wanted), {}, {}, {}, {}});
    for (size_t i = 0; i < answer.ways.size(); ++i) {
        Message words = wayWords(answer.ways[i]);
        out.push_back({SentenceKind::Way,
                       i == 0 ? texts::WouldBe(answer.wanted, std::move(words))
                              : texts::WouldAlsoBe(answer.wanted, std::move(words)),
                       {},
                       {},
                       answer.ways[i].empty() ? std::string() : answer.ways[i].front().path,
                       {}});
    }
    addSteps(out, texts::WhatKeepsIt(answer.value), answer.program, answer.asked, answer.steps);
    addDoubt(out, answer.doubt);
    return out;
}

std::string toText(const std::vector<Sentence>& sentences, uint32_t depth) {
    std::string text;
    for (const Sentence& sentence : sentences)
        text += std::string(2 * depth, ' ') + sentence.text.english() + "\n" + toText(sentence.parts, depth + 1);
    return text;
}

std::string toText(const Writer& writer) { return toText({sentenceOf(writer)}); }
std::string toText(const Explanation& answer) { return toText(sentencesOf(answer)); }
std::string toText(const WhyNot& answer) { return toText(sentencesOf(answer)); }

} // namespace plc::inside
