// Rows and grids in the designer with real events: dropped into a cell, dragged to another one and out, laid out by the
// menu; each a step of undo, byte for byte.
#include "design_studio.h"

namespace plc::hmi {
namespace {

constexpr const char* kRow = R"(
    {"id":"g","kind":"group","rect":[40,40,420,100],"layout":"row","gap":10,"padding":10},
    {"id":"a","kind":"lamp","parent":"g","rect":[50,50,100,80]},
    {"id":"b","kind":"lamp","parent":"g","rect":[160,50,100,80]})";

std::string order(const Panel& panel, const char* group) {
    QStringList out;
    for (const ElementId& id : panel.childrenOf(QLatin1String(group))) out += id;
    return out.join(u' ').toStdString();
}

TEST(DesignerCells, WhatIsDroppedIntoARowTakesTheCellAtThePointer) {
    Studio studio(kRow);
    const std::string before = studio.panel().write();
    studio.dropElement(ElementKind::Lamp, 156, 90);
    EXPECT_EQ(order(studio.panel(), "g"), "a lamp1 b");
    const QRectF rect = studio.panel().find(QStringLiteral("lamp1"))->rect();
    EXPECT_EQ(rect.left(), 160);
    EXPECT_EQ(rect.height(), 80);
    EXPECT_GT(studio.panel().find(QStringLiteral("b"))->rect().left(), rect.right()) << "it made room";
    studio.designer->document().undoStack().undo();
    EXPECT_EQ(studio.panel().write(), before);
}

TEST(DesignerCells, ADragTakesAnotherCellOrLeavesTheRow) {
    Studio studio(kRow);
    const std::string before = studio.panel().write();
    studio.drag(studio.at(100, 90), studio.at(250, 90), Qt::AltModifier); // Alt: what lies in the group
    EXPECT_EQ(order(studio.panel(), "g"), "b a");
    EXPECT_EQ(studio.panel().find(QStringLiteral("b"))->rect().left(), 50);
    studio.drag(studio.at(100, 90), studio.at(400, 300), Qt::AltModifier);
    EXPECT_EQ(order(studio.panel(), "g"), "a") << "b is free";
    EXPECT_EQ(studio.panel().find(QStringLiteral("b"))->rect().center(), QPointF(400, 300));
    studio.designer->document().undoStack().undo();
    studio.designer->document().undoStack().undo();
    EXPECT_EQ(studio.panel().write(), before);
}

TEST(DesignerCells, AFreeElementIsDraggedIntoACellInOneStep) {
    Studio studio(std::string(kRow) + R"(,{"id":"c","kind":"lamp","rect":[300,250,60,60]})");
    const std::string before = studio.panel().write();
    studio.drag(studio.at(330, 280), studio.at(60, 90));
    EXPECT_EQ(order(studio.panel(), "g"), "c a b");
    studio.designer->document().undoStack().undo();
    EXPECT_EQ(studio.panel().write(), before) << "the way there and the cell are one step";
}

TEST(DesignerCells, TheMenuLaysOutWhatIsSelectedInTheOrderSeen) {
    Studio studio(R"({"id":"d","kind":"lamp","rect":[200,200,50,50]},{"id":"a","kind":"lamp","rect":[40,42,50,50]},
                     {"id":"b","kind":"lamp","rect":[200,40,50,50]},{"id":"c","kind":"lamp","rect":[40,200,50,50]})");
    const std::string before = studio.panel().write();
    studio.designer->action(QStringLiteral("select-all"))->trigger();
    studio.designer->action(QStringLiteral("lay-grid"))->trigger();
    EXPECT_EQ(order(studio.panel(), "group1"), "a b c d");
    const Element* group = studio.panel().find(QStringLiteral("group1"));
    ASSERT_TRUE(group);
    EXPECT_EQ(group->integer("columns"), 2);
    EXPECT_EQ(studio.panel().find(QStringLiteral("a"))->rect().size(),
              studio.panel().find(QStringLiteral("d"))->rect().size());
    studio.designer->document().undoStack().undo();
    EXPECT_EQ(studio.panel().write(), before);
}

} // namespace
} // namespace plc::hmi
