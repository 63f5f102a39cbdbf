// Operating a panel with real mouse events: what is asked for, in which order, and what is repainted.
#include "hmi/model/array_index.h"
#include "hmi/view/panel_view.h"
#include "tests/support/settle.h"

#include <QSignalSpy>
#include <QTest>
#include <gtest/gtest.h>

namespace plc::hmi {
namespace {

/// A shown panel view with values and a log of its requests.
struct Desk {
    HeldValues values;
    TextCatalog texts;
    PanelView view;
    QStringList log;

    explicit Desk(const std::string& elements) {
        LanguageSettings settings;
        settings.languages = QStringList{"en", "de"};
        texts = TextCatalog(
            *TextTable::parse("key,comment,en,de\nMode.0,,Off,Aus\nMode.1,,Manual,Hand\nMode.2,,Automatic,Automatik\n",
                              QString()),
            settings);
        Result<Panel> panel =
            Panel::parse("{\"size\": [640, 400], \"elements\": [" + elements + "]}", QStringLiteral("p"));
        EXPECT_TRUE(panel) << panel.error().english();
        view.scene().setTexts(&texts);
        view.scene().setValues(&values);
        view.scene().setPanel(*panel);
        QObject::connect(&view.scene(), &PanelScene::writeRequested, &view, [this](const WriteRequest& write) {
            const char* const kinds[] = {"write", "press", "release"};
            log += QStringLiteral("%1 %2 %3")
                       .arg(QLatin1String(kinds[static_cast<int>(write.kind)]), write.target, write.value.toLiteral());
        });
        QObject::connect(&view.scene(), &PanelScene::confirmRequested, &view,
                         [this](const ConfirmRequest& confirm) { log += u'?' + confirm.question; });
        QObject::connect(&view.scene(), &PanelScene::entryRequested, &view, [this](const EntryRequest& entry) {
            log += QStringLiteral("entry %1 %2..%3 %4")
                       .arg(entry.target)
                       .arg(entry.minimum.value_or(-1))
                       .arg(entry.maximum.value_or(-1))
                       .arg(entry.unit);
        });
        QObject::connect(&view.scene(), &PanelScene::choiceRequested, &view, [this](const ChoiceRequest& choice) {
            log += QStringLiteral("choice ") + choice.texts.join(u'|');
        });
        QObject::connect(&view.scene(), &PanelScene::panelRequested, &view,
                         [this](const QString& name) { log += QStringLiteral("panel ") + name; });
        QObject::connect(&view.scene(), &PanelScene::languageRequested, &view,
                         [this](const QString& tag) { log += QStringLiteral("language ") + tag; });
        view.resize(640, 400);
        view.show();
        view.frame();
        settle();
    }
    void click(int x, int y) { QTest::mouseClick(&view, Qt::LeftButton, {}, QPoint(x, y)); }
    std::string said() {
        const std::string out = log.join(QStringLiteral("; ")).toStdString();
        log.clear();
        return out;
    }
};

TEST(Operation, AMomentaryButtonPressesAndReleasesAlsoWhenTheFingerSlipsOff) {
    Desk desk(R"({"id":"b","kind":"button","rect":[10,10,100,50],"text":"","target":"Main.start"})");
    QTest::mousePress(&desk.view, Qt::LeftButton, {}, QPoint(50, 30));
    EXPECT_EQ(desk.said(), "press Main.start TRUE");
    QTest::mouseMove(&desk.view, QPoint(400, 300));
    QTest::mouseRelease(&desk.view, Qt::LeftButton, {}, QPoint(400, 300));
    EXPECT_EQ(desk.said(), "release Main.start FALSE");
    QTest::mousePress(&desk.view, Qt::LeftButton, {}, QPoint(50, 30));
    desk.view.hide();
    EXPECT_EQ(desk.said(), "press Main.start TRUE; release Main.start FALSE");
}

TEST(Operation, AHeldButtonComesUpWhenItsPanelGoesAway) {
    Desk desk(R"({"id":"b","kind":"button","rect":[10,10,100,50],"text":"","target":"Main.start"})");
    QTest::mousePress(&desk.view, Qt::LeftButton, {}, QPoint(50, 30));
    desk.view.scene().setPanel(Panel());
    EXPECT_EQ(desk.said(), "press Main.start TRUE; release Main.start FALSE");
}

TEST(Operation, EachActionOfAButton) {
    const struct {
        const char *properties, *expected;
    } rows[] = {
        {R"("action":"toggle","target":"A.x")", "write A.x FALSE"},
        {R"("action":"set","target":"A.x")", "write A.x TRUE"},
        {R"("action":"reset","target":"A.x")", "write A.x FALSE"},
        {R"("action":"write","target":"A.n","write":"7")", "write A.n 7"},
        {R"("action":"panel","panel":"two")", "panel two"},
        {R"("action":"language","tag":"de")", "language de"},
        {R"("action":"set","target":"A.x","confirm":"Really?")", "?Really?"},
        {R"("action":"set","target":"A.x","enabled":"A.off")", ""},
        {R"("action":"set","target":"A.x","visible":"A.off")", ""},
    };
    for (const auto& row : rows) {
        Desk desk(std::string(R"({"id":"b","kind":"button","rect":[10,10,100,50],"text":"",)") + row.properties + "}");
        desk.values.set(QStringLiteral("A.x"), Value::ofBool(true));
        desk.values.set(QStringLiteral("A.off"), Value::ofBool(false));
        desk.view.frame();
        desk.click(50, 30);
        EXPECT_EQ(desk.said(), row.expected) << row.properties;
    }
}

TEST(Operation, SelectorsWriteTheChosenValue) {
    Desk desk(R"({"id":"s","kind":"switch","rect":[0,0,100,50],"target":"S"},
                 {"id":"c","kind":"checkbox","rect":[0,60,160,44],"target":"C"},
                 {"id":"r","kind":"radio","rect":[0,120,160,132],"target":"M","list":"Mode"},
                 {"id":"d","kind":"combo","rect":[200,0,180,44],"target":"M","list":"Mode"},
                 {"id":"o","kind":"rotary","rect":[200,100,160,140],"target":"M","options":[{"value":"10","text":"a"},{"value":"20","text":"b"}]},
                 {"id":"l","kind":"languages","rect":[400,0,200,44]},
                 {"id":"n","kind":"numberEntry","rect":[400,100,140,44],"target":"N","minimum":"2","maximum":"8","unit":"bar"})");
    for (const char* name : {"S", "C"}) desk.values.set(QLatin1String(name), Value::ofBool(false));
    desk.values.set(QStringLiteral("M"), Value::ofInteger(1));
    desk.values.set(QStringLiteral("N"), Value::ofReal(3));
    desk.view.frame();
    desk.click(50, 25);
    EXPECT_EQ(desk.said(), "write S TRUE");
    desk.click(20, 82);
    EXPECT_EQ(desk.said(), "write C TRUE");
    desk.click(20, 230);
    EXPECT_EQ(desk.said(), "write M 2");
    desk.click(290, 20);
    EXPECT_EQ(desk.said(), "choice Off|Manual|Automatic");
    desk.click(330, 160);
    EXPECT_EQ(desk.said(), "write M 20");
    desk.click(550, 20);
    EXPECT_EQ(desk.said(), "language de");
    desk.click(470, 120);
    EXPECT_EQ(desk.said(), "entry N 2..8 bar");
}

TEST(Operation, ASliderWritesStepsAndAlwaysTheLastValue) {
    Desk desk(R"({"id":"s","kind":"slider","rect":[0,0,232,56],"target":"V","step":10})");
    desk.values.set(QStringLiteral("V"), Value::ofInteger(0));
    desk.view.frame();
    QTest::mousePress(&desk.view, Qt::LeftButton, {}, QPoint(116, 40));
    for (int x = 116; x <= 216; x += 10) QTest::mouseMove(&desk.view, QPoint(x, 40));
    QTest::mouseRelease(&desk.view, Qt::LeftButton, {}, QPoint(216, 40));
    const QStringList log = desk.log;
    ASSERT_GE(log.size(), 2);
    EXPECT_EQ(log.front().toStdString(), "write V 50");
    EXPECT_EQ(log.back().toStdString(), "write V 100");
}

TEST(Operation, TheCellGridAndTheTableWriteTheirElements) {
    Desk desk(
        R"({"id":"g","kind":"cellGrid","rect":[0,0,200,100],"rows":2,"columns":2,"value":"G","action":"toggle","target":"G[#]"},
                 {"id":"t","kind":"table","rect":[0,150,300,200],"count":50,"columns":[{"title":"a","value":"R[#].v"},{"title":"b","value":"R[#].on"}]})");
    desk.values.set(QStringLiteral("G"), Value::ofArray({Value::ofBool(false), Value::ofBool(false),
                                                         Value::ofBool(true), Value::ofBool(false)}));
    desk.values.set(QStringLiteral("R[3].on"), Value::ofBool(false));
    desk.view.frame();
    desk.click(50, 75);
    EXPECT_EQ(desk.said(), "write G[3] FALSE");
    desk.click(80, 150 + 29 + 44 * 2 + 10);
    EXPECT_EQ(desk.said(), "entry R[3].v -1..-1 ");
    desk.click(250, 150 + 29 + 44 * 2 + 10);
    EXPECT_EQ(desk.said(), "write R[3].on TRUE");
    QTest::mousePress(&desk.view, Qt::LeftButton, {}, QPoint(80, 300));
    QTest::mouseMove(&desk.view, QPoint(80, 180));
    QTest::mouseRelease(&desk.view, Qt::LeftButton, {}, QPoint(80, 180));
    EXPECT_EQ(desk.said(), ""); // a drag scrolls
    desk.click(80, 150 + 29 + 10);
    EXPECT_EQ(desk.said(), "entry R[3].v -1..-1 ");
}

TEST(Operation, AnIndexIsPutInOnlyWhereItStandsForOne) {
    const struct {
        const char *expression, *expected;
    } rows[] = {
        {"G[#]", "G[7]"},
        {"G[ # ].v", "G[ 7 ].v"},
        {"G[#r, #c]", "G[2, 3]"},
        {"G[#-1]", "G[7-1]"},
        {"G[2 * #r + #c]", "G[2 * 2 + 3]"},
        {"T > T#10s", "T > T#10s"},
        {"16#FF", "16#FF"},
        {"x = INT#5", "x = INT#5"},
        {"G[16#0F]", "G[16#0F]"},
        {"G[Index#red]", "G[Index#red]"},
        {"#local", "#local"},
        {"G[#row].v", "G[#row].v"},
        {"s = 'a[#]'", "s = 'a[#]'"},
        {"G[#] = T#1s", "G[7] = T#1s"},
        {"G[H[#]].v > DINT#3", "G[H[7]].v > DINT#3"},
        {"M = Mode#running", "M = Mode#running"},
        {"M = Mode#closed", "M = Mode#closed"},
    };
    for (const auto& row : rows)
        EXPECT_EQ(withIndex(QLatin1String(row.expression), 7, 2, 3).toStdString(), row.expected);
}

TEST(Frames, OnlyWhatChangedIsPaintedAndNothingWhenNothingChanged) {
    Desk desk(
        R"({"id":"a","kind":"lamp","rect":[10,10,50,50],"value":"A"},{"id":"b","kind":"number","rect":[300,300,100,40],"value":"B","format":"%.0f"})");
    desk.values.set(QStringLiteral("A"), Value::ofBool(false));
    desk.values.set(QStringLiteral("B"), Value::ofReal(5));
    desk.view.frame();
    EXPECT_TRUE(desk.view.frame().isEmpty());
    desk.values.set(QStringLiteral("A"), Value::ofBool(true));
    const QRegion changed = desk.view.frame();
    EXPECT_TRUE(changed.contains(QPoint(35, 35)));
    EXPECT_FALSE(changed.intersects(QRect(300, 300, 100, 40)));
    desk.values.set(QStringLiteral("B"), Value::ofReal(5.2)); // shown without digits: the same
    EXPECT_TRUE(desk.view.frame().isEmpty());
    for (int i = 0; i < 20; ++i) desk.values.set(QStringLiteral("B"), Value::ofReal(i));
    EXPECT_FALSE(desk.view.frame().isEmpty()); // twenty changes, one repaint
    EXPECT_TRUE(desk.view.frame().isEmpty());
}

TEST(Language, ASelectorBeginsWhereReadingBegins) {
    Desk desk(R"({"id":"l","kind":"languages","rect":[0,0,200,44]})");
    desk.click(50, 20);
    EXPECT_EQ(desk.said(), "language en");
    desk.view.scene().setLanguage(QStringLiteral("ar"));
    desk.view.frame();
    desk.click(50, 20);
    EXPECT_EQ(desk.said(), "language de");
}

TEST(Language, SwitchesAtOnceEveryTextOfThePanel) {
    Desk desk(
        R"({"id":"d","kind":"combo","rect":[0,0,180,44],"target":"M","list":"Mode"},{"id":"f","kind":"combo","rect":[0,100,180,44],"target":"M","list":"Mode","language":"en"})");
    desk.values.set(QStringLiteral("M"), Value::ofInteger(1));
    const QImage english = desk.view.scene().picture();
    desk.view.scene().setLanguage(QStringLiteral("de"));
    const QImage german = desk.view.scene().picture();
    EXPECT_NE(english.copy(0, 0, 180, 44), german.copy(0, 0, 180, 44));
    EXPECT_EQ(english.copy(0, 100, 180, 44), german.copy(0, 100, 180, 44)); // its language is fixed
}

} // namespace
} // namespace plc::hmi
