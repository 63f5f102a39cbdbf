#include "hmi/check/unread_panels.h"

#include <QDir>

#include <algorithm>

namespace plc::hmi {

QStringList panelsOnDisk(const QString& folder) {
    const QString ending = QStringLiteral(".panel.json");
    QStringList out;
    for (const QString& file :
         QDir(folder + QStringLiteral("/hmi")).entryList({u'*' + ending}, QDir::Files, QDir::Name))
        out += file.chopped(ending.size());
    return out;
}

QStringList unreadPanels(const QString& folder, const std::vector<NamedPanel>& panels) {
    QStringList out = folder.isEmpty() ? QStringList() : panelsOnDisk(folder);
    out.removeIf([&](const QString& name) {
        return std::any_of(panels.begin(), panels.end(), [&](const NamedPanel& one) { return one.name == name; });
    });
    return out;
}

} // namespace plc::hmi
