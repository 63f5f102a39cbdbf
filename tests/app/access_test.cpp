// Every window without a mouse and without a picture: a letter of its own for every entry of a menu, the Tab key around
// every dialog, a name and a role for the screen reader.
#include "app/translation.h"
#include "tests/app/all_windows.h"

#include <QAbstractScrollArea>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QAction>
#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QRadioButton>

#include <map>
#include <set>

namespace plc::app {
namespace {

class LetterTest : public AllWindowsTest, public ::testing::WithParamInterface<const char*> {
protected:
    void TearDown() override {
        AllWindowsTest::TearDown();
        installTranslation(*qApp, "en");
    }
};

QChar letterOf(QString text) {
    text.remove("&&");
    const qsizetype at = text.indexOf(u'&');
    return at < 0 || at + 1 >= text.size() ? QChar() : text[at + 1].toUpper();
}

bool isLatin(QChar c) { return c.isDigit() || (c.toUpper() >= u'A' && c.toUpper() <= u'Z'); }

TEST_P(LetterTest, EveryEntryOfAMenuHasItsOwn) {
    installTranslation(*qApp, GetParam());
    open();
    int seen = 0;
    const Look look = [&](QWidget& shown, const QString& name) {
        std::map<QChar, QString> taken;
        QStringList without;
        for (const QAction* action : shown.actions()) {
            if (action->isSeparator() || action->text().isEmpty()) continue;
            ++seen;
            const QChar letter = letterOf(action->text());
            if (letter.isNull())
                without << (action->isEnabled() ? action->text() : QString()); // "none yet" is no entry
            else if (const auto [other, isFirst] = taken.emplace(letter, action->text()); !isFirst)
                ADD_FAILURE() << GetParam() << ", " << name.toStdString() << ": “" << action->text().toStdString()
                              << "” and “" << other->second.toStdString() << "” have the same letter";
        }
        // More entries than letters: then all letters of those without one are taken.
        for (const QString& text : without) {
            const auto free = std::find_if(text.begin(), text.end(),
                                           [&](QChar c) { return isLatin(c) && !taken.contains(c.toUpper()); });
            EXPECT_TRUE(free == text.end()) << GetParam() << ", " << name.toStdString() << ": “" << text.toStdString()
                                            << "” could have " << QString(free, 1).toStdString();
        }
    };
    lookAtAllMenus(*window, look);
    EXPECT_GT(seen, 120);
}

INSTANTIATE_TEST_SUITE_P(Languages, LetterTest, ::testing::Values("en", "de", "da", "fr", "es", "zh_CN"));

TEST_F(AllWindowsTest, AChineseMenuHasTheLetterOfItsEnglish) {
    installTranslation(*qApp, "zh_CN");
    open();
    QString letters;
    for (const QAction* action : window->menuBar()->actions()) letters += letterOf(action->text());
    EXPECT_EQ(letters, QString("FERTVH")) << "File, Edit, Run, Time, View, Help";
    window.reset();
    installTranslation(*qApp, "en");
}

/// What the Tab key must reach: not the parts of a field, of a list or of a group of choices.
std::vector<QWidget*> tabStopsOf(QWidget& dialog) {
    std::vector<QWidget*> out;
    for (QWidget* widget : widgetsOf(dialog)) {
        if (widget == &dialog || !(widget->focusPolicy() & Qt::TabFocus) || widget->focusProxy()) continue;
        if (!widget->isVisibleTo(&dialog) || !widget->isEnabled()) continue;
        if (auto* choice = qobject_cast<QRadioButton*>(widget); choice && !choice->isChecked()) continue;
        if (qobject_cast<QComboBox*>(widget->parentWidget())) continue;
        out.push_back(widget);
    }
    return out;
}

/// Where Tab goes from the first field until it comes back, by the keyboard.
std::vector<QWidget*> visitedByTab(QWidget& dialog, size_t atMost) {
    std::vector<QWidget*> out;
    for (size_t i = 0; i < atMost; ++i) {
        QWidget* at = dialog.focusWidget();
        if (!at) at = &dialog;
        if (std::find(out.begin(), out.end(), at) == out.end()) out.push_back(at);
        QTest::keyClick(at, Qt::Key_Tab);
    }
    return out;
}

QString nameOf(const QWidget& widget) {
    return QString::fromLatin1(widget.metaObject()->className()) + " “" + widget.objectName() + "” " +
           widget.accessibleName();
}

/// Against the direction of reading, among neighbours: above, or on the same line to the left.
bool goesBack(const QWidget& from, const QWidget& to) {
    if (from.parentWidget() != to.parentWidget()) return false;
    const QRect a = from.geometry(), b = to.geometry();
    if (b.bottom() < a.top()) return b.left() <= a.right();
    return b.top() <= a.bottom() && b.right() < a.left();
}

TEST_F(AllWindowsTest, TabVisitsEveryFieldOfADialogInTheOrderOfReading) {
    open();
    size_t dialogs = 0;
    lookAtAllDialogs(*window, [&](QWidget& dialog, const QString& name) {
        ++dialogs;
        const std::vector<QWidget*> wanted = tabStopsOf(dialog);
        const std::vector<QWidget*> visited = visitedByTab(dialog, 2 * wanted.size() + 3);
        for (const QWidget* each : wanted)
            EXPECT_TRUE(std::find(visited.begin(), visited.end(), each) != visited.end())
                << name.toStdString() << ": Tab does not reach " << nameOf(*each).toStdString();
        for (size_t i = 1; i < visited.size(); ++i)
            EXPECT_FALSE(visited[i] != visited.front() && goesBack(*visited[i - 1], *visited[i]))
                << name.toStdString() << ": Tab goes back from " << nameOf(*visited[i - 1]).toStdString() << " to "
                << nameOf(*visited[i]).toStdString();
    });
    EXPECT_GT(dialogs, 15u);
}

TEST_F(AllWindowsTest, EveryPlaceThatTakesTheFocusHasANameAndARole) {
    open();
    std::map<QString, QString> nameless;
    size_t seen = 0;
    lookAtAll([&](QWidget& shown, const QString& name) {
        for (QWidget* widget : widgetsOf(shown)) {
            if (widget->focusPolicy() == Qt::NoFocus || !widget->isVisibleTo(&shown)) continue;
            QWidget* parent = widget->parentWidget();
            if (qobject_cast<QAbstractScrollArea*>(parent)) continue; // a viewport, a header
            if (qobject_cast<QAbstractSpinBox*>(parent) || qobject_cast<QComboBox*>(parent)) continue; // its field
            if (widget->isWindow()) continue;
            if (auto* label = qobject_cast<QLabel*>(widget); label && label->text().isEmpty())
                continue; // nothing to say
            ++seen;
            QAccessibleInterface* access = QAccessible::queryAccessibleInterface(widget);
            const bool isNamed =
                access && access->role() != QAccessible::NoRole && !access->text(QAccessible::Name).trimmed().isEmpty();
            if (!isNamed)
                nameless.emplace(QString::fromLatin1(widget->metaObject()->className()) + ' ' + widget->objectName() +
                                     " in " + (parent ? parent->metaObject()->className() : ""),
                                 name);
        }
    });
    for (const auto& [widget, name] : nameless)
        ADD_FAILURE() << name.toStdString() << ": " << widget.toStdString() << " has no name or role";
    EXPECT_GT(seen, 300u);
}

} // namespace
} // namespace plc::app
