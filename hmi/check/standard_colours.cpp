// What colours say: grey when all is normal, alarm colours for alarms, never a colour alone, contrast in every theme.
#include "hmi/check/standard_parts.h"

#include "hmi/model/errors.h"
#include "hmi/view/paint/colour_sight.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace plc::hmi {

namespace {

class ColourChecker {
public:
    explicit ColourChecker(StandardFindings& out) : m_out(out), m_panel(out.panel()) {}

    void run() {
        checkStatic({}, m_panel, "background");
        collectCaptions();
        for (const Element& element : m_panel.elements()) {
            if (element.kind() == ElementKind::Unknown) continue;
            checkNormal(element);
            checkAlone(element);
            checkContrast(element);
        }
    }

private:
    // ---- grey in normal state

    void checkNormal(const Element& element) {
        // A 7-segment display is red or green as its model is; what comes and goes is a condition.
        if (element.kind() == ElementKind::SevenSegment || isSometimesHidden(m_panel, element)) return;
        for (const PropertyDescriptor& property : element.descriptor().properties) {
            if (property.type != PropertyType::Color) continue;
            // Lit is a condition; of a symbol or a cell, it is the normal one: running.
            const bool isLit =
                property.key == "litColor" || (property.key == "onColor" && element.kind() != ElementKind::Symbol &&
                                               element.kind() != ElementKind::CellGrid);
            if (isLit) continue;
            checkStatic(element.id(), element, property.key);
        }
    }

    void checkStatic(const ElementId& id, const Properties& properties, std::string_view key) {
        const QString color = properties.text(key);
        const bool isAlarm = isAlarmColour(color);
        if (!isAlarm && !isLoud(color)) return;
        if (key == "line" && properties.text("lineStyle") == QStringLiteral("none")) return;
        const PropertyDescriptor* property = properties.descriptor().property(key);
        const QString normal = property ? toQString(property->fallback) : QString();
        Edit fix;
        std::string instead = "surface";
        if (!normal.isEmpty() && normal != QStringLiteral("none") && !isLoud(normal)) {
            fix = setProperty(m_panel, id, key, property->fallback);
            instead = toUtf8(normal);
        }
        m_out.add(isAlarm ? StandardRule::AlarmColourInNormalState : StandardRule::ColourInNormalState, id,
                  QString::fromStdString(std::string(key)),
                  isAlarm ? errors::AlarmColourUsed(toUtf8(color), instead)
                          : errors::LoudColourUsed(toUtf8(color), instead),
                  std::move(fix));
    }

    // ---- colour alone

    /// In every theme that the colours belong to, one is brighter than the other.
    bool areToldApart(const QString& a, const QString& b) const {
        constexpr double Visible = 1.25;
        const QColor one = theme().color(a), other = theme().color(b);
        return !one.isValid() || !other.isValid() || contrast(one, other) >= Visible;
    }

    void addAlone(const Element& element, const QString& property, const QString& a, const QString& b, Edit fix = {}) {
        m_out.add(StandardRule::ColourAlone, element.id(), property, errors::OnlyColourDiffers(toUtf8(a), toUtf8(b)),
                  std::move(fix));
    }

    /// The colours that the kind has by itself, if brightness tells those apart.
    Edit ownColours(const Element& element) const {
        EditList out;
        QStringList colours;
        for (const char* key : {"onColor", "offColor"}) {
            const PropertyDescriptor* property = element.descriptor().property(key);
            if (!property) return {};
            colours += toQString(property->fallback);
            if (element.has(key)) out.edits.push_back(setProperty(m_panel, element.id(), key, property->fallback));
        }
        return areToldApart(colours.front(), colours.back()) ? Edit{std::move(out)} : Edit();
    }

