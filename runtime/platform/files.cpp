#include "runtime/platform/files.h"

#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace plc::platform {

int openToWrite(const std::string& path, Existing existing, Readers readers) {
    const int how = existing == Existing::Refused ? O_EXCL : O_TRUNC;
    return ::open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | how, readers == Readers::OwnerOnly ? 0600 : 0666);
}

bool writeAll(int file, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t n = ::write(file, bytes.data(), bytes.size());
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) return false;
        bytes.remove_prefix(static_cast<size_t>(n));
    }
    return true;
}

bool syncFile(int file) { return ::fsync(file) == 0; }
bool closeFile(int file) { return ::close(file) == 0; }
bool replaceFile(const std::string& from, const std::string& to) { return ::rename(from.c_str(), to.c_str()) == 0; }

void syncFolder(const std::string& folder) {
    const int handle = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (handle < 0) return;
    ::fsync(handle);
    ::close(handle);
}

void removeFile(const std::string& path) {
    const int code = errno;
    ::unlink(path.c_str());
    errno = code;
}

bool mayWriteIn(const std::string& folder) { return ::access(folder.c_str(), W_OK | X_OK) == 0; }

int lockFile(const std::string& path) {
    const int handle = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    if (handle < 0 || ::flock(handle, LOCK_EX | LOCK_NB) == 0) return handle;
    const int code = errno;
    ::close(handle);
    errno = code;
    return -1;
}

} // namespace plc::platform
