#include "hmi/station/text_exchange.h"

#include "hmi/model/property_literals.h"
#include "hmi/model/walk.h"

namespace plc::hmi {

QMap<QString, QStringList> placesOfTexts(const PanelProject& project) {
    QMap<QString, QStringList> out;
    const TextTable& table = project.texts.table();
    const auto look = [&](const QString& owner, const Properties& properties, const QString& id) {
        const QString begin = owner + QStringLiteral(": ") + (id.isEmpty() ? QString() : id + u'.');
        forEachText(properties, [&](const Found& found) {
            if (isTextKey(found.text)) out[keyOf(found.text)] += begin + found.place();
        });
        forEachTextList(properties, [&](const Found& found) {
            const QString prefix = isTextKey(found.text) ? keyOf(found.text) : found.text;
            for (int i = 0, length = table.listLength(prefix); i < length; ++i)
                out[prefix + u'.' + QString::number(i)] += begin + found.place();
        });
    };
    for (const NamedPanel& panel : project.panels) {
        look(panel.name, panel.panel, {});
        for (const Element& element : panel.panel.elements()) look(panel.name, element, element.id());
    }
    for (const Properties& alarm : project.alarms.rows()) look(QStringLiteral("alarms"), alarm, alarm.text("id"_text));
    for (const Properties& one : project.alarms.classRows()) look(QStringLiteral("alarms"), one, one.text("name"_text));
    return out;
}

std::string reportText(const XliffReport& report) {
    std::string out;
    for (const Error& remark : report.remarks) out += remark.english() + "\n";
    return out + std::to_string(report.taken) + (report.taken == 1 ? " text taken, " : " texts taken, ") +
           std::to_string(report.same) + " as they were, " + std::to_string(report.empty) + " without a translation\n";
}

} // namespace plc::hmi
