// Several panels as one application: frame, navigation, pop-ups with parameters, sizes that adapt; people who log in,
// are refused, allowed, and leave a trail; recipes; alarms set aside. With real events on a running controller.
#include "hmi/model/layout.h"
#include "hmi/people/password.h"
#include "hmi/player/alarm_sheet.h"
#include "hmi/player/keypad.h"
#include "hmi/player/pop_up.h"
#include "hmi/view/lists/recipe_view.h"
#include "running.h"
#include "tests/support/patience.h"
#include "tests/support/settle.h"

#include <QPushButton>
#include <QTemporaryDir>

namespace plc::hmi {
namespace {

Panel parsed(const std::string& text) {
    Result<Panel> panel = Panel::parse(text, QStringLiteral("p"));
    EXPECT_TRUE(panel) << (panel ? "" : panel.error().english());
    return panel ? *panel : Panel();
}

struct Plant {
    QTemporaryDir folder;
    PanelProject project = machineProject();
    session::Session session{builtMachine()};
    std::unique_ptr<PanelPlayer> player;

    Plant() { project.folder = folder.path(); }
    void add(const char* name, const std::string& text) {
        project.panels.push_back({QString::fromLatin1(name), parsed(text)});
    }
    PanelPlayer& play(const char* start, bool run = true) {
        project.startPanel = QString::fromLatin1(start);
        player = std::make_unique<PanelPlayer>(project, &session);
        player->resize(640, 400);
        player->show();
        if (run) {
            session.startThread({session::Pace::Factor, 5});
            EXPECT_TRUE(waitFor("Main.count > 2"));
        }
        return *player;
    }
    void click(PanelView& view, const char* id) {
        const ElementView* element = view.scene().view(QString::fromLatin1(id));
        ASSERT_TRUE(element) << id;
        const QPoint at = view.toWidget(view.scene().shownRect(*element)).center().toPoint();
        QTest::mouseClick(&view, Qt::LeftButton, {}, at);
        settle();
    }
    void click(const char* id) { click(player->view(), id); }
    void clickAt(double x, double y) {
        QTest::mouseClick(&player->view(), Qt::LeftButton, {},
                          player->view().toWidget(QRectF(x, y, 0, 0)).topLeft().toPoint());
        settle();
    }
    bool waitFor(const char* expression) {
        const BindingId id = player->values()->bind(QString::fromUtf8(expression));
        return hmi::waitFor(*player, [&] { return player->values()->value(id).toBool(); });
    }
    /// What is written is seen at once, and recorded with the next scan.
    bool waitForScan() {
        const uint64_t before = session.status().scans;
        return hmi::waitFor(*player, [&] { return session.status().scans > before; });
    }
    template <class Box> Box* box() {
        Box* found = nullptr;
        EXPECT_TRUE(QTest::qWaitFor(
            [&] {
                for (Box* one : player->findChildren<Box*>())
                    if (one->isVisible()) found = one;
                return found != nullptr;
            },
            kPatience));
        return found;
    }
    void enter(const char* text) {
        Keypad* keypad = box<Keypad>();
        if (!keypad) return;
        for (const char* c = text; *c; ++c) keypad->type(QString(QLatin1Char(*c)));
        keypad->accept();
        settle();
    }
    std::vector<AuditEntry> trail() const {
        const auto read = readAudit(folder.filePath(QStringLiteral(".stepwise/audit.csv")));
        EXPECT_TRUE(read);
        if (!read) return {};
        EXPECT_EQ(read->firstBroken, 0);
        return read->entries;
    }
};

// ---- several panels as one

const char* const kFrame = R"({"size": [640, 400], "elements": [
    {"id": "nav", "kind": "navigation", "rect": [0, 0, 300, 50], "entries": [{"panel": "one", "text": "1"}, {"panel": "two", "text": "2"}]},
    {"id": "back", "kind": "button", "rect": [400, 0, 80, 50], "action": "back", "text": ""},
    {"id": "area", "kind": "panelArea", "rect": [0, 60, 640, 340]}]})";

std::string page(const std::string& elements) { return "{\"size\": [640, 340], \"elements\": [" + elements + "]}"; }

