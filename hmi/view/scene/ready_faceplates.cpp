#include "hmi/view/scene/ready_faceplates.h"

#include "runtime/base/assert.h"

#include <QDir>
#include <QFile>

static void registerFaceplates() { Q_INIT_RESOURCE(hmi_faceplates); }

namespace plc::hmi {

namespace {

std::vector<NamedPanel> readAll() {
    registerFaceplates();
    std::vector<NamedPanel> out;
    const QDir folder(QStringLiteral(":/hmi/faceplates"));
    for (const QString& name : folder.entryList({QStringLiteral("*.panel.json")}, QDir::Files, QDir::Name)) {
        QFile file(folder.filePath(name));
        if (!file.open(QIODevice::ReadOnly)) continue;
        Result<Panel> panel = Panel::parse(file.readAll().toStdString(), name);
        PLC_ASSERT(panel, continue);
        out.push_back({QStringLiteral("library/") + name.chopped(11), std::move(*panel)});
    }
    return out;
}

const Panel* findIn(const std::vector<NamedPanel>& panels, const QString& name) {
    for (const NamedPanel& one : panels)
        if (one.name == name) return &one.panel;
    return nullptr;
}

} // namespace

const std::vector<NamedPanel>& readyFaceplates() {
    static const std::vector<NamedPanel> all = readAll();
    return all;
}

PanelLookup lookupIn(const std::vector<NamedPanel>& panels) {
    return [&panels](const QString& name) -> const Panel* {
        if (const Panel* own = findIn(panels, name)) return own;
        return name.startsWith(QLatin1String("library/")) ? findIn(readyFaceplates(), name) : nullptr;
    };
}

} // namespace plc::hmi
