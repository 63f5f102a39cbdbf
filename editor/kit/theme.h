// The studio's look: one set of named colours for light, dark and high contrast, a palette made from it and the style
// that draws with it. One Theme lives as a child of the QApplication; `Theme::current()` finds it, or makes a light one
// in a test. GUI thread only. Widgets that paint with theme colours repaint on `changed`.
#pragma once

#include <QColor>
#include <QObject>
#include <QPalette>

#include <vector>

class QApplication;

namespace plc::kit {

enum class ThemeChoice { System, Light, Dark, Contrast }; // their numbers are kept in the settings

/// Every colour that the studio paints with, by what it is for.
struct ThemeColors {
    bool dark = false;
    bool contrast = false;                      // white on black, lines instead of shades
    QColor window, base, alternate, raised;     // grounds: behind docks, behind text, every second row, menus and tips
    QColor text, muted, disabled;               // inks
    QColor border, divider, hover, pressed;     // lines and states of controls
    QColor accent, onAccent, selection;         // focus, default buttons, selected rows
    QColor good, warning, bad, info;            // state of the machine and of messages
    QColor online, forced, breakpoint, current; // online values, forced values, breakpoints, the line that is executed
    QColor plotGround, plotGrid, plotAxis, plotCursor, plotGap, plotTrigger;
    std::vector<QColor> curves; // colours that charts give out in turn

    QColor curve(int index) const { return curves[static_cast<size_t>(index) % curves.size()]; }
};

const ThemeColors& lightColors();
const ThemeColors& darkColors();
const ThemeColors& contrastColors();
QPalette paletteFor(const ThemeColors& colors);

class Theme : public QObject {
    Q_OBJECT
public:
    /// Makes the theme of the application and applies it; a second call changes the choice.
    static Theme& install(QApplication& application, ThemeChoice choice);
    static Theme& current();

    ThemeChoice choice() const { return m_choice; }
    bool isDark() const { return colors().dark; }
    const ThemeColors& colors() const;
    void setChoice(ThemeChoice choice);

signals:
    void changed();

private:
    explicit Theme(QApplication& application);
    void apply();

    ThemeChoice m_choice = ThemeChoice::Light;
    bool m_systemDark = false;
};

/// The colours of the present theme.
const ThemeColors& colors();

} // namespace plc::kit
