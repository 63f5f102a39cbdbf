// What makes binding and arranging quick: variables dropped on elements and on the property sheet, colours as swatches,
// only the properties that say something, an outline that can be read, one of several by a click, paste in place.
#include "design_studio.h"
#include "hmi/designer/canvas/outline.h"

#include <QComboBox>

namespace plc::hmi {
namespace {

constexpr const char* kTwo = R"({"id":"a","kind":"lamp","rect":[100,100,60,60]},
                                {"id":"b","kind":"button","rect":[300,100,120,60],"text":"Go"})";

TEST(DesignComfort, AVariableDroppedOnAnElementBindsItAndOneUndoTakesItBack) {
    Studio studio(kTwo);
    const std::string before = studio.panel().write();
    studio.dropVariable("Main.running", 130, 130);
    EXPECT_EQ(studio.panel().elements().size(), 2u);
    EXPECT_EQ(studio.panel().find("a")->text("value").toStdString(), "Main.running");
    EXPECT_TRUE(studio.designer->selection().contains("a"));
    studio.dropVariable("Main.start", 350, 130);
    EXPECT_EQ(studio.panel().find("b")->text("target").toStdString(), "Main.start");
    studio.designer->document().undoStack().undo();
    studio.designer->document().undoStack().undo();
    EXPECT_EQ(studio.panel().write(), before);
}

TEST(DesignComfort, WhatDoesNotFitOrIsMeantToBeNewBecomesANewElement) {
    Studio studio(kTwo);
    studio.dropVariable("Main.level", 130, 130); // a REAL on a lamp
    EXPECT_EQ(studio.panel().elements().size(), 3u);
    EXPECT_EQ(studio.panel().find("a")->text("value").toStdString(), "");
    studio.dropVariable("Main.start", 130, 130, Qt::ShiftModifier);
    EXPECT_EQ(studio.panel().elements().size(), 4u) << "Shift asks for an element that operates";
}

TEST(DesignComfort, WhatIsDroppedOnATrendBecomesACurveOfIt) {
    Studio studio(R"({"id":"t","kind":"trend","rect":[100,100,400,200]})");
    const std::string before = studio.panel().write();
    studio.dropVariable("Main.level", 300, 200);
    studio.dropVariable("Main.level", 300, 200);
    EXPECT_EQ(studio.panel().elements().size(), 1u);
    EXPECT_EQ(studio.panel().find("t")->at("series"),
              Json::parse(R"([{"value": "Main.level"}, {"value": "Main.level"}])"));
    EXPECT_TRUE(studio.designer->selection().contains("t"));
    studio.designer->document().undoStack().undo();
    studio.designer->document().undoStack().undo();
    EXPECT_EQ(studio.panel().write(), before);
    studio.dropVariable("Main.level", 300, 200, Qt::ShiftModifier);
    EXPECT_EQ(studio.panel().elements().size(), 2u) << "Shift asks for an element that operates";
}

TEST(DesignComfort, ABlockDroppedOnThePanelBecomesItsFaceplateOrIsRefusedWithAReason) {
    Studio studio(kTwo);
    QString said;
    QObject::connect(&studio.designer->canvas(), &DesignCanvas::refused, [&](const QString& reason) { said = reason; });
    studio.dropVariable("Main.edge", 400, 300);
    EXPECT_EQ(studio.panel().elements().size(), 2u) << "it has no single value";
    EXPECT_TRUE(said.contains("Main.edge") && said.contains("R_TRIG")) << said.toStdString();

    auto plate = Panel::parse(R"({"size": [80, 60], "parameters": [{"name": "title", "type": "text"},
                                  {"name": "trig", "type": "r_trig"}], "elements": []})",
                              QStringLiteral("plate"));
    ASSERT_TRUE(plate);
    studio.project.panels.push_back({QStringLiteral("plate"), *plate});
    studio.dropVariable("Main.edge", 400, 300);
    ASSERT_EQ(studio.panel().elements().size(), 3u);
    EXPECT_EQ(studio.last().kind(), ElementKind::Faceplate);
    EXPECT_EQ(studio.last().text("panel"), "plate");
    EXPECT_EQ(studio.last().at("arguments"), Json({{"trig", "Main.edge"}}));
    EXPECT_EQ(studio.last().rect().size(), QSizeF(80, 60));
}

TEST(DesignComfort, AVariableDroppedOnARowOfThePropertySheetBindsIt) {
    Studio studio(kTwo);
    studio.designer->selection().set({"a"});
    auto* grid = studio.designer->sheet().findChild<kit::PropertyGrid*>();
    ASSERT_TRUE(grid && grid->row("value"));
    grid->scrollToItem(grid->row("value"));
    const QPoint row = grid->visualItemRect(grid->row("value")).center();
    std::unique_ptr<QMimeData> mime(kit::makeVariableMime({QStringLiteral("Main.stop")}));
    QDragEnterEvent enter(row, Qt::CopyAction, mime.get(), Qt::LeftButton, {});
    QApplication::sendEvent(grid->viewport(), &enter);
    QDragMoveEvent move(row, Qt::CopyAction, mime.get(), Qt::LeftButton, {});
    QApplication::sendEvent(grid->viewport(), &move);
    EXPECT_TRUE(move.isAccepted());
    QDropEvent drop(QPointF(row), Qt::CopyAction, mime.get(), Qt::LeftButton, {});
    QApplication::sendEvent(grid->viewport(), &drop);
    EXPECT_EQ(studio.panel().find("a")->text("value").toStdString(), "Main.stop");
}