    void checkAlone(const Element& element) {
        const bool hasOnOff = element.kind() == ElementKind::Lamp || element.kind() == ElementKind::CellGrid ||
                              element.kind() == ElementKind::Symbol;
        if (hasOnOff && !element.isSet("blink") && isShownByColour(element) &&
            !areToldApart(element.text("onColor"), element.text("offColor")))
            addAlone(element, QStringLiteral("onColor"), element.text("onColor"), element.text("offColor"),
                     ownColours(element));
        checkRows(element, "states");
        checkRows(element, "when");
        if (element.kind() == ElementKind::Lamp && !element.text("value").isEmpty() && !isFaceplate(m_panel) &&
            element.text("label").isEmpty() && !hasWordsBeside(element))
            m_out.add(StandardRule::ColourAlone, element.id(), QStringLiteral("label"), errors::LampWithoutWords());
    }

    static bool isShownByColour(const Element& element) {
        if (element.kind() == ElementKind::CellGrid && !element.at("states").empty()) return false;
        return element.kind() != ElementKind::Symbol || !element.text("state").isEmpty();
    }

    /// Two rows with the same words, neither blinking, that nothing but the hue tells apart.
    void checkRows(const Element& element, std::string_view key) {
        const Json& rows = element.at(key);
        if (!rows.is_array()) return;
        const auto text = [](const Json& row, const char* field) {
            return row.is_object() && row.contains(field) ? toQString(row[field]) : QString();
        };
        const auto blinks = [](const Json& row) {
            return row.is_object() && row.contains("blink") && row["blink"] == true;
        };
        for (size_t b = 1; b < rows.size() && b < kMostRows; ++b)
            for (size_t a = 0; a < b; ++a) {
                const QString one = text(rows[a], "color"), other = text(rows[b], "color");
                const bool isValueShown = element.kind() == ElementKind::MultiState && text(rows[a], "text").isEmpty();
                if (one.isEmpty() || other.isEmpty() || one == other || isValueShown ||
                    text(rows[a], "text") != text(rows[b], "text") || blinks(rows[a]) != blinks(rows[b]) ||
                    areToldApart(one, other))
                    continue;
                addAlone(element, QStringLiteral("%1[%2].color").arg(QString::fromStdString(std::string(key))).arg(b),
                         one, other);
                return;
            }
    }

    /// Where words are that may belong to a lamp.
    void collectCaptions() {
        for (const Element& element : m_panel.elements())
            for (const char* key : {"text", "label", "title"})
                if (element.descriptor().property(key) && !element.text(key).isEmpty()) {
                    m_captions.push_back(element.rect());
                    break;
                }
    }

    bool hasWordsBeside(const Element& element) const {
        constexpr double Near = 72; // as far as a caption is from what it belongs to
        const QRectF around = element.rect().adjusted(-Near, -Near, Near, Near);
        return std::any_of(m_captions.begin(), m_captions.end(), [&](const QRectF& words) {
            return around.intersects(words) || heads(words, element.rect());
        });
    }

    /// The head of its column or row, however far.
    static bool heads(const QRectF& words, const QRectF& element) {
        const bool isAbove =
            words.bottom() <= element.top() && words.left() < element.right() && words.right() > element.left();
        const bool isBefore = words.top() < element.bottom() && words.bottom() > element.top();
        return isAbove || isBefore;
    }

    // ---- contrast

    /// The colour on which the element is drawn: that of the nearest filled thing below it.
    QString groundOf(const Element& element) const {
        QString out = m_panel.text("background");
        for (const Element& below : m_panel.elements()) {
            if (below.id() == element.id()) break;
            if (!isFilled(below) || !below.rect().contains(element.rect().center())) continue;
            const QString fill = below.text("fill");
            if (fill != QStringLiteral("none") && !fill.contains(u'$')) out = fill;
        }
        return out;
    }

    bool isFilled(const Element& element) const {
        static constexpr std::array kinds = {ElementKind::Rectangle, ElementKind::Rounded, ElementKind::Ellipse,
                                             ElementKind::Text};
        return std::find(kinds.begin(), kinds.end(), element.kind()) != kinds.end() &&
               !isSometimesHidden(m_panel, element);
    }

