// A panel operated with keys alone, on a running controller: from element to element, pressed, turned, left again.
#include "running.h"

#include "hmi/view/panel_keys.h"
#include "tests/support/settle.h"

#include <QApplication>
#include <QLineEdit>

namespace plc::hmi {
namespace {

struct Desk {
    PanelProject project = machineProject();
    session::Session session{builtMachine()};
    QWidget window; // with a field before and behind the panel
    QLineEdit before{&window};
    std::unique_ptr<PanelPlayer> player;
    QLineEdit behind{&window};
    PanelKeys* keys = nullptr;

    explicit Desk(const std::string& elements) {
        project.panels.push_back({QStringLiteral("main"), panelOf(elements)});
        project.startPanel = QStringLiteral("main");
        player = std::make_unique<PanelPlayer>(project, &session, &window);
        player->setGeometry(0, 40, 640, 400);
        behind.move(0, 450);
        QWidget::setTabOrder(&before, player.get());
        QWidget::setTabOrder(&player->view(), &behind);
        window.resize(640, 500);
        window.show();
        QApplication::setActiveWindow(&window);
        session.startThread({session::Pace::Factor, 5});
        keys = static_cast<PanelKeys*>(player->view().findChild<QObject*>("panelKeys"));
        before.setFocus();
    }
    void press(int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        QTest::keyClick(QApplication::focusWidget(), static_cast<Qt::Key>(key), modifiers);
    }
    /// Until the panel has the focus: the player itself has it first.
    void tabIntoPanel() {
        for (int i = 0; i < 3 && !player->view().hasFocus(); ++i) press(Qt::Key_Tab);
        ASSERT_TRUE(player->view().hasFocus());
    }
    [[nodiscard]] QString focused() const { return keys->focused() ? keys->focused()->element().id() : QString(); }
    bool waitFor(const char* expression) {
        const BindingId id = player->values()->bind(QString::fromUtf8(expression));
        return hmi::waitFor(*player, [&] { return player->values()->value(id).toBool(); });
    }
};

constexpr char kElements[] =
    R"({"id":"right","kind":"button","rect":[200,12,120,60],"text":"Stop","target":"Main.stop"},
    {"id":"left","kind":"button","rect":[10,10,120,60],"text":"Start","target":"Main.start"},
    {"id":"lamp","kind":"lamp","rect":[400,10,60,60],"value":"Main.running"},
    {"id":"slider","kind":"slider","rect":[10,120,300,60],"target":"Main.level","min":0,"max":100})";

TEST(PanelKeys, TabGoesFromElementToElementAndOutAgain) {
    Desk desk(kElements);
    ASSERT_TRUE(desk.waitFor("Main.count > 2"));
    desk.tabIntoPanel();
    EXPECT_EQ(desk.focused(), "left") << "in the order of reading, not of drawing";
    desk.press(Qt::Key_Tab);
    EXPECT_EQ(desk.focused(), "right");
    desk.press(Qt::Key_Tab);
    EXPECT_EQ(desk.focused(), "slider") << "a lamp does not react";
    desk.press(Qt::Key_Backtab, Qt::ShiftModifier);
    EXPECT_EQ(desk.focused(), "right");
    desk.press(Qt::Key_Tab);
    desk.press(Qt::Key_Tab);
    EXPECT_FALSE(desk.player->view().hasFocus()) << "behind the last one the panel is left";
    EXPECT_TRUE(desk.behind.hasFocus());
}

TEST(PanelKeys, SpacePressesAsLongAsItIsHeld) {
    Desk desk(kElements);
    ASSERT_TRUE(desk.waitFor("Main.count > 2"));
    desk.tabIntoPanel();
    QTest::keyPress(&desk.player->view(), Qt::Key_Space);
    EXPECT_TRUE(desk.waitFor("Main.start AND Main.presses = 1"));
    QTest::keyRelease(&desk.player->view(), Qt::Key_Space);
    EXPECT_TRUE(desk.waitFor("Main.running AND NOT Main.start"));
    desk.press(Qt::Key_Return);
    EXPECT_TRUE(desk.waitFor("Main.presses = 2"));
    // With the focus the press ends as well.
    QTest::keyPress(&desk.player->view(), Qt::Key_Space);
    ASSERT_TRUE(desk.waitFor("Main.start"));
    desk.behind.setFocus();
    EXPECT_TRUE(desk.waitFor("NOT Main.start"));
}

TEST(PanelKeys, ArrowsTurnASlider) {
    Desk desk(kElements);
    ASSERT_TRUE(desk.waitFor("Main.count > 2 AND Main.level = 12.5"));
    desk.tabIntoPanel();
    desk.press(Qt::Key_Tab);
    desk.press(Qt::Key_Tab);
    ASSERT_EQ(desk.focused(), "slider");
    desk.press(Qt::Key_Up);
    EXPECT_TRUE(desk.waitFor("Main.level = 13.5")) << "a hundredth of the range";
    desk.press(Qt::Key_Left);
    EXPECT_TRUE(desk.waitFor("Main.level = 12.5"));
    desk.press(Qt::Key_PageUp);
    EXPECT_TRUE(desk.waitFor("Main.level = 22.5"));
    const QPointF middle = desk.keys->place();
    desk.press(Qt::Key_Right, Qt::ControlModifier);
    EXPECT_GT(desk.keys->place().x(), middle.x()) << "where it is pressed";
    for (int i = 0; i < 60; ++i) desk.press(Qt::Key_Right, Qt::ControlModifier);
    EXPECT_LT(desk.keys->place().x(), 310) << "but inside of it";
}

} // namespace
} // namespace plc::hmi
