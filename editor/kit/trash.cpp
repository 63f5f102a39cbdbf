#include "editor/kit/trash.h"

#include <QDir>
#include <QFile>
#include <QStandardPaths>

namespace plc::kit {

bool removeToTrash(const QString& path) {
    // Qt makes the trash, but not the folder that it belongs into: where that is missing, as for somebody who has never
    // started a desktop, it takes the current folder instead.
    QDir().mkpath(QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation));
    return QFile::moveToTrash(path) || QFile::remove(path);
}

} // namespace plc::kit
