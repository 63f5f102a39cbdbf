// Files as only the system can write them: certainly on the disk, exchanged in one step, held by one process. What
// fails returns false or -1 and leaves the reason in errno. Free functions, any thread.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>

namespace plc::platform {

enum class Existing : uint8_t { Emptied, Refused };
enum class Readers : uint8_t { AsUsual, OwnerOnly };

/// A handle to write to, or -1.
[[nodiscard]] int openToWrite(const std::string& path, Existing existing, Readers readers = Readers::AsUsual);
[[nodiscard]] bool writeAll(int file, std::string_view bytes);
/// True once it is on the disk.
[[nodiscard]] bool syncFile(int file);
[[nodiscard]] bool closeFile(int file);
/// `from` takes the place of `to`: others see the old or the new one, whole.
[[nodiscard]] bool replaceFile(const std::string& from, const std::string& to);
/// Names of files are on the disk, too.
void syncFolder(const std::string& folder);
/// Leaves errno as it is, so that a failure can still be reported.
void removeFile(const std::string& path);

/// Whether this user may make files there.
[[nodiscard]] bool mayWriteIn(const std::string& folder);
/// A handle that keeps other processes out until it is closed or this one ends; -1 with EWOULDBLOCK: another has it.
[[nodiscard]] int lockFile(const std::string& path);

} // namespace plc::platform
