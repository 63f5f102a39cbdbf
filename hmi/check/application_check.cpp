#include "hmi/check/application_check.h"

#include "hmi/model/errors.h"
#include "hmi/texts/language_tags.h"

#include <algorithm>

namespace plc::hmi {

namespace {

const NamedPanel* find(const CheckInput& input, const QString& name) {
    const auto found =
        std::find_if(input.panels.begin(), input.panels.end(), [&](const NamedPanel& one) { return one.name == name; });
    return found == input.panels.end() ? nullptr : &*found;
}

bool hasArea(const Panel& panel) {
    return std::any_of(panel.elements().begin(), panel.elements().end(),
                       [](const Element& one) { return one.kind() == ElementKind::PanelArea; });
}

} // namespace

std::vector<Finding> checkApplication(const CheckInput& input) {
    std::vector<Finding> out;
    const auto add = [&](FindingKind kind, const QString& file, const QString& property, Message message) {
        out.push_back({kind, true, file, 0, {}, property, {}, std::move(message)});
    };
    if (!input.frame.isEmpty()) {
        const NamedPanel* frame = find(input, input.frame);
        if (!frame)
            add(FindingKind::UnknownPanel, QStringLiteral("project.json"), QStringLiteral("frame"),
                errors::NoPanel(toUtf8(input.frame)));
        else if (!hasArea(frame->panel))
            add(FindingKind::WrongFrame, QStringLiteral("hmi/%1.panel.json").arg(input.frame), {},
                errors::FrameWithoutArea(toUtf8(input.frame)));
    }
    const LanguageSettings& own = input.texts.settings();
    for (const auto& [property, tags] : {std::pair("languages", own.languages), std::pair("fallback", own.fallback)})
        for (const QString& tag : tags)
            if (!isLanguageTag(tag))
                add(FindingKind::UnknownLanguage, QStringLiteral("project.json"), QLatin1String(property),
                    errors::LanguageUnknown(toUtf8(tag), Verbatim("de"), Verbatim("pt-BR")));
    for (const Properties& alarm : input.alarms.rows())
        if (const QString show = alarm.text("show"); !show.isEmpty() && !find(input, show))
            add(FindingKind::UnknownPanel, QStringLiteral("hmi/alarms.json"),
                alarm.text("id") + QStringLiteral(".show"), errors::NoPanel(toUtf8(show)));
    for (const QString& start : input.startPanels)
        if (!start.isEmpty() && !find(input, start))
            add(FindingKind::UnknownPanel, QStringLiteral("hmi/people.json"), QStringLiteral("startPanel"),
                errors::NoPanel(toUtf8(start)));
    return out;
}

std::vector<Finding> checkAccess(const CheckInput& input, const NamedPanel& panel) {
    std::vector<Finding> out;
    const QString file = QStringLiteral("hmi/%1.panel.json").arg(panel.name);
    const PanelLookup panels = input.panelLookup();
    for (const Element& element : panel.panel.elements()) {
        const auto add = [&](FindingKind kind, bool isError, const QString& property, Message message) {
            out.push_back({kind, isError, file, 0, element.id(), property, {}, std::move(message)});
        };
        for (const QString& one : element.text("access").split(u',', Qt::SkipEmptyParts)) {
            const QString role = one.trimmed();
            if (!input.hasPeople)
                add(FindingKind::UnknownRole, false, QStringLiteral("access"),
                    errors::CriticalWithoutPeople(toUtf8(role)));
            else if (!input.roles.contains(role, Qt::CaseInsensitive) && !role.startsWith(u'$'))
                add(FindingKind::UnknownRole, true, QStringLiteral("access"), errors::NoSuchRole(toUtf8(role)));
        }
        if (element.kind() != ElementKind::NavigationBar || !element.at("entries").is_array()) continue;
        int row = 0;
        for (const Json& entry : element.at("entries")) {
            const QString name = entry.is_object() && entry.contains("panel") ? toQString(entry["panel"]) : QString();
            if (!name.isEmpty() && !panels(name))
                add(FindingKind::UnknownPanel, true, QStringLiteral("entries[%1].panel").arg(row),
                    errors::NoPanel(toUtf8(name)));
            ++row;
        }
    }
    return out;
}

} // namespace plc::hmi
