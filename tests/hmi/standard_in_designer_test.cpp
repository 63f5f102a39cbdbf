// The check against ISA-101 in the designer: findings while drawing, with their reasons, and fixes as undo steps.
#include "design_studio.h"

namespace plc::hmi {
namespace {

std::string codes(const PanelDesigner& designer) {
    QStringList out;
    for (const Finding& one : designer.findings()) out += one.code();
    return out.join(u' ').toStdString();
}

TEST(StandardInDesigner, AFindingIsFixedAsOneUndoStepByteForByte) {
    Studio studio(R"({"id": "r", "kind": "rectangle", "rect": [0, 0, 80, 80], "fill": "red"},
                     {"id": "s", "kind": "text", "rect": [0, 100, 80, 40], "text": "@start", "fontSize": 8},
                     {"id": "n", "kind": "number", "rect": [0, 200, 140, 40]})");
    studio.project.standard = StandardSettings::fromJson(Json::object());
    studio.designer->checkNow();
    const std::string found = codes(*studio.designer);
    for (const char* code : {"H1102", "H1105", "H1111"}) EXPECT_NE(found.find(code), std::string::npos) << found;
    const std::string before = studio.panel().write();
    size_t fixable = studio.designer->findings().size();
    for (size_t i = 0; i < studio.designer->findings().size(); ++i)
        if (studio.designer->findings()[i].code() == QStringLiteral("H1102")) fixable = i;
    ASSERT_LT(fixable, studio.designer->findings().size());
    EXPECT_FALSE(studio.designer->findings()[fixable].why.isEmpty());
    studio.designer->fixFinding(fixable);
    EXPECT_EQ(codes(*studio.designer).find("H1102"), std::string::npos);
    EXPECT_NE(codes(*studio.designer).find("H1105"), std::string::npos);
    QAction* all = studio.designer->action(QStringLiteral("fix-all"));
    ASSERT_TRUE(all->isEnabled());
    all->trigger();
    EXPECT_EQ(codes(*studio.designer).find("H1105"), std::string::npos);
    EXPECT_NE(codes(*studio.designer).find("H1111"), std::string::npos) << "what to bind is a decision";
    EXPECT_FALSE(all->isEnabled());
    studio.designer->document().undoStack().undo();
    studio.designer->document().undoStack().undo();
    EXPECT_EQ(studio.panel().write(), before);
}

TEST(StandardInDesigner, WhatOtherPanelsSayOfThisOneIsReportedHere) {
    Studio studio(R"({"id": "h", "kind": "button", "rect": [400, 500, 120, 48], "action": "home", "text": "@start"})");
    studio.project.panels.push_back(
        {QStringLiteral("start"),
         panelOf(R"({"id": "h", "kind": "button", "rect": [8, 500, 120, 48], "action": "home", "text": "@start"},
                    {"id": "g", "kind": "button", "rect": [8, 8, 120, 48], "action": "panel", "panel": "main", "text": "@start"})")});
    studio.project.startPanel = QStringLiteral("start");
    studio.project.standard = StandardSettings::fromJson(Json::object());
    studio.designer->checkNow();
    EXPECT_NE(codes(*studio.designer).find("H1108"), std::string::npos) << codes(*studio.designer);
    studio.designer->fixAll();
    EXPECT_EQ(studio.panel().find(QStringLiteral("h"))->rect(), QRectF(8, 500, 120, 48));
}

} // namespace
} // namespace plc::hmi
