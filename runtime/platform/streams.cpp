#include "runtime/platform/streams.h"

#include <cerrno>
#include <csignal>
#include <poll.h>
#include <unistd.h>

namespace plc::platform {

bool isTerminal(int stream) { return ::isatty(stream) != 0; }

std::optional<size_t> readWithin(int stream, std::span<char> into, int milliseconds) {
    pollfd file{stream, POLLIN, 0};
    if (::poll(&file, 1, milliseconds) <= 0) return {};
    const ssize_t count = ::read(stream, into.data(), into.size());
    if (count < 0 && (errno == EINTR || errno == EAGAIN)) return {};
    return count > 0 ? static_cast<size_t>(count) : 0;
}

std::FILE* openStandardOutput() {
    const int copy = ::dup(kStandardOutput);
    return copy < 0 ? nullptr : ::fdopen(copy, "wb");
}

void catchInterrupts(void (*handler)(int)) {
    std::signal(SIGINT, handler);
    std::signal(SIGTERM, handler);
}

void ignoreLostReaders() { std::signal(SIGPIPE, SIG_IGN); }

} // namespace plc::platform
