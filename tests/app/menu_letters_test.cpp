// The menus without a mouse: in Chinese they have the letters that Chinese software gives them.
#include "app/translation.h"
#include "tests/app/all_windows.h"

#include <QAction>
#include <QMenuBar>

namespace plc::app {
namespace {

QChar letterOf(QString text) {
    text.remove("&&");
    const qsizetype at = text.indexOf(u'&');
    return at < 0 || at + 1 >= text.size() ? QChar() : text[at + 1].toUpper();
}

TEST_F(AllWindowsTest, AChineseMenuHasTheLetterOfItsEnglish) {
    installTranslation(*qApp, "zh_CN");
    open();
    QString letters;
    for (const QAction* action : window->menuBar()->actions()) letters += letterOf(action->text());
    for (const QChar wanted : QString("FERTVH")) // File, Edit, Run, Time, View, Help
        EXPECT_TRUE(letters.contains(wanted)) << letters.toStdString();
    window.reset();
    installTranslation(*qApp, "en");
}

} // namespace
} // namespace plc::app
