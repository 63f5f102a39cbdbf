// What a user does to the small widgets of the kit: typing, choosing, spinning, undoing.
#include "editor/kit/canvas.h"
#include "editor/kit/command_palette.h"
#include "editor/kit/contrast.h"
#include "editor/kit/edit_history.h"
#include "editor/kit/fuzzy.h"
#include "editor/kit/icons.h"
#include "editor/kit/inputs/expression_edit.h"
#include "editor/kit/inputs/property_grid.h"
#include "editor/kit/inputs/variable_picker.h"
#include "editor/kit/theme.h"
#include "tests/support/settle.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QFile>
#include <QGraphicsRectItem>
#include <QHeaderView>
#include <QLineEdit>
#include <QMainWindow>
#include <QMenuBar>
#include <QMimeData>
#include <QSignalSpy>
#include <QSpinBox>
#include <QSvgRenderer>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeWidget>

#include <gtest/gtest.h>

#include <array>
#include <cmath>

using namespace plc::kit;

TEST(FuzzyMatch, PrefersWordBeginningsAndTouchingLetters) {
    struct Row {
        const char* pattern;
        const char* better;
        const char* worse;
    };
    for (const Row& row : {Row{"sa", "Save all", "Reset task"}, Row{"so", "Step over", "Also this one"},
                           Row{"run", "Run", "Prune entry"}, Row{"mpid", "Main.pid", "ManPowerInside.d"}}) {
        const auto better = fuzzyMatch(QString(row.pattern), QString(row.better));
        const auto worse = fuzzyMatch(QString(row.pattern), QString(row.worse));
        ASSERT_TRUE(better && worse) << row.pattern;
        EXPECT_GT(better->score, worse->score) << row.pattern;
    }
    EXPECT_FALSE(fuzzyMatch(u"xyz", u"Step over"));
    EXPECT_FALSE(fuzzyMatch(u"revo", u"over"));
    EXPECT_EQ(fuzzyMatch(u"so", u"Step over")->positions, (std::vector<int>{0, 5}));
}

TEST(Icons, EveryDrawingIsGoodSvgAndLeavesInk) {
    for (const ThemeColors* theme : {&lightColors(), &darkColors()})
        for (Icon which : allIcons()) {
            const QByteArray svg = iconSvg(which, *theme);
            EXPECT_FALSE(svg.contains('$')) << iconWord(which).toString().toStdString();
            QSvgRenderer renderer(svg);
            ASSERT_TRUE(renderer.isValid()) << iconWord(which).toString().toStdString();
            QImage image(32, 32, QImage::Format_ARGB32);
            image.fill(Qt::transparent);
            QPainter painter(&image);
            renderer.render(&painter);
            painter.end();
            int inked = 0;
            for (int y = 0; y < 32; ++y)
                for (int x = 0; x < 32; ++x) inked += qAlpha(image.pixel(x, y)) > 40;
            EXPECT_GT(inked, 20) << iconWord(which).toString().toStdString();
        }
    EXPECT_EQ(iconByWord(u"step-over"), Icon::StepOver);
    EXPECT_FALSE(iconByWord(u"no-such-icon"));
}

TEST(Icons, FollowTheTheme) {
    const QIcon run = icon(Icon::Project);
    const QImage light = run.pixmap(32, 32).toImage();
    Theme::current().setChoice(ThemeChoice::Dark);
    const QImage dark = run.pixmap(32, 32).toImage();
    Theme::current().setChoice(ThemeChoice::Light);
    EXPECT_NE(light, dark);
    EXPECT_EQ(light, run.pixmap(32, 32).toImage());
}

