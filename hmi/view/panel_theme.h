// The colours of panels by role, after the ideas of ISA-101: a grey process, colour for what is not normal.
// Immutable values, any thread.
#pragma once
#include <QColor>
#include <QHash>
#include <QStringList>

namespace plc::hmi {

enum class PanelThemeKind { Light, Dark, Contrast };

class PanelTheme {
public:
    static const PanelTheme& of(PanelThemeKind kind);
    /// "light", "dark", "contrast"; anything else is light.
    static const PanelTheme& named(const QString& name);

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

private:
    PanelThemeKind m_kind = PanelThemeKind::Light;
    QHash<QString, QColor> m_colors;
};

} // namespace plc::hmi
