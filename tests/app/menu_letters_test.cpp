// Every window without a mouse and without a picture: a letter of its own for every entry of a menu, a name and a role
// for the screen reader.
#include "app/settings/translation.h"
#include "tests/app/all_windows.h"

#include <QAbstractScrollArea>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>

#include <map>

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