TEST(Theme, TextCanBeReadOnItsGroundInEveryTheme) {
    for (const ThemeColors* c : {&lightColors(), &darkColors(), &contrastColors()}) {
        for (const QColor& ground : {c->base, c->window, c->raised, c->alternate, c->selection})
            EXPECT_GE(contrast(c->text, ground), 7) << ground.name().toStdString();
        for (const QColor& ink : {c->muted, c->good, c->warning, c->bad, c->online, c->forced})
            EXPECT_GE(contrast(ink, c->base), 4.5) << ink.name().toStdString();
        for (const QColor& curve : c->curves)
            EXPECT_GE(contrast(curve, c->plotGround), 3) << curve.name().toStdString();
        EXPECT_GE(contrast(c->onAccent, c->accent), 4.5);
    }
}

namespace {

/// As somebody sees it who has no red or no green cones (matrices of Machado and others, 2009), in CIE Lab.
std::array<double, 3> seenAs(const QColor& color, const std::array<std::array<double, 3>, 3>& eye) {
    const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
    const std::array<double, 3> full{linear(color.redF()), linear(color.greenF()), linear(color.blueF())};
    std::array<double, 3> seen{};
    for (size_t i = 0; i < 3; ++i)
        seen[i] = std::clamp(eye[i][0] * full[0] + eye[i][1] * full[1] + eye[i][2] * full[2], 0.0, 1.0);
    const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; };
    const double x = f((0.4125 * seen[0] + 0.3576 * seen[1] + 0.1804 * seen[2]) / 0.9505);
    const double y = f(0.2127 * seen[0] + 0.7152 * seen[1] + 0.0722 * seen[2]);
    const double z = f((0.0193 * seen[0] + 0.1192 * seen[1] + 0.9503 * seen[2]) / 1.0888);
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

} // namespace

TEST(Theme, CurvesAreToldApartWithoutRedOrGreenCones) {
    constexpr std::array<std::array<std::array<double, 3>, 3>, 2> kEyes{
        {{{{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}},
         {{{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}}}};
    for (const ThemeColors* c : {&lightColors(), &darkColors()})
        for (const auto& eye : kEyes)
            for (size_t i = 0; i < c->curves.size(); ++i)
                for (size_t k = 0; k < i; ++k) {
                    const auto a = seenAs(c->curves[i], eye), b = seenAs(c->curves[k], eye);
                    EXPECT_GT(std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]), 8)
                        << c->curves[i].name().toStdString() << " and " << c->curves[k].name().toStdString();
                }
}

TEST(Theme, HighContrastHasSevenToOneForEveryInkAndThreeForEveryLine) {
    const ThemeColors& c = contrastColors();
    for (const QColor& ground : {c.window, c.base, c.alternate, c.raised, c.hover, c.pressed, c.selection, c.current})
        EXPECT_GE(contrast(c.text, ground), 7) << ground.name().toStdString();
    for (const QColor& ink : {c.muted, c.disabled, c.accent, c.good, c.warning, c.bad, c.info, c.online, c.forced,
                              c.breakpoint, c.plotAxis, c.plotCursor, c.plotTrigger})
        EXPECT_GE(contrast(ink, c.base), 7) << ink.name().toStdString();
    for (const QColor& curve : c.curves) EXPECT_GE(contrast(curve, c.plotGround), 7) << curve.name().toStdString();
    EXPECT_GE(contrast(c.onAccent, c.accent), 7);
    for (const QColor& line : {c.border, c.divider, c.plotGrid})
        EXPECT_GE(contrast(line, c.base), 3) << line.name().toStdString();
}

TEST(Theme, HighContrastBrightensAnInkUntilItCanBeRead) {
    const QColor dull("#8fa392"), deep("#2020c0");
    EXPECT_EQ(legible(deep), deep) << "another theme leaves it";
    Theme::current().setChoice(ThemeChoice::Contrast);
    for (const QColor& ink : {dull, deep, QColor(Qt::black)}) EXPECT_GE(contrast(legible(ink), colors().base), 7);
    EXPECT_EQ(legible(Qt::yellow), QColor(Qt::yellow)) << "it can be read already";
    Theme::current().setChoice(ThemeChoice::Light);
}

