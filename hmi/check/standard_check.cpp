#include "hmi/check/standard_check.h"

#include "hmi/check/property_fix.h"
#include "hmi/check/standard_parts.h"
#include "hmi/model/errors.h"

#include <QQueue>

#include <algorithm>

namespace plc::hmi {

namespace {

FindingKind kindOf(StandardRule rule) {
    return static_cast<FindingKind>(static_cast<int>(FindingKind::FirstStandardRule) + static_cast<int>(rule));
}

Finding make(const CheckInput& input, StandardRule rule, const QString& file, const ElementId& element,
             const QString& property, Message message) {
    Finding out{kindOf(rule), input.standard.isError(rule), file, 0, element, property, {}, std::move(message)};
    out.why = standardRules()[static_cast<size_t>(rule)].why;
    return out;
}

QString fileOf(const QString& panel) { return QStringLiteral("hmi/%1.panel.json").arg(panel); }

/// The panels that a press on this one leads to; what is drawn in it included.
class Ways {
public:
    explicit Ways(const CheckInput& input) : m_panels(input.panelLookup()) {}

    QStringList from(const Panel& panel, int depth = 0) const {
        QStringList out;
        const auto add = [&](const QString& name) {
            if (!name.isEmpty() && !out.contains(name)) out += name;
        };
        for (const Element& element : panel.elements()) {
            if (element.kind() == ElementKind::Button) add(element.text("panel"));
            if (element.kind() == ElementKind::NavigationBar && element.at("entries").is_array())
                for (const Json& entry : element.at("entries"))
                    if (entry.is_object() && entry.contains("panel")) add(toQString(entry["panel"]));
            if (element.kind() != ElementKind::Faceplate || depth > kDeepest) continue;
            const Panel* inner = m_panels(element.text("panel"));
            const Arguments given = argumentsOf(element.at("arguments"));
            if (inner)
                for (const QString& name : from(withArguments(*inner, given), depth + 1)) add(name);
        }
        if (depth == 0) add(panel.text("portrait"));
        return out;
    }

    /// Back, home or a navigation bar; a pop-up closes by itself.
    bool hasWayBack(const Panel& panel) const {
        return std::any_of(panel.elements().begin(), panel.elements().end(), [](const Element& element) {
            if (element.kind() == ElementKind::NavigationBar) return true;
            const QString action = element.kind() == ElementKind::Button ? element.text("action") : QString();
            return action == QStringLiteral("back") || action == QStringLiteral("home") ||
                   action == QStringLiteral("panel") || action == QStringLiteral("close");
        });
    }

private:
    static constexpr int kDeepest = 8;
    const PanelLookup m_panels;
};

class ApplicationChecker {
public:
    explicit ApplicationChecker(const CheckInput& input) : m_input(input) {}

    std::vector<Finding> run() {
        for (const auto& [property, message] : m_input.standard.problems)
            m_found.push_back(
                {FindingKind::WrongCheckSetting, true, QStringLiteral("project.json"), 0, {}, property, {}, message});
        if (m_input.standard.isChecked(StandardRule::TooManyPresses)) checkWays();
        if (m_input.standard.isChecked(StandardRule::InconsistentPlace)) checkPlaces();
        if (m_input.hasAlarms) checkAlarms();
        if (m_input.standard.isChecked(StandardRule::LowContrast)) checkThemes();
        return std::move(m_found);
    }

private:
    void add(StandardRule rule, const QString& panel, const ElementId& element, const QString& property,
             Message message, Edit fix = {}) {
        if (!m_input.standard.isChecked(rule) || m_input.standard.isOff(rule, panel, element)) return;
        m_found.push_back(make(m_input, rule, fileOf(panel), element, property, std::move(message)));
        m_found.back().fix = std::move(fix);
    }

    const NamedPanel* find(const QString& name) const {
        for (const NamedPanel& one : m_input.panels)
            if (one.name == name) return &one;
        return nullptr;
    }

