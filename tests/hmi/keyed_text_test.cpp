// A panel that was drawn in one language: when a second is added, its texts come into the table by Fix All Issues.
#include "design_studio.h"

#include "tests/support/settle.h"

#include <QTreeWidget>

namespace plc::hmi {
namespace {

QString textOf(const Studio& studio, const char* element, std::string_view property) {
    return studio.panel().find(QString::fromLatin1(element))->text(property);
}

std::string inTable(Studio& studio, const QString& key) {
    return studio.context->project().texts.table().text(key.mid(1), QStringLiteral("en")).toStdString();
}

size_t unkeyed(Studio& studio) {
    studio.designer->checkNow();
    size_t count = 0;
    for (const Finding& finding : studio.designer->findings()) count += finding.kind == FindingKind::HardCodedText;
    return count;
}

TEST(KeyedText, TextsThatWereDrawnBeforeASecondLanguageAreMovedIntoTheTable) {
    Studio studio(R"({"id":"a","kind":"switch","rect":[0,0,160,48],"onText":"Drain tank","offText":"Drain tank"},
        {"id":"m","kind":"multiState","rect":[0,80,160,48],"states":[{"value":"1","text":"Filling"},{"value":"2","text":"Heating"}]})");
    studio.context->setLanguage(QStringLiteral("en"));
    const std::string before = studio.panel().write();
    ASSERT_EQ(unkeyed(studio), 4u);
    studio.designer->fixFinding(0);
    EXPECT_EQ(unkeyed(studio), 3u) << "one of them";
    studio.designer->fixAll();
    EXPECT_EQ(unkeyed(studio), 0u);
    const QString on = textOf(studio, "a", "onText"), off = textOf(studio, "a", "offText");
    EXPECT_TRUE(on.startsWith(u'@')) << on.toStdString();
    EXPECT_EQ(on, off) << "the same text has one key";
    EXPECT_EQ(inTable(studio, on), "Drain tank");
    const Json& states = studio.panel().find(QStringLiteral("m"))->at("states");
    EXPECT_EQ(inTable(studio, toQString(states[0]["text"])), "Filling");
    EXPECT_EQ(inTable(studio, toQString(states[1]["text"])), "Heating");
    studio.designer->document().undoStack().undo();
    studio.designer->document().undoStack().undo();
    EXPECT_EQ(studio.panel().write(), before) << "two steps for two fixes";
    EXPECT_FALSE(studio.context->project().texts.table().contains(on.mid(1)));
}

TEST(KeyedText, TheTitleOfThePanelIsNamedWithoutAnElementAndMovedToo) {
    Studio studio;
    studio.designer->document().perform({}, setProperty(studio.panel(), {}, "title", "Cooling water"));
    ASSERT_EQ(unkeyed(studio), 1u);
    QStringList places;
    for (const QTreeWidget* list : studio.designer->findChildren<QTreeWidget*>())
        if (list->columnCount() == 3 && list->topLevelItemCount() == 1) places += list->topLevelItem(0)->text(1);
    EXPECT_EQ(places, QStringList{QStringLiteral("title")});
    studio.designer->fixAll();
    EXPECT_EQ(unkeyed(studio), 0u);
    EXPECT_EQ(inTable(studio, studio.panel().text("title")), "Cooling water");
}

} // namespace
} // namespace plc::hmi