TEST(CommandPalette, TypedLettersFindAndReturnRunsTheAction) {
    QMainWindow window;
    QMenu* file = window.menuBar()->addMenu("&File");
    QMenu* debug = window.menuBar()->addMenu("&Debug");
    QAction* save = file->addAction("&Save all");
    QAction* over = debug->addAction("Step &over");
    QAction* dead = debug->addAction("Step out");
    dead->setEnabled(false);
    CommandPalette palette(&window);
    QSignalSpy ranOver(over, &QAction::triggered), ranSave(save, &QAction::triggered),
        ranDead(dead, &QAction::triggered);
    window.resize(800, 600);
    window.show();
    palette.open();
    auto* input = palette.findChild<QLineEdit*>();
    EXPECT_EQ(palette.shownTexts().size(), 3);
    QTest::keyClicks(input, "stov");
    ASSERT_FALSE(palette.shownTexts().isEmpty());
    EXPECT_EQ(palette.shownTexts().first(), "Debug: Step over");
    QTest::keyClick(input, Qt::Key_Return);
    EXPECT_EQ(ranOver.count(), 1);
    EXPECT_EQ(ranSave.count(), 0);
    EXPECT_FALSE(palette.isVisible());

    palette.open(); // what was run last comes first
    EXPECT_EQ(palette.shownTexts().first(), "Debug: Step over");
    QTest::keyClicks(input, "step out");
    QTest::keyClick(input, Qt::Key_Return);
    EXPECT_EQ(ranDead.count(), 0) << "a disabled action must not run";
    QTest::keyClick(input, Qt::Key_Escape);
    EXPECT_FALSE(palette.isVisible());
}

TEST(EditHistory, UndoAppliesTheInverseAndMergesOneGesture) {
    int value = 0;
    auto apply = [&](const int& next) { return std::exchange(value, next); };
    QUndoStack stack;
    stack.push(new EditCommand<int>("Set", 1, apply));
    stack.push(new EditCommand<int>("Drag", 2, apply, 7));
    stack.push(new EditCommand<int>("Drag", 3, apply, 7));
    EXPECT_EQ(stack.count(), 2);
    EXPECT_EQ(value, 3);
    stack.undo();
    EXPECT_EQ(value, 1);
    stack.undo();
    EXPECT_EQ(value, 0);
    stack.redo();
    stack.redo();
    EXPECT_EQ(value, 3);
}

namespace {

std::vector<PropertyDescriptor> someDescriptors() {
    std::vector<PropertyDescriptor> d(6);
    d[0] = {.id = "x", .group = "Geometry", .label = "X", .kind = PropertyKind::Integer, .minimum = 0, .maximum = 500};
    d[1] = {.id = "name", .group = "General", .label = "Name", .kind = PropertyKind::Text};
    d[2] = {.id = "on", .group = "General", .label = "Visible", .kind = PropertyKind::Bool};
    d[3] = {.id = "style", .group = "General", .label = "Style", .kind = PropertyKind::Enumeration};
    d[3].choices = {{"flat", "Flat", {}}, {"round", "Round", {}}};
    d[4] = {.id = "fill", .group = "General", .label = "Fill", .kind = PropertyKind::Color};
    d[5] = {.id = "var", .group = "General", .label = "Variable", .kind = PropertyKind::Expression};
    return d;
}

QRect cellOf(const PropertyGrid& grid, const QString& id) {
    const QRect row = grid.visualItemRect(grid.row(id));
    return {grid.columnViewportPosition(1), row.top(), grid.columnWidth(1), row.height()};
}

} // namespace

TEST(PropertyGrid, NamesAreReadWholeWhileValuesHaveRoom) {
    PropertyGrid grid;
    grid.resize(600, 300);
    grid.show();
    const QString name = QStringLiteral("Background of what is selected");
    grid.setDescriptors({{.id = QStringLiteral("a"), .label = name, .kind = PropertyKind::Text}});
    const int needed = grid.fontMetrics().horizontalAdvance(name);
    EXPECT_GT(cellOf(grid, QStringLiteral("a")).left(), needed);
    grid.resize(200, 300);
    EXPECT_GE(grid.columnWidth(1), 60);
    grid.resize(600, 300);
    EXPECT_GT(grid.columnWidth(0), needed);
    grid.header()->resizeSection(0, 90); // as a hand does
    grid.resize(500, 300);
    EXPECT_EQ(grid.columnWidth(0), 90);
}

