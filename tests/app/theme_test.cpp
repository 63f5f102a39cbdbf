// The themes of the studio: chosen in the menu, kept, and in each of them every window can be read.
#include "app/pages/st_page.h"
#include "editor/kit/contrast.h"
#include "editor/kit/theme.h"
#include "tests/app/all_windows.h"
#include "tests/support/settle.h"

#include <QAbstractItemView>
#include <QAbstractScrollArea>
#include <QAction>
#include <QLabel>
#include <QTextBlock>
#include <QTextDocument>
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
        EXPECT_TRUE(waitFor([&] { return window->palette().color(QPalette::Window) == kit::colors().window; }))
            << action;
    }
}

/// WCAG AA, and AAA where high contrast was asked for.
double needed() { return kit::colors().contrast ? 7 : 4.5; }

QString faintness(const QColor& ink, const QColor& ground, double least) {
    const double is = kit::contrast(ink, ground);
    return is >= least ? QString() : QString("%1 on %2, %3 to 1").arg(ink.name(), ground.name()).arg(is, 0, 'f', 2);
}

/// What is painted behind a widget: its own ground, or that of the nearest around it that paints one.
QColor groundOf(const QWidget& widget) {
    if (widget.styleSheet().contains("background")) // Qt keeps a style sheet's ground there
        return widget.palette().color(QPalette::Active, QPalette::Base);
    for (const QWidget* each = &widget; each; each = each->parentWidget())
        if (each->autoFillBackground() || each->isWindow() || each->inherits("QAbstractScrollArea"))
            return each->palette().color(QPalette::Active, each->backgroundRole());
    return kit::colors().window;
}

/// A widget with colours of its own, set by a palette, would show here.
QStringList faintInksOf(const QWidget& widget) {
    const QPalette palette = widget.palette();
    QStringList out;
    const auto expect = [&](QPalette::ColorRole ink, const QColor& ground) {
        const QString faint = faintness(palette.color(QPalette::Active, ink), ground, needed());
        if (!faint.isEmpty()) out << QString("role %1: %2").arg(ink).arg(faint);
    };
    expect(widget.foregroundRole(), groundOf(widget));
    if (qobject_cast<const QAbstractScrollArea*>(&widget) || widget.inherits("QLineEdit")) {
        const QColor base = palette.color(QPalette::Active, QPalette::Base);
        expect(QPalette::Text, base);
        expect(QPalette::PlaceholderText, base);
        expect(QPalette::HighlightedText, palette.color(QPalette::Active, QPalette::Highlight));
    }
    if (const auto* view = qobject_cast<const QAbstractItemView*>(&widget); view && view->alternatingRowColors())
        expect(QPalette::Text, palette.color(QPalette::Active, QPalette::AlternateBase));
    return out;
}

/// Inks of a text as its lexer has them, on the paper that Scintilla paints.
QStringList faintInksOf(QsciScintilla& text) {
    QStringList out;
    for (unsigned long style = 0; style <= QsciScintillaBase::STYLE_LINENUMBER; ++style) {
        const auto colour = [&](unsigned message) {
            const long bgr = text.SendScintilla(message, style);
            return QColor(static_cast<int>(bgr & 0xff), static_cast<int>(bgr >> 8 & 0xff),
                          static_cast<int>(bgr >> 16 & 0xff));
        };
        const QString faint = faintness(colour(QsciScintillaBase::SCI_STYLEGETFORE),
                                        colour(QsciScintillaBase::SCI_STYLEGETBACK), needed());
        if (!faint.isEmpty()) out << QString("style %1: %2").arg(style).arg(faint);
    }
    return out;
}

/// The colours that spans of rich text bring along: a label cannot take those from the theme by itself.
QStringList faintInksOf(const QLabel& label) {
    QStringList out;
    if (!Qt::mightBeRichText(label.text())) return out;
    QTextDocument text;
    text.setHtml(label.text());
    for (QTextBlock block = text.begin(); block.isValid(); block = block.next())
        for (auto at = block.begin(); !at.atEnd(); ++at) {
            const QTextCharFormat format = at.fragment().charFormat();
            if (!format.hasProperty(QTextFormat::ForegroundBrush) || format.isAnchor()) continue;
            const QString faint =
                faintness(format.foreground().color(), label.palette().color(QPalette::Window), needed());
            if (!faint.isEmpty()) out << at.fragment().text().left(20) + ": " + faint;
        }
    return out;
}

/// What models give their rows as colours of text.
QStringList faintInksOf(const QAbstractItemView& view) {
    QStringList out;
    const QAbstractItemModel* model = view.model();
    if (!model) return out;
    for (int row = 0; row < std::min(model->rowCount(view.rootIndex()), 100); ++row)
        for (int column = 0; column < model->columnCount(view.rootIndex()); ++column) {
            const QModelIndex index = model->index(row, column, view.rootIndex());
            const QVariant ink = index.data(Qt::ForegroundRole), paper = index.data(Qt::BackgroundRole);
            if (!ink.isValid() || !(index.flags() & Qt::ItemIsEnabled)) continue;
            const QColor ground =
                paper.isValid() ? paper.value<QBrush>().color() : view.palette().color(QPalette::Base);
            const QString faint = faintness(ink.value<QBrush>().color(), ground, needed());
            if (!faint.isEmpty()) out << "“" + index.data().toString().left(20) + "”: " + faint;
        }
    return out;
}

class ContrastTest : public ThemeTest, public ::testing::WithParamInterface<kit::ThemeChoice> {};

TEST_P(ContrastTest, EveryTextOfEveryWindowHasContrast) {
    kit::Theme::install(*qApp, GetParam()); // of a window that was made in another one
    std::set<QString> faint;
    size_t seen = 0;
    lookAtAll([&](QWidget& shown, const QString& name) {
        for (QWidget* widget : widgetsOf(shown)) {
            if (!widget->isVisibleTo(&shown) || !widget->isEnabled()) continue;
            ++seen;
            QStringList found = faintInksOf(*widget);
            if (auto* text = qobject_cast<QsciScintilla*>(widget)) found += faintInksOf(*text);
            if (auto* label = qobject_cast<QLabel*>(widget)) found += faintInksOf(*label);
            if (auto* view = qobject_cast<QAbstractItemView*>(widget)) found += faintInksOf(*view);
            for (const QString& each : found)
                faint.insert(
                    QString("%1: %2 %3 %4")
                        .arg(name.section(':', 0, 0), widget->metaObject()->className(), widget->objectName(), each));
        }
    });
    for (const QString& each : faint) ADD_FAILURE() << each.toStdString();
    EXPECT_GT(seen, 3000u);
}

INSTANTIATE_TEST_SUITE_P(Themes, ContrastTest,
                         ::testing::Values(kit::ThemeChoice::Light, kit::ThemeChoice::Dark,
                                           kit::ThemeChoice::Contrast));

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
    settle();
    expectDrawn(*page, "chart");
    page = window->tabs().openFile("src/rungs.st");
    ASSERT_NE(page->showLadder("Rungs"), nullptr);
    settle();
    expectDrawn(*page, "ladder");
    expectDrawn(*window, "window");
}

} // namespace
} // namespace plc::app