TEST(Application, AFrameShowsOnePanelAfterTheOtherAndTheWayBack) {
    Plant plant;
    plant.project.frame = QStringLiteral("frame");
    plant.add("frame", kFrame);
    plant.add("one",
              page(R"({"id": "go", "kind": "button", "rect": [10, 10, 100, 60], "target": "Main.start", "text": ""})"));
    plant.add("two", page(R"({"id": "lamp", "kind": "lamp", "rect": [10, 10, 60, 60], "value": "Main.running"})"));
    PanelPlayer& player = plant.play("one");
    ASSERT_TRUE(player.scene().view(QStringLiteral("area/go")));
    EXPECT_EQ(player.scene().shownRect(*player.scene().view(QStringLiteral("area/go"))).center(), QPointF(60, 100));
    plant.click("area/go");
    EXPECT_TRUE(plant.waitFor("Main.running"));
    QTest::mouseClick(&player.view(), Qt::LeftButton, {}, QPoint(225, 25)); // the second key of the bar
    EXPECT_TRUE(waitFor(player, [&] { return player.panelName() == QStringLiteral("two"); }));
    EXPECT_TRUE(player.scene().view(QStringLiteral("area/lamp")));
    EXPECT_FALSE(player.scene().view(QStringLiteral("area/go")));
    EXPECT_EQ(player.scene().currentPanel().toStdString(), "two");
    plant.click("back");
    EXPECT_TRUE(waitFor(player, [&] { return player.panelName() == QStringLiteral("one"); }));
    EXPECT_FALSE(player.navigation().canGoBack());
    plant.click("back"); // nothing to go back to
    EXPECT_EQ(player.panelName().toStdString(), "one");
    // A panel may be without the frame.
    plant.project.find(QStringLiteral("two"))->panel.set("framed", false);
    player.showPanel(QStringLiteral("two"));
    EXPECT_TRUE(player.scene().view(QStringLiteral("lamp")));
}

TEST(Application, APopUpGetsItsArgumentsWritesAndCloses) {
    Plant plant;
    plant.add("main",
              page(R"({"id": "open", "kind": "button", "rect": [10, 10, 100, 60], "action": "popup", "panel": "detail",
                               "arguments": {"go": "Main.start", "title": "Motor"}, "text": ""})"));
    plant.add(
        "detail",
        R"({"size": [200, 120], "title": "@start", "parameters": [{"name": "go", "type": "BOOL"}, {"name": "title", "type": "text"}],
        "elements": [{"id": "t", "kind": "text", "rect": [0, 0, 100, 30], "text": "$title"},
                     {"id": "b", "kind": "button", "rect": [10, 40, 80, 60], "target": "$go", "text": ""},
                     {"id": "x", "kind": "button", "rect": [110, 40, 80, 60], "action": "close", "text": ""}]})");
    PanelPlayer& player = plant.play("main");
    plant.click("open");
    ASSERT_TRUE(waitFor(player, [&] { return player.popUps().size() == 1; }));
    PopUp* popUp = player.popUps().front();
    EXPECT_EQ(popUp->scene().view(QStringLiteral("t"))->element().text("text").toStdString(), "Motor");
    plant.click(popUp->view(), "b");
    EXPECT_TRUE(plant.waitFor("Main.running"));
    plant.click(popUp->view(), "x");
    EXPECT_TRUE(waitFor(player, [&] { return player.popUps().empty(); }));
    plant.click("open"); // and again, closed by a press beside it
    ASSERT_TRUE(waitFor(player, [&] { return player.popUps().size() == 1; }));
    QTest::mouseClick(player.popUps().front(), Qt::LeftButton, {}, QPoint(3, 3));
    EXPECT_TRUE(waitFor(player, [&] { return player.popUps().empty() && player.navigation().popUps().empty(); }));
}