TEST(PropertyGrid, ACommitThatBringsOtherRowsIsMadeBeforeAnotherRowIsGoneTo) {
    const auto rows = [](const QString& ids) {
        std::vector<PropertyDescriptor> out;
        for (const QChar id : ids) {
            PropertyDescriptor row;
            row.id = row.label = id;
            out.push_back(row);
        }
        return out;
    };
    const std::function<void(PropertyGrid&)> ways[] = {
        [](PropertyGrid& grid) { QTest::mouseClick(grid.viewport(), Qt::LeftButton, {}, cellOf(grid, "c").center()); },
        [](PropertyGrid& grid) { QTest::keyClick(&grid, Qt::Key_Down); },
        [](PropertyGrid& grid) { QTest::keyClick(&grid, Qt::Key_C); },
        [](PropertyGrid& grid) { grid.editProperty("c"); },
        [&rows](PropertyGrid& grid) { grid.setDescriptors(rows("xy")); },
    };
    for (const auto& go : ways) {
        PropertyGrid grid;
        grid.resize(400, 300);
        grid.setDescriptors(rows("abc"));
        grid.show();
        QStringList committed;
        QObject::connect(&grid, &PropertyGrid::committed, &grid, [&](const QString& id, const QVariant& value) {
            committed += id + "=" + value.toString();
            grid.setDescriptors(rows("acd"));
        });
        grid.editProperty("b");
        auto* line = grid.findChild<ExpressionEdit*>();
        ASSERT_TRUE(line);
        line->setText("typed"); // the keyboard is elsewhere, as when the window is not the one in front
        go(grid);
        plc::settle();
        EXPECT_EQ(committed, QStringList("b=typed"));
    }
}

TEST(PropertyGrid, ShiftBeforeACapitalLeavesTheEditorOpen) {
    PropertyGrid grid;
    PropertyDescriptor row;
    row.id = row.label = "name";
    grid.setDescriptors({row});
    grid.show();
    QSignalSpy commits(&grid, &PropertyGrid::committed);
    grid.editProperty("name");
    auto* line = grid.findChild<ExpressionEdit*>();
    ASSERT_TRUE(line);
    for (const Qt::Key key : {Qt::Key_Shift, Qt::Key_Control, Qt::Key_Alt}) {
        QTest::keyPress(line, key);
        QTest::keyClick(line, Qt::Key_M, Qt::ShiftModifier);
        QTest::keyRelease(line, key);
    }
    EXPECT_EQ(commits.count(), 0);
    EXPECT_FALSE(line->isHidden());
    QTest::keyClick(line, Qt::Key_Return);
    ASSERT_EQ(commits.count(), 1);
    EXPECT_EQ(commits[0][1].toString().toUpper(), "MMM");
}

TEST(PropertyGrid, SpinningPreviewsAndLeavingCommitsOnce) {
    PropertyGrid grid;
    grid.setDescriptors(someDescriptors());
    grid.setValue("x", 10);
    grid.resize(320, 400);
    grid.show();
    QSignalSpy previews(&grid, &PropertyGrid::previewed), commits(&grid, &PropertyGrid::committed);
    QTest::mouseClick(grid.viewport(), Qt::LeftButton, {}, cellOf(grid, "x").center());
    auto* spin = grid.viewport()->findChild<QSpinBox*>();
    ASSERT_TRUE(spin);
    EXPECT_EQ(spin->value(), 10);
    QTest::keyClick(spin, Qt::Key_Up);
    QTest::keyClick(spin, Qt::Key_Up);
    EXPECT_EQ(previews.count(), 2);
    EXPECT_EQ(commits.count(), 0);
    QTest::keyClick(spin, Qt::Key_Return);
    ASSERT_EQ(commits.count(), 1);
    EXPECT_EQ(commits[0][0].toString(), "x");
    EXPECT_EQ(commits[0][1].toInt(), 12);
    EXPECT_EQ(grid.value("x").toInt(), 12);
}