TEST(DesignComfort, OnlyThePropertiesThatSaySomethingAreShown) {
    Studio studio(kTwo);
    studio.designer->selection().set({"b"});
    auto* grid = studio.designer->sheet().findChild<kit::PropertyGrid*>();
    EXPECT_TRUE(grid->row("target"));
    EXPECT_FALSE(grid->row("panel") || grid->row("tag") || grid->row("write"));
    studio.designer->sheet().commit("action", "panel");
    EXPECT_TRUE(grid->row("panel"));
    EXPECT_FALSE(grid->row("target") || grid->row("confirm"));
    studio.designer->sheet().commit("action", "write");
    EXPECT_TRUE(grid->row("target") && grid->row("write"));
}

TEST(DesignComfort, ColoursAreOfferedAsSwatches) {
    Studio studio(kTwo);
    studio.designer->selection().set({"a"});
    auto* grid = studio.designer->sheet().findChild<kit::PropertyGrid*>();
    ASSERT_TRUE(grid->row("onColor"));
    grid->editProperty("onColor");
    auto* combo = grid->findChild<QComboBox*>();
    ASSERT_TRUE(combo);
    const int red = combo->findData("red");
    ASSERT_GE(red, 0);
    const QImage swatch = combo->itemIcon(red).pixmap(16, 16).toImage();
    ASSERT_FALSE(swatch.isNull());
    EXPECT_GT(swatch.pixelColor(8, 8).red(), 180);
    EXPECT_LT(swatch.pixelColor(8, 8).green(), 90);
}

TEST(DesignComfort, TheOutlineSaysWhatThingsAre) {
    Studio studio(R"({"id":"a","kind":"lamp","rect":[0,0,60,60],"value":"Main.running"},
                     {"id":"b","kind":"button","rect":[100,0,120,60],"text":"Go"},
                     {"id":"c","kind":"rectangle","rect":[300,0,120,60]},
                     {"id":"d","kind":"lamp","rect":[500,0,60,60],"name":"Horn","value":"Main.stop"})");
    auto* outline = studio.designer->findChild<Outline*>();
    ASSERT_TRUE(outline);
    EXPECT_EQ(outline->itemOf("a")->text(0).toStdString(), "Lamp  Main.running");
    EXPECT_EQ(outline->itemOf("b")->text(0).toStdString(), "Button  \"Go\"");
    EXPECT_EQ(outline->itemOf("c")->text(0).toStdString(), "Rectangle  c");
    EXPECT_EQ(outline->itemOf("d")->text(0).toStdString(), "Horn");
    studio.designer->selection().set({"a"});
    studio.designer->sheet().commit("value", "Main.start");
    EXPECT_EQ(outline->itemOf("a")->text(0).toStdString(), "Lamp  Main.start");
}

TEST(DesignComfort, AnEmptyOutlineSaysHowToBegin) {
    Studio studio;
    const auto words = [&] { // something is drawn on the ground
        const QImage picture = studio.designer->outline().viewport()->grab().toImage();
        for (int y = 0; y < picture.height(); ++y)
            for (int x = 0; x < picture.width(); ++x)
                if (picture.pixel(x, y) != picture.pixel(0, 0)) return true;
        return false;
    };
    EXPECT_TRUE(words());
}

TEST(DesignComfort, AClickOnOneOfSeveralSelectsItAndADragMovesThemAll) {
    Studio studio(kTwo);
    studio.designer->selection().set({"a", "b"});
    studio.drag(studio.at(350, 130), studio.at(350, 190), Qt::AltModifier);
    EXPECT_EQ(studio.designer->selection().ids().size(), 2u);
    EXPECT_EQ(studio.panel().find("a")->rect().top(), 160);
    studio.click(350, 190);
    ASSERT_EQ(studio.designer->selection().ids().size(), 1u);
    EXPECT_EQ(studio.designer->selection().ids().front().toStdString(), "b");
}

TEST(DesignComfort, PasteInPlacePutsACopyWhereTheOriginalWas) {
    Studio studio(kTwo);
    studio.designer->selection().set({"a", "b"});
    studio.designer->action("cut")->trigger();
    EXPECT_TRUE(studio.panel().elements().empty());
    studio.designer->action("paste-in-place")->trigger();
    ASSERT_EQ(studio.panel().elements().size(), 2u);
    EXPECT_EQ(studio.panel().elements()[0].rect(), QRectF(100, 100, 60, 60));
    EXPECT_EQ(studio.panel().elements()[1].rect(), QRectF(300, 100, 120, 60));
}

} // namespace
} // namespace plc::hmi
