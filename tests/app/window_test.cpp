// The window itself: names for those who do not see it, shortcuts that clash, speed, docks, the palette over
// everything.
#include "app/settings/settings_dialog.h"
#include "editor/kit/command_palette.h"
#include "editor/kit/inputs/text_question.h"
#include "editor/kit/theme.h"
#include "tests/app/studio_fixture.h"
#include "tests/support/answer.h"
#include "tests/support/patience.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QInputDialog>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QStatusBar>
#include <QTableWidget>
#include <QTimer>
#include <QToolBar>

namespace plc::app {
namespace {

/// Widgets that take input and have nothing to be called by.
QStringList nameless(QWidget& window) {
    QStringList out;
    for (QWidget* each : window.findChildren<QWidget*>()) {
        const bool isInner =
            qobject_cast<QComboBox*>(each->parentWidget()) || qobject_cast<QAbstractSpinBox*>(each->parentWidget()) ||
            qobject_cast<QKeySequenceEdit*>(each->parentWidget()) || qobject_cast<QLineEdit*>(each->parentWidget()) ||
            each->objectName().startsWith("qt_") || each->inherits("QComboBoxListView") ||
            each->inherits("QHeaderView") || each->inherits("QTableCornerButton") ||
            each->inherits("QDockWidgetTitleButton") || each->inherits("QMenuBarExtension");
        const bool isInteractive = qobject_cast<QAbstractButton*>(each) || qobject_cast<QLineEdit*>(each) ||
                                   qobject_cast<QComboBox*>(each) || qobject_cast<QAbstractItemView*>(each) ||
                                   qobject_cast<QAbstractSpinBox*>(each);
        if (isInner || !isInteractive || each->focusPolicy() == Qt::NoFocus) {
            if (!qobject_cast<QAbstractButton*>(each) || isInner) continue;
        }
        QAccessibleInterface* spoken = QAccessible::queryAccessibleInterface(each);
        if (spoken && !spoken->text(QAccessible::Name).trimmed().isEmpty()) continue;
        if (!each->toolTip().isEmpty()) continue;
        QString where;
        for (QWidget* at = each; at && at != &window; at = at->parentWidget())
            where = QString(at->metaObject()->className()) +
                    (at->objectName().isEmpty() ? "" : "#" + at->objectName()) + " > " + where;
        out << where;
    }
    return out;
}

TEST_F(StudioTest, EverythingThatTakesInputHasANameToBeSpoken) {
    for (QDockWidget* dock : window->findChildren<QDockWidget*>()) window->showDock(dock->objectName());
    EXPECT_EQ(nameless(*window).join("\n").toStdString(), "");
    SettingsDialog settings(window->settings(), window->allActions(), defaultShortcuts(), window.get());
    settings.show();
    EXPECT_EQ(nameless(settings).join("\n").toStdString(), "");
}

TEST_F(StudioTest, AShortcutThatClashesIsTakenFromTheOtherAction) {
    QAction* build = window->action("run.build");
    QAction* step = window->action("run.stepOver");
    const QKeySequence keys = step->shortcut();
    {
        SettingsDialog dialog(window->settings(), window->allActions(), defaultShortcuts(), window.get());
        dialog.show();
        auto* table = dialog.findChild<QTableWidget*>();
        const auto edit = [&](QAction* action) {
            return static_cast<QKeySequenceEdit*>(
                table->cellWidget(static_cast<int>(window->allActions().indexOf(action)), 1));
        };
        edit(build)->setKeySequence(keys);
        bool isTold = false;
        for (QLabel* each : dialog.findChildren<QLabel*>()) isTold |= each->text().contains(step->text());
        EXPECT_TRUE(isTold);
        dialog.accept();
    }
    EXPECT_EQ(build->shortcut(), keys);
    EXPECT_TRUE(step->shortcut().isEmpty()) << "two with one shortcut would both be dead";
    EXPECT_TRUE(build->toolTip().contains(keys.toString(QKeySequence::NativeText))) << "the tip says the new one";
    MainWindow again;
    EXPECT_EQ(again.action("run.build")->shortcut(), keys) << "kept";
    EXPECT_TRUE(again.action("run.stepOver")->shortcut().isEmpty());
    {
        SettingsDialog dialog(window->settings(), window->allActions(), defaultShortcuts(), window.get());
        for (QAbstractButton* each : dialog.findChildren<QAbstractButton*>())
            if (each->text() == "Restore Defaults") each->click();
        dialog.accept();
    }
    EXPECT_EQ(step->shortcut(), keys);
    EXPECT_EQ(build->shortcut(), QKeySequence(Qt::Key_F11));
}

TEST_F(StudioTest, AnySpeedCanBeTypedAndTheStatusLineSaysIt) {
    const auto choose = [&](const QString& typed) {
        typeIntoNext(window.get(), typed);
        window->action("run.speed")->trigger();
    };
    choose("2,5 x");
    EXPECT_EQ(window->control().mode().factor, 2.5) << "comma and letter as they are typed";
    choose("7.25");
    EXPECT_EQ(window->control().mode().pace, session::Pace::Factor);
    EXPECT_EQ(window->control().mode().factor, 7.25);
    window->action("run.start")->trigger();
    const auto shows = [&](const QString& text) {
        for (QLabel* each : window->findChildren<QLabel*>())
            if (each->isVisible() && each->text().contains(text)) return true;
        return false;
    };
    EXPECT_TRUE(waitFor([&] { return shows("7.25 ×"); }));
    inNext<kit::TextQuestion>(window.get(), [](kit::TextQuestion& question) {
        question.setTextValue("nonsense");
        question.accept();
        EXPECT_TRUE(question.isVisible());
        EXPECT_EQ(question.complaint(), "The speed is a factor from 0.001 to 10000");
        question.reject();
    });
    window->action("run.speed")->trigger();
    EXPECT_EQ(window->control().mode().factor, 7.25);
}

TEST_F(StudioTest, FoldsStayAsTheyAreWhenTheColoursChange) {
    using S = QsciScintillaBase;
    const auto isHeader = [&] {
        return (editor().SendScintilla(S::SCI_GETFOLDLEVEL, 1ul) & S::SC_FOLDLEVELHEADERFLAG) != 0; // of VAR
    };
    ASSERT_TRUE(waitFor(isHeader));
    editor().foldLine(1);
    ASSERT_EQ(editor().contractedFolds(), QList<int>{1});
    for (const kit::ThemeChoice choice : {kit::ThemeChoice::Dark, kit::ThemeChoice::Light}) {
        kit::Theme::current().setChoice(choice);
        EXPECT_TRUE(isHeader());
        EXPECT_EQ(editor().contractedFolds(), QList<int>{1});
    }
}

TEST_F(StudioTest, ASpeedIsTypedAndTakenByOneEnter) {
    bool isClosed = false;
    QTimer::singleShot(0, [&isClosed] {
        QPointer<QWidget> dialog;
        ASSERT_TRUE(QTest::qWaitFor(
            [&dialog] {
                dialog = QApplication::activeModalWidget();
                return dialog && dialog->isAncestorOf(QApplication::focusWidget());
            },
            kPatience));
        for (const char key : {'0', '.', '5'})
            QTest::keyClick(QApplication::focusWidget(), key); // the first letters of "0.5 ×"
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
        isClosed = !dialog || !dialog->isVisible();
        if (!isClosed) static_cast<QDialog*>(dialog.data())->reject();
    });
    window->action("run.speed")->trigger();
    EXPECT_TRUE(isClosed);
    EXPECT_EQ(window->control().mode().factor, 0.5);
}

TEST_F(StudioTest, AMessageThatDoesNotFitIntoTheStatusLineIsReadAboveIt) {
    const auto shown = [&] {
        const auto* whole = window->findChild<QLabel*>("longMessage");
        return whole && whole->isVisible() ? whole->text() : QString();
    };
    window->say("Short");
    EXPECT_EQ(shown(), "");
    const QString why = QString("The file %1 cannot be written: the disk is full; free some space and try again")
                            .arg(QString("long/").repeated(30));
    window->say(why, true);
    EXPECT_EQ(shown(), why);
    const auto* whole = window->findChild<QLabel*>("longMessage");
    EXPECT_TRUE(window->rect().contains(whole->geometry()));
    EXPECT_GE(whole->height(), whole->heightForWidth(whole->width())) << "all of it";
    EXPECT_LT(whole->geometry().bottom(), window->statusBar()->geometry().top());
    QTest::mouseClick(const_cast<QLabel*>(whole), Qt::LeftButton);
    EXPECT_EQ(shown(), "") << "a click closes it";
    window->say(why, true);
    EXPECT_EQ(shown(), why);
    window->say("Saved");
    EXPECT_EQ(shown(), "") << "another message takes its place";
}

TEST_F(StudioTest, ThePaletteOffersEveryAction) {
    window->openPalette();
    auto* palette = window->findChild<kit::CommandPalette*>();
    const QStringList shown = palette->shownTexts();
    for (QAction* action : window->allActions()) {
        QString text = action->text();
        text.remove(QChar(0x2026));
        text.remove('&');
        bool isThere = false;
        for (const QString& each : shown) isThere |= each.endsWith(text.trimmed());
        EXPECT_TRUE(isThere) << text.toStdString();
    }
}

TEST_F(StudioTest, DocksFloatCloseAndComeBackWithTheReset) {
    QDockWidget* watch = window->dock("watch");
    watch->setFloating(true);
    window->dock("log")->close();
    window->dock("project")->hide();
    EXPECT_TRUE(watch->isFloating());
    window->action("view.reset")->trigger();
    for (QDockWidget* each : window->findChildren<QDockWidget*>()) {
        EXPECT_FALSE(each->isFloating()) << each->objectName().toStdString();
        EXPECT_FALSE(each->isHidden()) << each->objectName().toStdString();
    }
}

} // namespace
} // namespace plc::app
