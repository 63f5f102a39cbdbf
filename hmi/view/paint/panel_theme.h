// The colours of panels by role, after the ideas of ISA-101: a grey process, colour for what is not normal. Three
// themes are built in; a project has more in hmi/themes/NAME.json. Immutable values, any thread.
#pragma once
#include "runtime/base/result.h"

#include <QColor>
#include <QHash>
#include <QStringList>

#include <map>
#include <memory>
#include <vector>

namespace plc::hmi {

enum class PanelThemeKind { Light, Dark, Contrast };

class PanelTheme {
public:
    static const PanelTheme& of(PanelThemeKind kind);
    /// "light", "dark", "contrast"; anything else is light.
    static const PanelTheme& named(const QString& name);
    /// Their names, as PanelThemeKind counts them.
    static const QStringList& builtIn();

    PanelThemeKind kind() const { return m_kind; }
    bool isDark() const { return m_kind != PanelThemeKind::Light; }
    /// The colour of a role or of "#rrggbb"; an invalid colour for "none" and what is not known.
    QColor color(const QString& name) const;
    QColor color(const char* role) const { return color(QString::fromLatin1(role)); }
    /// Black or white, whichever can be read on the ground.
    static QColor inkOn(const QColor& ground);
    /// 1 (most urgent) … 4.
    QColor priority(int priority) const;
    QColor series(int index) const;
    static QStringList roles();
    /// A theme file: {"base": "dark", "colors": {"background": "#10202A", …}}; what it does not name is the base's.
    static Result<PanelTheme> parse(const std::string& utf8, const QString& place);
    /// The file that parse() reads back.
    std::string write() const;
    /// The colours that are those of the base become those of the new one, the others stay.
    void setBase(PanelThemeKind kind);
    /// `role` is one of roles(); an invalid colour is the base's.
    void setColor(const QString& role, const QColor& color);
    /// Pairs of roles that are read on each other and cannot be told apart well enough.
    struct Weak {
        QString ink, ground;
        double contrast = 0, needed = 0;
    };
    std::vector<Weak> weaknesses() const;
    bool operator==(const PanelTheme&) const = default;

private:
    PanelThemeKind m_kind = PanelThemeKind::Light;
    QHash<QString, QColor> m_colors;
};

/// The built-in themes and those of a project, by name. A value that is cheap to copy.
class PanelThemes {
public:
    void set(const QString& name, PanelTheme theme);
    void clear() { m_own.clear(); }
    /// The theme of that name; light for one that is not known.
    const PanelTheme& named(const QString& name) const;
    bool has(const QString& name) const { return names().contains(name); }
    /// The built-in ones first.
    QStringList names() const;
    const std::map<QString, std::shared_ptr<const PanelTheme>>& own() const { return m_own; }

private:
    std::map<QString, std::shared_ptr<const PanelTheme>> m_own;
};

} // namespace plc::hmi