TEST(Layout, ElementsKeepTheirDistanceToTheEdgesTheyAreAnchoredTo) {
    const Panel panel = parsed(R"({"size": [400, 200], "adapts": "anchors", "elements": [
        {"id": "l", "kind": "lamp", "rect": [10, 10, 40, 40]},
        {"id": "r", "kind": "lamp", "rect": [350, 150, 40, 40], "anchorX": "right", "anchorY": "bottom"},
        {"id": "w", "kind": "lamp", "rect": [60, 10, 280, 40], "anchorX": "both"},
        {"id": "c", "kind": "lamp", "rect": [180, 80, 40, 40], "anchorX": "center", "anchorY": "center"},
        {"id": "g", "kind": "group", "rect": [60, 60, 100, 100], "anchorX": "both"},
        {"id": "i", "kind": "lamp", "rect": [120, 60, 40, 40], "parent": "g", "anchorX": "right"}]})");
    EXPECT_EQ(sizeFor(panel, {800, 400}), QSizeF(400, 200)); // the same proportions: twice as large
    EXPECT_EQ(sizeFor(panel, {1000, 400}), QSizeF(500, 200));
    EXPECT_EQ(sizeFor(panel, {400, 800}), QSizeF(400, 800));
    const Panel wide = laidOut(panel, {500, 260});
    const auto rect = [&](const char* id) { return wide.find(QString::fromLatin1(id))->rect(); };
    EXPECT_EQ(rect("l"), QRectF(10, 10, 40, 40));
    EXPECT_EQ(rect("r"), QRectF(450, 210, 40, 40));
    EXPECT_EQ(rect("w"), QRectF(60, 10, 380, 40));
    EXPECT_EQ(rect("c"), QRectF(230, 110, 40, 40));
    EXPECT_EQ(rect("g"), QRectF(60, 60, 200, 100));
    EXPECT_EQ(rect("i"), QRectF(220, 60, 40, 40));
    EXPECT_EQ(laidOut(wide, panel.size()).write(), panel.write());
}

TEST(Application, APanelWithAnchorsFillsTheScreenAndAHighScreenHasItsOwn) {
    Plant plant;
    plant.add("main", R"({"size": [640, 400], "adapts": "anchors", "portrait": "high", "elements": [
        {"id": "r", "kind": "lamp", "rect": [580, 10, 40, 40], "anchorX": "right", "value": "TRUE"}]})");
    plant.add("high", R"({"size": [400, 640], "elements": [{"id": "h", "kind": "lamp", "rect": [10, 10, 40, 40]}]})");
    PanelPlayer& player = plant.play("main");
    player.resize(900, 400);
    ASSERT_TRUE(player.scene().view(QStringLiteral("r")));
    EXPECT_NEAR(player.scene().view(QStringLiteral("r"))->rect().left(), 900 * (400.0 / player.view().height()) - 60,
                2);
    player.resize(400, 800);
    EXPECT_TRUE(player.scene().view(QStringLiteral("h")));
    EXPECT_EQ(player.panelName().toStdString(), "main"); // it is the same place
    player.resize(900, 400);
    EXPECT_TRUE(player.scene().view(QStringLiteral("r")));
}

// ---- people

