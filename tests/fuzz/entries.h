// What the fuzz targets do with their bytes; used by the libFuzzer programs and by the replay of seeds and findings.
#pragma once
#include <cstdint>
#include <string_view>

namespace plc::fuzz {

void lexText(std::string_view bytes);
void parseText(std::string_view bytes);

/// Whether a text reached what its target is meant for. A fuzzer keeps only those: mutants of a text that is no
/// program are seldom one.
enum class Reach : uint8_t { Short, Meant };

/// The front end to the checked program: what it says lies in the text, and for some texts is the same when all is
/// read again. Meant: the checker (nothing was wrong for the lexer and the parser).
Reach checkText(std::string_view bytes);
/// Checks, compiles and runs a bounded number of scans; the controller must stay alive whatever the program does.
/// Meant: it ran.
Reach runText(std::string_view bytes);
/// The program runs, is exchanged for a relative of itself (seed from the bytes) and for itself again, state kept.
/// Meant: it was exchanged.
Reach changeText(std::string_view bytes);

/// For libFuzzer: -1 keeps a text out of the corpus.
inline int verdict(Reach reach) { return reach == Reach::Meant ? 0 : -1; }

} // namespace plc::fuzz
