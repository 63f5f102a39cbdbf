// The check of what properties say: each rule with an element that breaks it and one that does not.
#include "hmi/check/standard_check.h"
#include "hmi/model/errors.h"

#include <gtest/gtest.h>

namespace plc::hmi {
namespace {

std::vector<Finding> check(const std::string& elements) {
    CheckInput input;
    Result<Panel> panel = Panel::parse("{\"elements\": [" + elements + "]}", QStringLiteral("main"));
    EXPECT_TRUE(panel) << panel.error().english();
    input.panels.push_back({QStringLiteral("main"), *panel});
    // Of the variables, r is a REAL, b a BOOL and s a STRING.
    input.checkBinding = [](const QString& expression, std::string_view wanted, bool) -> Message {
        const std::string text = toUtf8(expression);
        if (wanted == "bool" && text != "b") return errors::BoolNeeded(text, Verbatim("REAL"));
        if (wanted == "number" && text == "s") return errors::NumberNeeded(text, Verbatim("STRING"));
        return {};
    };
    return checkPanels(input);
}

std::string findings(const std::string& elements) {
    std::string out;
    for (const Finding& one : check(elements))
        out += (out.empty() ? "" : "; ") + (one.element + u'.' + one.property).toStdString() + ": " +
               one.message.english();
    return out;
}

TEST(PropertyCheck, EachRuleHasAnElementThatBreaksIt) {
    const struct {
        std::string element, expected;
    } rows[] = {
        {R"("kind":"button","text":"Go","action":"momentary","target":"r")",
         "a.target: r is REAL; a BOOL is needed here"},
        {R"("kind":"button","text":"Go","action":"momentary","target":"b")", ""},
        {R"("kind":"button","text":"Go","action":"write","target":"r","write":"1.5")", ""},
        {R"("kind":"bar","min":100,"max":0)",
         "a.max: max (0) must be greater than min (100); exchange or correct the values"},
        {R"("kind":"bar","low":20,"high":10)",
         "a.high: high (10) must be greater than low (20); exchange or correct the values"},
        {R"("kind":"bar","lowLow":5,"low":5,"high":80,"highHigh":90)", ""},
        {R"("kind":"xyChart","minX":3,"maxX":3)",
         "a.maxX: maxX (3) must be greater than minX (3); exchange or correct the values"},
        {R"("kind":"numberEntry","target":"r","title":"Speed","minimum":"10","maximum":"5")",
         "a.maximum: maximum (5) must be greater than minimum (10); exchange or correct the values"},
        {R"("kind":"number","value":"s","format":"%d")",
         "a.format: The format %d needs a number, and s is none; use %s"},
        {R"("kind":"number","value":"s","format":"%s")", ""},
        {R"("kind":"number","value":"s")", ""},
        {R"("kind":"text","text":"{x:%.1f} l","values":{"x":"s"})",
         "a.text: The format %.1f needs a number, and s is none; use %s"},
        {R"("kind":"lamp","onColor":"gren")", "a.onColor: gren is not a colour; did you mean green?"},
        {R"("kind":"lamp","onColor":"#12345")",
         "a.onColor: #12345 is not a colour; use the name of a role of the theme or a value such as #2A6CA6"},
        {R"("kind":"lamp","when":[{"if":"b","color":"#GGGGGG"}])",
         "a.when[0].color: #GGGGGG is not a colour; use the name of a role of the theme or a value such as #2A6CA6"},
        {R"("kind":"lamp","onColor":"#2A6CA6","offColor":"none")", ""},
        {R"("kind":"lamp","vlaue":"b")", "a.vlaue: This version does not know the property vlaue; did you mean value?"},
        {R"("kind":"lamp","weather":"b")",
         "a.weather: This version does not know the property weather; it is kept as it is"},
        {R"("kind":"lamp","when":[{"iff":"b"}])",
         "a.when[0].iff: This version does not know the property iff; did you mean if?"},
        {R"("kind":"lamp","blink":"yes")", "a.blink: The value must be true or false"},
        {R"("kind":"gauge","ticks":2.5)", "a.ticks: The value must be a whole number"},
        {R"("kind":"gauge","min":"0")", "a.min: The value must be a number"},
        {R"("kind":"lamp","value":true)", "a.value: The value must be a text in quotes"},
        {R"("kind":"lamp","shape":"oval")", "a.shape: oval is not one of the choices: round, square, pill"},
        {R"("kind":"lamp","when":"b")", "a.when: The value must be a list of objects"},
        {R"("kind":"line","points":[[0,1],[2]])",
         "a.points: The value must be a list of points, each a list of two numbers"},
        {R"("kind":"lamp","parent":"g")", "a.parent: The panel has no group or tab g; create it or choose another one"},
        {R"("kind":"group","parent":"a")", "a.parent: The group a contains itself; choose another parent"},
        {R"("kind":"hologram","colour":7)",
         "a.kind: This version does not know the element kind \"hologram\"; it is kept as it is"},
    };
    for (const auto& row : rows)
        EXPECT_EQ(findings(R"({"id":"a","rect":[0,0,200,200],)" + row.element + "}"), row.expected) << row.element;
}

TEST(PropertyCheck, GroupsThatHoldEachOtherAreFoundAndPagesMustExist) {
    EXPECT_EQ(findings(R"({"id":"a","kind":"group","rect":[0,0,99,99],"parent":"b"},
                          {"id":"b","kind":"group","rect":[0,0,99,99],"parent":"a"})"),
              "a.parent: The group a contains itself; choose another parent; "
              "b.parent: The group b contains itself; choose another parent");
    EXPECT_EQ(findings(R"({"id":"t","kind":"tab","rect":[0,0,99,99]},
                          {"id":"a","kind":"lamp","rect":[0,0,20,20],"parent":"t","page":2},
                          {"id":"b","kind":"lamp","rect":[0,0,20,20],"parent":"t","page":1})"),
              "a.page: t has no page 2; its 2 pages are numbered from 0");
}

TEST(PropertyCheck, AColumnOfTextsThatIsNoLanguageOfTheProjectIsReported) {
    CheckInput input;
    LanguageSettings settings;
    settings.languages = QStringList{"en", "de"};
    const Result<TextTable> table = TextTable::parse("key,comment,en,de,fr\n", QStringLiteral("hmi/texts.csv"));
    ASSERT_TRUE(table);
    input.texts = TextCatalog(*table, settings);
    EXPECT_TRUE(checkPanels(input).empty()) << "an empty table harms nobody";
    input.texts = TextCatalog(*TextTable::parse("key,comment,en,de,fr\nhmi.ok,,OK,OK,OK\n", QString()), settings);
    const std::vector<Finding> found = checkPanels(input);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].text().toStdString(),
              "hmi/texts.csv:1:  [fr]: warning H1038: The project has no language fr, so operators never see this "
              "column; add it to the languages in project.json");
}

TEST(PropertyCheck, WhatCanOnlyMeanOneThingIsFixedAndUndoneByteForByte) {
    const struct {
        std::string before, after;
    } rows[] = {
        {R"("kind":"lamp","vlaue":"b")", R"("value":"b")"},
        {R"("kind":"lamp","onColor":"yelow")", R"("onColor":"yellow")"},
        {R"("kind":"lamp","blink":"True")", R"("blink":true)"},
        {R"("kind":"gauge","min":"2.5")", R"("min":2.5)"},
        {R"("kind":"gauge","ticks":"7")", R"("ticks":7)"},
        {R"("kind":"lamp","shape":"squre")", R"("shape":"square")"},
        {R"("kind":"number","value":"s","format":"%d")", R"("format":"%s")"},
        {R"("kind":"lamp","when":[{"iff":"b","color":"gren"},{"if":"b","color":"yelow"}])",
         R"("when":[{"if":"b","color":"green"},{"if":"b","color":"yellow"}])"},
    };
    for (const auto& row : rows) {
        const std::string element = R"({"id":"a","rect":[0,0,40,40],)" + row.before + "}";
        Result<Panel> panel = Panel::parse("{\"elements\": [" + element + "]}", QStringLiteral("main"));
        ASSERT_TRUE(panel);
        const std::string before = panel->write();
        const Edit fixes = fixesOf(check(element), panelFile(QStringLiteral("main")), *panel);
        ASSERT_FALSE(fixes.isEmpty()) << row.before;
        const Edit back = applyTo(*panel, fixes);
        const Json fields = panel->find(QStringLiteral("a"))->fields();
        const Json expected = Json::parse("{" + row.after + "}");
        for (const auto& [key, value] : expected.items()) EXPECT_EQ(fields.at(key).dump(), value.dump()) << row.before;
        EXPECT_EQ(findings(fields.dump()), "") << row.before;
        applyTo(*panel, back);
        EXPECT_EQ(panel->write(), before) << row.before;
    }
}

TEST(PropertyCheck, WhatNeedsADecisionHasNoFix) {
    for (const char* element :
         {R"("kind":"lamp","blink":"yes")", R"("kind":"lamp","onColor":"#12345")", R"("kind":"gauge","min":"low")",
          R"("kind":"bar","min":100,"max":0)", R"("kind":"lamp","weather":"b")", R"("kind":"lamp","parent":"g")"})
        for (const Finding& one : check(std::string(R"({"id":"a","rect":[0,0,40,40],)") + element + "}"))
            EXPECT_TRUE(one.fix.isEmpty()) << one.text().toStdString();
}

} // namespace
} // namespace plc::hmi