struct Manned : Plant {
    Manned() {
        project.people.setRole({QStringLiteral("operator"), {}, {}});
        project.people.setRole({QStringLiteral("engineer"), {}, QStringLiteral("second")});
        project.people.setUser({QStringLiteral("anna"), {QStringLiteral("operator")}, *hashOf(QStringLiteral("4711"))});
        project.people.setUser({QStringLiteral("bert"), {QStringLiteral("engineer")}, *hashOf(QStringLiteral("0815"))});
        add("main",
            page(
                R"({"id": "go", "kind": "button", "rect": [10, 10, 100, 60], "target": "Main.start", "text": "", "access": "operator"},
            {"id": "hidden", "kind": "button", "rect": [120, 10, 100, 60], "target": "Main.stop", "text": "", "access": "engineer", "denied": "hidden"},
            {"id": "level", "kind": "numberEntry", "rect": [10, 100, 140, 44], "target": "Main.level", "access": "operator", "critical": true},
            {"id": "who", "kind": "user", "rect": [300, 10, 200, 50]})"));
        add("second",
            page(R"({"id": "out", "kind": "button", "rect": [10, 10, 100, 60], "action": "logOut", "text": ""})"));
    }
};

TEST(People, LogInByKeysAlone) {
    Manned plant;
    PanelPlayer& player = plant.play("main");
    const auto press = [](Qt::Key key) { QTest::keyClick(QApplication::focusWidget(), key); };
    const auto logIn = [&](const std::vector<Qt::Key>& keys, const char* password) {
        plant.click("who");
        ASSERT_TRUE(plant.box<ChoiceList>());
        for (const Qt::Key key : keys) press(key);
        plant.enter(password);
    };
    logIn({Qt::Key_Down, Qt::Key_Up, Qt::Key_Space}, "4711");
    EXPECT_EQ(player.people().user().toStdString(), "anna");
    plant.click("who");
    logIn({Qt::Key_Down, Qt::Key_Return}, "0815");
    EXPECT_EQ(player.people().user().toStdString(), "bert");
}

TEST(People, SomebodyLogsInIsAllowedAndLeavesATrail) {
    Manned plant;
    PanelPlayer& player = plant.play("main");
    plant.click("go"); // nobody is logged in: refused with the reason, and asked who it is
    EXPECT_EQ(player.lastRefusal().toStdString(), "Only for: operator");
    ChoiceList* names = plant.box<ChoiceList>();
    ASSERT_TRUE(names);
    EXPECT_TRUE(plant.waitFor("Main.count > 20 AND Main.presses = 0"));
    QTest::mouseClick(names->findChildren<QPushButton*>().front(), Qt::LeftButton);
    plant.enter("1111");
    EXPECT_EQ(player.lastRefusal().toStdString(), "The password is wrong.");
    EXPECT_FALSE(player.people().isLoggedIn());
    plant.click("who");
    names = plant.box<ChoiceList>();
    ASSERT_TRUE(names);
    QTest::mouseClick(names->findChildren<QPushButton*>().front(), Qt::LeftButton);
    plant.enter("4711");
    ASSERT_EQ(player.people().user().toStdString(), "anna");
    EXPECT_EQ(player.scene().user().toStdString(), "anna");
    plant.click("go");
    EXPECT_TRUE(plant.waitFor("Main.presses = 1"));
    EXPECT_FALSE(player.scene().isShown(*player.scene().view(QStringLiteral("hidden"))));
    plant.click("who"); // a press on the name logs out
    EXPECT_FALSE(player.people().isLoggedIn());
    const std::vector<AuditEntry> trail = plant.trail();
    QStringList actions;
    for (const AuditEntry& one : trail) actions += one.user + u':' + one.action;
    EXPECT_EQ(actions.join(u' ').toStdString(), ":log in refused anna:log in anna:write anna:log out");
    EXPECT_EQ(trail[2].what.toStdString(), "Main.start");
    EXPECT_EQ(trail[2].from.toStdString(), "FALSE");
    EXPECT_EQ(trail[2].to.toStdString(), "TRUE");
    EXPECT_EQ(trail[2].place.toStdString(), "main, go");
}

TEST(People, AWriteIsRefusedAlsoWhereNoViewAsksForIt) {
    Manned plant;
    PanelPlayer& player = plant.play("main");
    const WriteRequest write{
        QStringLiteral("go"), QStringLiteral("Main.start"), WriteKind::Write, Value::ofBool(true), {}};
    EXPECT_EQ(player.post(write).toStdString(), "Only for: operator");
    EXPECT_EQ(player.logIn(QStringLiteral("bert"), QStringLiteral("0815")), LogIn::Answer::Good);
    EXPECT_EQ(player.panelName().toStdString(), "second"); // the start panel of the role
    player.showPanel(QStringLiteral("main"));
    EXPECT_FALSE(player.post(write).isEmpty());
    EXPECT_TRUE(player.scene().isShown(*player.scene().view(QStringLiteral("hidden"))));
    player.showPanel(QStringLiteral("second"));
    plant.click("out");
    EXPECT_FALSE(player.people().isLoggedIn());
}

TEST(People, ACriticalWriteIsConfirmedAndSigned) {
    Manned plant;
    PanelPlayer& player = plant.play("main");
    ASSERT_EQ(player.logIn(QStringLiteral("anna"), QStringLiteral("4711")), LogIn::Answer::Good);
    const auto type = [&](const char* password) {
        plant.click("level");
        plant.enter("20");
        Question* question = plant.box<Question>();
        ASSERT_TRUE(question);
        QTest::mouseClick(question->findChildren<QPushButton*>().back(), Qt::LeftButton); // yes
        settle();
        plant.enter(password);
    };
    type("9999");
    EXPECT_EQ(player.lastRefusal().toStdString(), "The password is wrong.");
    EXPECT_TRUE(plant.waitFor("Main.level = 12.5"));
    type("4711");
    EXPECT_TRUE(plant.waitFor("Main.level = 20.0"));
    const std::vector<AuditEntry> trail = plant.trail();
    EXPECT_EQ(trail.back().comment.toStdString(), "signed by anna");
    EXPECT_EQ(trail.back().from.toStdString(), "12.5");
    EXPECT_EQ(trail.back().to.toStdString(), "20.0");
    EXPECT_EQ(trail[trail.size() - 2].action.toStdString(), "signature refused");
}

TEST(People, APeopleFileThatCannotBeReadLetsNobodyIn) {
    Manned plant;
    QDir(plant.folder.path()).mkpath(QStringLiteral("hmi"));
    QFile file(plant.project.peoplePath());
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("{\"users\": 5}");
    file.close();
    EXPECT_FALSE(plant.project.readPeople());
    EXPECT_FALSE(plant.project.problems.empty());
    PanelPlayer& player = plant.play("main");
    const WriteRequest write{
        QStringLiteral("go"), QStringLiteral("Main.start"), WriteKind::Write, Value::ofBool(true), {}};
    EXPECT_FALSE(player.post(write).isEmpty());
}

// ---- recipes

const char* const kRecipes = R"({"recipes": [{"name": "r", "variables": [
    {"variable": "Main.level", "title": "Level", "unit": "m", "min": 0, "max": 50},
    {"variable": "Main.small"}, {"variable": "Main.name"}],
    "sets": [{"name": "a", "values": {"Main.level": "30.5", "Main.small": "-7", "Main.name": "'abc'"}},
             {"name": "b", "values": {"Main.level": "1.0", "Main.small": "300", "Main.name": "'b'"}}]}]})";

