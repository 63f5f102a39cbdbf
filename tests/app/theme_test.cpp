// The themes of the studio: chosen in the menu, kept, and in high contrast every window can be read.
#include "app/st_page.h"
#include "editor/kit/contrast.h"
#include "editor/kit/theme.h"
#include "tests/app/all_windows.h"

#include <QAbstractScrollArea>
#include <QAction>
#include <Qsci/qsciscintilla.h>

#include <set>

namespace plc::app {
namespace {

class ThemeTest : public AllWindowsTest {
protected:
    void SetUp() override {
        kit::Theme::install(*qApp, kit::ThemeChoice::Light);
        open();
    }
    void TearDown() override {
        AllWindowsTest::TearDown();
        kit::Theme::install(*qApp, kit::ThemeChoice::Light);
    }
    void choose(const char* action) { window->action(action)->trigger(); }
};

TEST_F(ThemeTest, IsChosenInTheMenuAndKept) {
    const std::pair<const char*, kit::ThemeChoice> all[] = {{"view.contrast", kit::ThemeChoice::Contrast},
                                                            {"view.dark", kit::ThemeChoice::Dark},
                                                            {"view.light", kit::ThemeChoice::Light},
                                                            {"view.system", kit::ThemeChoice::System}};
    for (const auto& [action, choice] : all) {
        choose(action);
        EXPECT_EQ(kit::Theme::current().choice(), choice) << action;
        EXPECT_EQ(Settings().theme(), choice) << action << " is there again at the next start";
        EXPECT_EQ(window->palette().color(QPalette::Window), kit::colors().window) << action;
    }
}

bool canBeRead(const QColor& ink, const QColor& ground) { return kit::contrast(ink, ground) >= 7; }

/// A widget with colours of its own, set by a palette or a style sheet, would show here.
QString unreadable(const QWidget& widget) {
    const QPalette palette = widget.palette();
    const std::pair<QPalette::ColorRole, QPalette::ColorRole> pairs[] = {
        {QPalette::WindowText, QPalette::Window},
        {QPalette::Text, QPalette::Base},
        {QPalette::ButtonText, QPalette::Button},
        {QPalette::HighlightedText, QPalette::Highlight}};
    for (const auto& [ink, ground] : pairs)
        if (!canBeRead(palette.color(QPalette::Active, ink), palette.color(QPalette::Active, ground)))
            return palette.color(ink).name() + " on " + palette.color(ground).name();
    return {};
}

/// Inks of a text as its lexer has them, on the paper that Scintilla paints.
std::set<QString> dimInksOf(QsciScintilla& text) {
    std::set<QString> out;
    for (unsigned long style = 0; style < 32; ++style) {
        const auto colour = [&](unsigned message) {
            const long bgr = text.SendScintilla(message, style);
            return QColor(static_cast<int>(bgr & 0xff), static_cast<int>(bgr >> 8 & 0xff),
                          static_cast<int>(bgr >> 16 & 0xff));
        };
        const QColor ink = colour(QsciScintillaBase::SCI_STYLEGETFORE),
                     paper = colour(QsciScintillaBase::SCI_STYLEGETBACK);
        if (!canBeRead(ink, paper)) out.insert(QString("style %1: %2 on %3").arg(style).arg(ink.name(), paper.name()));
    }
    return out;
}

TEST_F(ThemeTest, EveryWindowCanBeReadInHighContrast) {
    choose("view.contrast");
    std::set<QString> dim;
    size_t seen = 0;
    lookAtAll([&](QWidget& shown, const QString& name) {
        for (QWidget* widget : widgetsOf(shown)) {
            if (!widget->isVisibleTo(&shown)) continue;
            ++seen;
            const QString which = name + ": " + widget->metaObject()->className() + ' ' + widget->objectName() + ' ';
            if (const QString found = unreadable(*widget); !found.isEmpty()) dim.insert(which + found);
            if (auto* text = qobject_cast<QsciScintilla*>(widget))
                for (const QString& found : dimInksOf(*text)) dim.insert(which + found);
        }
    });
    for (const QString& each : dim) ADD_FAILURE() << each.toStdString();
    EXPECT_GT(seen, 3000u);
}

/// A chart and a ladder paint on their own: the ground is black, and what is drawn reaches white.
TEST_F(ThemeTest, DrawingsAreWhiteOnBlackInHighContrast) {
    choose("view.contrast");
    const auto expectDrawn = [](QWidget& view, const char* name) {
        const QImage picture = view.grab().toImage();
        size_t black = 0, bright = 0;
        for (int y = 0; y < picture.height(); ++y)
            for (int x = 0; x < picture.width(); ++x) {
                const double light = kit::luminance(picture.pixelColor(x, y));
                black += light < 0.01;
                bright += light > 0.6;
            }
        const auto all = static_cast<size_t>(picture.width() * picture.height());
        EXPECT_GT(black, all / 2) << name;
        EXPECT_GT(bright, 200u) << name;
    };
    StPage* page = window->tabs().openFile("src/steps.st");
    ASSERT_NE(page->showChart("Steps"), nullptr);
    QTest::qWait(50);
    expectDrawn(*page, "chart");
    page = window->tabs().openFile("src/rungs.st");
    ASSERT_NE(page->showLadder("Rungs"), nullptr);
    QTest::qWait(50);
    expectDrawn(*page, "ladder");
    expectDrawn(*window, "window");
}

} // namespace
} // namespace plc::app
