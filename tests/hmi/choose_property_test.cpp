// Choosing from a list in the property sheet, as somebody does with the mouse: one click opens it, it stays open on the
// way to the choice whatever is previewed, and leaving it changes nothing.
#include "design_studio.h"
#include "hmi/designer/context/applicable.h"
#include "hmi/designer/panel_designer.h"

#include "tests/support/patience.h"
#include "tests/support/settle.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QPointer>
#include <QTreeWidget>
#include <QWindow>

namespace plc::hmi {
namespace {

constexpr const char* kButton = R"({"id":"b","kind":"button","rect":[100,100,128,56]})";

QString actionOf(Studio& studio) { return studio.panel().find(QStringLiteral("b"))->text("action"); }

/// The list of `id` in the sheet, open.
QComboBox* openList(Studio& studio, const QString& id) {
    studio.designer->selection().set({QStringLiteral("b")});
    kit::PropertyGrid& grid = studio.designer->sheet().grid();
    grid.editProperty(id);
    auto* list = grid.viewport()->findChild<QComboBox*>();
    return list && QTest::qWaitFor([&] { return list->view()->isVisible(); }, kPatience) ? list : nullptr;
}

TEST(ChooseProperty, AButtonThatOpensAPanelAsksForThePanelAndItsArguments) {
    Studio studio(kButton);
    studio.designer->selection().set({QStringLiteral("b")});
    kit::PropertyGrid& grid = studio.designer->sheet().grid();
    for (const auto& [action, opens] :
         {std::pair("panel", true), std::pair("popup", true), std::pair("close", false)}) {
        studio.designer->sheet().commit(QStringLiteral("action"), QString::fromLatin1(action));
        EXPECT_EQ(grid.descriptor(QStringLiteral("panel")) != nullptr, opens) << action;
        EXPECT_EQ(isApplicable(*studio.panel().find(QStringLiteral("b")), "arguments"), opens) << action;
    }
}

TEST(ChooseProperty, TheListStaysOpenOnTheWayToTheLastChoice) {
    Studio studio(kButton);
    settle();
    QPointer<QComboBox> list = openList(studio, QStringLiteral("action"));
    ASSERT_TRUE(list);
    const int last = list->count() - 1;
    for (int i = 1; i <= last; ++i) {
        QTest::keyClick(list->view(), Qt::Key_Down);
        settle();
        ASSERT_TRUE(list && list->view()->isVisible()) << "closed at choice " << i;
    }
    const QString chosen = list->itemData(last).toString();
    QTest::keyClick(list->view(), Qt::Key_Return);
    settle();
    EXPECT_EQ(actionOf(studio), chosen);
    EXPECT_EQ(studio.designer->document().undoStack().count(), 1);
    EXPECT_TRUE(studio.designer->sheet().grid().descriptor(QStringLiteral("theme"))) << "the row of the last action";
    EXPECT_GE(studio.designer->sheet().grid().descriptor(QStringLiteral("theme"))->choices.size(), 4u)
        << "none and the built-in themes";
    studio.designer->document().undoStack().undo();
    EXPECT_EQ(actionOf(studio).toStdString(), "momentary") << "one step";
}

TEST(ChooseProperty, LeavingTheListChangesNothingAndIsNoStep) {
    Studio studio(kButton);
    settle();
    const std::string before = studio.panel().write();
    for (const char* id : {"action", "icon", "color"}) {
        QPointer<QComboBox> list = openList(studio, QString::fromLatin1(id));
        ASSERT_TRUE(list) << id;
        QTest::keyClick(list->view(), Qt::Key_Down);
        QTest::keyClick(list->view(), Qt::Key_Down);
        EXPECT_NE(studio.panel().write(), before) << id << " is previewed";
        QTest::keyClick(list->view(), Qt::Key_Escape);
        EXPECT_TRUE(QTest::qWaitFor([&] { return !list; }, kPatience)) << id << ": nothing is left in the cell";
        EXPECT_EQ(studio.panel().write(), before) << id;
        EXPECT_TRUE(studio.designer->document().isClean()) << id;
        EXPECT_EQ(studio.designer->document().undoStack().count(), 0) << id;
    }
}

TEST(ChooseProperty, EscapeInANumberIsNoStepEither) {
    Studio studio(kButton);
    settle();
    studio.designer->selection().set({QStringLiteral("b")});
    kit::PropertyGrid& grid = studio.designer->sheet().grid();
    grid.editProperty(QStringLiteral("rect.x"));
    auto* spin = grid.viewport()->findChild<QDoubleSpinBox*>();
    ASSERT_TRUE(spin);
    QTest::keyClick(spin, Qt::Key_Up);
    QTest::keyClick(spin, Qt::Key_Escape);
    settle();
    EXPECT_EQ(studio.panel().find(QStringLiteral("b"))->rect().x(), 100);
    EXPECT_EQ(studio.designer->document().undoStack().count(), 0);
}

TEST(ChooseProperty, OneClickOpensTheListAndEveryChoiceIsReadable) {
    Studio studio(kButton);
    studio.designer->selection().set({QStringLiteral("b")});
    settle();
    kit::PropertyGrid& grid = studio.designer->sheet().grid();
    grid.scrollToItem(grid.row(QStringLiteral("action")));
    const QRect row = grid.visualItemRect(grid.row(QStringLiteral("action")));
    const QPoint global = grid.viewport()->mapToGlobal(QPoint(grid.columnViewportPosition(1) + 20, row.center().y()));
    QWindow* window = grid.window()->windowHandle();
    QTest::mousePress(window, Qt::LeftButton, {}, window->mapFromGlobal(global));
    QPointer<QComboBox> list;
    ASSERT_TRUE(QTest::qWaitFor(
        [&] {
            list = grid.viewport()->findChild<QComboBox*>();
            return list && list->view()->isVisible();
        },
        kPatience));
    QWindow* popup = list->view()->window()->windowHandle();
    QTest::mouseRelease(popup, Qt::LeftButton, {}, popup->mapFromGlobal(global));
    settle();
    ASSERT_TRUE(list);
    EXPECT_TRUE(list->view()->isVisible()) << "the release of the same click leaves it open";
    for (int i = 0; i < list->count(); ++i)
        EXPECT_GE(list->view()->viewport()->width(), list->view()->fontMetrics().horizontalAdvance(list->itemText(i)))
            << list->itemText(i).toStdString();
    list->hidePopup();
}

TEST(ChooseProperty, AnExpressionIsKeptWhenTheNextRowIsClicked) {
    Studio studio(R"({"id":"b","kind":"lamp","rect":[100,100,60,60]})");
    studio.designer->selection().set({QStringLiteral("b")});
    settle();
    kit::PropertyGrid& grid = studio.designer->sheet().grid();
    grid.setPicker([](const QString&) { return std::nullopt; }); // its button stands beside the line
    const auto click = [&](const char* id) {
        QTreeWidgetItem* item = grid.row(QString::fromLatin1(id));
        grid.scrollToItem(item);
        const QPoint cell(grid.columnViewportPosition(1) + 20, grid.visualItemRect(item).center().y());
        QTest::mouseClick(grid.viewport(), Qt::LeftButton, {}, cell);
        settle();
    };
    click("value");
    ASSERT_TRUE(qobject_cast<QLineEdit*>(QApplication::focusWidget()));
    QTest::keyClicks(QApplication::focusWidget(), "Main.Run");
    if (QWidget* words = QApplication::activePopupWidget()) words->hide();
    click("visible");
    EXPECT_EQ(studio.panel().find(QStringLiteral("b"))->text("value").toStdString(), "Main.Run");
    auto* next = qobject_cast<QLineEdit*>(QApplication::focusWidget());
    ASSERT_TRUE(next) << "the clicked row is edited";
    QTest::keyClicks(next, "TRUE");
    if (QWidget* words = QApplication::activePopupWidget()) words->hide();
    studio.designer->canvas().setFocus(); // as a click on the drawing does
    settle();
    EXPECT_EQ(studio.panel().find(QStringLiteral("b"))->text("visible").toStdString(), "TRUE");
    EXPECT_EQ(studio.panel().find(QStringLiteral("b"))->text("value").toStdString(), "Main.Run");
    EXPECT_EQ(grid.viewport()->findChildren<QLineEdit*>().size(), 0) << "no line stays open";
}

} // namespace
} // namespace plc::hmi