struct Cook : Plant {
    Cook() {
        project.recipes = *RecipeFile::parse(kRecipes, QStringLiteral("hmi/recipes.json"));
        QDir(folder.path()).mkpath(QStringLiteral("hmi"));
        add("main", page(R"({"id": "t", "kind": "recipe", "rect": [0, 0, 620, 330], "recipe": "r"})"));
    }
    RecipeTableView& table() { return *dynamic_cast<RecipeTableView*>(player->scene().view(QStringLiteral("t"))); }
    // The head is 50 high: the name, then write, read, add, remove, each 44 wide.
    void clickKey(int key) { clickAt(620 - 8 - (4 - key) * 48 + 24, 25); }
};

TEST(Recipe, ASetIsWrittenInOneScanAndOneWithAMistakeNotAtAll) {
    Cook plant;
    PanelPlayer& player = plant.play("main");
    plant.clickKey(0);
    EXPECT_TRUE(plant.waitFor("Main.level = 30.5 AND Main.small = -7 AND Main.name = 'abc'"))
        << player.lastRefusal().toStdString();
    ASSERT_TRUE(plant.waitForScan());
    // In every recorded scan either none or all of it.
    const auto level = plant.session.expression("Main.level"), small = plant.session.expression("Main.small");
    ASSERT_TRUE(level && small);
    const history::Statistics there = plant.session.history().statistics();
    int changes = 0;
    for (history::Position at = there.first; at < there.end; ++at) {
        const auto image = plant.session.history().seek(at);
        const bool one = *level->number(image) == 30.5, other = *small->number(image) == -7;
        EXPECT_EQ(one, other) << at;
        changes += one;
    }
    EXPECT_GT(changes, 0);
    plant.table().showSet(QStringLiteral("b")); // 300 does not fit into SINT
    plant.clickKey(0);
    EXPECT_FALSE(player.lastRefusal().isEmpty());
    EXPECT_TRUE(plant.waitFor("Main.level = 30.5"));
    // Something that only the scan refuses leaves nothing of the set behind either.
    plant.table().showSet(QStringLiteral("a"));
    plant.session.force("Main.small", types::Value{types::TypeTable::of(types::TypeKind::Sint), int64_t(5)});
    ASSERT_TRUE(plant.waitFor("Main.small = 5"));
    ASSERT_TRUE(
        player.post(WriteRequest{{}, QStringLiteral("Main.level"), WriteKind::Write, Value::ofReal(2), {}}).isEmpty());
    ASSERT_TRUE(plant.waitFor("Main.level = 2.0"));
    plant.clickKey(0);
    EXPECT_TRUE(waitFor(player, [&] { return player.lastRefusal().contains(QStringLiteral("Main.small")); }))
        << player.lastRefusal().toStdString();
    EXPECT_TRUE(plant.waitFor("Main.level = 2.0"));
}

