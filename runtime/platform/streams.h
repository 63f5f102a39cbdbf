// Standard input and output as a command line and a server on two pipes need them, and the signals that end a program.
// Free functions; each stream is one thread's.
#pragma once
#include <cstdio>
#include <optional>
#include <span>

namespace plc::platform {

inline constexpr int kStandardInput = 0, kStandardOutput = 1, kStandardError = 2;

[[nodiscard]] bool isTerminal(int stream);
/// What arrives within that time (< 0: however long it takes), at most as much as fits; none: nothing did; 0: it is
/// over.
[[nodiscard]] std::optional<size_t> readWithin(int stream, std::span<char> into, int milliseconds);
/// Standard output as a file that may be closed while standard output stays; null: errno says why.
[[nodiscard]] std::FILE* openStandardOutput();

/// Ctrl+C and the request to end call it.
void catchInterrupts(void (*handler)(int));
/// Writing to a pipe that nobody reads any more is a failed write, not the end of the program.
void ignoreLostReaders();

} // namespace plc::platform
