// What the designer does to several elements, as edits: each undone gives the file back byte for byte.
#include "hmi/designer/canvas/snapping.h"
#include "hmi/designer/context/arrange.h"
#include "running.h"

namespace plc::hmi {
namespace {

const char* const kElements = R"({"id":"a","kind":"rectangle","rect":[10,10,100,40]},
    {"id":"b","kind":"rectangle","rect":[150,30,60,20]},
    {"id":"c","kind":"rectangle","rect":[400,100,80,80]})";

std::string rects(const Panel& panel) {
    std::string out;
    for (const Element& element : panel.elements())
        out += toUtf8(element.id()) + writeCompact(rectToJson(element.rect())) + " ";
    return out;
}

TEST(Arrange, EachActionAndItsUndo) {
    const ElementIds all{QStringLiteral("a"), QStringLiteral("b"), QStringLiteral("c")};
    const struct {
        const char* name;
        std::function<Edit(const Panel&)> edit;
        const char* expected;
    } rows[] = {
        {"left", [&](const Panel& p) { return align(p, all, Alignment::Left); },
         "a[10, 10, 100, 40] b[10, 30, 60, 20] c[10, 100, 80, 80] "},
        {"right", [&](const Panel& p) { return align(p, all, Alignment::Right); },
         "a[380, 10, 100, 40] b[420, 30, 60, 20] c[400, 100, 80, 80] "},
        {"middle", [&](const Panel& p) { return align(p, all, Alignment::CenterY); },
         "a[10, 75, 100, 40] b[150, 85, 60, 20] c[400, 55, 80, 80] "},
        {"one to the panel", [&](const Panel& p) { return align(p, {QStringLiteral("b")}, Alignment::Bottom); },
         "a[10, 10, 100, 40] b[150, 380, 60, 20] c[400, 100, 80, 80] "},
        {"gaps", [&](const Panel& p) { return distribute(p, all, Direction::Horizontal); },
         "a[10, 10, 100, 40] b[225, 30, 60, 20] c[400, 100, 80, 80] "},
        {"same size", [&](const Panel& p) { return makeSameSize(p, all, SameSize::Both); },
         "a[10, 10, 100, 40] b[150, 30, 100, 40] c[400, 100, 100, 40] "},
        {"front", [&](const Panel& p) { return reorder(p, {QStringLiteral("a")}, Order::Front); },
         "b[150, 30, 60, 20] c[400, 100, 80, 80] a[10, 10, 100, 40] "},
        {"back",
         [&](const Panel& p) {
             return reorder(p, {QStringLiteral("c"), QStringLiteral("b")}, Order::Back);
         },
         "b[150, 30, 60, 20] c[400, 100, 80, 80] a[10, 10, 100, 40] "},
        {"forward", [&](const Panel& p) { return reorder(p, {QStringLiteral("a")}, Order::Forward); },
         "b[150, 30, 60, 20] a[10, 10, 100, 40] c[400, 100, 80, 80] "},
        {"group",
         [&](const Panel& p) {
             return makeGroup(p, {QStringLiteral("b"), QStringLiteral("c")});
         },
         "a[10, 10, 100, 40] group1[150, 30, 330, 150] b[150, 30, 60, 20] c[400, 100, 80, 80] "},
    };
    for (const auto& row : rows) {
        Panel panel = panelOf(kElements);
        const std::string before = panel.write();
        const Edit inverse = applyTo(panel, row.edit(panel));
        EXPECT_EQ(rects(panel), row.expected) << row.name;
        applyTo(panel, inverse);
        EXPECT_EQ(panel.write(), before) << row.name;
    }
}

TEST(Arrange, AGroupMovesAndScalesWithItsContentsAndDissolves) {
    Panel panel = panelOf(kElements);
    ElementId group;
    applyTo(panel, makeGroup(panel, {QStringLiteral("b"), QStringLiteral("c")}, &group));
    applyTo(panel, moveBy(panel, {group}, QPointF(10, -10)));
    EXPECT_EQ(panel.find(QStringLiteral("c"))->rect(), QRectF(410, 90, 80, 80));
    applyTo(panel, resizeTo(panel, group, QRectF(160, 20, 660, 300)));
    EXPECT_EQ(panel.find(QStringLiteral("b"))->rect(), QRectF(160, 20, 120, 40));
    EXPECT_EQ(panel.find(QStringLiteral("c"))->rect(), QRectF(660, 160, 160, 160));
    applyTo(panel, dissolveGroups(panel, {group}));
    EXPECT_FALSE(panel.find(group));
    EXPECT_TRUE(panel.find(QStringLiteral("b"))->parent().isEmpty());
}

TEST(Arrange, DuplicatesAsAnArrayWithCountingIndexAndTexts) {
    Panel panel = panelOf(
        R"({"id":"lamp1","kind":"lamp","rect":[10,10,50,50],"value":"Motor[1].on AND Line[9]","label":"Motor 1","when":[{"if":"Motor[1].fault"}]})");
    ElementIds added;
    applyTo(panel, duplicatedAsArray(panel, {QStringLiteral("lamp1")}, {8, 4, QPointF(10, 20), 1}, &added));
    ASSERT_EQ(panel.elements().size(), 8u);
    EXPECT_EQ(added.size(), 7u);
    const Element& last = panel.elements().back();
    EXPECT_EQ(last.text("value").toStdString(), "Motor[8].on AND Line[9]");
    EXPECT_EQ(last.text("label").toStdString(), "Motor 8");
    EXPECT_EQ(toQString(last.at("when")[0]["if"]).toStdString(), "Motor[8].fault");
    EXPECT_EQ(last.rect(), QRectF(10 + 3 * 60, 10 + 70, 50, 50));
}

TEST(Arrange, PastesWithNewIdsAndKeepsGroups) {
    Panel from = panelOf(kElements), to = panelOf(R"({"id":"b","kind":"lamp","rect":[0,0,10,10]})");
    ElementId group;
    applyTo(from, makeGroup(from, {QStringLiteral("b"), QStringLiteral("c")}, &group));
    ElementIds added;
    applyTo(to, pasted(to, copied(from, {group}), QPointF(5, 5), &added));
    ASSERT_EQ(added.size(), 1u);
    EXPECT_EQ(to.childrenOf(added[0]).size(), 2u);
    EXPECT_EQ(to.find(added[0])->rect().topLeft(), QPointF(5, 5));
}

TEST(Arrange, RenamesAVariableButNothingThatOnlyLooksLikeIt) {
    const struct {
        const char *before, *after;
    } rows[] = {
        {"Main.start", "Main.go"},
        {"main.START AND x", "Main.go AND x"},
        {"Main.starter", "Main.starter"},
        {"Other.Main.start", "Other.Main.start"},
        {"'Main.start'", "'Main.start'"},
        {"NOT Main.start.x", "NOT Main.go.x"},
        {"XMain.start", "XMain.start"},
        {"f(Main.start,Main.start)", "f(Main.go,Main.go)"},
        {"'a$'Main.start' = Main.start", "'a$'Main.start' = Main.go"},
    };
    for (const auto& row : rows)
        EXPECT_EQ(withRenamedPath(QLatin1String(row.before), QStringLiteral("Main.start"), QStringLiteral("Main.go"))
                      .toStdString(),
                  row.after);
}

TEST(Snapping, EdgesCentresGapsThenTheGrid) {
    SnapField field;
    field.panel = QRectF(0, 0, 800, 480);
    field.others = {QRectF(100, 100, 80, 40), QRectF(220, 100, 80, 40)};
    const auto x = [&](double at, double y = 300, double width = 50) {
        return at + snapMove(QRectF(at, y, width, 40), field).offset.x();
    };
    EXPECT_EQ(x(103), 100);          // left edges
    EXPECT_EQ(x(133), 130);          // right edges: 130 + 50 = 180
    EXPECT_EQ(x(112), 115);          // centres: 115 + 25 = 140
    EXPECT_EQ(x(337, 100, 80), 340); // the gap of 40 goes on
    EXPECT_EQ(x(547), 544);          // nothing near: the grid of 8
    const Snapped gap = snapMove(QRectF(337, 100, 80, 40), field);
    EXPECT_GE(std::count_if(gap.guides.begin(), gap.guides.end(), [](const Guide& guide) { return guide.isGap; }), 2);
    DraggedEdges right;
    right.right = true;
    EXPECT_EQ(snapResize(QRectF(50, 300, 127, 40), right, field).offset.x(), 3); // its right edge to 180
}

} // namespace
} // namespace plc::hmi
