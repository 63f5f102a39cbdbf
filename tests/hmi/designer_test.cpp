// The designer with real events: a panel from nothing, run, pressed, seen, in another language; and what the designer
// does on the way: texts get keys, variables become elements, everything is undone.
#include "design_studio.h"
#include "hmi/designer/canvas/outline.h"
#include "hmi/designer/canvas/palette.h"
#include "hmi/designer/editors/alarm_editor.h"
#include "hmi/designer/editors/text_editor.h"
#include "hmi/designer/panel_designer.h"
#include "hmi/designer/sheet/records_dialog.h"

#include "editor/kit/inputs/expression_edit.h"
#include "editor/kit/inputs/variable_picker.h"
#include "tests/support/settle.h"

#include <QLineEdit>
#include <QMimeData>
#include <QTabWidget>
#include <QTreeWidget>

namespace plc::hmi {
namespace {

TEST(Designer, ColoursOfTheSheetAreThoseOfThePanelsTheme) {
    Studio studio;
    const auto colour = [&](const char* role) {
        for (const kit::PropertyChoice& choice : studio.designer->sheet().grid().descriptor("background")->choices)
            if (choice.value == QString::fromLatin1(role)) return choice.color;
        return QColor();
    };
    EXPECT_EQ(colour("background"), PanelTheme::of(PanelThemeKind::Light).color("background"));
    studio.designer->sheet().commit(QStringLiteral("theme"), QStringLiteral("dark"));
    EXPECT_EQ(colour("background"), PanelTheme::of(PanelThemeKind::Dark).color("background"));
}

TEST(Designer, WhatIsDroppedAtTheEdgeLiesOnThePanel) {
    Studio studio;
    const QSizeF panel = studio.designer->canvas().scene().size();
    const double right = panel.width() - 2, bottom = panel.height() - 2;
    for (const auto& [x, y] : {std::pair{2.0, 2.0}, {right, 2.0}, {right, bottom}, {2.0, bottom}}) {
        studio.dropElement(ElementKind::Button, x, y);
        EXPECT_TRUE(QRectF(QPointF(), panel).contains(studio.last().rect())) << x << ' ' << y;
    }
    studio.dropVariable("Main.running", right, bottom);
    EXPECT_TRUE(QRectF(QPointF(), panel).contains(studio.last().rect()));
}

TEST(Designer, APanelFromNothingIsDrawnRunPressedSeenAndSwitchedToAnotherLanguage) {
    Studio studio;
    const std::string empty = studio.panel().write();
    studio.dropElement(ElementKind::Button, 100, 60);
    ASSERT_EQ(studio.panel().elements().size(), 1u);
    const ElementId button = studio.last().id();
    studio.designer->sheet().commit(QStringLiteral("text"), QStringLiteral("Go ahead"));
    studio.designer->sheet().commit(QStringLiteral("target"), QStringLiteral("Main.start"));
    studio.dropVariable("Main.running", 320, 60);
    const ElementId lamp = studio.last().id();
    EXPECT_EQ(studio.last().kind(), ElementKind::Lamp);
    EXPECT_EQ(studio.last().text("value").toStdString(), "Main.running");
    studio.dropElement(ElementKind::LanguageSelector, 300, 300);
    const ElementId languages = studio.last().id();
    // The typed text got a key; its translation is typed in the text table.
    const QString key = keyOf(studio.panel().find(button)->text("text"));
    EXPECT_EQ(key.toStdString(), "main.go_ahead");
    EXPECT_EQ(studio.project.texts.table().text(key, QStringLiteral("en")).toStdString(), "Go ahead");
    TextEditor editor(*studio.context);
    editor.model().setData(editor.model().index(studio.project.texts.table().rowOf(key), TextModel::FirstLanguage + 1),
                           QStringLiteral("Kør"), Qt::EditRole);
    studio.designer->checkNow();
    for (const Finding& finding : studio.designer->findings()) ADD_FAILURE() << finding.text().toStdString();

    studio.session.startThread({session::Pace::Factor, 5});
    studio.designer->action(QStringLiteral("live"))->trigger();
    ASSERT_TRUE(studio.designer->preview());
    PanelPlayer& player = *studio.designer->preview();
    settle();
    PanelView& view = player.view();
    const auto placeOf = [&](const ElementId& id) { return view.toWidget(studio.panel().find(id)->rect()); };
    const QImage dark = player.scene().picture();
    QTest::mouseClick(&view, Qt::LeftButton, {}, placeOf(button).center().toPoint());
    const BindingId running = player.values()->bind(QStringLiteral("Main.running AND Main.presses = 1"));
    ASSERT_TRUE(waitFor(player, [&] { return player.values()->value(running).toBool(); }));
    const QImage lit = player.scene().picture();
    const QRect lampRect = studio.panel().find(lamp)->rect().toRect();
    EXPECT_NE(dark.copy(lampRect), lit.copy(lampRect));
    const QRectF selector = placeOf(languages);
    QTest::mouseClick(&view, Qt::LeftButton, {},
                      QPointF(selector.left() + selector.width() * 0.5, selector.center().y()).toPoint());
    EXPECT_EQ(player.language().toStdString(), "da");
    EXPECT_EQ(player.scene().texts().text(u'@' + key, player.language()).toStdString(), "Kør");
    const QRect buttonRect = studio.panel().find(button)->rect().toRect();
    EXPECT_NE(lit.copy(buttonRect), player.scene().picture().copy(buttonRect));
    // Without leaving the designer: an edit shows in the preview.
    studio.designer->selection().set({lamp});
    studio.designer->sheet().commit(QStringLiteral("onColor"), QStringLiteral("red"));
    player.frame();
    EXPECT_NE(lit.copy(lampRect), player.scene().picture().copy(lampRect));
    studio.designer->action(QStringLiteral("live"))->trigger();
    EXPECT_FALSE(studio.designer->isLive());

    while (studio.designer->document().undoStack().canUndo()) studio.designer->document().undoStack().undo();
    EXPECT_EQ(studio.panel().write(), empty);
    EXPECT_FALSE(studio.project.texts.table().contains(key)); // its key went with it
}

TEST(Designer, VariablesBecomeTheElementsThatFit) {
    const struct {
        const char* path;
        bool operates;
        ElementKind kind;
        const char *property, *extra;
    } rows[] = {
        {"Main.running", false, ElementKind::Lamp, "value", ""},
        {"Main.start", true, ElementKind::Switch, "target", ""},
        {"Main.level", false, ElementKind::NumericDisplay, "value", ""},
        {"Main.level", true, ElementKind::NumericEntry, "target", ""},
        {"Main.count", false, ElementKind::NumericDisplay, "value", "%d"},
        {"Main.operation", false, ElementKind::MultiState, "value", ""},
        {"Main.operation", true, ElementKind::ComboBox, "target", ""},
        {"Main.name", true, ElementKind::TextEntry, "target", ""},
        {"Main.numbers", false, ElementKind::BarChart, "value", ""},
    };
    Studio studio;
    double y = 40;
    for (const auto& row : rows) {
        studio.dropVariable(row.path, 300, y += 60, row.operates ? Qt::ShiftModifier : Qt::NoModifier);
        EXPECT_EQ(studio.last().kind(), row.kind) << row.path;
        EXPECT_EQ(studio.last().text(row.property).toStdString(), row.path);
        if (*row.extra) {
            EXPECT_EQ(studio.last().text("format").toStdString(), row.extra);
        }
        EXPECT_TRUE(studio.designer->selection().contains(studio.last().id()));
    }
    const QStringList problems = [&] {
        QStringList out;
        studio.designer->checkNow();
        for (const Finding& finding : studio.designer->findings())
            if (finding.kind == FindingKind::WrongBinding) out += finding.text();
        return out;
    }();
    EXPECT_TRUE(problems.isEmpty()) << problems.join(u'\n').toStdString();
}

TEST(Designer, WordsDraggedOutOfTheCodeBecomeTheVariableThatTheyName) {
    Studio studio;
    double y = 40;
    const auto dropText = [&](const char* text) {
        auto* mime = new QMimeData;
        mime->setText(QString::fromLatin1(text));
        studio.drop(mime, 300, y += 100);
        return studio.panel().elements().size();
    };
    EXPECT_EQ(dropText("running"), 1u);
    EXPECT_EQ(studio.last().kind(), ElementKind::Lamp);
    EXPECT_EQ(studio.last().text("value").toStdString(), "Main.running");
    EXPECT_EQ(dropText("IF running THEN"), 1u); // no variable
    EXPECT_EQ(dropText("Main.level\nMain.name"), 3u);
    EXPECT_EQ(studio.last().text("value").toStdString(), "Main.name");
    EXPECT_EQ(dropText("Language"), 4u);
}

TEST(Designer, VariablesAreDraggedFromTheListBesideTheElements) {
    class TwoVariables final : public kit::VariableProvider {
    public:
        std::vector<kit::VariableNode> children(const QString& path) const override {
            if (path.isEmpty())
                return {{QStringLiteral("Main"), QStringLiteral("Main"), {}, {}, kit::Icon::Program, true, true}};
            return {{QStringLiteral("running"), QStringLiteral("Main.running"), QStringLiteral("BOOL")},
                    {QStringLiteral("level"), QStringLiteral("Main.level"), QStringLiteral("REAL")}};
        }
        std::vector<kit::VariableNode> search(const QString&, int) const override {
            return children(QStringLiteral("Main"));
        }
    } variables;
    Studio studio;
    studio.context->setVariables([&]() -> const kit::VariableProvider& { return variables; });
    studio.designer = std::make_unique<PanelDesigner>(*studio.context, QStringLiteral("main"));
    studio.designer->resize(1400, 900);
    studio.designer->show();
    settle();
    auto* tabs = studio.designer->findChild<QTabWidget*>();
    auto* picker = studio.designer->findChild<kit::VariablePicker*>();
    ASSERT_TRUE(tabs && picker);
    tabs->setCurrentWidget(picker);
    ASSERT_TRUE(picker->selectPath(QStringLiteral("Main.running")));
    QTreeWidget* tree = nullptr;
    for (QTreeWidget* one : picker->findChildren<QTreeWidget*>())
        if (one->currentItem()) tree = one;
    ASSERT_TRUE(tree);
    studio.drop(tree->model()->mimeData({tree->currentIndex()}), 300, 200);
    EXPECT_EQ(studio.last().kind(), ElementKind::Lamp);
    EXPECT_EQ(studio.last().text("value").toStdString(), "Main.running");
    picker->setFilter(QStringLiteral("level")); // chosen by the keyboard
    QTest::keyClick(picker->findChild<QLineEdit*>(), Qt::Key_Down);
    QTest::keyClick(picker->findChild<QLineEdit*>(), Qt::Key_Return);
    EXPECT_EQ(studio.last().text("value").toStdString(), "Main.level");
}

TEST(Designer, AlarmListsShowTheTextsOfTheProject) {
    Studio studio(R"({"id":"l","kind":"alarmList","rect":[10,10,600,300]})");
    const QImage english = studio.designer->canvas().scene().picture();
    studio.context->setLanguage(QStringLiteral("da"));
    EXPECT_NE(studio.designer->canvas().scene().picture().copy(210, 60, 200, 40),
              english.copy(210, 60, 200, 40)); // "Overbelastet ved 0"
}

TEST(Designer, ThePanelIsShownWholeUntilAZoomIsChosen) {
    PanelProject project = machineProject();
    project.panels.push_back({QStringLiteral("main"), panelOf("")});
    DesignContext context(project);
    PanelDesigner designer(context, QStringLiteral("main"));
    designer.resize(1000, 620);
    designer.show();
    settle();
    DesignCanvas& canvas = designer.canvas();
    const auto isWhole = [&] {
        return QRectF(canvas.viewport()->rect()).contains(canvas.toViewport(QRectF(0, 0, 640, 400)));
    };
    EXPECT_TRUE(isWhole());
    EXPECT_LT(canvas.zoom(), 1);
    designer.resize(860, 520);
    settle();
    EXPECT_TRUE(isWhole());
    designer.action(QStringLiteral("zoom-1"))->trigger();
    designer.resize(840, 520);
    settle();
    EXPECT_EQ(canvas.zoom(), 1);
}

TEST(Designer, SelectsMovesWithSnappingResizesAndUndoesEachAsOneStep) {
    Studio studio(
        R"({"id":"a","kind":"rectangle","rect":[100,100,80,40]},{"id":"b","kind":"rectangle","rect":[300,200,80,40]})");
    const std::string before = studio.panel().write();
    studio.drag(studio.at(110, 110), studio.at(110 + 197, 110 + 43)); // 297: its left edge snaps to b's at 300
    EXPECT_EQ(studio.panel().find(QStringLiteral("a"))->rect().x(), 300);
    EXPECT_TRUE(studio.designer->canvas().guides().empty()); // they go with the drag
    EXPECT_EQ(studio.designer->document().undoStack().count(), 1);
    studio.designer->action(QStringLiteral("undo"))->trigger();
    EXPECT_EQ(studio.panel().write(), before);
    studio.designer->selection().set({QStringLiteral("a")});
    const QPoint corner = studio.designer->canvas().handle(4).toPoint();
    studio.drag(corner, corner + QPoint(33, 21), Qt::AltModifier);
    EXPECT_EQ(studio.panel().find(QStringLiteral("a"))->rect(), QRectF(100, 100, 113, 61));
    studio.designer->action(QStringLiteral("undo"))->trigger();
    EXPECT_EQ(studio.panel().write(), before);
    QTest::keyClick(&studio.designer->canvas(), Qt::Key_Right);
    QTest::keyClick(&studio.designer->canvas(), Qt::Key_Down, Qt::ShiftModifier);
    EXPECT_EQ(studio.panel().find(QStringLiteral("a"))->rect().topLeft(), QPointF(101, 108));
    studio.drag(studio.at(20, 20), studio.at(450, 280)); // a band around both
    EXPECT_EQ(studio.designer->selection().ids().size(), 2u);
    studio.click(500, 350);
    EXPECT_TRUE(studio.designer->selection().isEmpty());
    studio.click(320, 220);
    studio.click(110, 120, Qt::ControlModifier);
    EXPECT_EQ(studio.designer->selection().ids().size(), 2u);
    QTest::keyClick(&studio.designer->canvas(), Qt::Key_Delete);
    EXPECT_TRUE(studio.panel().elements().empty());
    studio.designer->action(QStringLiteral("undo"))->trigger();
    EXPECT_EQ(studio.panel().elements().size(), 2u);
}

TEST(Designer, AGroupIsTakenAsOneAndEnteredByADoubleClick) {
    Studio studio(
        R"({"id":"a","kind":"rectangle","rect":[100,100,80,40]},{"id":"b","kind":"rectangle","rect":[300,200,80,40]})");
    studio.designer->selectAll();
    studio.designer->action(QStringLiteral("group"))->trigger();
    const ElementId group = studio.designer->selection().ids().front();
    studio.click(600, 380);
    studio.click(120, 120);
    EXPECT_EQ(studio.designer->selection().ids(), ElementIds{group});
    QTest::mouseDClick(studio.ground(), Qt::LeftButton, {}, studio.at(120, 120));
    EXPECT_EQ(studio.designer->selection().ids(), ElementIds{QStringLiteral("a")});
    QTest::keyClick(&studio.designer->canvas(), Qt::Key_Escape);
    EXPECT_EQ(studio.designer->selection().ids(), ElementIds{group});
    studio.designer->action(QStringLiteral("lock"))->trigger();
    studio.drag(studio.at(110, 110), studio.at(200, 200));
    EXPECT_EQ(studio.panel().find(QStringLiteral("a"))->rect().x(), 100); // locked
    studio.designer->selection().set({group});
    studio.designer->action(QStringLiteral("lock"))->trigger();
    studio.designer->action(QStringLiteral("ungroup"))->trigger();
    EXPECT_FALSE(studio.panel().find(group));
}

TEST(Designer, CopiesBetweenPanelsThroughTheClipboard) {
    Studio studio(R"({"id":"a","kind":"lamp","rect":[100,100,50,50],"value":"Main.running"})");
    studio.project.panels.push_back({QStringLiteral("other"), panelOf("")});
    PanelDesigner other(*studio.context, QStringLiteral("other"));
    studio.designer->selectAll();
    studio.designer->copy();
    other.paste();
    other.paste();
    ASSERT_EQ(other.document().panel().elements().size(), 2u);
    EXPECT_EQ(other.document().panel().elements()[1].text("value").toStdString(), "Main.running");
    EXPECT_NE(other.document().panel().elements()[0].rect(), other.document().panel().elements()[1].rect());
}

TEST(Designer, ThePropertySheetEditsSeveralElementsAtOnceAndOnlyWhatTheyShare) {
    Studio studio(
        R"({"id":"a","kind":"lamp","rect":[100,100,50,50]},{"id":"b","kind":"lamp","rect":[200,100,60,60]},{"id":"t","kind":"text","rect":[0,0,100,30]})");
    studio.designer->selection().set({QStringLiteral("a"), QStringLiteral("b")});
    kit::PropertyGrid& grid = studio.designer->sheet().grid();
    EXPECT_TRUE(grid.isVarious(QStringLiteral("rect.x")));
    EXPECT_FALSE(grid.isVarious(QStringLiteral("rect.y")));
    studio.designer->sheet().commit(QStringLiteral("shape"), QStringLiteral("square"));
    EXPECT_EQ(studio.panel().find(QStringLiteral("a"))->text("shape").toStdString(), "square");
    EXPECT_EQ(studio.panel().find(QStringLiteral("b"))->text("shape").toStdString(), "square");
    EXPECT_EQ(studio.designer->document().undoStack().count(), 1);
    studio.designer->selection().set({QStringLiteral("a"), QStringLiteral("t")});
    EXPECT_FALSE(grid.descriptor(QStringLiteral("shape")));
    EXPECT_TRUE(grid.descriptor(QStringLiteral("fontSize")));
    EXPECT_TRUE(grid.descriptor(QStringLiteral("rect.w")));
    studio.designer->selection().clear();
    studio.designer->sheet().commit(QStringLiteral("size.preset"), QSize(800, 480));
    EXPECT_EQ(studio.panel().size(), QSize(800, 480));
}

TEST(Designer, APlaceIsTypedDigitByDigit) {
    Studio studio(R"({"id":"a","kind":"lamp","rect":[100,100,50,50]})");
    studio.designer->selection().set({QStringLiteral("a")});
    settle();
    kit::PropertyGrid& grid = studio.designer->sheet().grid();
    const std::string before = studio.panel().write();
    grid.editProperty(QStringLiteral("rect.x"));
    auto* spin = grid.viewport()->findChild<QDoubleSpinBox*>();
    ASSERT_TRUE(spin);
    for (const char digit : {'2', '4', '8'}) {
        QTest::keyClick(spin, digit);
        settle();
    }
    QTest::keyClick(spin, Qt::Key_Return);
    settle();
    EXPECT_EQ(studio.panel().find(QStringLiteral("a"))->rect(), QRectF(248, 100, 50, 50));
    studio.designer->document().undoStack().undo();
    EXPECT_EQ(studio.panel().write(), before) << "one step";
}

TEST(Designer, ASizeThatIsNoneOfTheUsualIsShown) {
    Studio studio;
    settle();
    kit::PropertyGrid& grid = studio.designer->sheet().grid();
    studio.designer->sheet().commit(QStringLiteral("size.w"), 80.0);
    studio.designer->sheet().commit(QStringLiteral("size.h"), 96.0);
    EXPECT_EQ(grid.row(QStringLiteral("size.preset"))->text(1).toStdString(), "80 × 96");
}

TEST(Designer, EveryPropertyOfEveryKindIsOfferedAndComesBackUnchanged) {
    Studio studio;
    for (const ElementDescriptor& kind : elementDescriptors()) {
        Element element = Element::make(kind.kind, QStringLiteral("e"), QRectF(QPointF(10, 10), kind.size));
        for (const PropertyDescriptor& property : kind.properties) {
            const auto rows = gridRows(property, *studio.context);
            const bool isHidden = property.type == PropertyType::Name || property.type == PropertyType::Element ||
                                  property.type == PropertyType::Points ||
                                  property.type == PropertyType::Arguments; // by what is placed: argumentRows
            EXPECT_EQ(rows.empty(), isHidden) << kind.key << '.' << property.key;
            for (const kit::PropertyDescriptor& row : rows) {
                const Json present = element.at(property.key);
                EXPECT_EQ(fromGrid(property, present, row.id, gridValue(property, present, row.id, *studio.context)),
                          present)
                    << kind.key << '.' << property.key;
            }
        }
    }
}

TEST(Designer, RecordsAreEditedInTheirDialog) {
    Studio studio(R"({"id":"m","kind":"multiState","rect":[100,100,160,44]})");
    const PropertyDescriptor* states = descriptorOf(ElementKind::MultiState).property("states");
    RecordsDialog dialog(*states, Json::array(), *studio.context, {}, nullptr);
    dialog.addRow();
    emit dialog.grid().committed(QStringLiteral("value"), QStringLiteral("1"));
    emit dialog.grid().committed(QStringLiteral("text"), QStringLiteral("Running"));
    emit dialog.grid().committed(QStringLiteral("color"), QStringLiteral("green"));
    dialog.addRow();
    emit dialog.grid().committed(QStringLiteral("value"), QStringLiteral("2"));
    dialog.moveRow(-1);
    EXPECT_EQ(writeCompact(dialog.value()), R"([{"value": "2"}, {"value": "1", "text": "Running", "color": "green"}])");
    dialog.removeRow();
    EXPECT_EQ(dialog.rowCount(), 1);
}

TEST(Designer, TheTypeOfAParameterIsCompleted) {
    Studio studio(R"({"id":"m","kind":"multiState","rect":[100,100,160,44]})");
    const PropertyDescriptor* parameters = panelDescriptor().property("parameters");
    ASSERT_NE(parameters, nullptr);
    RecordsDialog dialog(*parameters, Json::array(), *studio.context, {}, nullptr);
    dialog.addRow();
    dialog.show();
    ASSERT_TRUE(dialog.grid().descriptor(QStringLiteral("type")));
    EXPECT_TRUE(dialog.grid().descriptor(QStringLiteral("type"))->words.contains("Mode")) << "a type of the program";
    dialog.grid().editProperty(QStringLiteral("type"));
    auto* line = dialog.grid().findChild<kit::ExpressionEdit*>();
    ASSERT_TRUE(line);
    QTest::keyClicks(line, "lre");
    ASSERT_TRUE(line->isCompletionShown());
    EXPECT_EQ(line->shownCompletions(), QStringList{"LREAL"});
    QTest::keyClick(line, Qt::Key_Return);
    EXPECT_EQ(line->text(), "LREAL");
    QTest::keyClick(line, Qt::Key_Return);
    EXPECT_EQ(writeCompact(dialog.value()), R"([{"type": "LREAL"}])");
}

TEST(Designer, ThePaletteFindsElementsByWhatTheyAreCalledElsewhere) {
    Palette palette;
    palette.setFilter(QStringLiteral("potentiometer"));
    EXPECT_EQ(palette.shownTitles().join(u' ').toStdString(), "Rotary knob");
    palette.setFilter(QStringLiteral("pump"));
    EXPECT_EQ(palette.shownTitles().join(u' ').toStdString(), "Pump");
    palette.setFilter({});
    const QStringList all = palette.shownTitles();
    EXPECT_GT(all.size(), 55);
    for (const QString& title : all) EXPECT_EQ(all.count(title), 1) << title.toStdString() << " names two elements";
}

TEST(Designer, EnterInTheSearchPutsInTheElementWhoseTitleFitsBest) {
    Palette palette;
    Json chosen;
    QObject::connect(&palette, &Palette::elementChosen, [&](const Json& fields) { chosen = fields; });
    auto* search = palette.findChild<QLineEdit*>();
    ASSERT_TRUE(search);
    QTest::keyClicks(search, QStringLiteral("recipe"));
    EXPECT_GT(palette.shownTitles().size(), 1) << "a table is for recipes, too, and comes before them";
    QTest::keyClick(search, Qt::Key_Return);
    EXPECT_EQ(Element(chosen).kind(), ElementKind::RecipeTable);
}

TEST(Designer, TheOutlineShowsTheTreeAndSelectsBothWays) {
    Studio studio(
        R"({"id":"g","kind":"group","rect":[90,90,300,200]},{"id":"a","kind":"lamp","parent":"g","rect":[100,100,50,50]},{"id":"b","kind":"lamp","rect":[500,100,50,50]})");
    Outline& outline = studio.designer->outline();
    ASSERT_TRUE(outline.itemOf(QStringLiteral("a")));
    EXPECT_EQ(outline.itemOf(QStringLiteral("a"))->parent(), outline.itemOf(QStringLiteral("g")));
    EXPECT_EQ(outline.topLevelItem(0), outline.itemOf(QStringLiteral("b"))); // the topmost first
    outline.itemOf(QStringLiteral("a"))->setSelected(true);
    EXPECT_EQ(studio.designer->selection().ids(), ElementIds{QStringLiteral("a")});
    studio.click(520, 120);
    EXPECT_TRUE(outline.itemOf(QStringLiteral("b"))->isSelected());
}

TEST(Designer, ARenamedMemberIsRenamedBehindInstancesAndParametersOfItsType) {
    Studio studio(
        R"({"id":"a","kind":"lamp","rect":[100,100,50,50],"value":"Main.edge.Q AND main.EDGE.q AND Main.name <> 'Main.edge.Q'"})");
    const auto add = [&](const char* name, const char* type) {
        const std::string text = std::string(R"({"size":[80,60],"parameters":[{"name":"p","type":")") + type +
                                 R"("}],"elements":[{"id":"x","kind":"lamp","rect":[0,0,50,50],"value":"NOT $p.Q"}]})";
        studio.project.panels.push_back({QString::fromLatin1(name), *Panel::parse(text, QString())});
    };
    add("plate", "R_TRIG");
    add("delay", "TON"); // has a Q too, which is another
    const auto value = [&](size_t panel) {
        return studio.project.panels[panel].panel.elements()[0].text("value").toStdString();
    };
    auto named = studio.context->namedVariable(QString(), QStringLiteral("R_TRIG"), QStringLiteral("Q"));
    EXPECT_EQ(studio.context->usesOf(named).size(), 2u);
    EXPECT_TRUE(studio.context->rename(named, QStringLiteral("Rising")));
    EXPECT_EQ(studio.panel().find(QStringLiteral("a"))->text("value").toStdString(),
              "Main.edge.Rising AND main.EDGE.Rising AND Main.name <> 'Main.edge.Q'");
    EXPECT_EQ(value(1), "NOT $p.Rising");
    EXPECT_EQ(value(2), "NOT $p.Q");
    named.name = QStringLiteral("Rising"); // taken back, while the program does not know the old name yet
    EXPECT_TRUE(studio.context->rename(named, QStringLiteral("Q")));
    EXPECT_EQ(value(1), "NOT $p.Q");
    EXPECT_TRUE(studio.panel().find(QStringLiteral("a"))->text("value").startsWith(QStringLiteral("Main.edge.Q AND")));
}

