// Faceplates: one panel with parameters, placed for every element of an array; edited once, checked by the front end,
// operated on a running controller, undone byte for byte.
#include "hmi/designer/array_arrangement_dialog.h"
#include "hmi/designer/canvas/outline.h"
#include "hmi/designer/canvas/palette.h"
#include "hmi/designer/panel_designer.h"
#include "hmi/view/element_factory.h"
#include "hmi/view/scene/faceplate_view.h"
#include "running.h"
#include "tests/support/answer.h"
#include "tests/support/settle.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QMimeData>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTreeWidget>

namespace plc::hmi {
namespace {

const char* const kPlant = R"(
FUNCTION_BLOCK Gate
VAR_INPUT
    Go : BOOL;
END_VAR
VAR_OUTPUT
    IsOpen : BOOL;
    Way : REAL;
END_VAR
IF Go THEN IsOpen := TRUE; Way := 100.0; END_IF;
END_FUNCTION_BLOCK
FUNCTION_BLOCK LargeGate EXTENDS Gate
END_FUNCTION_BLOCK
PROGRAM Main
VAR
    gates : ARRAY[1..200] OF Gate;
    large : LargeGate;
    speed : REAL;
    i : INT;
END_VAR
FOR i := 1 TO 200 DO gates[i](); END_FOR;
large();
END_PROGRAM
CONFIGURATION C
RESOURCE R ON PLC
    TASK T(INTERVAL := T#10ms, PRIORITY := 1);
    PROGRAM Main WITH T : Main;
END_RESOURCE
END_CONFIGURATION
)";

driver::Built builtPlant() {
    jit::setRuntimeSymbols(controller::runtimeSymbols());
    driver::BuildInput input;
    input.files.push_back({"main.st", kPlant});
    driver::Built built = driver::build(input);
    EXPECT_TRUE(built.program);
    return built;
}

Panel parsed(const std::string& text) {
    Result<Panel> panel = Panel::parse(text, QStringLiteral("p"));
    EXPECT_TRUE(panel) << (panel ? "" : panel.error().english());
    return panel ? *panel : Panel();
}

const char* const kGate = R"({"size": [40, 60],
    "parameters": [{"name": "gate", "type": "Gate"}, {"name": "title", "type": "text"}, {"name": "limit", "type": "REAL", "value": "50"}],
    "elements": [
        {"id": "lamp", "kind": "lamp", "rect": [5, 5, 30, 20], "value": "$gate.IsOpen"},
        {"id": "bar", "kind": "progress", "rect": [0, 26, 40, 8], "value": "$gate.Way", "max": "$limit", "showValue": false},
        {"id": "go", "kind": "button", "rect": [0, 36, 40, 24], "text": "$title", "fontSize": 9, "target": "$gate.Go"}]})";

struct Plant {
    PanelProject project;
    driver::Built built = builtPlant();

    explicit Plant(const std::string& elements, const std::string& faceplate = kGate) {
        LanguageSettings settings;
        settings.languages = QStringList{"en"};
        TextTable table;
        table.addLanguage(QStringLiteral("en"));
        project.texts = TextCatalog(table, settings);
        project.panels.push_back({QStringLiteral("gate"), parsed(faceplate)});
        project.panels.push_back(
            {QStringLiteral("main"), parsed("{\"size\": [1024, 700], \"elements\": [" + elements + "]}")});
        project.startPanel = QStringLiteral("main");
    }
    std::string findings() const {
        std::string out;
        CheckInput input = project.checkInput();
        const driver::Checked checked = checkedForPanels(*built.input, built.checked, project.panels);
        for (const Finding& one : hmi::checkPanels(project, checked))
            if (one.kind != FindingKind::MissingFont) out += one.text().toStdString() + "\n";
        return out;
    }
};

const char* const kOne =
    R"({"id": "g", "kind": "faceplate", "rect": [10, 10, 40, 60], "panel": "gate", "arguments": {"gate": "Main.gates[1]", "title": "G1"}})";