TEST(Recipe, IsEditedReadAndKeptInTheFile) {
    Cook plant;
    PanelPlayer& player = plant.play("main");
    plant.clickAt(370, 50 + 22); // the set's value of the first row
    plant.enter("44");
    EXPECT_EQ(player.recipes().find(QStringLiteral("r"))->find(QStringLiteral("a"))->values["Main.level"].toStdString(),
              "44.0");
    plant.clickAt(370, 50 + 22);
    Keypad* keypad = plant.box<Keypad>();
    ASSERT_TRUE(keypad);
    keypad->type(QStringLiteral("9"));
    keypad->type(QStringLiteral("9"));
    keypad->accept(); // beyond the limit of 50
    EXPECT_FALSE(keypad->complaint().isEmpty());
    keypad->close();
    plant.clickKey(2); // a copy
    EXPECT_EQ(plant.table().currentSet().toStdString(), "a2");
    const auto answer = [&](const QString& word) {
        Question* question = plant.box<Question>();
        ASSERT_TRUE(question);
        for (QPushButton* button : question->findChildren<QPushButton*>())
            if (button->text() == word) return button->click();
        FAIL() << word.toStdString();
    };
    plant.clickKey(1); // asks first: what was in the set would be lost
    answer(QStringLiteral("No"));
    settle();
    const auto copied = [&] { return player.recipes().find(QStringLiteral("r"))->find(QStringLiteral("a2")); };
    ASSERT_TRUE(copied());
    EXPECT_EQ(copied()->values["Main.level"].toStdString(), "44.0");
    plant.clickKey(1);
    answer(QStringLiteral("Yes")); // what the controller holds
    const RecipeSet* read = copied();
    ASSERT_TRUE(read);
    EXPECT_EQ(read->values["Main.level"].toStdString(), "12.5");
    EXPECT_EQ(read->values["Main.small"].toStdString(), "0");
    QFile file(plant.project.recipesPath());
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    const auto kept = RecipeFile::parse(file.readAll().toStdString(), {});
    ASSERT_TRUE(kept);
    EXPECT_EQ(kept->recipes(), player.recipes().recipes());
    plant.clickKey(3); // asks first
    answer(QStringLiteral("No"));
    settle();
    EXPECT_TRUE(player.recipes().find(QStringLiteral("r"))->find(QStringLiteral("a2")));
    plant.clickKey(3);
    answer(QStringLiteral("Yes"));
    EXPECT_FALSE(player.recipes().find(QStringLiteral("r"))->find(QStringLiteral("a2")));
}

TEST(Recipe, GoesOutAndComesBackAsCsv) {
    RecipeFile file = *RecipeFile::parse(kRecipes, {});
    Recipe& recipe = file.recipes().front();
    const Recipe before = recipe;
    const std::string csv = recipeToCsv(recipe);
    ASSERT_TRUE(recipeFromCsv(recipe, csv, QStringLiteral("f.csv")));
    EXPECT_EQ(recipe, before);
    ASSERT_TRUE(recipeFromCsv(recipe, "variable;c\r\nMain.level;5\r\nMAIN.SMALL;6\r\n", QStringLiteral("f.csv")));
    EXPECT_EQ(recipe.find(QStringLiteral("c"))->values["Main.small"].toStdString(), "6");
    const auto wrong = recipeFromCsv(recipe, "variable,c\nMain.other,5\n", QStringLiteral("f.csv"));
    ASSERT_FALSE(wrong);
    EXPECT_EQ(wrong.error().place, "f.csv:2");
    EXPECT_FALSE(recipeFromCsv(recipe, "name,c\n", QStringLiteral("f.csv")));
    EXPECT_EQ(recipeToText(before, before.sets.front()),
              "// r: a\nMain.level := 30.5; // m\nMain.small := -7;\nMain.name := 'abc';\n");
    EXPECT_EQ(RecipeFile::parse(file.write(), {})->write(), file.write());
}