TEST(Designer, ARenameInAProgramThatHasNeverBeenWithoutErrorsFindsNoTypes) {
    PanelProject project = machineProject();
    project.panels.push_back({QStringLiteral("main"),
                              panelOf(R"({"id": "a", "kind": "lamp", "rect": [0, 0, 9, 9], "value": "Main.edge.Q"})")});
    const DesignContext context(project); // as the studio has it until the program is right for the first time
    const auto named = context.namedVariable(QStringLiteral("Main.edge"), QStringLiteral("R_TRIG"), QStringLiteral("Q"),
                                             {QStringLiteral("Main.edge.Q")});
    EXPECT_TRUE(named.bases.empty());
    EXPECT_FALSE(driver::compileExpression({}, "1 + 1"));
}

TEST(Designer, ARenamedVariableIsRenamedInPanelsAlarmsAndRecipes) {
    Studio studio(R"({"id":"a","kind":"lamp","rect":[100,100,50,50],"value":"Main.overload AND Main.running"})");
    studio.project.panels.push_back(
        {QStringLiteral("closed"),
         panelOf(R"({"id":"a","kind":"lamp","rect":[100,100,50,50],"value":"main.OVERLOAD"})")});
    studio.project.recipes = *RecipeFile::parse(R"({"recipes":[{"name":"r","variables":[{"variable":"Main.overload"}],
        "sets":[{"name":"s","values":{"Main.overload":"TRUE"}}]}]})",
                                                {});
    EXPECT_TRUE(studio.context->rename({QStringLiteral("Main.overload"), QStringLiteral("overload"), {}},
                                       QStringLiteral("tooMuch")));
    const Recipe& recipe = studio.project.recipes.recipes().front();
    EXPECT_EQ(recipe.variables[0].variable.toStdString(), "Main.tooMuch");
    EXPECT_EQ(recipe.sets[0].values.value(QStringLiteral("Main.tooMuch")).toStdString(), "TRUE");
    EXPECT_EQ(studio.panel().find(QStringLiteral("a"))->text("value").toStdString(), "Main.tooMuch AND Main.running");
    EXPECT_EQ(studio.project.panels[1].panel.elements()[0].text("value").toStdString(), "Main.tooMuch");
    EXPECT_EQ(studio.project.alarms.definitions()[0].condition.toStdString(), "Main.tooMuch");
    studio.designer->action(QStringLiteral("undo"))->trigger();
    EXPECT_EQ(studio.panel().find(QStringLiteral("a"))->text("value").toStdString(), "Main.overload AND Main.running");
}