    QMap<QString, int> pressesFromStart(const Ways& ways) const {
        QMap<QString, int> out;
        QQueue<QString> open;
        const auto reach = [&](const QString& name, int presses) {
            if (name.isEmpty() || out.contains(name) || !find(name)) return;
            out.insert(name, presses);
            open.enqueue(name);
        };
        reach(m_input.startPanel, 0);
        for (const QString& start : m_input.startPanels) reach(start, 0);
        if (const NamedPanel* frame = find(m_input.frame))
            for (const QString& name : ways.from(frame->panel)) reach(name, 1);
        for (const Properties& alarm : m_input.alarms.rows()) reach(alarm.text("show"), 2); // list, sheet
        while (!open.isEmpty()) {
            const QString at = open.dequeue();
            for (const QString& name : ways.from(find(at)->panel)) reach(name, out.value(at) + 1);
        }
        return out;
    }

    void checkThemes() {
        for (const auto& [name, theme] : m_input.themes.own())
            for (const PanelTheme::Weak& weak : theme->weaknesses())
                m_found.push_back(
                    make(m_input, StandardRule::LowContrast, QStringLiteral("hmi/themes/%1.json").arg(name), {},
                         QStringLiteral("colors.") + weak.ink,
                         errors::ContrastTooLow(toUtf8(weak.ink), toUtf8(weak.ground), ratioText(weak.contrast),
                                                toUtf8(name), ratioText(weak.needed))));
    }

    void checkWays() {
        if (m_input.panels.size() < 2 || m_input.startPanel.isEmpty()) return;
        const Ways ways(m_input);
        const QMap<QString, int> presses = pressesFromStart(ways);
        const NamedPanel* frame = find(m_input.frame);
        for (const NamedPanel& one : m_input.panels) {
            if (isFaceplate(one.panel) || one.name == m_input.frame) continue;
            constexpr int Most = 3;
            if (!presses.contains(one.name)) { // then nobody needs a way back yet
                add(StandardRule::TooManyPresses, one.name, {}, {},
                    errors::PanelNotReached(toUtf8(one.name), toUtf8(m_input.startPanel)));
                continue;
            }
            if (presses.value(one.name) > Most)
                add(StandardRule::TooManyPresses, one.name, {}, {},
                    errors::PanelTooDeep(toUtf8(one.name), presses.value(one.name), Most));
            const bool hasFrame = frame && one.panel.isSet("framed") && ways.hasWayBack(frame->panel);
            if (one.name != m_input.startPanel && !hasFrame && !ways.hasWayBack(one.panel))
                add(StandardRule::TooManyPresses, one.name, {}, {}, errors::NoWayBack(toUtf8(one.name)));
        }
    }

    /// What is recognised as the same thing on several panels; empty: nothing.
    static QString roleOf(const Element& element) {
        if (!element.parent().isEmpty()) return {};
        switch (element.kind()) {
        case ElementKind::NavigationBar:
        case ElementKind::LanguageSelector:
        case ElementKind::UserField:
        case ElementKind::AlarmBanner:
            return QString::fromStdString(std::string(element.descriptor().key));
        case ElementKind::Button: {
            const QString action = element.text("action");
            const bool isFixed = action == QStringLiteral("home") || action == QStringLiteral("back") ||
                                 action == QStringLiteral("acknowledge") || action == QStringLiteral("logOut");
            return isFixed ? action : QString();
        }
        default: // every other kind has its place by what it shows
            return {};
        }
    }

