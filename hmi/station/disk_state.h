// What the files of a project's operator side held when they were read or written last: whoever writes one asks here,
// so that nothing newer is overwritten. Shared by those who work on one project; main thread.
#pragma once
#include "runtime/base/result.h"

#include <QString>

#include <map>
#include <optional>
#include <string>

namespace plc::hmi {

class DiskState {
public:
    /// The file holds these bytes, and who edits it knows them.
    void taken(const QString& path, std::string bytes) { m_known[path] = std::move(bytes); }
    /// What it holds is not known, for example because it could not be understood.
    void forget(const QString& path) { m_known.erase(path); }
    [[nodiscard]] bool isKnown(const QString& path) const { return m_known.contains(path); }
    /// The bytes on disk where another program has changed or made the file; nothing when it is as known, or gone.
    [[nodiscard]] std::optional<std::string> newer(const QString& path) const;
    /// Refuses to write over what another program has written.
    Result<void> write(const QString& path, const std::string& bytes);

private:
    std::map<QString, std::string> m_known;
};

} // namespace plc::hmi