TEST(Designer, ANewNavigationBarLeadsToThePanelsOfTheProject) {
    Studio studio;
    for (const char* name : {"mixing", "alarms"}) studio.project.panels.push_back({QLatin1String(name), panelOf("")});
    studio.dropElement(ElementKind::NavigationBar, 300, 300);
    ASSERT_EQ(studio.panel().elements().size(), 1u);
    QStringList places;
    for (const Json& entry : studio.panel().elements().front().fields()["entries"])
        places << QString::fromStdString(entry["panel"].get<std::string>());
    EXPECT_EQ(places, (QStringList{"main", "mixing", "alarms"}));
    studio.designer->document().undoStack().undo();
    EXPECT_TRUE(studio.panel().elements().empty());
}

TEST(Alarms, TheEditorAddsChangesAndUndoes) {
    Studio studio;
    AlarmEditor editor(*studio.context);
    const std::string before = studio.project.alarms.write();
    editor.addAlarm();
    editor.commit(QStringLiteral("id"), QStringLiteral("12004"));
    editor.commit(QStringLiteral("condition"), QStringLiteral("Main.level > 50"));
    editor.commit(QStringLiteral("priority"), 1);
    editor.commit(QStringLiteral("text"), QStringLiteral("Too hot"));
    const AlarmDefinition added = studio.project.alarms.definitions().back();
    EXPECT_EQ(added.id.toStdString(), "12004");
    EXPECT_EQ(added.condition.toStdString(), "Main.level > 50");
    EXPECT_EQ(added.priority, 1);
    EXPECT_EQ(studio.project.texts.text(added.text, QStringLiteral("en")).toStdString(), "Too hot");
    editor.commit(QStringLiteral("id"), QStringLiteral("over")); // taken
    EXPECT_EQ(studio.project.alarms.definitions().back().id.toStdString(), "12004");
    while (editor.undoStack().canUndo()) editor.undoStack().undo();
    EXPECT_EQ(studio.project.alarms.write(), before);
}

} // namespace
} // namespace plc::hmi