TEST(PropertyGrid, DigitsAreTypedOneAfterTheOtherWhileEachIsPreviewed) {
    PropertyGrid grid;
    grid.setDescriptors(someDescriptors());
    grid.setValue("x", 10);
    grid.resize(320, 400);
    grid.show();
    // As a sheet does: what is previewed becomes the value, which the row shows.
    QObject::connect(&grid, &PropertyGrid::previewed, &grid,
                     [&](const QString& id, const QVariant& value) { grid.setValue(id, value); });
    QSignalSpy commits(&grid, &PropertyGrid::committed), previews(&grid, &PropertyGrid::previewed);
    const auto edit = [&] {
        QTest::mouseClick(grid.viewport(), Qt::LeftButton, {}, cellOf(grid, "x").center());
        auto* spin = grid.viewport()->findChild<QSpinBox*>();
        for (const char digit : {'2', '4', '0'}) {
            QTest::keyClick(spin, digit);
            QCoreApplication::processEvents();
        }
        return spin;
    };
    QSpinBox* spin = edit();
    EXPECT_EQ(spin->value(), 240);
    QTest::keyClick(spin, Qt::Key_Return);
    ASSERT_EQ(commits.count(), 1) << "although the preview showed it already";
    EXPECT_EQ(commits[0][1].toInt(), 240);
    EXPECT_EQ(grid.value("x").toInt(), 240);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    grid.setValue("x", 10);
    QTest::keyClick(edit(), Qt::Key_Escape);
    EXPECT_EQ(commits.count(), 1);
    EXPECT_EQ(previews.last()[1].toInt(), 10) << "back to what it was before the first digit";
}

TEST(PropertyGrid, EscapeTakesThePreviewBackAndCommitsNothing) {
    PropertyGrid grid;
    grid.setDescriptors(someDescriptors());
    grid.setValue("x", 10);
    grid.resize(320, 400);
    grid.show();
    QSignalSpy previews(&grid, &PropertyGrid::previewed), commits(&grid, &PropertyGrid::committed);
    grid.editProperty("x");
    auto* spin = grid.viewport()->findChild<QSpinBox*>();
    ASSERT_TRUE(spin);
    QTest::keyClick(spin, Qt::Key_Up);
    QTest::keyClick(spin, Qt::Key_Escape);
    EXPECT_EQ(commits.count(), 0);
    EXPECT_EQ(previews.last()[1].toInt(), 10);
}

TEST(PropertyGrid, CheckBoxTogglesAndVariousBecomesOneValue) {
    PropertyGrid grid;
    grid.setDescriptors(someDescriptors());
    grid.setValue("on", false);
    grid.setVarious("name");
    grid.resize(320, 400);
    grid.show();
    QSignalSpy commits(&grid, &PropertyGrid::committed);
    QTest::mouseClick(grid.viewport(), Qt::LeftButton, {}, cellOf(grid, "on").center());
    ASSERT_EQ(commits.count(), 1);
    EXPECT_TRUE(commits[0][1].toBool());
    EXPECT_EQ(grid.row("name")->text(1), "various");
    QTest::mouseClick(grid.viewport(), Qt::LeftButton, {}, cellOf(grid, "name").center());
    auto* line = grid.viewport()->findChild<QLineEdit*>();
    ASSERT_TRUE(line);
    QTest::keyClicks(line, "Pump");
    QTest::keyClick(line, Qt::Key_Return);
    ASSERT_EQ(commits.count(), 2);
    EXPECT_EQ(commits[1][1].toString(), "Pump");
    EXPECT_FALSE(grid.isVarious("name"));
}

