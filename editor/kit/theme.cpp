#include "editor/kit/theme.h"

#include "editor/kit/paper.h"

#include "editor/kit/studio_style.h"

#include <QAbstractItemModel>
#include <QApplication>
#include <QFont>
#include <QListWidget>
#include <QPixmapCache>
#include <QSignalBlocker>
#include <QStyleFactory>
#include <QTableWidget>
#include <QTreeWidget>
#include <QWidget>

namespace plc::kit {

namespace {

QColor rgb(const char* text) { return QColor(QLatin1String(text)); }

ThemeColors makeLight() {
    ThemeColors c;
    c.dark = false;
    c.window = rgb("#f3f4f7");
    c.base = rgb("#ffffff");
    c.alternate = rgb("#f7f8fb");
    c.raised = rgb("#ffffff");
    c.text = rgb("#1d2129");
    c.muted = rgb("#5f6876");
    c.disabled = rgb("#a3aab5");
    c.border = rgb("#c9ced8");
    c.divider = rgb("#e0e3ea");
    c.hover = rgb("#e4e8ef");
    c.pressed = rgb("#d5dbe5");
    c.accent = rgb("#2563d9");
    c.onAccent = rgb("#ffffff");
    c.selection = rgb("#cfe0fb");
    c.good = rgb("#1a7f3c");
    c.warning = rgb("#b45f06");
    c.bad = rgb("#c8282d");
    c.info = rgb("#2563d9");
    c.online = rgb("#0b6fa4");
    c.forced = rgb("#c2410c");
    c.breakpoint = rgb("#c8282d");
    c.current = rgb("#ffe58a");
    c.plotGround = rgb("#ffffff");
    c.plotGrid = rgb("#e5e8ee");
    c.plotAxis = rgb("#8a93a1");
    c.plotCursor = rgb("#30363f");
    c.plotGap = rgb("#eceef2");
    c.plotTrigger = rgb("#b8348f");
    for (const char* curve :
         {"#2563d9", "#d9480f", "#1a8a3f", "#b0164e", "#4c1d95", "#0996ab", "#6b4100", "#7d8591", "#cc33ff", "#003366"})
        c.curves.push_back(rgb(curve));
    return c;
}

ThemeColors makeDark() {
    ThemeColors c;
    c.dark = true;
    c.window = rgb("#202329");
    c.base = rgb("#17191e");
    c.alternate = rgb("#1c1f25");
    c.raised = rgb("#282c34");
    c.text = rgb("#dfe3ea");
    c.muted = rgb("#99a1af");
    c.disabled = rgb("#5d6470");
    c.border = rgb("#434954");
    c.divider = rgb("#30353d");
    c.hover = rgb("#2d323b");
    c.pressed = rgb("#3a404b");
    c.accent = rgb("#5a9bff");
    c.onAccent = rgb("#0d1420");
    c.selection = rgb("#214375");
    c.good = rgb("#4cc472");
    c.warning = rgb("#eda63b");
    c.bad = rgb("#ff6b69");
    c.info = rgb("#5a9bff");
    c.online = rgb("#5fc3ee");
    c.forced = rgb("#ff9352");
    c.breakpoint = rgb("#f0565b");
    c.current = rgb("#5c5220");
    c.plotGround = rgb("#17191e");
    c.plotGrid = rgb("#2c3038");
    c.plotAxis = rgb("#7a8391");
    c.plotCursor = rgb("#e3e7ee");
    c.plotGap = rgb("#22252b");
    c.plotTrigger = rgb("#f07acb");
    for (const char* curve :
         {"#5a9bff", "#ff8a4c", "#3fb866", "#ff5c93", "#cdbcff", "#35dbe8", "#ffe27a", "#8f98a6", "#c24fe0", "#7f9a2a"})
        c.curves.push_back(rgb(curve));
    return c;
}

/// Every ink has at least 7:1 on black (WCAG AAA), every line that divides at least 3:1.
ThemeColors makeContrast() {
    ThemeColors c;
    c.dark = true;
    c.contrast = true;
    c.window = rgb("#000000");
    c.base = rgb("#000000");
    c.alternate = rgb("#141414");
    c.raised = rgb("#000000");
    c.text = rgb("#ffffff");
    c.muted = rgb("#d8d8d8");
    c.disabled = rgb("#a6a6a6");
    c.border = rgb("#ffffff");
    c.divider = rgb("#8c8c8c");
    c.hover = rgb("#2b2b2b");
    c.pressed = rgb("#454545");
    c.accent = rgb("#ffe600");
    c.onAccent = rgb("#000000");
    c.selection = rgb("#004ec2");
    c.good = rgb("#4dff88");
    c.warning = rgb("#ffc233");
    c.bad = rgb("#ff8a8a");
    c.info = rgb("#7fd0ff");
    c.online = rgb("#66d9ff");
    c.forced = rgb("#ffb000");
    c.breakpoint = rgb("#ff8a8a");
    c.current = rgb("#5c5200");
    c.plotGround = rgb("#000000");
    c.plotGrid = rgb("#5e5e5e");
    c.plotAxis = rgb("#ffffff");
    c.plotCursor = rgb("#ffffff");
    c.plotGap = rgb("#333333");
    c.plotTrigger = rgb("#ff80ff");
    for (const char* curve :
         {"#66b8ff", "#ff9d5c", "#4dff88", "#ff7fb0", "#e2d4ff", "#33d6f0", "#ffe14d", "#ffffff", "#ff6666", "#00cc00"})
        c.curves.push_back(rgb(curve));
    return c;
}

/// What a row was given as its ink, in the other theme; an invalid colour for one that is none of ours.
QColor inkIn(const ThemeColors& to, const ThemeColors& from, const QColor& ink) {
    for (const auto role : {&ThemeColors::text, &ThemeColors::muted, &ThemeColors::good, &ThemeColors::warning,
                            &ThemeColors::bad, &ThemeColors::online, &ThemeColors::forced, &ThemeColors::accent})
        if (ink == from.*role) return to.*role;
    return {};
}

void recolour(QAbstractItemModel& rows, const QModelIndex& parent, const ThemeColors& from, const ThemeColors& to) {
    for (int row = 0; row < rows.rowCount(parent); ++row)
        for (int column = 0; column < rows.columnCount(parent); ++column) {
            const QModelIndex index = rows.index(row, column, parent);
            if (const QVariant given = index.data(Qt::ForegroundRole); given.isValid())
                if (const QColor ink = inkIn(to, from, given.value<QBrush>().color()); ink.isValid())
                    rows.setData(index, QBrush(ink), Qt::ForegroundRole);
            if (column == 0) recolour(rows, index, from, to);
        }
}

/// These keep the inks that their rows were given; others ask again when they are painted.
void recolourRows(QWidget& widget, const ThemeColors& from, const ThemeColors& to) {
    auto* view = qobject_cast<QAbstractItemView*>(&widget);
    if (!qobject_cast<QTreeWidget*>(view) && !qobject_cast<QTableWidget*>(view) && !qobject_cast<QListWidget*>(view))
        return;
    const QSignalBlocker nobodyEdits(view);
    recolour(*view->model(), {}, from, to);
}

} // namespace

const ThemeColors& lightColors() {
    static const ThemeColors colors = makeLight();
    return colors;
}

const ThemeColors& darkColors() {
    static const ThemeColors colors = makeDark();
    return colors;
}

const ThemeColors& contrastColors() {
    static const ThemeColors colors = makeContrast();
    return colors;
}

QPalette paletteFor(const ThemeColors& c) {
    QPalette p;
    p.setColor(QPalette::Window, c.window);
    p.setColor(QPalette::WindowText, c.text);
    p.setColor(QPalette::Base, c.base);
    p.setColor(QPalette::AlternateBase, c.alternate);
    p.setColor(QPalette::ToolTipBase, c.raised);
    p.setColor(QPalette::ToolTipText, c.text);
    p.setColor(QPalette::PlaceholderText, c.muted);
    p.setColor(QPalette::Text, c.text);
    p.setColor(QPalette::Button, c.window);
    p.setColor(QPalette::ButtonText, c.text);
    p.setColor(QPalette::BrightText, c.bad);
    p.setColor(QPalette::Light, c.raised);
    p.setColor(QPalette::Midlight, c.hover);
    p.setColor(QPalette::Mid, c.border);
    p.setColor(QPalette::Dark, c.muted);
    p.setColor(QPalette::Shadow, QColor(0, 0, 0, c.dark ? 160 : 60));
    p.setColor(QPalette::Highlight, c.selection);
    p.setColor(QPalette::HighlightedText, c.text);
    p.setColor(QPalette::Link, c.accent);
    p.setColor(QPalette::LinkVisited, c.accent);
    for (auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::HighlightedText})
        p.setColor(QPalette::Disabled, role, c.disabled);
    p.setColor(QPalette::Disabled, QPalette::Base, c.window);
    p.setColor(QPalette::Disabled, QPalette::Highlight, c.divider);
    return p;
}