TEST(FaceplateText, ParametersAreReplacedInExpressionsButNotInTheirTexts) {
    const Arguments arguments{{"motor", "Main.m[2]"}, {"sum", "a + b"}, {"none", ""}, {"n", "3"}};
    const struct {
        const char *expression, *expected;
    } rows[] = {
        {"$motor.Speed > 5", "Main.m[2].Speed > 5"},
        {"$Motor", "Main.m[2]"},
        {"2 * $sum", "2 * (a + b)"},
        {"$sum", "a + b"},
        {"Main.a[$n]", "Main.a[3]"},
        {"$none", ""},
        {"$none AND $motor.On", ""},
        {"$motor.Name = 'cost: $motor'", "Main.m[2].Name = 'cost: $motor'"},
        {"x = '$'' AND $n > 1", "x = '$'' AND 3 > 1"},
        {"$other.x", "$other.x"},
        {"Main.plain", "Main.plain"},
    };
    for (const auto& row : rows)
        EXPECT_EQ(withArguments(QString::fromLatin1(row.expression), arguments).toStdString(), row.expected)
            << row.expression;
    EXPECT_EQ(textWithArguments(QStringLiteral("Valve $n costs 5 $"), arguments).toStdString(), "Valve 3 costs 5 $");
}

TEST(FaceplateText, ADefaultMayNameAParameterBeforeIt) {
    const Panel panel =
        parsed(R"({"parameters": [{"name": "v", "type": "Gate"}, {"name": "go", "type": "BOOL", "value": "$v.Go"}]})");
    EXPECT_EQ(completed(parametersOf(panel), {{"v", "a[1]"}}).value("go").toStdString(), "a[1].Go");
    EXPECT_EQ(completed(parametersOf(panel), {{"v", "a[1]"}, {"go", "x"}}).value("go").toStdString(), "x");
}

TEST(Faceplate, IsDrawnScaledAtItsPlaceAndFollowsItsOwnGate) {
    Plant plant(
        R"({"id": "g", "kind": "faceplate", "rect": [100, 50, 80, 120], "panel": "gate", "arguments": {"gate": "Main.gates[7]"}})");
    HeldValues values;
    PanelScene scene{makeElementView};
    scene.setFaceplates(plant.project.panelLookup());
    scene.setValues(&values);
    scene.setPanel(plant.project.find(QStringLiteral("main"))->panel);
    ElementView* lamp = scene.view(QStringLiteral("g/lamp"));
    ASSERT_TRUE(lamp);
    EXPECT_EQ(lamp->boundExpressions(), QStringList{"Main.gates[7].IsOpen"});
    EXPECT_EQ(scene.shownRect(*lamp).center(), QPointF(100 + 2 * 20, 50 + 2 * 15));
    EXPECT_EQ(scene.view(QStringLiteral("g/bar"))->element().number("max"), 50); // the default of $limit
    scene.refresh(0);
    values.set(QStringLiteral("Main.gates[7].IsOpen"), Value::ofBool(true));
    const QRegion changed = scene.refresh(33);
    EXPECT_TRUE(changed.contains(QPoint(140, 80)));
    EXPECT_FALSE(changed.contains(QPoint(140, 150))); // the button
    EXPECT_EQ(scene.viewAt(QPointF(140, 150)), scene.view(QStringLiteral("g/go")));
}

TEST(Faceplate, WithoutABackgroundOfItsOwnThatOfThePanelIsSeen) {
    Plant plant(
        R"({"id": "g", "kind": "faceplate", "rect": [100, 50, 80, 120], "panel": "gate", "arguments": {"gate": "Main.gates[7]"}})");
    PanelScene scene{makeElementView};
    scene.setFaceplates(plant.project.panelLookup());
    scene.setPanel(plant.project.find(QStringLiteral("main"))->panel);
    for (const char* theme : {"light", "dark", "contrast"}) {
        scene.setTheme(QString::fromLatin1(theme));
        const QImage picture = scene.picture();
        EXPECT_EQ(picture.pixelColor(106, 56).name().toStdString(), picture.pixelColor(20, 20).name().toStdString())
            << theme;
    }
}