TEST(PropertyGrid, FilterKeepsTheGroupsThatHaveRows) {
    PropertyGrid grid;
    grid.setDescriptors(someDescriptors());
    grid.setFilter("fill");
    EXPECT_FALSE(grid.row("fill")->isHidden());
    EXPECT_TRUE(grid.row("x")->isHidden());
    EXPECT_TRUE(grid.row("x")->parent()->isHidden());
    grid.setFilter("");
    EXPECT_FALSE(grid.row("x")->isHidden());
}

TEST(ExpressionEdit, CompletesTheWordAtTheCursorAndKeepsTheRest) {
    ExpressionEdit edit;
    edit.setCompletionSource([](const QString& text, int cursor) {
        std::vector<Completion> result;
        const QString before = text.left(cursor);
        if (before.endsWith("pid.r")) result.push_back({"rIput", "REAL"});
        return result;
    });
    edit.setCheck([](const QString& text) { return text.contains("??") ? QString("unexpected ?") : QString(); });
    edit.resize(300, 28);
    edit.show();
    edit.setFocus();
    QTest::keyClicks(&edit, "2 * Main.pid.r");
    ASSERT_TRUE(edit.isCompletionShown());
    EXPECT_EQ(edit.shownCompletions(), QStringList{"rIput"});
    QTest::keyClick(&edit, Qt::Key_Return);
    EXPECT_EQ(edit.text(), "2 * Main.pid.rIput");
    EXPECT_TRUE(edit.complaint().isEmpty());
    QTest::keyClicks(&edit, " ??");
    EXPECT_EQ(edit.complaint(), "unexpected ?");
}

TEST(ExpressionEdit, TabTakesTheCompletionAndThenMovesOn) {
    QWidget window;
    auto* edit = new ExpressionEdit(&window);
    auto* next = new QLineEdit(&window);
    edit->setCompletionSource([](const QString& text, int cursor) {
        std::vector<Completion> result;
        if (text.left(cursor).endsWith("m1.run")) result.push_back({"running", "BOOL"});
        return result;
    });
    window.show();
    edit->setFocus();
    QTest::keyClicks(edit, "Main.m1.run");
    ASSERT_TRUE(edit->isCompletionShown());
    QTest::keyClick(edit, Qt::Key_Tab);
    EXPECT_EQ(edit->text(), "Main.m1.running");
    EXPECT_FALSE(edit->isCompletionShown());
    EXPECT_EQ(window.focusWidget(), edit);
    QTest::keyClick(edit, Qt::Key_Tab);
    EXPECT_EQ(window.focusWidget(), next);
}

TEST(ExpressionEdit, EnterOnANameThatIsCompleteEnds) {
    ExpressionEdit edit;
    edit.setCompletionSource([](const QString&, int) {
        return std::vector<Completion>{{"run", "BOOL"}, {"running", "BOOL"}};
    });
    QSignalSpy ended(&edit, &QLineEdit::returnPressed);
    edit.show();
    edit.setFocus();
    QTest::keyClicks(&edit, "run");
    ASSERT_TRUE(edit.isCompletionShown());
    QTest::keyClick(&edit, Qt::Key_Down); // on the longer one
    QTest::keyClick(&edit, Qt::Key_Return);
    EXPECT_EQ(edit.text(), "run");
    EXPECT_FALSE(edit.isCompletionShown());
    EXPECT_EQ(ended.count(), 1);
}

namespace {

class FewVariables : public VariableProvider {
public:
    std::vector<VariableNode> children(const QString& path) const override {
        if (path.isEmpty())
            return {{"Main", "Main", "Main", "", Icon::Program, true},
                    {"GVL", "GVL", "", "", Icon::Globals, true, false}};
        if (path == "Main")
            return {{"pid", "Main.pid", "FB_PID", "the loop", Icon::Block, true}, {"run", "Main.run", "BOOL", ""}};
        if (path == "Main.pid") return {{"q", "Main.pid.q", "REAL", ""}};
        if (path == "GVL") return {{"limit", "GVL.limit", "REAL", ""}};
        return {};
    }
    std::vector<VariableNode> search(const QString& text, int) const override {
        std::vector<VariableNode> result;
        for (const char* path : {"Main.pid", "Main.run", "Main.pid.q", "GVL.limit"})
            if (QString(path).contains(text, Qt::CaseInsensitive)) result.push_back({path, path, "REAL", ""});
        return result;
    }
};

} // namespace