    void checkPlaces() {
        struct Place {
            QString panel;
            QRectF rect;
        };
        QMap<QString, Place> first;
        std::vector<const NamedPanel*> order; // the start panel sets the places
        for (const NamedPanel& one : m_input.panels) {
            if (isFaceplate(one.panel) || one.name == m_input.frame) continue;
            order.insert(one.name == m_input.startPanel ? order.begin() : order.end(), &one);
        }
        for (const NamedPanel* one : order)
            for (const Element& element : one->panel.elements()) {
                const QString role = roleOf(element);
                if (role.isEmpty()) continue;
                const QString key =
                    QStringLiteral("%1 %2x%3").arg(role).arg(one->panel.size().width()).arg(one->panel.size().height());
                if (!first.contains(key)) {
                    first.insert(key, {one->name, element.rect()});
                    continue;
                }
                constexpr double Unseen = 4;
                const Place& wanted = first[key];
                if (wanted.panel == one->name ||
                    (element.rect().topLeft() - wanted.rect.topLeft()).manhattanLength() <= Unseen)
                    continue;
                add(StandardRule::InconsistentPlace, one->name, element.id(), QStringLiteral("rect"),
                    errors::PlaceDiffers(toUtf8(role), toUtf8(wanted.panel)),
                    setProperty(one->panel, element.id(), "rect", rectToJson(wanted.rect)));
            }
    }

    void addOfAlarms(StandardRule rule, const ElementId& alarm, const QString& property, Message message) {
        if (!m_input.standard.isChecked(rule) || m_input.standard.isOff(rule, QStringLiteral("alarms"), alarm)) return;
        m_found.push_back(make(m_input, rule, QStringLiteral("hmi/alarms.json"), alarm, property, std::move(message)));
    }

    void checkAlarms() {
        size_t urgent = 0;
        for (const Properties& row : m_input.alarms.rows()) {
            urgent += row.integer("priority") <= 1;
            if (row.text("help").isEmpty())
                addOfAlarms(StandardRule::AlarmWithoutHelp, row.text("id"), QStringLiteral("help"),
                            errors::AlarmHasNoHelp(toUtf8(row.text("id"))));
        }
        const size_t all = m_input.alarms.rows().size();
        constexpr size_t Few = 10; // of fewer, nobody can make out a share
        if (all >= Few && urgent * 5 > all)
            addOfAlarms(StandardRule::TooManyUrgentAlarms, {}, {},
                        errors::UrgentAlarms(static_cast<int64_t>(urgent), static_cast<int64_t>(all)));
        const bool areShown = std::any_of(m_input.panels.begin(), m_input.panels.end(), [](const NamedPanel& one) {
            return std::any_of(one.panel.elements().begin(), one.panel.elements().end(), [](const Element& element) {
                return element.kind() == ElementKind::AlarmList || element.kind() == ElementKind::AlarmBanner;
            });
        });
        if (all > 0 && !areShown)
            addOfAlarms(StandardRule::AlarmsNotShown, {}, {}, errors::NoPanelShowsAlarms(static_cast<int64_t>(all)));
    }

    const CheckInput& m_input;
    std::vector<Finding> m_found;
};

} // namespace

void StandardFindings::add(StandardRule rule, const ElementId& element, const QString& property, Message message,
                           Edit fix) {
    if (!isChecked(rule) || m_input.standard.isOff(rule, m_named.name, element)) return;
    m_found.push_back(make(m_input, rule, fileOf(m_named.name), element, property, std::move(message)));
    m_found.back().fix = std::move(fix);
}

std::vector<Finding> checkStandard(const CheckInput& input, const NamedPanel& panel) {
    if (input.standard.level == CheckLevel::Off) return {};
    StandardFindings out(input, panel);
    checkColours(out);
    checkSizes(out);
    checkOverlaps(out);
    checkOperation(out);
    checkHint(out);
    return out.take();
}

std::vector<Finding> checkStandardOfAll(const CheckInput& input) { return ApplicationChecker(input).run(); }

Edit fixesOf(const std::vector<Finding>& findings, const QString& file, const Panel& panel) {
    std::vector<Edit> all;
    for (const Finding& one : findings)
        if (one.file == file && !one.fix.isEmpty()) all.push_back(one.fix);
    return together(panel, all);
}

} // namespace plc::hmi