    void checkContrast(const Element& element) {
        if (!m_out.isChecked(StandardRule::LowContrast)) return;
        switch (element.kind()) {
        case ElementKind::Text: {
            const QString own = element.text("fill");
            return hold(element, "textColor", element.text("textColor"),
                        own == QStringLiteral("none") || own.isEmpty() ? groundOf(element) : own);
        }
        case ElementKind::NumericDisplay:
            return hold(element, "textColor", element.text("textColor"),
                        element.isSet("frame") ? QStringLiteral("inset") : groundOf(element));
        case ElementKind::DateTime:
            return hold(element, "textColor", element.text("textColor"), groundOf(element));
        case ElementKind::Button:
            if (element.text("textColor") == QStringLiteral("text")) return; // black or white, as the ground asks
            hold(element, "textColor", element.text("textColor"), element.text("color"));
            return hold(element, "litColor", element.text("textColor"), element.text("litColor"));
        case ElementKind::Lamp:
        case ElementKind::Symbol:
        case ElementKind::FloatSwitch:
            if (element.text("label").isEmpty()) return;
            return hold(element, "label", QStringLiteral("text"), groundOf(element));
        case ElementKind::CheckBox:
        case ElementKind::RadioGroup:
        case ElementKind::Switch:
            return hold(element, "fontSize", QStringLiteral("text"), groundOf(element));
        case ElementKind::MultiState:
            return checkStates(element);
        default: // draws its own ground
            return;
        }
    }

    void checkStates(const Element& element) {
        const Json& states = element.at("states");
        for (size_t row = 0; states.is_array() && row < states.size(); ++row) {
            if (!states[row].is_object()) continue;
            const Properties state(descriptorOf(ElementKind::Unknown), states[row]);
            const QString ink = state.text("textColor"), ground = state.text("color");
            if (ink.isEmpty() && element.text("textColor") == QStringLiteral("text")) continue;
            hold(element, "states", ink.isEmpty() ? element.text("textColor") : ink,
                 ground.isEmpty() ? QStringLiteral("surface") : ground);
        }
    }

    /// In the panel's own theme, and in all where both colours come from the theme.
    void hold(const Element& element, const char* property, const QString& ink, const QString& ground) {
        const bool isThemed = !ink.startsWith(u'#') && !ground.startsWith(u'#');
        const double size = element.number("fontSize");
        const bool isLarge = size >= 24 || (size >= 18.66 && element.isSet("bold"));
        const double needed = isLarge ? 3 : 4.5;
        const PanelThemes& themes = m_out.input().themes;
        for (const QString& name : themes.names()) {
            const PanelTheme* theme = &themes.named(name);
            if (!isThemed && theme != &this->theme()) continue;
            const QColor front = theme->color(ink), back = theme->color(ground);
            if (!front.isValid() || !back.isValid() || contrast(front, back) >= needed) continue;
            Edit fix;
            if (std::string_view(property) == "textColor" &&
                contrast(theme->color("text"), back) >= needed) // the role that is made for it
                fix = setProperty(m_panel, element.id(), "textColor", "text");
            return m_out.add(StandardRule::LowContrast, element.id(), QString::fromLatin1(property),
                             errors::ContrastTooLow(toUtf8(ink), toUtf8(ground), ratioText(contrast(front, back)),
                                                    toUtf8(name), ratioText(needed)),
                             std::move(fix));
        }
    }

    const PanelTheme& theme() const { return m_out.input().themes.named(m_panel.text("theme")); }

    static constexpr size_t kMostRows = 100;
    StandardFindings& m_out;
    const Panel& m_panel;
    std::vector<QRectF> m_captions;
};

} // namespace

std::string ratioText(double contrast) { return toUtf8(QString::number(std::floor(contrast * 10) / 10, 'f', 1)); }

void checkColours(StandardFindings& out) { ColourChecker(out).run(); }

} // namespace plc::hmi