TEST(VariablePicker, UnfoldsLazilySearchesAndPicks) {
    FewVariables provider;
    VariablePicker picker(provider);
    picker.resize(420, 300);
    picker.show();
    QSignalSpy picked(&picker, &VariablePicker::picked);
    ASSERT_TRUE(picker.selectPath("main.PID.q"));
    EXPECT_EQ(picker.selectedPaths(), QStringList{"Main.pid.q"});
    EXPECT_FALSE(picker.selectPath("Main.nothing"));
    auto* search = picker.findChild<QLineEdit*>();
    QTest::keyClicks(search, "lim");
    EXPECT_EQ(picker.selectedPaths(), QStringList{"GVL.limit"});
    QTest::keyClick(search, Qt::Key_Return);
    ASSERT_EQ(picked.count(), 1);
    EXPECT_EQ(picked[0][0].toString(), "GVL.limit");
}

TEST(VariablePicker, MimeCarriesSeveralPaths) {
    std::unique_ptr<QMimeData> mime(makeVariableMime({"Main.a", "Main.b"}));
    EXPECT_EQ(variablesOf(mime.get()), (QStringList{"Main.a", "Main.b"}));
    QMimeData text;
    text.setText("x > 5\n");
    EXPECT_EQ(variablesOf(&text), QStringList{"x > 5"});
}

TEST(Canvas, ZoomKeepsThePointUnderThePointerAndExports) {
    QGraphicsScene scene(0, 0, 4000, 3000);
    scene.addRect(100, 100, 600, 400, QPen(Qt::black), QBrush(Qt::red));
    Canvas canvas;
    canvas.setScene(&scene);
    canvas.resize(500, 400);
    canvas.show();
    canvas.centerOn(400, 300);
    const QPoint pointer(120, 90);
    const QPointF before = canvas.mapToScene(pointer);
    QWheelEvent wheel(pointer, canvas.viewport()->mapToGlobal(pointer), {}, QPoint(0, 120), Qt::NoButton,
                      Qt::ControlModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(canvas.viewport(), &wheel);
    EXPECT_NEAR(canvas.zoom(), 1.2, 1e-9);
    const QPointF after = canvas.mapToScene(pointer);
    EXPECT_NEAR(before.x(), after.x(), 1.5);
    EXPECT_NEAR(before.y(), after.y(), 1.5);

    const QImage image = canvas.picture(1);
    EXPECT_NEAR(image.width(), 617, 2);
    EXPECT_EQ(image.pixelColor(300, 200), QColor(Qt::red));
    QTemporaryDir folder;
    ASSERT_TRUE(canvas.exportSvg(folder.filePath("a.svg")));
    ASSERT_TRUE(canvas.exportPdf(folder.filePath("a.pdf")));
    QFile svg(folder.filePath("a.svg"));
    ASSERT_TRUE(svg.open(QIODevice::ReadOnly));
    EXPECT_TRUE(svg.readAll().contains("#ff0000"));
    QFile pdf(folder.filePath("a.pdf"));
    ASSERT_TRUE(pdf.open(QIODevice::ReadOnly));
    EXPECT_TRUE(pdf.readAll().startsWith("%PDF"));
}

TEST(Canvas, SnapsToTheGridOnlyWhenThereIsOne) {
    Canvas canvas;
    EXPECT_EQ(canvas.snapped({13, 17}), QPointF(13, 17));
    canvas.setGridStep(10);
    EXPECT_EQ(canvas.snapped({13, 17}), QPointF(10, 20));
}
