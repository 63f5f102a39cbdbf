// Rows, columns and grids: who gets which cell, on screens of either shape, and that undo gives the file back.
#include "hmi/model/cells.h"
#include "hmi/model/document.h"
#include "hmi/model/layout.h"

#include <gtest/gtest.h>

namespace plc::hmi {
namespace {

Panel panelWith(const std::string& group, const std::string& contents, const std::string& more = {}) {
    Result<Panel> panel = Panel::parse(
        "{\"size\": [400, 300], " + more + "\"elements\": [" + group + "," + contents + "]}", QStringLiteral("p"));
    EXPECT_TRUE(panel) << (panel ? "" : panel.error().english());
    return panel ? *panel : Panel();
}

/// "a 10,10 100x80; b …" of what lies in groups.
std::string places(const Panel& panel) {
    QString out;
    for (const Element& one : panel.elements())
        if (!one.parent().isEmpty())
            out += QStringLiteral("%1 %2,%3 %4x%5; ")
                       .arg(one.id())
                       .arg(one.rect().x())
                       .arg(one.rect().y())
                       .arg(one.rect().width())
                       .arg(one.rect().height());
    return toUtf8(out);
}

std::string lamp(const char* id, const char* rect, const char* more = "") {
    return std::string(R"({"id":")") + id + R"(","kind":"lamp","parent":"g","rect":)" + rect + more + "}";
}

TEST(Cells, EachLayoutGivesItsCells) {
    const std::string three =
        lamp("a", "[0,0,50,40]") + "," + lamp("b", "[0,0,60,20]", ",\"stretch\":1") + "," + lamp("c", "[0,0,40,60]");
    const struct {
        const char *layout, *expected;
    } rows[] = {
        // 200 x 100 less a margin of 10, a gap of 5
        {R"("layout":"row")", "a 10,10 50x80; b 65,10 80x80; c 150,10 40x80; "},
        {R"("layout":"row","across":"center")", "a 10,30 50x40; b 65,40 80x20; c 150,20 40x60; "},
        {R"("layout":"row","across":"end")", "a 10,50 50x40; b 65,70 80x20; c 150,30 40x60; "},
        {R"("layout":"column","across":"start")", "a 10,10 50x28; b 10,43 60x1; c 10,48 40x42; "},
        {R"("layout":"grid","columns":2)", "a 10,10 88x38; b 103,10 87x38; c 10,53 88x37; "},
        {R"("layout":"grid","columns":0,"cellWidth":80)", "a 10,10 88x38; b 103,10 87x38; c 10,53 88x37; "},
        {R"("layout":"grid","columns":0,"cellWidth":500)", "a 10,10 180x23; b 10,38 180x24; c 10,67 180x23; "},
        {R"("layout":"either")", "a 10,10 50x80; b 65,10 80x80; c 150,10 40x80; "},
        {R"("layout":"free")", "a 0,0 50x40; b 0,0 60x20; c 0,0 40x60; "},
    };
    for (const auto& row : rows) {
        const Panel panel = panelWith(
            std::string(R"({"id":"g","kind":"group","rect":[0,0,200,100],"gap":5,"padding":10,)") + row.layout + "}",
            three);
        const Panel placed = laidOut(panel, panel.size());
        EXPECT_EQ(places(placed), row.expected) << row.layout;
        EXPECT_TRUE(arrangement(placed).isEmpty()) << row.layout << ": what is in its cell stays there";
        for (const Element& one : placed.elements())
            EXPECT_TRUE(std::string_view(row.layout).find("free") != std::string_view::npos ||
                        QRectF(0, 0, 200, 100).contains(one.rect()))
                << row.layout << ' ' << toUtf8(one.id()) << " leaves the group";
    }
}

TEST(Cells, ATitleAndASpanTakeTheirRoom) {
    const Panel panel = laidOut(
        panelWith(
            R"({"id":"g","kind":"group","rect":[0,0,210,148],"layout":"grid","columns":2,"gap":10,"padding":0,"title":"T","fontSize":20})",
            lamp("a", "[0,0,9,9]", ",\"columnSpan\":2") + "," + lamp("b", "[0,0,9,9]") + "," + lamp("c", "[0,0,9,9]")),
        {400, 300});
    EXPECT_EQ(places(panel), "a 0,38 210x50; b 0,98 100x50; c 110,98 100x50; ");
}

TEST(Cells, ATallScreenTurnsARowAndAddsRowsToAGrid) {
    const std::string group =
        R"({"id":"g","kind":"group","rect":[0,0,400,300],"anchorX":"both","anchorY":"both","gap":0,"padding":0,"layout":"either"})";
    const Panel panel =
        panelWith(group, lamp("a", "[0,0,10,10]", ",\"stretch\":1") + "," + lamp("b", "[0,0,10,10]", ",\"stretch\":1"),
                  "\"adapts\": \"anchors\", ");
    EXPECT_EQ(places(laidOut(panel, sizeFor(panel, {400, 300}))), "a 0,0 200x300; b 200,0 200x300; ");
    const QSizeF tall = sizeFor(panel, {300, 600});
    EXPECT_EQ(places(laidOut(panel, tall)), "a 0,0 400x400; b 0,400 400x400; ");
}

TEST(Cells, AGroupInACellPlacesItsOwnContents) {
    const Panel panel = laidOut(
        panelWith(
            R"({"id":"g","kind":"group","rect":[0,0,200,100],"layout":"row","gap":0,"padding":0})",
            R"({"id":"h","kind":"group","parent":"g","rect":[0,0,50,50],"stretch":1,"layout":"column","gap":0,"padding":0},)" +
                std::string(R"({"id":"x","kind":"lamp","parent":"h","rect":[0,0,9,9],"stretch":1},)") +
                R"({"id":"y","kind":"lamp","parent":"h","rect":[0,0,9,9],"stretch":3})"),
        {400, 300});
    EXPECT_EQ(places(panel), "h 0,0 200x100; x 0,0 200x25; y 0,25 200x75; ");
}

TEST(Cells, AnEditMovesTheOthersAndUndoGivesTheFileBack) {
    PanelDocument document(
        panelWith(R"({"id":"g","kind":"group","rect":[0,0,200,100],"layout":"row","gap":0,"padding":0})",
                  lamp("a", "[0,0,50,100]") + "," + lamp("b", "[50,0,50,100]") + "," +
                      R"({"id":"free","kind":"lamp","rect":[300,200,50,50]})"));
    const std::string before = document.panel().write();
    document.perform(QStringLiteral("in"),
                     putIntoCells(document.panel(), {QStringLiteral("free")}, QStringLiteral("g"), 1));
    EXPECT_EQ(places(document.panel()), "a 0,0 50x100; free 50,0 50x100; b 100,0 50x100; ");
    const std::string after = document.panel().write();
    document.perform(QStringLiteral("gone"), removeElements(document.panel(), {QStringLiteral("a")}));
    EXPECT_EQ(places(document.panel()), "free 0,0 50x100; b 50,0 50x100; ");
    document.undoStack().undo();
    EXPECT_EQ(document.panel().write(), after);
    document.undoStack().undo();
    EXPECT_EQ(document.panel().write(), before);
    document.undoStack().redo();
    EXPECT_EQ(document.panel().write(), after);
}

TEST(Cells, OddFilesDoNoHarm) {
    for (const char* group :
         {R"({"id":"g","kind":"group","rect":[0,0,1,1],"layout":"grid","columns":64,"gap":400,"padding":400})",
          R"({"id":"g","kind":"group","parent":"a","rect":[0,0,0,0],"layout":"row"})",
          R"({"id":"g","kind":"group","parent":"g","rect":[0,0,50,50],"layout":"column"})"}) {
        const Panel panel = panelWith(
            group,
            R"({"id":"a","kind":"group","parent":"g","rect":[0,0,9,9],"layout":"row","columnSpan":64,"stretch":1000})");
        const Panel placed = laidOut(panel, panel.size());
        for (const Element& one : placed.elements()) {
            EXPECT_GE(one.rect().width(), 0) << group;
            EXPECT_LE(one.rect().width(), kLargestElement) << group;
        }
    }
}

} // namespace
} // namespace plc::hmi