TEST(Faceplate, MayBeNestedButNotContainItself) {
    Plant plant(
        R"({"id": "p", "kind": "faceplate", "rect": [0, 0, 100, 60], "panel": "pair", "arguments": {"a": "Main.gates[1]", "b": "Main.gates[2]"}})");
    plant.project.panels.push_back(
        {QStringLiteral("pair"),
         parsed(R"({"size": [100, 60], "parameters": [{"name": "a", "type": "Gate"}, {"name": "b", "type": "Gate"}],
            "elements": [{"id": "x", "kind": "faceplate", "rect": [0, 0, 40, 60], "panel": "gate", "arguments": {"gate": "$a"}},
                         {"id": "y", "kind": "faceplate", "rect": [60, 0, 40, 60], "panel": "gate", "arguments": {"gate": "$b"}}]})")});
    EXPECT_EQ(plant.findings(), "");
    PanelScene scene{makeElementView};
    HeldValues values;
    scene.setValues(&values);
    scene.setFaceplates(plant.project.panelLookup());
    scene.setPanel(plant.project.find(QStringLiteral("main"))->panel);
    ASSERT_TRUE(scene.view(QStringLiteral("p/y/lamp")));
    EXPECT_EQ(scene.view(QStringLiteral("p/y/lamp"))->boundExpressions(), QStringList{"Main.gates[2].IsOpen"});
    EXPECT_EQ(scene.shownRect(*scene.view(QStringLiteral("p/y/lamp"))).center(), QPointF(60 + 20, 15));
    // gate places pair, which places gate: said, and drawn without hanging.
    Panel& gate = plant.project.find(QStringLiteral("gate"))->panel;
    gate.elements().push_back(
        Element(Json::parse(R"({"id": "again", "kind": "faceplate", "rect": [0, 0, 10, 10], "panel": "pair"})")));
    EXPECT_NE(plant.findings().find("H1020"), std::string::npos) << plant.findings();
    scene.setPanel(plant.project.find(QStringLiteral("main"))->panel);
    EXPECT_FALSE(scene.picture().isNull());
}

TEST(FaceplateCheck, EachMistakeIsSaidWhereItIs) {
    const std::string open = R"({"id": "g", "kind": "faceplate", "rect": [10, 10, 40, 60], "panel": "gate")";
    const struct {
        const char* name;
        std::string elements, faceplate, expected;
    } rows[] = {
        {"good", kOne, kGate, ""},
        {"a block that extends the type", open + R"(, "arguments": {"gate": "Main.large"}})", kGate, ""},
        {"no panel", R"({"id": "g", "kind": "faceplate", "rect": [10, 10, 40, 60]})", kGate,
         "hmi/main.panel.json: g.panel: error H1019: The faceplate does not say which panel it shows; choose one"},
        {"no such panel", R"({"id": "g", "kind": "faceplate", "rect": [10, 10, 40, 60], "panel": "gone"})", kGate,
         "hmi/main.panel.json: g.panel: error H1013"},
        {"missing", open + "}", kGate,
         "hmi/main.panel.json: g.arguments.gate: error H1019: The parameter $gate needs an argument of type Gate; "
         "enter one in the properties of this faceplate"},
        {"other type", open + R"(, "arguments": {"gate": "Main.speed"}})", kGate,
         "hmi/main.panel.json: g.arguments.gate: error H1019: Main.speed is REAL; the parameter $gate needs Gate"},
        {"misspelled variable", open + R"(, "arguments": {"gate": "Main.gaets[1]"}})", kGate,
         "hmi/main.panel.json: g.arguments.gate: error H1019"},
        {"too much", open + R"(, "arguments": {"gate": "Main.gates[1]", "colour": "red"}})", kGate,
         "hmi/main.panel.json: g.arguments.colour: error H1019: The panel gate has no parameter colour; remove the "
         "argument or add the parameter"},
        {"no such member", kOne,
         R"({"size": [40, 60], "parameters": [{"name": "gate", "type": "Gate"}], "elements": [{"id": "l", "kind": "lamp", "rect": [0, 0, 30, 30], "value": "$gate.IsOpne"}]})",
         "hmi/gate.panel.json: l.value: error H1012"},
        {"no such member, placed nowhere", "",
         R"({"size": [40, 60], "parameters": [{"name": "g", "type": "TON"}], "elements": [{"id": "l", "kind": "lamp", "rect": [0, 0, 30, 30], "value": "$g.QQ"}]})",
         "hmi/gate.panel.json: l.value: error H1012"},
        {"no such parameter", kOne,
         R"({"size": [40, 60], "parameters": [{"name": "gate", "type": "Gate"}], "elements": [{"id": "l", "kind": "lamp", "rect": [0, 0, 30, 30], "value": "$gat.IsOpen"}]})",
         "hmi/gate.panel.json: l.value: error H1012: The panel gate has no parameter gat; remove the argument or add "
         "the parameter"},
        {"wrong type of binding", kOne,
         R"({"size": [40, 60], "parameters": [{"name": "gate", "type": "Gate"}], "elements": [{"id": "l", "kind": "lamp", "rect": [0, 0, 30, 30], "value": "$gate.Way"}]})",
         "hmi/gate.panel.json: l.value: error H1012: Main.gates[1].Way is REAL; a BOOL is needed here (tried with "
         "$gate = Main.gates[1])"},
        {"no such type", "", R"({"size": [40, 60], "parameters": [{"name": "gate", "type": "Gaet"}], "elements": []})",
         "hmi/gate.panel.json: parameters[0].type: error H1019"},
    };
    for (const auto& row : rows) {
        Plant plant(row.elements, row.faceplate);
        if (std::string(row.name) == "no such member") // only the one argument is there
            plant.project.find(QStringLiteral("main"))
                ->panel.find(QStringLiteral("g"))
                ->set("arguments", Json{{"gate", "Main.gates[1]"}});
        const std::string found = plant.findings();
        if (row.expected.empty())
            EXPECT_EQ(found, "") << row.name;
        else
            EXPECT_NE(found.find(row.expected), std::string::npos) << row.name << "\n" << found;
    }
}

TEST(FaceplateCheck, ReadyFaceplatesFitTheBlocksOfTheLibraries) {
    driver::BuildInput input;
    input.libraries = {"plant", "toolbox"};
    input.files.push_back({"main.st", "PROGRAM Main\nVAR motor : plant.Motor; valve : plant.Valve; b : Bistable_Valve; "
                                      "pid : FB_PID; count : CTU; level : REAL; END_VAR\nEND_PROGRAM\n"});
    const driver::Checked checked = driver::check(input);
    ASSERT_FALSE(checked.analysis->hasErrors);
    ASSERT_GE(readyFaceplates().size(), 6u);
    for (const NamedPanel& ready : readyFaceplates()) {
        CheckInput checking;
        checking.panels = {ready};
        askProgram(checking, checked);
        for (const Finding& one : checkPanel(checking, ready))
            EXPECT_TRUE(one.kind == FindingKind::MissingFont) << one.text().toStdString();
        for (const Parameter& parameter : parametersOf(ready.panel))
            EXPECT_TRUE(parameter.isText() || !parameter.wanted().empty() ||
                        !instanceOf(checked, parameter.type).isEmpty())
                << ready.name.toStdString() << ' ' << parameter.type.toStdString();
        EXPECT_EQ(parsed(ready.panel.write()).write(), ready.panel.write());
        if (qEnvironmentVariableIsSet("STEPWISE_PICTURES"))
            for (const char* theme : {"light", "dark"}) {
                Panel panel = withArguments(ready.panel, {{"title", "Title"}, {"unit", "bar"}});
                panel.set("theme", theme);
                PanelScene scene{makeElementView};
                scene.setDesigning(true);
                scene.setPanel(panel);
                scene.picture(2).save(
                    qEnvironmentVariable("STEPWISE_PICTURES") +
                    QStringLiteral("/faceplate_%1_%2.png").arg(ready.name.section(u'/', 1), QLatin1String(theme)));
            }
    }
}

struct Studio {
    Plant plant;
    session::Session session{builtPlant()};
    DesignContext context{plant.project};
    std::unique_ptr<PanelDesigner> designer;

    explicit Studio(const std::string& elements) : plant(elements) {
        context.setChecked(plant.built.checked);
        context.setRun(&session);
        designer = std::make_unique<PanelDesigner>(context, QStringLiteral("main"));
        designer->resize(1400, 900);
        designer->show();
        settle();
        designer->canvas().setZoom(1);
    }
    const Panel& panel() const { return designer->document().panel(); }
};

TEST(FaceplateDesigner, TwoHundredGatesAreArrangedOverAnArrayInOneGestureAndEditedOnce) {
    Studio studio(
        R"({"id": "g", "kind": "faceplate", "rect": [8, 8, 40, 60], "panel": "gate", "arguments": {"title": "G#"}})");
    const std::string before = studio.panel().write();
    studio.designer->selection().set({QStringLiteral("g")});
    ASSERT_TRUE(studio.designer->action(QStringLiteral("arrange-array"))->isEnabled());
    inNext<ArrayArrangementDialog>(qApp, [](ArrayArrangementDialog& dialog) {
        EXPECT_EQ(dialog.array().currentText().toStdString(), "Main.gates"); // the only one that fits
        EXPECT_EQ(dialog.columns().value(), 21);                             // as many as fit
        EXPECT_EQ(dialog.complaint().text(), "");
        dialog.columns().setValue(5);
        EXPECT_TRUE(dialog.complaint().text().contains(QStringLiteral("240 × 2720")))
            << dialog.complaint().text().toStdString();
        dialog.columns().setValue(20);
        EXPECT_EQ(dialog.complaint().text(), "");
        QTest::mouseClick(dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok), Qt::LeftButton);
    });
    studio.designer->action(QStringLiteral("arrange-array"))->trigger();
    ASSERT_EQ(studio.panel().elements().size(), 200u);
    EXPECT_EQ(studio.designer->document().undoStack().count(), 1);
    const Element& last = studio.panel().elements().back();
    EXPECT_EQ(argumentsOf(last.at("arguments")), (Arguments{{"gate", "Main.gates[200]"}, {"title", "G200"}}));
    EXPECT_EQ(last.rect(), QRectF(8 + 19 * 48, 8 + 9 * 68, 40, 60));
    EXPECT_EQ(studio.plant.findings(), "");

    const QTreeWidgetItem* row = studio.designer->outline().topLevelItem(0);
    EXPECT_EQ(row->text(0).toStdString().substr(0, 7), "gate  G") << "which of the two hundred it is";

    // One edit of the faceplate, in its own designer, changes all of them on the open panel.
    PanelScene& scene = studio.designer->canvas().scene();
    const QImage round = scene.picture();
    PanelDesigner gate(studio.context, QStringLiteral("gate"));
    gate.document().perform(QStringLiteral("Shape"),
                            setProperty(gate.document().panel(), QStringLiteral("lamp"), "shape", "square"));
    int square = 0;
    for (const auto& view : scene.views()) square += view->element().text("shape") == QStringLiteral("square");
    EXPECT_EQ(square, 200);
    EXPECT_NE(scene.picture(), round);
    gate.document().undoStack().undo();
    EXPECT_EQ(scene.picture(), round);
    // Undone byte for byte, and done again.
    const std::string arranged = studio.panel().write();
    studio.designer->document().undoStack().undo();
    EXPECT_EQ(studio.panel().write(), before);
    studio.designer->document().undoStack().redo();
    EXPECT_EQ(studio.panel().write(), arranged);
}

TEST(FaceplateDesigner, ArgumentsAreRowsOfThePropertySheet) {
    Studio studio(R"({"id": "g", "kind": "faceplate", "rect": [8, 8, 40, 60], "panel": "gate"})");
    studio.designer->selection().set({QStringLiteral("g")});
    kit::PropertyGrid& grid = studio.designer->sheet().grid();
    ASSERT_TRUE(grid.descriptor(QStringLiteral("arguments.gate")));
    EXPECT_EQ(grid.descriptor(QStringLiteral("arguments.gate"))->kind, kit::PropertyKind::Expression);
    EXPECT_EQ(grid.descriptor(QStringLiteral("arguments.title"))->kind, kit::PropertyKind::Text);
    const std::string before = studio.panel().write();
    studio.designer->sheet().commit(QStringLiteral("arguments.gate"), QStringLiteral("Main.gates[3]"));
    studio.designer->sheet().commit(QStringLiteral("arguments.title"), QStringLiteral("Third"));
    EXPECT_EQ(argumentsOf(studio.panel().find(QStringLiteral("g"))->at("arguments")),
              (Arguments{{"gate", "Main.gates[3]"}, {"title", "Third"}}));
    EXPECT_EQ(grid.value(QStringLiteral("arguments.gate")).toString().toStdString(), "Main.gates[3]");
    EXPECT_EQ(studio.designer->canvas().scene().view(QStringLiteral("g/lamp"))->boundExpressions(),
              QStringList{"Main.gates[3].IsOpen"});
    // Another panel has other rows.
    studio.designer->sheet().commit(QStringLiteral("panel"), QStringLiteral("library/counter"));
    EXPECT_TRUE(grid.descriptor(QStringLiteral("arguments.counter")));
    EXPECT_FALSE(grid.descriptor(QStringLiteral("arguments.gate")));
    while (studio.designer->document().undoStack().canUndo()) studio.designer->document().undoStack().undo();
    EXPECT_EQ(studio.panel().write(), before);
}

TEST(FaceplateDesigner, ThePaletteOffersTheProjectsAndTheReadyOnesAndRefusesOneInItself) {
    Studio studio("");
    for (const char* name : {"gate", "library/motor", "library/pid", "library/valve"})
        EXPECT_TRUE(studio.designer->palette().shownTitles().contains(QLatin1String(name))) << name;
    studio.designer->canvas().insertElements(
        Json::array({newFaceplateFields(*studio.plant.project.find(QStringLiteral("gate")))}), QPointF(200, 200));
    ASSERT_EQ(studio.panel().elements().size(), 1u);
    EXPECT_EQ(studio.panel().elements().front().rect().size(), QSizeF(40, 60));
    // It is one element on the canvas: a click selects it, not what it shows.
    const QPointF middle = studio.panel().elements().front().rect().center();
    QTest::mouseClick(studio.designer->canvas().viewport(), Qt::LeftButton, {},
                      studio.designer->canvas().toViewport(middle).toPoint());
    EXPECT_EQ(studio.designer->selection().ids(), ElementIds{studio.panel().elements().front().id()});

    PanelDesigner gate(studio.context, QStringLiteral("gate"));
    QSignalSpy refused(&gate, &PanelDesigner::refused);
    const size_t count = gate.document().panel().elements().size();
    gate.canvas().insertElements(Json::array({newFaceplateFields(*studio.plant.project.find(QStringLiteral("gate")))}),
                                 QPointF(20, 20));
    EXPECT_EQ(gate.document().panel().elements().size(), count);
    EXPECT_EQ(refused.size(), 1);
}

TEST(FaceplateDesigner, ARenamedVariableIsRenamedInArguments) {
    Studio studio(kOne);
    const DesignContext::NamedVariable gates{QStringLiteral("Main.gates"), QStringLiteral("gates"), {}};
    EXPECT_EQ(studio.context.usesOf(gates).size(), 1u);
    EXPECT_TRUE(studio.context.rename(gates, QStringLiteral("doors")));
    EXPECT_EQ(argumentsOf(studio.panel().find(QStringLiteral("g"))->at("arguments")).value("gate").toStdString(),
              "Main.doors[1]");
}

TEST(FaceplatePlayer, AButtonInOneOfTwoHundredFaceplatesOpensItsOwnGate) {
    Plant plant(kOne);
    Panel& panel = plant.project.find(QStringLiteral("main"))->panel;
    applyTo(panel, arrangedOverArray(panel, QStringLiteral("g"),
                                     {QStringLiteral("Main.gates"), QStringLiteral("gate"), 1, 200, 20, {8, 8}}));
    session::Session session(builtPlant());
    PanelPlayer player(plant.project, &session);
    player.resize(1024, 700);
    player.show();
    session.startThread({session::Pace::Factor, 5});
    const auto opened = [&](int gate) {
        const BindingId id = player.values()->bind(QStringLiteral("Main.gates[%1].IsOpen").arg(gate));
        return player.values()->value(id).toBool();
    };
    ASSERT_TRUE(waitFor(player, [&] { return player.values()->status().scans > 3; }));
    const ElementView* button = nullptr;
    for (const auto& view : player.scene().views())
        if (view->boundExpressions().contains(QStringLiteral("Main.gates[137].Go"))) button = view.get();
    ASSERT_TRUE(button);
    const QPoint at = (player.scene().shownRect(*button).center()).toPoint();
    QTest::mousePress(&player.view(), Qt::LeftButton, {}, at);
    QTest::mouseRelease(&player.view(), Qt::LeftButton, {}, at);
    EXPECT_TRUE(waitFor(player, [&] { return opened(137); })) << player.lastRefusal().toStdString();
    int others = 0;
    for (int gate = 1; gate <= 200; ++gate) others += gate != 137 && opened(gate);
    EXPECT_EQ(others, 0);
}

} // namespace
} // namespace plc::hmi