TEST(Recipe, TheCheckFindsASetThatTheControllerWouldRefuse) {
    Cook plant;
    const driver::Built built = builtMachine();
    const auto refused = [&] {
        int count = 0;
        for (const Finding& one : checkPanels(plant.project, built.checked))
            count += one.code() == QStringLiteral("H1023");
        return count;
    };
    EXPECT_EQ(refused(), 1) << "300 does not fit into SINT";
    Recipe& recipe = plant.project.recipes.recipes().front();
    recipe.find(QStringLiteral("b"))->values[QStringLiteral("Main.small")] = QStringLiteral("100");
    EXPECT_EQ(refused(), 0);
    recipe.variables.front().variable = QStringLiteral("Main.lvel");
    EXPECT_GE(refused(), 1) << "no such variable";
}

// ---- alarms set aside

TEST(Alarms, OneIsShelvedFromItsSheetAndComesBack) {
    Plant plant;
    plant.project.alarms = *AlarmFile::parse(
        R"({"alarms": [{"id": "over", "condition": "Main.overload", "text": "Overload", "help": "Look at the motor.", "show": "two", "firstOut": "g"},
                       {"id": "run", "condition": "Main.running", "text": "Running", "firstOut": "g"}]})",
        QString());
    plant.add("main", page(R"({"id": "list", "kind": "alarmList", "rect": [0, 0, 620, 300]})"));
    plant.add("two", page(R"({"id": "aside", "kind": "alarmList", "rect": [0, 0, 620, 300], "shows": "aside"})"));
    PanelPlayer& player = plant.play("main");
    ASSERT_TRUE(player.keepAlarmsInProject());
    const auto write = [&](const char* target) {
        EXPECT_TRUE(
            player.post(WriteRequest{{}, QLatin1String(target), WriteKind::Write, Value::ofBool(true), {}}).isEmpty());
    };
    const auto present = [&] { return player.alarms().present({}, AlarmOrder::Priority); };
    write("Main.overload");
    ASSERT_TRUE(waitFor(player, [&] { return present().size() == 1; }));
    write("Main.start");
    ASSERT_TRUE(waitFor(player, [&] { return present().size() == 2; }));
    for (const AlarmEntry& entry : present()) EXPECT_EQ(entry.isFirstOut, entry.id == QStringLiteral("over"));
    size_t row = present()[0].id == QStringLiteral("over") ? 0 : 1;
    plant.clickAt(200, 50 + static_cast<double>(row) * 46 + 20);
    AlarmSheet* sheet = plant.box<AlarmSheet>();
    ASSERT_TRUE(sheet);
    ASSERT_TRUE(sheet->keyOf(AlarmAction::ShelveShort));
    EXPECT_FALSE(sheet->keyOf(AlarmAction::PutBack));
    QTest::mouseClick(sheet->keyOf(AlarmAction::ShelveShort), Qt::LeftButton);
    EXPECT_TRUE(waitFor(player, [&] { return present().size() == 1; }));
    EXPECT_EQ(present().front().id.toStdString(), "run");
    EXPECT_EQ(player.alarms().aside({}).size(), 1u);
    EXPECT_TRUE(QFile::exists(plant.folder.filePath(QStringLiteral(".stepwise/alarms_aside.json"))));
    player.showPanel(QStringLiteral("two"));
    plant.clickAt(200, 50 + 20);
    sheet = plant.box<AlarmSheet>();
    ASSERT_TRUE(sheet);
    ASSERT_TRUE(sheet->keyOf(AlarmAction::PutBack));
    QTest::mouseClick(sheet->keyOf(AlarmAction::PutBack), Qt::LeftButton);
    EXPECT_TRUE(waitFor(player, [&] { return present().size() == 2; }));
    const AlarmStatistics found = player.alarms().statistics(std::chrono::hours(1));
    EXPECT_EQ(found.raised, 2);
    player.showPanel(QStringLiteral("main"));
    plant.clickAt(200, 50 + 20);
    sheet = plant.box<AlarmSheet>();
    ASSERT_TRUE(sheet);
    ASSERT_TRUE(sheet->whyKey());
    QTest::mouseClick(sheet->whyKey(), Qt::LeftButton);
    EXPECT_TRUE(waitFor(player, [&] { return player.answer() != nullptr; })) << "why the alarm is active";
}

} // namespace
} // namespace plc::hmi
