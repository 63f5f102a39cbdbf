#include "hmi/station/disk_state.h"

#include "projects/storage/project_file.h"
#include "runtime/base/messages.h"

#include <QFileInfo>

namespace plc::hmi {

std::optional<std::string> DiskState::newer(const QString& path) const {
    if (!QFileInfo::exists(path)) return {};
    const auto bytes = projects::readFile(path.toStdString());
    if (!bytes) return {}; // about to be replaced; whoever writes it will be told why it cannot be
    const auto known = m_known.find(path);
    if (known != m_known.end() && known->second == *bytes) return {};
    return *bytes;
}

Result<void> DiskState::write(const QString& path, const std::string& bytes) {
    if (newer(path)) return Error{errors::FileChangedOutside(), path.toStdString()};
    if (auto written = projects::writeFileAtomically(path.toStdString(), bytes); !written) return written;
    taken(path, bytes);
    return {};
}

} // namespace plc::hmi