Theme::Theme(QApplication& application) : QObject(&application) {
    // The palette that the desktop gave us, before we replace it, says whether the desktop is dark.
    m_systemDark = application.palette().color(QPalette::Window).lightness() < 128;
    setObjectName(QStringLiteral("stepwise.theme"));
}

Theme& Theme::install(QApplication& application, ThemeChoice choice) {
    auto* theme = application.findChild<Theme*>(QStringLiteral("stepwise.theme"), Qt::FindDirectChildrenOnly);
    if (!theme) {
        theme = new Theme(application);
        application.setStyle(new StudioStyle);
        theme->m_choice = choice;
        theme->apply();
    } else {
        theme->setChoice(choice);
    }
    return *theme;
}

Theme& Theme::current() {
    auto* theme = qApp->findChild<Theme*>(QStringLiteral("stepwise.theme"), Qt::FindDirectChildrenOnly);
    if (theme) return *theme;
    theme = new Theme(*qApp); // a test or the command line: colours without the style
    return *theme;
}

const ThemeColors& Theme::colors() const {
    switch (m_choice) {
    case ThemeChoice::System:
        return m_systemDark ? darkColors() : lightColors();
    case ThemeChoice::Light:
        return lightColors();
    case ThemeChoice::Dark:
        return darkColors();
    case ThemeChoice::Contrast:
        return contrastColors();
    }
    return lightColors();
}

void Theme::setChoice(ThemeChoice choice) {
    if (choice == m_choice) return;
    const ThemeColors& before = colors();
    m_choice = choice;
    for (QWidget* widget : qApp->allWidgets()) recolourRows(*widget, before, colors());
    apply();
}

void Theme::apply() {
    QPixmapCache::clear();
    if (qobject_cast<StudioStyle*>(qApp->style())) qApp->setPalette(paletteFor(colors()));
    emit changed();
    for (QWidget* widget : qApp->allWidgets()) widget->update();
}

const ThemeColors& colors() {
    const ThemeColors* paper = PaperColors::current();
    return paper ? *paper : Theme::current().colors();
}

} // namespace plc::kit
