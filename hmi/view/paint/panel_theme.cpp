#include "hmi/view/paint/panel_theme.h"

#include "hmi/model/errors.h"
#include "hmi/model/json.h"
#include "hmi/view/paint/colour_sight.h"
#include "runtime/base/read_json.h"
#include "runtime/base/text.h"

#include <array>

namespace plc::hmi {

namespace {

struct Role {
    const char* name;
    std::array<const char*, 3> colors; // light, dark, high contrast
};

constexpr Role kRoles[] = {
    {"background", {"#DCDFE2", "#20252A", "#000000"}}, {"surface", {"#EBEDEF", "#2B3138", "#0A0A0A"}},
    {"raised", {"#F6F7F8", "#363E46", "#141414"}},     {"inset", {"#FFFFFF", "#171B1F", "#000000"}},
    {"line", {"#6E777F", "#87919B", "#FFFFFF"}},       {"faint", {"#C3C8CD", "#414A53", "#8A8A8A"}},
    {"text", {"#1B2127", "#E9EDF0", "#FFFFFF"}},       {"muted", {"#59636C", "#A3ADB6", "#E0E0E0"}},
    {"button", {"#F9FAFB", "#3B444D", "#101010"}},     {"accent", {"#2A6CA6", "#4C9BDB", "#FFD60A"}},
    {"off", {"#9AA2AA", "#59626B", "#4A4A4A"}},        {"running", {"#FBFCFD", "#E3E8EC", "#FFFFFF"}},
    {"liquid", {"#84A9C9", "#4F7FA6", "#4DA3FF"}},     {"pipe", {"#B3BAC1", "#5C666F", "#9A9A9A"}},
    {"measure", {"#4C7CA6", "#6FA3CF", "#5CB8FF"}},    {"segment", {"#FF5A3C", "#FF6A4D", "#FF6A4D"}},
    {"glass", {"#1D2226", "#101316", "#000000"}},      {"alarm", {"#C81E1E", "#F04747", "#FF3B30"}},
    {"high", {"#D9660F", "#F5872B", "#FF9500"}},       {"warning", {"#D9A800", "#F2C522", "#FFE600"}},
    {"low", {"#8650B0", "#B98BDE", "#E19BFF"}},        {"red", {"#D6281F", "#F2473C", "#FF3B30"}},
    {"orange", {"#E87417", "#F68B33", "#FF9500"}},     {"yellow", {"#F2B90C", "#F7CB36", "#FFE600"}},
    {"green", {"#2B9A57", "#3FBF74", "#2BFF6E"}},      {"blue", {"#2878C8", "#4A9DF0", "#4DA3FF"}},
    {"white", {"#FFFFFF", "#FFFFFF", "#FFFFFF"}},      {"black", {"#000000", "#000000", "#000000"}},
    {"grey", {"#8C949C", "#7D8790", "#9A9A9A"}},       {"good", {"#3D7F5C", "#63B08A", "#2BFF6E"}},
    {"series1", {"#2A6CA6", "#5BA8E6", "#4DA3FF"}},    {"series2", {"#B4511B", "#F0915A", "#FF9500"}},
    {"series3", {"#3A7D54", "#6CC493", "#2BFF6E"}},    {"series4", {"#7A4FA3", "#BC97E3", "#E19BFF"}},
    {"series5", {"#8A6D00", "#D9BC4A", "#FFE600"}},    {"series6", {"#A3315F", "#EE7FA8", "#FF6FA5"}},
    {"series7", {"#2C7C86", "#63C3CE", "#5CF2FF"}},    {"series8", {"#555D65", "#B4BCC4", "#FFFFFF"}},
};

} // namespace

const PanelTheme& PanelTheme::of(PanelThemeKind kind) {
    static const std::array<PanelTheme, 3> themes = [] {
        std::array<PanelTheme, 3> out;
        for (size_t i = 0; i < 3; ++i) {
            out[i].m_kind = static_cast<PanelThemeKind>(i);
            for (const Role& role : kRoles)
                out[i].m_colors.insert(QString::fromLatin1(role.name), QColor(QLatin1String(role.colors[i])));
        }
        return out;
    }();
    return themes[static_cast<size_t>(kind)];
}

const PanelTheme& PanelTheme::named(const QString& name) {
    return of(static_cast<PanelThemeKind>(std::max(qsizetype(0), builtIn().indexOf(name))));
}

const QStringList& PanelTheme::builtIn() {
    static const QStringList names{QStringLiteral("light"), QStringLiteral("dark"), QStringLiteral("contrast")};
    return names;
}

QColor PanelTheme::color(const QString& name) const {
    const auto found = m_colors.constFind(name);
    if (found != m_colors.constEnd()) return *found;
    return name.startsWith(u'#') ? QColor(name) : QColor();
}

QColor PanelTheme::inkOn(const QColor& ground) {
    const QColor dark(0x15, 0x1A, 0x1F), light(0xFF, 0xFF, 0xFF);
    return contrast(dark, ground) >= contrast(light, ground) ? dark : light;
}

QColor PanelTheme::priority(int priority) const {
    const char* const roles[] = {"alarm", "high", "warning", "low"};
    return color(roles[std::clamp(priority, 1, 4) - 1]);
}

QColor PanelTheme::series(int index) const { return color(QStringLiteral("series%1").arg(index % 8 + 1)); }

QStringList PanelTheme::roles() {
    QStringList out;
    for (const Role& role : kRoles) out += QString::fromLatin1(role.name);
    return out;
}

namespace {

Message unknownRole(const std::string& name) {
    std::vector<std::string> roles;
    for (const Role& role : kRoles) roles.emplace_back(role.name);
    if (const std::optional<std::string> near = nearestName(name, roles))
        return errors::ThemeRoleUnknownSuggest(name, *near);
    return errors::ThemeRoleUnknown(name);
}

/// "hmi/themes/night.json:7": where the file names the key.
std::string placeOf(const std::string& key, const std::string& utf8, const std::string& file) {
    const size_t at = utf8.find('"' + key + '"');
    if (at == std::string::npos) return file; // written with escapes
    const auto end = utf8.begin() + static_cast<std::ptrdiff_t>(at);
    return file + ':' + std::to_string(1 + std::count(utf8.begin(), end, '\n'));
}

} // namespace

Result<PanelTheme> PanelTheme::parse(const std::string& utf8, const QString& place) {
    const JsonText<Json> json = readJson<Json>(utf8);
    const std::string where = toUtf8(place);
    if (!json.isGood()) return Error{errors::ThemeNotJson(), where + ":" + std::to_string(json.line)};
    if (!json.value.is_object()) return Error{errors::ThemeNotJson(), where};
    const Json base = json.value.value("base", Json("light"));
    const QString name = base.is_string() ? toQString(base) : QString();
    if (!builtIn().contains(name)) return Error{errors::ThemeBaseUnknown(toUtf8(name)), placeOf("base", utf8, where)};
    PanelTheme out = named(name);
    const Json colors = json.value.value("colors", Json::object());
    if (!colors.is_object()) return Error{errors::ThemeNotJson(), placeOf("colors", utf8, where)};
    for (const auto& [role, value] : colors.items()) {
        if (!out.m_colors.contains(QString::fromStdString(role)))
            return Error{unknownRole(role), placeOf(role, utf8, where)};
        const QColor color = value.is_string() ? QColor(toQString(value)) : QColor();
        if (!color.isValid() || !toQString(value).startsWith(u'#'))
            return Error{errors::ThemeColorWrong(role, Verbatim("#2A6CA6")), placeOf(role, utf8, where)};
        out.m_colors[QString::fromStdString(role)] = color;
    }
    return out;
}

std::string PanelTheme::write() const {
    Json colors = Json::object();
    for (const Role& role : kRoles) // in their order, whatever the order of the edits
        if (const QColor own = color(role.name); own != of(m_kind).color(role.name))
            colors[role.name] = toUtf8(own.name(own.alpha() == 255 ? QColor::HexRgb : QColor::HexArgb).toUpper());
    return Json{{"base", toUtf8(builtIn()[static_cast<qsizetype>(m_kind)])}, {"colors", colors}}.dump(2) + '\n';
}

void PanelTheme::setBase(PanelThemeKind kind) {
    const PanelTheme before = *this;
    *this = of(kind);
    for (const QString& role : roles())
        if (const QColor own = before.color(role); own != of(before.m_kind).color(role)) m_colors[role] = own;
}

void PanelTheme::setColor(const QString& role, const QColor& color) {
    m_colors[role] = color.isValid() ? color : of(m_kind).color(role);
}

std::vector<PanelTheme::Weak> PanelTheme::weaknesses() const {
    // What elements write on what: WCAG 2's figure for letters, and the one for things that must be seen.
    struct Pair {
        const char *ink, *ground;
        double needed;
    };
    static constexpr Pair kPairs[] = {
        {"text", "background", 4.5}, {"text", "surface", 4.5},     {"text", "raised", 4.5},   {"text", "inset", 4.5},
        {"text", "button", 4.5},     {"muted", "background", 4.5}, {"muted", "surface", 4.5}, {"line", "background", 3},
        {"alarm", "surface", 3},     {"measure", "surface", 3},    {"accent", "surface", 3},  {"segment", "glass", 3},
        {"running", "off", 1.25},
    };
    std::vector<Weak> out;
    for (const Pair& pair : kPairs)
        if (const double is = contrast(color(pair.ink), color(pair.ground)); is < pair.needed)
            out.push_back({QString::fromLatin1(pair.ink), QString::fromLatin1(pair.ground), is, pair.needed});
    return out;
}

void PanelThemes::set(const QString& name, PanelTheme theme) {
    m_own[name] = std::make_shared<const PanelTheme>(std::move(theme));
}

const PanelTheme& PanelThemes::named(const QString& name) const {
    const auto found = m_own.find(name);
    return found == m_own.end() ? PanelTheme::named(name) : *found->second;
}

QStringList PanelThemes::names() const {
    QStringList out = PanelTheme::builtIn();
    for (const auto& [name, theme] : m_own)
        if (!out.contains(name)) out += name;
    return out;
}

} // namespace plc::hmi
