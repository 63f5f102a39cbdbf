// Answers of the Reasoner as sentences (message values, a tree to unfold): the window, the panel and the command line
// show the same, each in its reader's language. Pure functions.
#pragma once
#include "runtime/inside/why.h"

namespace plc::inside {

/// What a sentence is in an answer.
enum class SentenceKind : uint8_t { Head, Writer, Trigger, Enabler, Holding, Way, Step, Note };

/// A sentence of an answer, and what it explains itself with.
struct Sentence {
    SentenceKind kind = SentenceKind::Head;
    Message text;
    SourceRange range;                    // where one click goes; none: nowhere
    std::optional<history::ScanStamp> at; // the scan it speaks of
    std::string path;                     // of the variable it speaks of
    std::vector<Sentence> parts;
};

[[nodiscard]] std::vector<Sentence> sentencesOf(const Explanation& answer);
[[nodiscard]] std::vector<Sentence> sentencesOf(const WhyNot& answer);
[[nodiscard]] Sentence sentenceOf(const Writer& writer);
/// "written from panel Main, button Start"; "set by K1 := K1Latch;  src/main.st:29 (Main, task Fast)".
[[nodiscard]] Message writerWords(const Writer& writer);

/// "1.01 s", "2 min 3.5 s".
[[nodiscard]] Message timeWords(controller::Nanoseconds time);
/// What a timer or counter stands at: "it has run 3.2 s of 5 s, 1.8 s to go"; empty: nothing to say.
[[nodiscard]] Message blockNote(const Look& look, uint32_t instance, const types::Type& block);
/// "src/main.st:29"; empty: a place without a text.
[[nodiscard]] std::string placeWords(const image::CompiledProgram& program, SourceRange range);
/// One line of the user's text, cut where it is long.
[[nodiscard]] std::string statementWords(const image::CompiledProgram& program, SourceRange range);

/// In English, a line for each sentence, parts indented.
[[nodiscard]] std::string toText(const std::vector<Sentence>& sentences, uint32_t depth = 0);
[[nodiscard]] std::string toText(const Writer& writer);
[[nodiscard]] std::string toText(const Explanation& answer);
[[nodiscard]] std::string toText(const WhyNot& answer);

} // namespace plc::inside
