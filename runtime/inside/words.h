// Answers of the Reasoner in words, for the command line and as what the window translates from. Pure functions.
#pragma once
#include "runtime/inside/why.h"

namespace plc::inside {

/// "1.01 s", "2 min 3.5 s".
[[nodiscard]] std::string timeWords(controller::Nanoseconds time);
/// What a timer or counter stands at: "has run 3.2 s of 5 s, 1.8 s to go"; empty: nothing to say.
[[nodiscard]] std::string blockNote(const Look& look, uint32_t instance, const types::Type& block);
/// "src/main.st:29"; empty: a place without a text.
[[nodiscard]] std::string placeWords(const image::CompiledProgram& program, SourceRange range);
/// One line of the user's text, cut where it is long.
[[nodiscard]] std::string statementWords(const image::CompiledProgram& program, SourceRange range);
/// "written from panel Main, button Start"; "set by K1 := K1Latch;  src/main.st:29 (Main, task Fast)".
[[nodiscard]] std::string writerWords(const Writer& writer);

[[nodiscard]] std::string toText(const Writer& writer);
[[nodiscard]] std::string toText(const Explanation& answer);
[[nodiscard]] std::string toText(const WhyNot& answer);

} // namespace plc::inside
